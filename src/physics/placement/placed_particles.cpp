#include "physics/placement/placed_particles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace carom {
namespace {

// Wraps the index of a cell that lies outside a periodic box.
int wrapped(int cell, int cells) { return (cell % cells + cells) % cells; }

}  // namespace

// A particle is listed in the cells that lie within its radius, less the mean radius, of its
// centre: most in one cell, and large ones in all cells that they fill. Another one is compared
// with those that are listed within its own radius and the mean one, so large and small ones are
// found in the same way.
//
// Where sizes differ most particles are small, and cells as wide as the mean radius keep the lists
// of small ones short. In a very large box a grid with two cells per particle would have cells much
// wider than these, and all of them might lie in one; there cells are a few radii wide and several
// share a list. With the root of the mean square of the radii, in space of the mean cube, a
// particle is listed in about two cells on average, however large some are.
template <int dimension>
PlacedParticles<dimension>::PlacedParticles(const Box& box, const Eigen::ArrayXd& radii)
    : box_(box) {
    constexpr double most_radii = dimension == 2 ? 8.0 : 4.0;
    constexpr double most_cells = dimension == 2 ? 1e8 : 1e6;  // along an axis
    const auto root = [](double x) { return dimension == 2 ? std::sqrt(x) : std::cbrt(x); };
    const auto count = static_cast<double>(radii.size());
    const double lists = 2.0 * count + 8.0, least = root(box.content() / lists);
    double mean = 0.0, some = 0.0;
    if (count > 0.0) {
        mean = radii.mean();
        some = most_radii * root(dimension == 2 ? radii.square().mean() : radii.cube().mean());
    }
    const double cell = some > 0.0 && least > some ? some : std::max(mean, least);
    reach_ = mean;
    double all = 1.0;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        const double count_along = std::floor(box.size[axis] / cell);
        cells_[axis] = static_cast<int>(std::min(std::max(count_along, 1.0), most_cells));
        cell_size_[axis] = box.size[axis] / cells_[axis];
        all *= cells_[axis];
    }
    heads_.assign(static_cast<std::size_t>(std::min(all, lists)), -1);
    is_shared_ = static_cast<double>(heads_.size()) < all;
    entries_.reserve(static_cast<std::size_t>(radii.size()));
    if (!box.surfaces.are_plain()) barriers_ = InitialBarriers(box);
}

template <int dimension>
std::size_t PlacedParticles<dimension>::list_of(const Cell& cell) const {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 by the golden ratio: spreads rows
    std::uint64_t number = 0;
    for (std::size_t axis = dimension; axis-- > 0;)
        number = number * static_cast<std::uint64_t>(cells_[axis]) +
                 static_cast<std::uint64_t>(wrapped(cell[axis], cells_[axis]));
    return is_shared_ ? ((number * golden) >> 32) % heads_.size() : number;
}

// Calls f(list) for the cells that a particle touches, until f returns false.
template <int dimension>
template <typename Function>
void PlacedParticles<dimension>::for_each_list(const Vec& centre, double radius,
                                               Function&& f) const {
    Cell low{}, high{};
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        const int last = cells_[axis] - 1;
        // Clamped before the conversion to integers, since a particle may cover more cells than an
        // int can count.
        double from = std::floor((centre[axis] - radius) / cell_size_[axis]);
        double to = std::floor((centre[axis] + radius) / cell_size_[axis]);
        if (!box_.is_periodic(axis)) {
            from = std::clamp(from, 0.0, double(last));
            to = std::clamp(to, 0.0, double(last));
        } else if (to - from >= last) {  // all of them, each once
            from = 0.0;
            to = last;
        }
        low[axis] = static_cast<int>(from);
        high[axis] = static_cast<int>(to);
    }
    for (Cell cell = low; f(list_of(cell));) {
        std::size_t axis = 0;
        while (axis < dimension && cell[axis] == high[axis]) {
            cell[axis] = low[axis];
            ++axis;
        }
        if (axis == dimension) return;
        ++cell[axis];
    }
}

// Calls f(entry, squared distance) for those in a list, until f returns false; returns whether it
// has not.
template <int dimension>
template <typename Function>
bool PlacedParticles<dimension>::visit(std::size_t list, const Vec& centre, Function&& f) const {
    for (std::int32_t e = heads_[list]; e >= 0;) {
        ++compared_;
        const Entry& entry = entries_[static_cast<std::size_t>(e)];
        if (!f(entry, square(box_.nearest(entry.centre - centre)))) return false;
        e = entry.next;
    }
    return true;
}

// The same for those near a particle at `centre`.
template <int dimension>
template <typename Function>
void PlacedParticles<dimension>::for_each_near(const Vec& centre, double radius,
                                               Function&& f) const {
    std::size_t own = 0;  // most that overlap are listed there
    for_each_list(centre, 0.0, [&](std::size_t list) {
        own = list;
        return false;
    });
    if (!visit(own, centre, f)) return;
    for_each_list(centre, radius + reach_,
                  [&](std::size_t list) { return list == own || visit(list, centre, f); });
}

// Calls f(particle) until it returns false.
template <int dimension>
template <typename Function>
void PlacedParticles<dimension>::for_each_overlapping(const Vec& centre, double radius,
                                                      Function&& f) const {
    for_each_near(centre, radius, [&](const Entry& other, double squared) {
        const double contact = (radius + other.radius) * (1.0 - touching_tolerance);
        return squared < contact * contact ? f(other.particle) : true;
    });
}

template <int dimension>
std::optional<std::int32_t> PlacedParticles<dimension>::overlapped(const Vec& centre,
                                                                   double radius) const {
    std::optional<std::int32_t> lowest;
    for_each_overlapping(centre, radius, [&](std::int32_t particle) {
        lowest = std::min(lowest.value_or(particle), particle);
        return true;
    });
    return lowest;
}

template <int dimension>
bool PlacedParticles<dimension>::is_free(const Vec& centre, double radius) const {
    if (overlapped_surface(centre, radius)) return false;
    bool is = true;
    for_each_overlapping(centre, radius, [&](std::int32_t) { return is = false; });
    return is;
}

template <int dimension>
double PlacedParticles<dimension>::deepest_overlap(const Vec& centre, double radius) const {
    double deepest = 0.0;
    for_each_near(centre, radius, [&](const Entry& other, double squared) {
        const double contact = radius + other.radius;
        if (squared < contact * contact)
            deepest = std::max(deepest, 1.0 - std::sqrt(squared) / contact);
        return true;
    });
    return deepest;
}

template <int dimension>
void PlacedParticles<dimension>::add(std::int32_t particle, const Vec& centre, double radius) {
    for_each_list(centre, std::max(0.0, radius - reach_), [&](std::size_t list) {
        entries_.push_back({centre, radius, particle, heads_[list]});
        heads_[list] = static_cast<std::int32_t>(entries_.size()) - 1;
        return true;
    });
}

template class PlacedParticles<2>;
template class PlacedParticles<3>;

}  // namespace carom
