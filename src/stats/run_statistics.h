// Statistics of a whole run from its samples: means over time, histograms, and how well the
// conserved quantities and the hardness of the particles were preserved. Memory does not grow with
// the number of samples.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/box.h"
#include "physics/mechanics.h"
#include "physics/membership.h"
#include "physics/particles.h"
#include "physics/simulation.h"
#include "stats/growing_histogram.h"
#include "stats/pressure.h"
#include "util/exact_sum.h"

namespace carom {

/// Means over the particles that one species has at each time and the samples; of a run, over time.
struct SpeciesMeans {
    std::int64_t count = 0;        ///< at the start
    std::optional<double> energy;  ///< none with an infinite mass that moves
    std::optional<double> speed;
};

/// Quantities that have no meaning for this gas are absent: the energy with a moving infinite mass,
/// the pressure on walls if there are none; where surfaces act, the error of the energy of the gas
/// alone, and pressures that hold only for a gas of uniform density.
struct RunSummary {
    std::optional<double> energy_initial, energy_final;
    std::optional<double> largest_energy_error;  ///< over the samples, relative to the initial
                                                 ///< energy; 0 when that is 0
    std::vector<std::optional<double>> momentum_initial, momentum_final;  ///< by axis
    double largest_overlap = 0.0;  ///< at collisions and in samples (of large gases only in some
                                   ///< samples), in units of the contact distance
    std::optional<double> pressure_since;   ///< start of the measurement of `wall_pressure`
    std::optional<double> wall_pressure;    ///< over the time since which the gas has had a single
                                            ///< pressure; a force in 1-D
    std::optional<double> virial_pressure;  ///< from time 0 to the end
    std::optional<double> temperature;      ///< mean over the samples (ThermalMotion)
    std::vector<SpeciesMeans> species;
    BinnedCounts speeds, energies;  ///< of all particles in all samples
};

/// Sums over the particles of a sample are exact and rounded only once: they do not depend on
/// whether a sample was given whole or by its changes.
class RunStatistics {
  public:
    /// For a run of about `samples` samples with `species` species. The particles must outlive this
    /// object.
    RunStatistics(const Box& box, const Particles& particles, int species, std::int64_t samples);

    /// Takes the next sample in order of time, and what has happened until then.
    void see(const Sample& sample, const AdvanceResult& advanced = {});

    /// The same as see() in separate steps. First, if wants_positions(), the positions of the
    /// sample, which are checked for overlaps; its velocities may be missing.
    bool wants_positions(const AdvanceResult& advanced) const;
    void see_positions(const Sample& sample, const AdvanceResult& advanced);

    /// Then its velocities; the positions may be missing. With `is_followed`, the next sample may
    /// be given by its velocity changes (see_changes()).
    void see_velocities(const Sample& sample, const AdvanceResult& advanced, bool is_followed);

    /// Alternatively, the time and the membership of a sample, with all velocities that differ from
    /// the previous one, which must have been given with `is_followed` or by see_changes() itself.
    /// Returns false, and ignores the sample, if it must be given whole by see_velocities(): the
    /// energy of the drift is too large a part of the kinetic energy to be subtracted accurately,
    /// or the membership has changed.
    bool see_changes(const Sample& sample, std::span<const VelocityChange> changes,
                     const AdvanceResult& advanced);

    /// Takes an event of the run between samples, at which partitions may open.
    void see_event(double time, const AdvanceResult& advanced) {
        pressure_.see(time, advanced.impulses, advanced.surfaces);
    }

    /// The statistics of all samples seen. Requires at least one sample; the last one must be at
    /// the end of `advanced`, which gives the impulses since time 0.
    RunSummary summary(const AdvanceResult& advanced) const;

  private:
    /// Sums over the samples, for one species.
    struct Sums {
        double energy = 0.0, speed = 0.0;
    };
    /// Sums over the particles of one species in the present sample.
    struct Tally {
        ExactSum energy, speed;
    };
    /// Some of the particles, to be added to the sums: one entry for each.
    struct Bodies;
    struct Totals {
        double energy = 0.0;
        Eigen::ArrayXd momentum;
    };
    void tally(const Sample& sample, bool is_followed);
    template <bool is_added>
    void tally(const Bodies& bodies);
    void count(const Sample& sample);
    std::optional<ThermalMotion> present_motion() const;
    void finish(double time, const ThermalMotion& motion, const AdvanceResult& advanced);
    std::vector<SpeciesMeans> species_means() const;

    Box box_;
    const Particles& particles_;
    MembershipWatch membership_;
    bool some_are_absent_ = false;
    std::int64_t samples_between_audits_;
    std::int64_t seen_ = 0;
    std::int64_t audited_ = 0;              ///< samples whose positions were seen
    std::int64_t collisions_at_audit_ = 0;  ///< number of collisions at the last of these
    double time_ = 0.0;                     ///< of the last sample
    bool worked_on_ = false;                ///< an infinite mass moves
    bool is_followed_ = false;              ///< the next sample may be given by its changes
    std::vector<Tally> tallies_;            ///< by species
    std::array<ExactSum, 3> momentum_;      ///< by axis
    double mass_ = 0.0;                     ///< of all that are present
    std::array<bool, 3> is_conserved_{};    ///< momentum along an axis
    Totals first_, last_;
    double largest_energy_error_ = 0.0;
    double largest_overlap_ = 0.0;
    double thermal_energy_ = 0.0;      ///< summed over the samples
    double degrees_of_freedom_ = 0.0;  ///< sharing this energy, in the present sample
    double all_degrees_ = 0.0;         ///< summed over the samples
    std::vector<Sums> sums_;           ///< by species, over its particles and the samples
    std::vector<std::int64_t> counts_, first_counts_;  ///< by species, at present and at the start
    std::vector<std::int64_t> all_counts_;             ///< by species, summed over the samples
    GrowingHistogram speeds_, energies_;
    PressureWatch pressure_;
};

}  // namespace carom
