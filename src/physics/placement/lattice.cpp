#include "physics/placement/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "physics/placement/placed_particles.h"

namespace carom {
namespace {

double step_between(const Box& box, int axis, std::int64_t lines, double radius) {
    const auto count = static_cast<double>(lines);
    if (box.is_periodic(axis)) return box.size[axis] / count;
    const double room = box.size[axis] - 2.0 * radius;
    return lines > 1 ? room / (count - 1.0) : box.size[axis];
}

// Sites are nearest diagonally, or two lines apart along an axis. Across a periodic side a site
// that is alone on its line is nearest to itself.
double nearest_in(const Box& box, const Lattice& lattice) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto lines = [&](int axis) { return lattice.lines[static_cast<std::size_t>(axis)]; };
    for (int axis = 0; axis < lattice.dimension; ++axis) {
        const double step = lattice.step[axis];
        const bool is_periodic = box.is_periodic(axis);
        if (lines(axis) > 2 || (is_periodic && axis == 0))
            nearest = std::min(nearest, 2.0 * step);
        else if (lines(axis) == 1 && is_periodic)
            nearest = std::min(nearest, step);
        for (int other = 0; other < axis; ++other)
            if (lines(axis) > 1 && lines(other) > 1)
                nearest = std::min(nearest, std::hypot(lattice.step[other], step));
    }
    return nearest;
}

// For each number of lines across all axes but one, the least numbers across that one which give
// enough sites.
class LatticeSearch {
  public:
    LatticeSearch(const Box& box, std::int64_t count, double radius)
        : box_(box),
          count_(count),
          radius_(radius),
          apart_(2.0 * radius * (1.0 - touching_tolerance)),
          tried_{.dimension = box.dimension} {
        // In space that one is the longest: there are few lines across the others to be tried.
        if (box.dimension == 3)
            for (const std::size_t k : {1U, 2U})
                if (box.size[axes_[k]] > box.size[axes_[0]]) std::swap(axes_[0], axes_[k]);
    }

    std::optional<Lattice> run() {
        try_all(static_cast<std::size_t>(box_.dimension) - 1, 1);
        return best_;
    }

  private:
    void set_lines(int axis, std::int64_t lines) {
        tried_.lines[static_cast<std::size_t>(axis)] = lines;
        tried_.step[axis] = step_between(box_, axis, lines, radius_);
    }

    // Across the axes up to the k-th; `rows`: the product of the lines across those after it.
    void try_all(std::size_t k, std::int64_t rows) {
        if (k == 0) return try_least(rows);
        const int axis = axes_[k];
        for (std::int64_t lines = 1; lines <= count_ + 1; ++lines) {
            if (box_.is_periodic(axis) && lines > 1 && lines % 2 == 1) continue;
            set_lines(axis, lines);
            const double two = 2.0 * tried_.step[axis];
            if (lines > 2 && (two < apart_ || (best_ && two <= best_->nearest))) return;
            try_all(k - 1, rows * lines);
        }
    }

    // With all rows equally long, and with every other one shorter by a site, but not without any.
    void try_least(std::int64_t rows) {
        const int axis = axes_[0];
        const bool is_periodic = box_.is_periodic(axis);
        if (is_periodic || rows > 1) try_lines(2 * ((count_ + rows - 1) / rows));
        const std::int64_t shorter = 2 * ((count_ + rows / 2 + rows - 1) / rows) - 1;
        if (!is_periodic && (rows == 1 || shorter > 1)) try_lines(shorter);
    }

    void try_lines(std::int64_t lines) {
        set_lines(axes_[0], lines);
        tried_.nearest = nearest_in(box_, tried_);
        const bool fits = tried_.nearest >= apart_ && on_each_axis(tried_.dimension, [&](int axis) {
                              return !(tried_.step[axis] < 0.0);
                          });
        if (fits && (!best_ || tried_.nearest > best_->nearest)) best_ = tried_;
    }

    const Box& box_;
    std::int64_t count_;
    double radius_, apart_;
    std::array<int, 3> axes_{0, 1, 2};  ///< that for which the least numbers are found comes first
    Lattice tried_;
    std::optional<Lattice> best_;
};

}  // namespace

std::optional<Lattice> fitting_lattice(const Box& box, std::int64_t count, double radius) {
    return LatticeSearch(box, count, radius).run();
}

std::vector<Vec> lattice_sites(const Box& box, const Lattice& lattice, double radius) {
    // Against a wall the outermost particles touch it; those on a single line are in the middle.
    Vec origin;
    for (int axis = 0; axis < lattice.dimension; ++axis)
        origin[axis] = box.is_periodic(axis) ? 0.5 * lattice.step[axis]
                       : lattice.lines[static_cast<std::size_t>(axis)] > 1 ? radius
                                                                           : 0.5 * box.size[axis];
    std::vector<Vec> sites;
    sites.reserve(static_cast<std::size_t>(lattice.sites()));
    const auto along = [&](int axis, std::int64_t line) {
        return origin[axis] + lattice.step[axis] * static_cast<double>(line);
    };
    for (std::int64_t z = 0; z < lattice.lines[2]; ++z)
        for (std::int64_t y = 0; y < lattice.lines[1]; ++y)
            for (std::int64_t x = (y + z) % 2; x < lattice.lines[0]; x += 2)
                sites.push_back({along(0, x), along(1, y), along(2, z)});
    return sites;
}

}  // namespace carom
