// What a whole run was like, from its samples: means over time, histograms, and how well the
// conserved quantities and the hardness of the particles were kept. Memory does not grow with the
// number of samples.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/simulation.h"
#include "stats/growing_histogram.h"
#include "stats/pressure.h"

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

class RunStatistics {
  public:
    /// For a run of about `samples` samples; `species` is the number of species.
    RunStatistics(const Box& box, const Particles& particles, int species, std::int64_t samples);

    /// The next sample in order of time, with the impulses by then and the surfaces of a box that
    /// has any.
    void see(const Sample& sample, const ImpulseTotals& impulses = {},
             std::span<const SurfaceState> surfaces = {});

    /// The statistics of all samples seen, at least one, the last of them at the end of the
    /// `advanced`, which gives the impulses since time 0.
    RunSummary summary(const AdvanceResult& advanced) const;

  private:
    struct Sums {
        double energy = 0.0, speed = 0.0;
    };
    struct Totals {
        double energy = 0.0;
        Eigen::ArrayXd momentum;
    };
    void see_totals(const Sample& sample, const Eigen::ArrayXd& energies);
    void see_species(const Eigen::ArrayXd& speeds, const Eigen::ArrayXd& energies);
    void audit(const Sample& sample);
    std::vector<SpeciesMeans> species_means() const;

    Box box_;
    Particles particles_;
    std::int64_t samples_between_audits_;
    std::int64_t seen_ = 0;
    double time_ = 0.0;       ///< of the last sample
    bool worked_on_ = false;  ///< an infinite mass moves
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
