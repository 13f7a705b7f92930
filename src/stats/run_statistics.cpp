#include "stats/run_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "physics/mechanics.h"
#include "physics/placement/overlap.h"

namespace carom {
namespace {

// Particles looked at in all audits of a run: half a second or so, whatever its size.
constexpr double most_audited = 2e6;

std::optional<double> if_finite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::vector<std::optional<double>> components(const Eigen::ArrayXd& vector) {
    std::vector<std::optional<double>> result;
    for (const double value : vector) result.push_back(if_finite(value));
    return result;
}

std::int64_t audit_interval(double particles, double samples) {
    return std::max<std::int64_t>(
        1, static_cast<std::int64_t>(std::ceil(particles * samples / most_audited)));
}

}  // namespace

RunStatistics::RunStatistics(const Box& box, const Particles& particles, int species,
                             std::int64_t samples)
    : box_(box),
      particles_(particles),
      samples_between_audits_(
          audit_interval(static_cast<double>(particles.count()), static_cast<double>(samples))),
      sums_(static_cast<std::size_t>(species)),
      counts_(static_cast<std::size_t>(species)),
      pressure_(box) {
    for (const int s : particles.species) ++counts_[static_cast<std::size_t>(s)];
}

void RunStatistics::see(const Sample& sample, const ImpulseTotals& impulses,
                        std::span<const SurfaceState> surfaces) {
    pressure_.see(sample.time, impulses, surfaces);
    const Eigen::ArrayXd speed = speeds(sample);
    const Eigen::ArrayXd energy = kinetic_energies(particles_, sample);
    see_totals(sample, energy);
    see_species(speed, energy);
    speeds_.add(speed);
    energies_.add(energy);
    if (seen_ % samples_between_audits_ == 0) audit(sample);
    ++seen_;
    time_ = sample.time;
}

void RunStatistics::see_totals(const Sample& sample, const Eigen::ArrayXd& energies) {
    last_ = {energies.sum(), momentum(particles_, sample)};
    if (seen_ == 0) {
        first_ = last_;
        worked_on_ = infinite_mass_moves(particles_, sample);
    }
    if (first_.energy > 0.0)
        largest_energy_error_ =
            std::max(largest_energy_error_, std::abs(last_.energy - first_.energy) / first_.energy);
    const ThermalMotion motion = thermal_motion(box_, particles_, sample);
    thermal_energy_ += motion.energy;
    degrees_of_freedom_ = motion.degrees_of_freedom;
}

// Each sample is added up by itself: a sum of millions of terms would lose digits.
void RunStatistics::see_species(const Eigen::ArrayXd& speeds, const Eigen::ArrayXd& energies) {
    std::vector<Sums> here(sums_.size());
    for (Eigen::Index i = 0; i < particles_.count(); ++i) {
        Sums& sums = here[static_cast<std::size_t>(particles_.species[i])];
        sums.energy += energies[i];
        sums.speed += speeds[i];
    }
    for (std::size_t s = 0; s < sums_.size(); ++s) {
        sums_[s].energy += here[s].energy;
        sums_[s].speed += here[s].speed;
    }
}

void RunStatistics::audit(const Sample& sample) {
    largest_overlap_ =
        std::max(largest_overlap_, largest_relative_overlap(box_, particles_, sample));
}

std::vector<SpeciesMeans> RunStatistics::species_means() const {
    std::vector<SpeciesMeans> means;
    for (std::size_t s = 0; s < sums_.size(); ++s) {
        const double values = static_cast<double>(counts_[s]) * static_cast<double>(seen_);
        means.push_back(
            {counts_[s], if_finite(sums_[s].energy / values), if_finite(sums_[s].speed / values)});
    }
    return means;
}

RunSummary RunStatistics::summary(const AdvanceResult& advanced) const {
    const double thermal = thermal_energy_ / static_cast<double>(seen_);
    RunSummary summary;
    summary.energy_initial = if_finite(first_.energy);
    summary.energy_final = if_finite(last_.energy);
    const bool plain = advanced.surfaces.empty();
    if (!worked_on_ && plain) summary.largest_energy_error = if_finite(largest_energy_error_);
    summary.momentum_initial = components(first_.momentum);
    summary.momentum_final = components(last_.momentum);
    summary.largest_overlap = std::max(largest_overlap_, advanced.impulses.largest_overlap);
    if (const auto& start = pressure_.start()) {
        summary.wall_pressure =
            wall_pressure(box_, start->since(advanced.impulses), time_ - start->time);
        if (summary.wall_pressure) summary.pressure_since = start->time;
    }
    if (!worked_on_ && plain)
        summary.virial_pressure =
            virial_pressure(box_, particles_, thermal, advanced.impulses, time_);
    summary.temperature = if_finite(ThermalMotion{thermal, degrees_of_freedom_}.temperature());
    summary.species = species_means();
    summary.speeds = speeds_.counts();
    summary.energies = energies_.counts();
    return summary;
}

}  // namespace carom
