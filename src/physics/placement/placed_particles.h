// The disks or spheres already placed, and the test whether another one fits between them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/surfaces/barrier.h"
#include "util/memory/large_pages.h"

namespace carom {

/// Two particles do not count as overlapping if their overlap is at most this fraction of the sum
/// of their radii, because coordinates written in decimals touch only to within round-off.
inline constexpr double touching_tolerance = 1e-12;

/// In a box of this dimension, 2 or 3.
template <int dimension>
class PlacedParticles {
  public:
    /// Creates an empty grid for particles of these radii.
    PlacedParticles(const Box& box, const Eigen::ArrayXd& radii);

    /// The particle of the lowest number that overlaps one at `centre`, if any does.
    std::optional<std::int32_t> overlapped(const Vec& centre, double radius) const;

    /// The surface of the box that a particle at `centre` overlaps, or lies in, if any.
    std::optional<std::int32_t> overlapped_surface(const Vec& centre, double radius) const {
        return barriers_.surface_in_the_way(box_, centre, radius);
    }

    /// Whether a particle at `centre` overlaps neither another one nor a surface of the box.
    bool is_free(const Vec& centre, double radius) const;

    /// The relative depth to which a particle at `centre` would overlap others: the largest 1 -
    /// distance / (sum of radii), dimensionless; 0 if it overlaps none.
    double deepest_overlap(const Vec& centre, double radius) const;

    void add(std::int32_t particle, const Vec& centre, double radius);

    /// The number of distances calculated so far.
    std::int64_t compared() const { return compared_; }

  private:
    using Cell = std::array<int, dimension>;

    struct Entry {
        Vec centre;
        double radius;
        std::int32_t particle, next;
    };

    std::size_t list_of(const Cell& cell) const;
    template <typename Function>
    void for_each_list(const Vec& centre, double radius, Function&& f) const;
    template <typename Function>
    bool visit(std::size_t list, const Vec& centre, Function&& f) const;
    template <typename Function>
    void for_each_near(const Vec& centre, double radius, Function&& f) const;
    template <typename Function>
    void for_each_overlapping(const Vec& centre, double radius, Function&& f) const;

    Box box_;
    Cell cells_{};
    Vec cell_size_;
    double reach_ = 0.0;               ///< how far particles extend from the cells that list them
    LargeVector<std::int32_t> heads_;  ///< of lists of entries
    bool is_shared_ = false;           ///< whether several cells have one list
    LargeVector<Entry> entries_;
    InitialBarriers barriers_;  ///< none in a box with plain walls, which have nothing beyond
    mutable std::int64_t compared_ = 0;
};

}  // namespace carom
