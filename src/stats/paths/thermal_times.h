// Temperatures of groups of particles, or of the particles in parts of a box, averaged over time.
// The times of residence are exact, computed from the flights between collisions, not from samples.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "physics/box.h"
#include "physics/membership.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"
#include "stats/paths/stays.h"

namespace carom {

/// The particles whose temperature is measured.
struct ThermalPart {
    std::vector<Eigen::Index> members = {};  ///< indices in ascending order
    std::optional<Region> region = {};       ///< the region in which they count; none: anywhere
};

/// Integrals over time since the first sample: of the kinetic energy, and of half of the degrees of
/// freedom that share it, both as defined by ThermalMotion.
struct ThermalIntegrals {
    double energy = 0.0, half_freedom = 0.0;
};

class ThermalTimes {
  public:
    ThermalTimes(const Box& box, const Particles& particles, std::vector<ThermalPart> parts,
                 std::vector<double> velocity_changes);

    /// Changes which particles a part has, from the last sample seen on.
    void choose(std::size_t part, std::vector<Eigen::Index> members);

    /// Takes the next sample. Samples must come in order of time, each with all collisions since
    /// the previous one. Returns the integrals of each part.
    const std::vector<ThermalIntegrals>& see(const Sample& sample,
                                             std::span<const Collision> collisions);

    /// The same quantities at the moment of a sample, not integrated over time.
    std::vector<ThermalIntegrals> moment(const Sample& sample);

  private:
    void look_for_drift(const Sample& sample);
    bool is_conserved(Eigen::Index axis) const {
        return is_conserved_[static_cast<std::size_t>(axis)];
    }
    double half_freedom(Eigen::Index particle) const;
    void fly(const PathPiece& piece);
    void add(const PathPiece& piece, std::size_t part);
    void add_stay(const PathPiece& piece, double from, double to, ThermalIntegrals& into) const;

    Box box_;
    Particles particles_;
    std::vector<ThermalPart> parts_;
    std::vector<std::vector<bool>> is_member_;  ///< for each part, one flag for each particle
    Paths paths_;
    std::array<bool, 3> is_conserved_{};  ///< momentum along an axis
    Vec drift_ = {};                      ///< of the centre of mass, along conserved axes
    MembershipWatch membership_;
    bool some_are_absent_ = false;
    double mass_ = 0.0;  ///< of all that are present; 0 if the gas has infinite masses
    std::vector<ThermalIntegrals> integrals_;
    std::vector<Stay> stays_;  ///< scratch
};

}  // namespace carom
