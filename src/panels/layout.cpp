#include "panels/layout.h"

#include <algorithm>
#include <cmath>

#include "scene/film.h"
#include "scene/style/style.h"

namespace carom {
namespace {

bool same(double a, double b) { return std::abs(a - b) < 1e-6; }

double line_under_box(const Grid& grid) { return grid.height_of(1.9); }

}  // namespace

Grid::Grid(const LayoutSpec& layout, PictureSize size, double text)
    : across_(size.width / layout.grid_width),
      up_(size.height / layout.grid_height),
      unit_(std::min(across_, up_) * text) {}

Grid::Grid(const Film& film, const LayoutSpec& layout)
    : Grid(layout, film.size, film.style != nullptr ? film.style->film_text : 1.0) {}

Grid::Grid(const Film& film) : Grid(film, film.layout) {}

Rect Grid::place(const Slot& slot) const {
    return {slot.x * across_, slot.y * up_, slot.width * across_, slot.height * up_};
}

std::vector<Slot> shared_slots(const std::vector<Slot>& slots, std::size_t count) {
    if (count == 0 || count >= slots.size()) return slots;
    std::vector<Slot> shared(slots.begin(), slots.begin() + std::ptrdiff_t(count));
    const auto are_same = [&](double Slot::*side) {
        return std::ranges::all_of(
            slots, [&](const Slot& slot) { return same(slot.*side, slots.front().*side); });
    };
    if (!are_same(&Slot::width) || !are_same(&Slot::height)) return shared;
    const auto share = [&](double Slot::*start, double Slot::*size) {
        const Slot &first = slots.front(), &last = slots.back();
        const double gap = slots[1].*start - (first.*start + first.*size);
        const double step =
            (last.*start + last.*size - first.*start + gap) / static_cast<double>(count);
        for (std::size_t i = 0; i < count; ++i) {
            shared[i].*start = first.*start + step * static_cast<double>(i);
            shared[i].*size = step - gap;
        }
    };
    if (are_same(&Slot::x)) share(&Slot::y, &Slot::height);
    if (are_same(&Slot::y)) share(&Slot::x, &Slot::width);
    return shared;
}

std::vector<Slot> with_heights(std::vector<Slot> slots,
                               const std::vector<std::optional<double>>& enough) {
    const std::size_t count = std::min(slots.size(), enough.size());
    double spare = 0.0;
    std::size_t others = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0 && (!same(slots[i].x, slots[0].x) || !same(slots[i].width, slots[0].width)))
            return slots;
        if (enough[i]) spare += std::max(0.0, slots[i].height - *enough[i]);
        if (!enough[i]) ++others;
    }
    if (others == 0) return slots;
    double moved = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double height = enough[i] ? std::min(slots[i].height, *enough[i])
                                        : slots[i].height + spare / static_cast<double>(others);
        slots[i].y += moved;
        moved += height - slots[i].height;
        slots[i].height = height;
    }
    return slots;
}

Slot on_plate(const Slot& slot, const LayoutSpec& layout, const Grid& grid) {
    if (!is_within(slot, layout.gas)) return slot;
    const double across = grid.width_of(plate_margin), up = grid.height_of(plate_margin);
    return {slot.x + across, slot.y + up, slot.width - 2.0 * across, slot.height - 2.0 * up};
}

std::vector<PlaceBeside> places_beside(const Slot& place, double box_shape, const Grid& grid,
                                       std::size_t count) {
    constexpr double between = 1.6;
    constexpr double least_height = 17.0, least_width = 24.0;  // of a line, with its world lines
    const double words = line_under_box(grid), gap = grid.height_of(between),
                 gap_across = grid.width_of(between), shape = grid.shape_of(box_shape);
    const auto boxes = static_cast<double>(count);
    const double across = (place.width - (boxes - 1.0) * gap_across) / boxes;
    const double up = (place.height - (boxes - 1.0) * gap) / boxes - words;
    const double width_beside = shape > 0.0 ? std::min(across, (place.height - words) / shape) : 0;
    const double width_above = shape > 0.0 ? std::min(place.width, up / shape) : place.width;
    const bool is_line = shape == 0.0;
    const bool is_beside =
        is_line ? up < grid.height_of(least_height) && across >= grid.width_of(least_width)
                : width_beside >= width_above;
    const double width = is_beside ? (is_line ? across : width_beside) : width_above;
    const double most = is_beside ? place.height - words : up;
    const double height = shape > 0.0 ? std::min(most, width * shape) : most;
    const double used = is_beside ? height + words : boxes * (height + words) + (boxes - 1.0) * gap;
    std::vector<PlaceBeside> places(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto k = static_cast<double>(i);
        Slot& box = places.at(i).box;
        box = {place.x, place.y + 0.5 * (place.height - used), width, height};
        if (is_beside)
            box.x += k * (across + gap_across);
        else
            box.y += k * (height + words + gap);
        places.at(i).words = {box.x, box.y + box.height, is_beside ? across : place.width, words};
    }
    return places;
}

std::vector<PlaceBeside> places_overlaid(const Slot& place, double box_shape, const Grid& grid,
                                         std::size_t count) {
    const double words = line_under_box(grid), shape = grid.shape_of(box_shape);
    const double width = std::min(place.width, (place.height - words) / shape);
    const Slot box{place.x, place.y, width, width * shape};
    const double share = place.width / static_cast<double>(count);
    std::vector<PlaceBeside> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back(
            {box, {place.x + static_cast<double>(i) * share, box.y + box.height, share, words}});
    return places;
}

}  // namespace carom
