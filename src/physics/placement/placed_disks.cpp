#include "physics/placement/placed_disks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace carom {
namespace {

// Wraps the index of a cell that lies outside a periodic box.
int wrapped(int cell, int cells) { return (cell % cells + cells) % cells; }

}  // namespace

// Where sizes differ most disks are small, and cells as wide as the mean radius keep the lists of
// small disks short. In a very large box a grid with two cells per disk would have cells much wider
// than the disks, and all disks might lie in one of them; there cells are a few radii wide and
// several share a list. With the root mean square of the radii a disk lies in about two cells on
// average, however large some disks are.
PlacedDisks::PlacedDisks(const Box& box, const Eigen::ArrayXd& radii) : box_(box) {
    constexpr double most_radii = 8.0, most_cells = 1e8;
    const auto count = static_cast<double>(radii.size());
    const double lists = 2.0 * count + 8.0, least = std::sqrt(box.content() / lists);
    const double mean = count > 0.0 ? radii.mean() : 0.0;
    const double some = count > 0.0 ? most_radii * std::sqrt(radii.square().mean()) : 0.0;
    const double cell = some > 0.0 && least > some ? some : std::max(mean, least);
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double count_along = std::floor(box.size[axis] / cell);
        cells_[axis] = static_cast<int>(std::min(std::max(count_along, 1.0), most_cells));
        cell_size_[axis] = box.size[axis] / cells_[axis];
    }
    const double all = cells_.cast<double>().prod();
    heads_.assign(static_cast<std::size_t>(std::min(all, lists)), -1);
    is_shared_ = static_cast<double>(heads_.size()) < all;
    if (!box.surfaces.are_plain()) barriers_ = barriers_of(box, box.longest_side());
}

std::size_t PlacedDisks::list_of(int x, int y) const {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 by the golden ratio: spreads rows
    const auto column = static_cast<std::uint64_t>(wrapped(x, cells_[0]));
    const auto row = static_cast<std::uint64_t>(wrapped(y, cells_[1]));
    const std::uint64_t cell = row * static_cast<std::uint64_t>(cells_[0]) + column;
    return is_shared_ ? ((cell * golden) >> 32) % heads_.size() : cell;
}

template <typename Function>
void PlacedDisks::for_each_cell(const Vec& centre, double radius, Function&& f) const {
    std::array<int, 2> low{}, high{};
    for (int a = 0; a < 2; ++a) {
        const auto s = static_cast<std::size_t>(a);
        const int last = cells_[a] - 1;
        // Clamped before the conversion to integers, since a disk may cover more cells than an int
        // can count.
        double from = std::floor((centre[a] - radius) / cell_size_[a]);
        double to = std::floor((centre[a] + radius) / cell_size_[a]);
        if (!box_.is_periodic(s)) {
            from = std::clamp(from, 0.0, double(last));
            to = std::clamp(to, 0.0, double(last));
        } else if (to - from >= last) {  // all of them, each once
            from = 0.0;
            to = last;
        }
        low[s] = static_cast<int>(from);
        high[s] = static_cast<int>(to);
    }
    for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) f(list_of(x, y));
}

// Calls f(disk, squared distance) for the disks in the cells that a disk at `centre` touches, until
// f returns false.
template <typename Function>
void PlacedDisks::for_each_near(const Vec& centre, double radius, Function&& f) const {
    bool go_on = true;
    for_each_cell(centre, radius, [&](std::size_t cell) {
        for (std::int32_t e = heads_[cell]; go_on && e >= 0;) {
            ++compared_;
            const Entry& entry = entries_[static_cast<std::size_t>(e)];
            const Disk& other = disks_[static_cast<std::size_t>(entry.disk)];
            go_on = f(other, square(box_.nearest(other.centre - centre)));
            e = entry.next;
        }
    });
}

// Calls f(particle) until it returns false.
template <typename Function>
void PlacedDisks::for_each_overlapping(const Vec& centre, double radius, Function&& f) const {
    for_each_near(centre, radius, [&](const Disk& other, double squared) {
        const double contact = (radius + other.radius) * (1.0 - touching_tolerance);
        return squared < contact * contact ? f(other.particle) : true;
    });
}

std::optional<std::int32_t> PlacedDisks::overlapped(const Vec& centre, double radius) const {
    std::optional<std::int32_t> lowest;
    for_each_overlapping(centre, radius, [&](std::int32_t particle) {
        lowest = std::min(lowest.value_or(particle), particle);
        return true;
    });
    return lowest;
}

bool PlacedDisks::is_free(const Vec& centre, double radius) const {
    if (overlapped_surface(centre, radius)) return false;
    bool is = true;
    for_each_overlapping(centre, radius, [&](std::int32_t) { return is = false; });
    return is;
}

double PlacedDisks::deepest_overlap(const Vec& centre, double radius) const {
    double deepest = 0.0;
    for_each_near(centre, radius, [&](const Disk& other, double squared) {
        const double contact = radius + other.radius;
        if (squared < contact * contact)
            deepest = std::max(deepest, 1.0 - std::sqrt(squared) / contact);
        return true;
    });
    return deepest;
}

void PlacedDisks::add(std::int32_t particle, const Vec& centre, double radius) {
    const auto disk = static_cast<std::int32_t>(disks_.size());
    disks_.push_back({centre, radius, particle});
    for_each_cell(centre, radius, [&](std::size_t cell) {
        entries_.push_back({disk, heads_[cell]});
        heads_[cell] = static_cast<std::int32_t>(entries_.size()) - 1;
    });
}

}  // namespace carom
