// Temperatures of particles, or of those in parts of a box, averaged over time: by exact times of
// residence, from flights between collisions. Nothing is sampled.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"

namespace carom {

/// Whose temperature it is.
struct ThermalPart {
    std::vector<Eigen::Index> members = {};  ///< rising
    std::optional<Region> region = {};       ///< where they are while they count; none: anywhere
};

/// Integrals over time since the first sample: of the kinetic energy and of half of the degrees of
/// freedom that share it, as ThermalMotion counts them.
struct ThermalIntegrals {
    double energy = 0.0, half_freedom = 0.0;
};

class ThermalTimes {
  public:
    ThermalTimes(const Box& box, const Particles& particles, std::vector<ThermalPart> parts,
                 std::vector<double> velocity_changes);

    /// Samples in order of time, with all collisions on the way from the one before. Of each part.
    const std::vector<ThermalIntegrals>& see(const Sample& sample,
                                             std::span<const Collision> collisions);

    /// The same of a moment, not integrated.
    std::vector<ThermalIntegrals> moment(const Sample& sample);

  private:
    void look_for_drift(const Sample& sample);
    bool is_conserved(Eigen::Index axis) const {
        return is_conserved_[static_cast<std::size_t>(axis)];
    }
    double half_freedom(Eigen::Index particle) const;
    bool is_in(const Eigen::Array2d& place, const ThermalPart& part) const;
    void fly(const PathPiece& piece);
    void add(const PathPiece& piece, std::size_t part);
    void add_stay(const PathPiece& piece, double from, double to, ThermalIntegrals& into) const;
    void add_crossings(const PathPiece& piece, int axis, double edge);

    Box box_;
    Particles particles_;
    std::vector<ThermalPart> parts_;
    std::vector<std::vector<bool>> is_member_;  ///< of each part
    Paths paths_;
    std::array<bool, 2> is_conserved_{};  ///< momentum along an axis
    Eigen::Array2d drift_{0.0, 0.0};      ///< of the centre of mass, where it is conserved
    double mass_ = 0.0;                   ///< of the whole gas; infinite ones: 0
    std::vector<ThermalIntegrals> integrals_;
    std::vector<double> times_;  ///< scratch
};

}  // namespace carom
