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
#include "physics/placement/placed_disks.h"

namespace carom {
namespace {

double overlap_of_two(const Box& box, const Particles& particles, const Sample& sample,
                      Eigen::Index i, Eigen::Index j) {
    const double x = sample.position(j, 0) - sample.position(i, 0),
                 y = sample.position(j, 1) - sample.position(i, 1);
    const double contact = particles.radius[i] + particles.radius[j];
    const bool is_nearest = std::abs(x) < 0.25 * box.size[0] && std::abs(y) < 0.25 * box.size[1];
    const double squared = is_nearest ? x * x + y * y : square(box.nearest({x, y}));
    return squared < contact * contact ? 1.0 - std::sqrt(squared) / contact : 0.0;
}

// A grid with cells at least as wide as the largest disk, for gases in which no cell has to hold
// many disks: each disk is compared with those in the cells around its centre. Cells are processed
// in order, so that disks close to each other in the box are also close in the processor's caches.
class DisksInCells {
  public:
    /// Whether the grid suits these disks, that is, none is much larger than the others.
    static bool suits(const Box& box, const Particles& particles) {
        const double across = 2.0 * particles.radius.maxCoeff();
        const double room = box.size[0] * box.size[1];
        constexpr double most_in_cell = 4.0;
        return across > 0.0 &&
               across * across * static_cast<double>(particles.count()) < most_in_cell * room;
    }

    DisksInCells(const Box& box, const Particles& particles, const Sample& sample)
        : box_(box), particles_(particles), sample_(sample) {
        constexpr double beyond_rounding = 1.0 + 1e-9;  // margin for rounding to cells
        const double across = 2.0 * particles.radius.maxCoeff() * beyond_rounding;
        const double one_each =
            std::sqrt(box.size[0] * box.size[1] / static_cast<double>(particles.count()));
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            cells_[axis] = std::max(
                1, static_cast<int>(std::floor(box.size[axis] / std::max(across, one_each))));
            per_length_[axis] = cells_[axis] / box.size[axis];
        }
        sort();
    }

    double deepest_overlap() const {
        double deepest = 0.0;
        for (int y = 0; y < cells_[1]; ++y)
            for (int x = 0; x < cells_[0]; ++x) deepest = std::max(deepest, deepest_at(x, y));
        return deepest;
    }

  private:
    std::size_t cell_of(Eigen::Index i) const {
        const auto along = [&](Eigen::Index axis) {
            const double place = sample_.position(i, axis) * per_length_[axis];
            return static_cast<std::size_t>(std::clamp(place, 0.0, cells_[axis] - 1.0));
        };
        return number_of(along(0), along(1));
    }
    std::size_t number_of(std::size_t x, std::size_t y) const {
        return y * static_cast<std::size_t>(cells_[0]) + x;
    }

    // Counting sort by cell.
    void sort() {
        const auto all = static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]);
        begins_.assign(all + 1, 0);
        disks_.resize(static_cast<std::size_t>(particles_.count()));
        for (Eigen::Index i = 0; i < particles_.count(); ++i) ++begins_[cell_of(i)];
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        for (Eigen::Index i = particles_.count(); i-- > 0;)
            disks_[static_cast<std::size_t>(--begins_[cell_of(i)])] = static_cast<std::int32_t>(i);
    }

    // The disks in consecutive cells of a row.
    std::span<const std::int32_t> in_cells(std::size_t first, std::size_t last) const {
        const auto begin = static_cast<std::size_t>(begins_[first]),
                   end = static_cast<std::size_t>(begins_[last + 1]);
        return {disks_.data() + begin, end - begin};
    }

    double deepest_between(std::span<const std::int32_t> some,
                           std::span<const std::int32_t> others) const {
        double deepest = 0.0;
        for (const std::int32_t i : some)
            for (const std::int32_t j : others)
                if (i != j)
                    deepest = std::max(deepest, overlap_of_two(box_, particles_, sample_, i, j));
        return deepest;
    }

    // Of two adjacent cells only one is compared with the other; inside the box three cells of a
    // row are examined at once.
    double deepest_at(int x, int y) const {
        const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
        const std::size_t cell = number_of(column, row);
        const auto here = in_cells(cell, cell);
        if (x > 0 && x + 1 < cells_[0] && y + 1 < cells_[1]) {
            const std::size_t above = number_of(column, row + 1);
            return std::max(deepest_between(here, in_cells(cell, cell + 1)),
                            deepest_between(here, in_cells(above - 1, above + 1)));
        }
        constexpr std::array<std::array<int, 2>, 5> around{
            {{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
        double deepest = 0.0;
        for (const auto& [right, up] : around) {
            const auto its_column = other(0, x + right), its_row = other(1, y + up);
            if (!its_column || !its_row) continue;
            const std::size_t near = number_of(*its_column, *its_row);
            deepest = std::max(deepest, deepest_between(here, in_cells(near, near)));
        }
        return deepest;
    }

    // Wraps the index of a column or row on a periodic axis; nothing beyond a wall.
    std::optional<std::size_t> other(Eigen::Index axis, int at) const {
        if (at >= 0 && at < cells_[axis]) return static_cast<std::size_t>(at);
        if (!box_.is_periodic(axis)) return std::nullopt;
        return static_cast<std::size_t>(at < 0 ? at + cells_[axis] : at - cells_[axis]);
    }

    const Box& box_;
    const Particles& particles_;
    const Sample& sample_;
    Eigen::Array2i cells_;
    Vec per_length_;
    std::vector<std::int32_t> begins_;  ///< first index in disks_ for each cell, and the end of the
                                        ///< last cell
    std::vector<std::int32_t> disks_;   ///< sorted by cell
};

double overlap_of_disks(const Box& box, const Particles& particles, const Sample& sample) {
    if (DisksInCells::suits(box, particles))
        return DisksInCells(box, particles, sample).deepest_overlap();
    PlacedDisks placed(box, particles.radius);
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
    return box.dimension == 1 ? overlap_of_beads(box, particles, sample)
                              : overlap_of_disks(box, particles, sample);
}

}  // namespace carom
