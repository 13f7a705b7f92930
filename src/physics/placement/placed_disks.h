// Disks that have found their places, and the question whether a further one fits between them.
// Each disk is listed in all cells that it touches, so large and small ones are found alike.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/gas.h"
#include "physics/surfaces/barrier.h"

namespace carom {

/// Two disks count as apart when their distance is short of touching by no more than this part of
/// the sum of their radii: coordinates written in decimals touch only to within round-off.
inline constexpr double touching_tolerance = 1e-12;

class PlacedDisks {
  public:
    /// Room for disks of these radii.
    PlacedDisks(const Box& box, const Eigen::ArrayXd& radii);

    /// The particle of the lowest number that overlaps a disk at `centre`, if any does.
    std::optional<std::int32_t> overlapped(const Eigen::Array2d& centre, double radius) const;

    /// The surface of the box that a disk at `centre` overlaps, or lies in, if any.
    std::optional<std::int32_t> overlapped_surface(const Eigen::Array2d& centre,
                                                   double radius) const {
        return surface_in_the_way(box_, barriers_, centre, radius);
    }

    /// Whether a disk at `centre` overlaps none, and no surface of the box.
    bool is_free(const Eigen::Array2d& centre, double radius) const;

    /// How deep a disk at `centre` would lie in another: the largest 1 - distance / (sum of radii),
    /// dimensionless; 0 if it overlaps none.
    double deepest_overlap(const Eigen::Array2d& centre, double radius) const;

    void add(std::int32_t particle, const Eigen::Array2d& centre, double radius);

    /// How many distances the questions so far have cost.
    std::int64_t compared() const { return compared_; }

  private:
    struct Disk {
        Eigen::Array2d centre;
        double radius;
        std::int32_t particle;
    };
    struct Entry {
        std::int32_t disk, next;
    };

    std::size_t list_of(int x, int y) const;
    template <typename Function>
    void for_each_cell(const Eigen::Array2d& centre, double radius, Function&& f) const;
    template <typename Function>
    void for_each_near(const Eigen::Array2d& centre, double radius, Function&& f) const;
    template <typename Function>
    void for_each_overlapping(const Eigen::Array2d& centre, double radius, Function&& f) const;

    Box box_;
    Eigen::Array2i cells_;
    Eigen::Array2d cell_size_;
    std::vector<std::int32_t> heads_;  ///< of lists of entries
    bool is_shared_ = false;           ///< whether several cells have one list
    std::vector<Entry> entries_;
    std::vector<Disk> disks_;
    std::vector<Barrier> barriers_;  ///< none in a box with plain walls, which have no disk beyond
    mutable std::int64_t compared_ = 0;
};

}  // namespace carom
