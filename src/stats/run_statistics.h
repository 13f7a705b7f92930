// What a whole run was like, from its samples: means over time, histograms, and how well the
// conserved quantities and the hardness of the particles were kept. Memory does not grow with the
// number of samples.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/particles.h"
#include "physics/simulation.h"
#include "stats/growing_histogram.h"
#include "stats/pressure.h"
#include "util/exact_sum.h"

namespace carom {

/// One species: means over its particles and the samples.
struct SpeciesMeans {
    std::int64_t count = 0;
    std::optional<double> energy;  ///< nothing for an infinite mass that moves
    std::optional<double> speed;
};

/// Numbers without a meaning for this gas are absent: the energy with a moving infinite mass, the
/// pressure on walls that are not there; where surfaces act, the error of the energy of the gas
/// alone, and pressures that hold for a gas of one density only.
struct RunSummary {
    std::optional<double> energy_initial, energy_final;
    std::optional<double> largest_energy_error;  ///< over the samples, relative to the initial
                                                 ///< energy; 0 when that is 0
    std::vector<std::optional<double>> momentum_initial, momentum_final;  ///< by axis
    double largest_overlap = 0.0;           ///< at collisions and in samples (in large gases not in
                                            ///< all of them), in units of the contact distance
    std::optional<double> pressure_since;   ///< when its measurement begins
    std::optional<double> wall_pressure;    ///< from when on the gas has had one
                                            ///< pressure; a force in 1-D
    std::optional<double> virial_pressure;  ///< from time 0 to the end
    std::optional<double> temperature;      ///< mean over the samples (ThermalMotion)
    std::vector<SpeciesMeans> species;
    BinnedCounts speeds, energies;  ///< of all particles in all samples
};

/// Sums over the particles of a sample are exact, rounded once: they are the same however a sample
/// was given.
class RunStatistics {
  public:
    /// For a run of about `samples` samples; `species` is the number of species. The particles must
    /// outlive it.
    RunStatistics(const Box& box, const Particles& particles, int species, std::int64_t samples);

    /// The next sample in order of time, and what happened by then.
    void see(const Sample& sample, const AdvanceResult& advanced = {});

    /// The same in parts. First, if they are wanted, the positions of the sample, which are looked
    /// at for overlaps; no velocities need be there.
    bool wants_positions(const AdvanceResult& advanced) const;
    void see_positions(const Sample& sample, const AdvanceResult& advanced);

    /// Then its velocities; no positions need be there. With `is_followed` the next ones may be
    /// given by their changes.
    void see_velocities(const Sample& sample, const AdvanceResult& advanced, bool is_followed);

    /// Or of its velocities all that differ from the sample before, which was followed or seen so,
    /// too. False, and they are not seen, if they must be seen whole: the gas drifts faster than it
    /// is hot.
    bool see_changes(double time, std::span<const VelocityChange> changes,
                     const AdvanceResult& advanced);

    /// The statistics of all samples seen, at least one, the last of them at the end of the
    /// `advanced`, which gives the impulses since time 0.
    RunSummary summary(const AdvanceResult& advanced) const;

  private:
    /// Of one species, over the samples.
    struct Sums {
        double energy = 0.0, speed = 0.0;
    };
    /// Of one species in the present sample.
    struct Tally {
        ExactSum energy, speed;
    };
    /// Some particles, of which the sums are made: one entry for each.
    struct Bodies;
    struct Totals {
        double energy = 0.0;
        Eigen::ArrayXd momentum;
    };
    void tally(const Sample& sample, bool is_followed);
    template <bool is_added>
    void tally(const Bodies& bodies);
    std::optional<ThermalMotion> present_motion() const;
    void finish(double time, const ThermalMotion& motion, const AdvanceResult& advanced);
    std::vector<SpeciesMeans> species_means() const;

    Box box_;
    const Particles& particles_;
    std::int64_t samples_between_audits_;
    std::int64_t seen_ = 0;
    std::int64_t audited_ = 0;              ///< samples whose positions were seen
    std::int64_t collisions_at_audit_ = 0;  ///< that had happened by the last of these
    double time_ = 0.0;                     ///< of the last sample
    bool worked_on_ = false;                ///< an infinite mass moves
    bool is_followed_ = false;              ///< the last sample can be changed into the next
    std::vector<Tally> tallies_;            ///< by species
    std::array<ExactSum, 2> momentum_;      ///< by axis
    double mass_ = 0.0;                     ///< of all
    std::array<bool, 2> is_conserved_{};    ///< momentum along an axis
    Totals first_, last_;
    double largest_energy_error_ = 0.0;
    double largest_overlap_ = 0.0;
    double thermal_energy_ = 0.0;      ///< summed over the samples
    double degrees_of_freedom_ = 0.0;  ///< that share it, of one sample
    std::vector<Sums> sums_;           ///< by species, over its particles and the samples
    std::vector<std::int64_t> counts_;
    GrowingHistogram speeds_, energies_;
    PressureWatch pressure_;
};

}  // namespace carom
