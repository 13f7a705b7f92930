// Finds the pairs of particles that are near each other.
#pragma once

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <span>
#include <vector>

#include "physics/box.h"

namespace carom {

/// A cell list of the particles of a box: pairs nearer than a distance are found among neighbouring
/// cells.
class NearPairs {
  public:
    /// `positions` are N x dimension.
    NearPairs(const Box& box, const Eigen::ArrayXXd& positions, double distance);

    /// Calls `see(i, j)` once for each pair i < j whose nearest images may be within the distance:
    /// for all pairs that are, and for some that are not.
    void for_each(std::invocable<Eigen::Index, Eigen::Index> auto&& see) const {
        for (int cell = 0; cell < count_.prod(); ++cell) {
            const std::vector<int> near = around(cell);
            for (const Eigen::Index i : members(cell))
                for (const int other : near)
                    for (const Eigen::Index j : members(other))
                        if (j > i) see(i, j);
        }
    }

  private:
    std::span<const Eigen::Index> members(int cell) const {
        const auto k = static_cast<std::size_t>(cell);
        return std::span(order_).subspan(begin_[k], begin_[k + 1] - begin_[k]);
    }
    std::vector<int> around(int cell) const;

    Eigen::Array3i count_{1, 1, 1};
    std::array<bool, 3> is_periodic_{};
    std::vector<std::size_t> begin_;   ///< index in `order_` of the first particle of each cell
    std::vector<Eigen::Index> order_;  ///< particles sorted by cell
};

}  // namespace carom
