// Averages over time of the speeds and energies of particles, and of their temperature: exact, from
// the flights between collisions, not from samples.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "physics/box.h"
#include "physics/membership.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"

namespace carom {

class TimeAverages {
  public:
    /// For a gas with `species` species. `velocity_changes` as for Paths.
    TimeAverages(const Box& box, const Particles& particles, int species,
                 std::vector<double> velocity_changes);

    /// Whether see() needs positions and velocities; if not, after the first call the time of the
    /// sample and its membership are enough where this is the same object as before.
    bool needs_samples() const { return needs_samples_; }

    /// Takes the next sample. Samples must come in order of time, each with all collisions since
    /// the previous one.
    void see(const Sample& sample, std::span<const Collision> collisions);

    /// The averages over the time since the first sample, which must be longer than 0.
    struct Values {
        std::vector<double> energy, speed;  ///< by species, over its particles at each time;
                                            ///< particles of infinite mass have no energy
        double temperature;                 ///< as in ThermalMotion; NaN if nothing can move
    };
    Values averages() const;

  private:
    /// Integrals over time, by species, of what exceeds the first sample: what never changes has an
    /// exact mean.
    struct Integrals {
        std::vector<double> energy, speed;
    };
    /// Integrals over time of what changes only with the membership: the numbers of particles by
    /// species, what they had in the first sample, and the degrees of freedom.
    struct Times {
        std::vector<double> counts = {}, energy = {}, speed = {};
        double freedom = 0.0;
    };
    void add(const PathPiece& piece, Integrals& to) const;
    void begin(const Sample& sample);
    void look_for_drift(const Sample& sample);
    void count();
    void add_times_until(double time, Times& to) const;

    int dimension_;
    Particles particles_;
    MembershipWatch membership_;
    Eigen::ArrayXi species_;  ///< at present; -1: absent
    bool needs_samples_;
    Paths paths_;
    std::array<bool, 3> is_conserved_{};         ///< momentum along an axis
    double mass_ = 0.0;                          ///< of all present, if momentum is conserved
    double freedom_ = 0.0;                       ///< degrees of freedom
    std::vector<double> counts_;                 ///< of particles, by species
    Times before_;                               ///< until `since_`
    double since_ = 0.0;                         ///< when the membership changed last
    Eigen::ArrayXd first_energy_, first_speed_;  ///< of each particle, in the first sample
    Integrals integrals_;
    double drift_ = 0.0, drift_integral_ = 0.0;  ///< energy of the motion of the whole gas
    double start_ = 0.0, time_ = 0.0;
    bool is_first_ = true;
};

}  // namespace carom
