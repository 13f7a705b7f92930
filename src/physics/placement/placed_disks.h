// The disks already placed, and the test whether another one fits between them. Each disk is listed
// in all cells that it touches, so large and small ones are found in the same way.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/surfaces/barrier.h"

namespace carom {

/// Two disks do not count as overlapping if their overlap is at most this fraction of the sum of
/// their radii, because coordinates written in decimals touch only to within round-off.
inline constexpr double touching_tolerance = 1e-12;

class PlacedDisks {
  public:
    /// Creates an empty grid for disks of these radii.
    PlacedDisks(const Box& box, const Eigen::ArrayXd& radii);

    /// The particle of the lowest number that overlaps a disk at `centre`, if any does.
    std::optional<std::int32_t> overlapped(const Vec& centre, double radius) const;

    /// The surface of the box that a disk at `centre` overlaps, or lies in, if any.
    std::optional<std::int32_t> overlapped_surface(const Vec& centre, double radius) const {
        return surface_in_the_way(box_, barriers_, centre, radius);
    }

    /// Whether a disk at `centre` overlaps neither another disk nor a surface of the box.
    bool is_free(const Vec& centre, double radius) const;

    /// The relative depth to which a disk at `centre` would overlap others: the largest 1 -
    /// distance / (sum of radii), dimensionless; 0 if it overlaps none.
    double deepest_overlap(const Vec& centre, double radius) const;

    void add(std::int32_t particle, const Vec& centre, double radius);

    /// The number of distances calculated so far.
    std::int64_t compared() const { return compared_; }

  private:
    struct Disk {
        Vec centre;
        double radius;
        std::int32_t particle;
    };
    struct Entry {
        std::int32_t disk, next;
    };

    std::size_t list_of(int x, int y) const;
    template <typename Function>
    void for_each_cell(const Vec& centre, double radius, Function&& f) const;
    template <typename Function>
    void for_each_near(const Vec& centre, double radius, Function&& f) const;
    template <typename Function>
    void for_each_overlapping(const Vec& centre, double radius, Function&& f) const;

    Box box_;
    Eigen::Array2i cells_;
    Vec cell_size_;
    std::vector<std::int32_t> heads_;  ///< of lists of entries
    bool is_shared_ = false;           ///< whether several cells have one list
    std::vector<Entry> entries_;
    std::vector<Disk> disks_;
    std::vector<Barrier> barriers_;  ///< none in a box with plain walls, which have no disk beyond
    mutable std::int64_t compared_ = 0;
};

}  // namespace carom
