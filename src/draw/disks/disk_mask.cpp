#include "draw/disks/disk_mask.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr std::uint32_t x_steps = 256;  // resolution of an edge within a pixel

// Small disks are stored as whole rows of groups: the same number in each row, which is faster than
// counting.
constexpr float largest_of_whole_rows = 8.0F;

// The number of scan lines into which a row of pixels is divided: as many as there are phases, so
// that the lines of a radius have the same heights for every phase.
constexpr int lines = DiskShape::phases;

// Computes half the length of the chord on each scan line from the equator to a pole, in 1/x_steps
// of a pixel.
void find_half_chords(std::vector<std::uint32_t>& chords, float radius) {
    constexpr float scale = lines;
    chords.resize(static_cast<std::size_t>(std::ceil(radius * scale + 0.5F)));
    float height = 0.5F / scale;
    for (std::uint32_t& chord : chords) {
        // The product keeps the digits that a difference of squares would lose at the pole.
        const float half = std::sqrt(std::max(0.0F, (radius - height) * (radius + height)));
        chord = static_cast<std::uint32_t>(static_cast<int>(half * x_steps + 0.5F));
        height += 1.0F / scale;
    }
}

// Adds an edge at `position` (in 1/x_steps of a pixel from the start of the row), to the right of
// which the coverage is larger by `sign` lines. The change is divided between the edge's pixel and
// the next so that the running sum of the changes is the exact area.
void add_edge(std::int32_t* changes, std::uint32_t position, int sign) {
    const std::uint32_t pixel = position / x_steps;
    const int beyond = static_cast<int>(position % x_steps);
    changes[pixel] += sign * (static_cast<int>(x_steps) - beyond);
    changes[pixel + 1] += sign * beyond;
}

int groups_for(int pixels) { return (pixels + group_size - 1) / group_size; }

}  // namespace

void MaskStore::sum_changes(int width) {
    constexpr int full_sum = lines * static_cast<int>(x_steps);
    row_.assign(static_cast<std::size_t>(width + group_size), 0);
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i) {
        sum += changes_[i];
        row_[i] = static_cast<std::uint8_t>((sum * 255 + full_sum / 2) / full_sum);
    }
}

void MaskStore::append(int first, int groups) {
    const auto start = row_.begin() + first;
    coverages_.insert(coverages_.end(), start, start + groups * group_size);
}

void MaskStore::add_row(int left, int width, bool is_whole) {
    const auto is_full = [](std::uint8_t coverage) { return coverage == 255; };
    const auto begin = row_.begin(), end = begin + width;
    const auto full_begin = is_whole ? end : std::find_if(begin, end, is_full);
    const auto full_end = std::find_if_not(full_begin, end, is_full);
    const int left_groups = groups_for(static_cast<int>(full_begin - begin));
    const int span_begin = left_groups * group_size;
    const int span_end = std::max(span_begin, static_cast<int>(full_end - begin));
    const int right_groups = groups_for(std::max(0, width - span_end));

    append(0, left_groups);
    append(span_end, right_groups);
    rows_.push_back({static_cast<std::int16_t>(left), static_cast<std::uint16_t>(left_groups),
                     static_cast<std::uint16_t>(span_end - span_begin),
                     static_cast<std::uint16_t>(right_groups)});
}

void MaskStore::find_changes(int width, std::uint32_t middle, int first_line) {
    changes_.assign(static_cast<std::size_t>(width + 2), 0);
    for (int line = first_line; line < first_line + lines; ++line) {
        const auto from_equator = static_cast<std::size_t>(line < 0 ? -line - 1 : line);
        if (from_equator >= half_chords_.size()) continue;
        const std::uint32_t half = half_chords_[from_equator];
        add_edge(changes_.data(), middle - half, 1);
        add_edge(changes_.data(), middle + half, -1);
    }
}

DiskMask MaskStore::add(const DiskShape& shape) {
    const float radius = static_cast<float>(shape.radius) / DiskShape::radius_steps;
    const float center_x = static_cast<float>(shape.phase_x) / DiskShape::phases;
    const float center_y = static_cast<float>(shape.phase_y) / DiskShape::phases;
    const int left = static_cast<int>(std::floor(center_x - radius));
    const int width = static_cast<int>(std::floor(center_x + radius)) - left + 1;
    const int top = static_cast<int>(std::floor(center_y - radius));
    const int bottom = static_cast<int>(std::floor(center_y + radius));
    const DiskMask mask{
        left, top, width + group_size, bottom - top + 1, rows_.size(), coverages_.size()};
    find_half_chords(half_chords_, radius);
    const auto middle = static_cast<std::uint32_t>(shape.phase_x - left * DiskShape::phases) *
                        (x_steps / DiskShape::phases);
    for (int y = top; y <= bottom; ++y) {
        find_changes(width, middle, y * lines - shape.phase_y);
        sum_changes(width);
        add_row(left, width, radius <= largest_of_whole_rows);
    }
    return mask;
}

void MaskStore::truncate_to(const DiskMask& mask) {
    rows_.resize(mask.first_row);
    coverages_.resize(mask.first_coverage);
}

}  // namespace carom
