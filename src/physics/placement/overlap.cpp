#include "physics/placement/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "physics/placement/members.h"
#include "physics/placement/placed_particles.h"

namespace carom {
namespace {

template <int dimension>
double overlap_of_two(const Box& box, const Particles& particles, const Sample& sample,
                      Eigen::Index i, Eigen::Index j) {
    Vec apart;
    bool is_nearest = true;
    for (int axis = 0; axis < dimension; ++axis) {
        apart[axis] = sample.position(j, axis) - sample.position(i, axis);
        is_nearest = is_nearest && std::abs(apart[axis]) < 0.25 * box.size[axis];
    }
    const double contact = particles.radius[i] + particles.radius[j];
    const double squared = square(is_nearest ? apart : box.nearest(apart));
    return squared < contact * contact ? 1.0 - std::sqrt(squared) / contact : 0.0;
}

// A grid with cells at least as wide as the largest particle, for gases in which no cell has to
// hold many: each particle is compared with those in the cells around its centre. Cells are
// processed in order, so that particles close to each other in the box are also close in the
// processor's caches.
template <int dimension>
class ParticlesInCells {
    using Cell = std::array<int, dimension>;

  public:
    /// Whether the grid suits these particles, that is, none is much larger than the others.
    static bool suits(const Box& box, const Particles& particles) {
        const double across = 2.0 * particles.radius.maxCoeff();
        double taken = static_cast<double>(particles.count());
        for (int axis = 0; axis < dimension; ++axis) taken *= across;
        constexpr double most_in_cell = 4.0;
        return across > 0.0 && taken < most_in_cell * box.content();
    }

    ParticlesInCells(const Box& box, const Particles& particles, const Sample& sample)
        : box_(box), particles_(particles), sample_(sample) {
        constexpr double beyond_rounding = 1.0 + 1e-9;  // margin for rounding to cells
        const double across = 2.0 * particles.radius.maxCoeff() * beyond_rounding;
        const double room = box.content() / static_cast<double>(particles.count());
        const double one_each = dimension == 2 ? std::sqrt(room) : std::cbrt(room);
        for (std::size_t axis = 0; axis < dimension; ++axis) {
            cells_[axis] = std::max(
                1, static_cast<int>(std::floor(box.size[axis] / std::max(across, one_each))));
            per_length_[axis] = cells_[axis] / box.size[axis];
        }
        for (std::size_t k = 0; k < rows_after.size(); ++k)
            for (std::size_t axis = dimension; axis-- > 0;)
                steps_[k] = steps_[k] * static_cast<std::size_t>(cells_[axis]) +
                            static_cast<std::size_t>(rows_after[k][axis]);
        sort();
    }

    double deepest_overlap() const {
        double deepest = 0.0;
        for (Cell cell{};;) {
            deepest = std::max(deepest, deepest_at(cell));
            std::size_t axis = 0;
            while (axis < dimension && ++cell[axis] == cells_[axis]) cell[axis++] = 0;
            if (axis == dimension) return deepest;
        }
    }

  private:
    std::size_t cell_of(Eigen::Index i) const {
        Cell cell{};
        for (std::size_t axis = 0; axis < dimension; ++axis) {
            const double place =
                sample_.position(i, static_cast<Eigen::Index>(axis)) * per_length_[axis];
            cell[axis] = static_cast<int>(std::clamp(place, 0.0, cells_[axis] - 1.0));
        }
        return number_of(cell);
    }
    std::size_t number_of(const Cell& cell) const {
        std::size_t number = 0;
        for (std::size_t axis = dimension; axis-- > 0;)
            number = number * static_cast<std::size_t>(cells_[axis]) +
                     static_cast<std::size_t>(cell[axis]);
        return number;
    }

    // Counting sort by cell.
    void sort() {
        std::size_t all = 1;
        for (const int cells : cells_) all *= static_cast<std::size_t>(cells);
        begins_.assign(all + 1, 0);
        sorted_.resize(static_cast<std::size_t>(particles_.count()));
        for (Eigen::Index i = 0; i < particles_.count(); ++i) ++begins_[cell_of(i)];
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        for (Eigen::Index i = particles_.count(); i-- > 0;)
            sorted_[static_cast<std::size_t>(--begins_[cell_of(i)])] = static_cast<std::int32_t>(i);
    }

    // The particles in consecutive cells of a row.
    std::span<const std::int32_t> in_cells(std::size_t first, std::size_t last) const {
        const auto begin = static_cast<std::size_t>(begins_[first]),
                   end = static_cast<std::size_t>(begins_[last + 1]);
        return {sorted_.data() + begin, end - begin};
    }

    double deepest_between(std::span<const std::int32_t> some,
                           std::span<const std::int32_t> others) const {
        double deepest = 0.0;
        for (const std::int32_t i : some)
            for (const std::int32_t j : others)
                if (i != j)
                    deepest = std::max(deepest,
                                       overlap_of_two<dimension>(box_, particles_, sample_, i, j));
        return deepest;
    }

    // Of two adjacent cells only one is compared with the other; inside the box three cells of a
    // row are examined at once.
    double deepest_at(const Cell& cell) const {
        const std::size_t number = number_of(cell);
        const auto here = in_cells(number, number);
        if (here.empty()) return 0.0;
        bool is_inside = true;
        for (std::size_t axis = 0; axis < dimension; ++axis)
            is_inside = is_inside && cell[axis] > 0 && cell[axis] + 1 < cells_[axis];
        double deepest = 0.0;
        if (is_inside) {
            deepest = deepest_between(here, in_cells(number, number + 1));
            for (std::size_t k = 1; k < rows_after.size(); ++k) {
                const std::size_t near = number + steps_[k];
                deepest = std::max(deepest, deepest_between(here, in_cells(near - 1, near + 1)));
            }
            return deepest;
        }
        for (std::size_t k = 0; k < rows_after.size(); ++k)
            for (int right = k == 0 ? 0 : -1; right <= 1; ++right) {
                Cell offset = rows_after[k];
                offset[0] = right;
                const auto near = other(cell, offset);
                if (!near) continue;
                deepest = std::max(deepest, deepest_between(here, in_cells(*near, *near)));
            }
        return deepest;
    }

    // The rows along x: that of a cell, and those that come after it: in a plane the one above it,
    // in space another in the same layer and three in the next.
    static constexpr auto rows_after = [] {
        if constexpr (dimension == 2)
            return std::array<Cell, 2>{{{0, 0}, {0, 1}}};
        else
            return std::array<Cell, 5>{{{0, 0, 0}, {0, 1, 0}, {0, -1, 1}, {0, 0, 1}, {0, 1, 1}}};
    }();

    // A cell next to another, across a periodic side too; nothing beyond a wall.
    std::optional<std::size_t> other(Cell cell, const Cell& offset) const {
        for (std::size_t axis = 0; axis < dimension; ++axis) {
            int& at = cell[axis];
            at += offset[axis];
            if (at >= 0 && at < cells_[axis]) continue;
            if (!box_.is_periodic(axis)) return std::nullopt;
            at += at < 0 ? cells_[axis] : -cells_[axis];
        }
        return number_of(cell);
    }

    const Box& box_;
    const Particles& particles_;
    const Sample& sample_;
    Cell cells_{};
    std::array<std::size_t, rows_after.size()> steps_{};  ///< to the rows after a cell, modulo 2^64
    Vec per_length_;
    std::vector<std::int32_t> begins_;  ///< first index in sorted_ for each cell, and the end of
                                        ///< the last cell
    std::vector<std::int32_t> sorted_;  ///< by cell
};

template <int dimension>
double overlap_beyond_a_line(const Box& box, const Particles& particles, const Sample& sample) {
    if (ParticlesInCells<dimension>::suits(box, particles))
        return ParticlesInCells<dimension>(box, particles, sample).deepest_overlap();
    PlacedParticles<dimension> placed(box, particles.radius);
    double deepest = 0.0;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const Vec centre = vec_in(sample.position, i);
        deepest = std::max(deepest, placed.deepest_overlap(centre, particles.radius[i]));
        placed.add(static_cast<std::int32_t>(i), centre, particles.radius[i]);
    }
    return deepest;
}

double overlap_of_beads(const Box& box, const Particles& particles, const Sample& sample) {
    double deepest = 0.0;
    for_each_two_neighbours(
        box, beads_along(sample, 0), [&](Eigen::Index left, Eigen::Index right, double apart) {
            const double contact = particles.radius[left] + particles.radius[right];
            if (contact > 0.0) deepest = std::max(deepest, 1.0 - apart / contact);
        });
    return deepest;
}

}  // namespace

double largest_relative_overlap(const Box& box, const Particles& particles, const Sample& sample) {
    if (particles.count() < 2) return 0.0;
    return box.dimension == 1   ? overlap_of_beads(box, particles, sample)
           : box.dimension == 2 ? overlap_beyond_a_line<2>(box, particles, sample)
                                : overlap_beyond_a_line<3>(box, particles, sample);
}

}  // namespace carom
