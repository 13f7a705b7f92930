#include "stats/run_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "physics/mechanics.h"
#include "physics/placement/overlap.h"

namespace carom {
namespace {

// The number of particles checked for overlaps in a whole run: about half a second of work,
// whatever the size of the gas.
constexpr double most_audited = 2e6;

std::optional<double> if_finite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::vector<std::optional<double>> components(const Eigen::ArrayXd& vector) {
    std::vector<std::optional<double>> result;
    for (const double value : vector) result.push_back(if_finite(value));
    return result;
}

double largest_finite(const Eigen::ArrayXd& values) {
    double largest = 0.0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, value);
    return largest;
}

std::int64_t audit_interval(double particles, double samples) {
    return std::max<std::int64_t>(
        1, static_cast<std::int64_t>(std::ceil(particles * samples / most_audited)));
}

}  // namespace

struct RunStatistics::Bodies {
    Eigen::ArrayXd mass, speed, energy;
    Eigen::ArrayXi species;
    Eigen::ArrayXXd velocity;

    Eigen::Index count() const { return speed.size(); }

    // To be called once `velocity` and `species` are set; `inverse` are the inverse masses.
    void complete(const Eigen::Ref<const Eigen::ArrayXd>& inverse) {
        const Eigen::ArrayXd square = velocity.square().rowwise().sum();
        mass = 1.0 / inverse;
        speed = square.sqrt();
        energy = (square > 0.0).select(0.5 * square / inverse, 0.0);
    }
};

RunStatistics::RunStatistics(const Box& box, const Particles& particles, int species,
                             std::int64_t samples)
    : box_(box),
      particles_(particles),
      samples_between_audits_(
          audit_interval(static_cast<double>(particles.count()), static_cast<double>(samples))),
      tallies_(static_cast<std::size_t>(species)),
      sums_(static_cast<std::size_t>(species)),
      counts_(static_cast<std::size_t>(species)),
      all_counts_(static_cast<std::size_t>(species)),
      pressure_(box) {
    count({});
    first_counts_ = counts_;
}

// What depends on which particles are present, and on their species.
void RunStatistics::count(const Sample& sample) {
    const Eigen::ArrayXi& species = species_at(sample, particles_);
    some_are_absent_ = sample.membership && !sample.membership->is_present.all();
    counts_.assign(counts_.size(), 0);
    ExactSum mass;
    double movable = 0.0;
    for (Eigen::Index i = 0; i < particles_.count(); ++i) {
        if (!is_present(sample, i)) continue;
        ++counts_[static_cast<std::size_t>(species[i])];
        mass.add(1.0 / particles_.inverse_mass[i]);
        movable += particles_.inverse_mass[i] > 0.0;
    }
    mass_ = mass.value();
    degrees_of_freedom_ = box_.dimension * movable;
    for (int axis = 0; axis < box_.dimension; ++axis) {
        const bool is_conserved = mass_ > 0.0 && conserves_momentum(box_, particles_, axis);
        is_conserved_[static_cast<std::size_t>(axis)] = is_conserved;
        degrees_of_freedom_ -= is_conserved ? 1.0 : 0.0;
    }
}

void RunStatistics::see(const Sample& sample, const AdvanceResult& advanced) {
    if (wants_positions(advanced)) see_positions(sample, advanced);
    see_velocities(sample, advanced, false);
}

// In large gases positions are wanted again only after half of all particles have collided: until
// then a check would find nearly the same as before.
bool RunStatistics::wants_positions(const AdvanceResult& advanced) const {
    constexpr std::int64_t particles_a_collision = 4;
    if (audited_ == 0 || samples_between_audits_ == 1) return true;
    return seen_ % samples_between_audits_ == 0 &&
           particles_a_collision * (advanced.counts.particle - collisions_at_audit_) >=
               particles_.count();
}

void RunStatistics::see_positions(const Sample& sample, const AdvanceResult& advanced) {
    largest_overlap_ =
        std::max(largest_overlap_, largest_relative_overlap(box_, particles_, sample));
    collisions_at_audit_ = advanced.counts.particle;
    ++audited_;
}

void RunStatistics::see_velocities(const Sample& sample, const AdvanceResult& advanced,
                                   bool is_followed) {
    if (membership_.see(sample, particles_)) count(sample);
    tally(sample, is_followed);
    if (seen_ == 0) worked_on_ = infinite_mass_moves(particles_, sample);
    const std::optional<ThermalMotion> motion = present_motion();
    finish(sample.time, motion ? *motion : thermal_motion(box_, particles_, sample), advanced);
}

bool RunStatistics::see_changes(const Sample& sample, std::span<const VelocityChange> changes,
                                const AdvanceResult& advanced) {
    const bool is_unchanged = sample.membership == membership_.last() && !some_are_absent_;
    if (!is_followed_ || !is_unchanged) return false;
    const Eigen::ArrayXi& species = species_at(sample, particles_);
    const auto count = static_cast<Eigen::Index>(changes.size());
    Bodies before, after;
    Eigen::ArrayXd inverse(count);
    before.species.resize(count);
    before.velocity.resize(count, box_.dimension);
    after.velocity.resize(count, box_.dimension);
    for (Eigen::Index k = 0; k < count; ++k) {
        const VelocityChange& change = changes[static_cast<std::size_t>(k)];
        inverse[k] = particles_.inverse_mass[change.particle];
        before.species[k] = species[change.particle];
        for (int axis = 0; axis < box_.dimension; ++axis) {
            before.velocity(k, axis) = change.before[static_cast<std::size_t>(axis)];
            after.velocity(k, axis) = change.after[static_cast<std::size_t>(axis)];
        }
    }
    after.species = before.species;
    before.complete(inverse);
    after.complete(inverse);
    tally<false>(before);
    tally<true>(after);
    speeds_.make_room(largest_finite(after.speed));
    energies_.make_room(largest_finite(after.energy));
    speeds_.replace(before.speed, after.speed);
    energies_.replace(before.energy, after.energy);
    const std::optional<ThermalMotion> motion = present_motion();
    if (!motion) return false;
    finish(sample.time, *motion, advanced);
    return true;
}

// Recomputes the sums from all particles, in blocks that fit the processor's caches.
void RunStatistics::tally(const Sample& sample, bool is_followed) {
    if (is_followed_) {
        speeds_.hold_none();
        energies_.hold_none();
    }
    is_followed_ = is_followed;
    tallies_.assign(tallies_.size(), {});
    momentum_ = {};
    constexpr Eigen::Index in_block = 2048;
    const Eigen::ArrayXi& species = species_at(sample, particles_);
    const auto for_each_block = [&](const auto& see) {
        Bodies block;
        for (Eigen::Index first = 0; first < particles_.count(); first += in_block) {
            const Eigen::Index size = std::min(in_block, particles_.count() - first);
            if (some_are_absent_) {
                std::vector<Eigen::Index> there;
                for (Eigen::Index i = first; i < first + size; ++i)
                    if (is_present(sample, i)) there.push_back(i);
                block.species = species(there);
                block.velocity = sample.velocity(there, Eigen::all);
                block.complete(particles_.inverse_mass(there));
            } else {
                block.species = species.segment(first, size);
                block.velocity = sample.velocity.middleRows(first, size);
                block.complete(particles_.inverse_mass.segment(first, size));
            }
            see(block);
        }
    };
    double fastest = 0.0, most_energy = 0.0;
    for_each_block([&](const Bodies& block) {
        fastest = std::max(fastest, largest_finite(block.speed));
        most_energy = std::max(most_energy, largest_finite(block.energy));
    });
    speeds_.make_room(fastest);
    energies_.make_room(most_energy);
    for_each_block([&](const Bodies& block) {
        tally<true>(block);
        if (is_followed) {
            speeds_.hold(block.speed);
            energies_.hold(block.energy);
        } else {
            speeds_.add(block.speed);
            energies_.add(block.energy);
        }
    });
}

template <bool is_added>
void RunStatistics::tally(const Bodies& bodies) {
    const auto put = [](ExactSum& sum, double term) {
        if constexpr (is_added)
            sum.add(term);
        else
            sum.subtract(term);
    };
    for (Eigen::Index k = 0; k < bodies.count(); ++k) {
        Tally& its = tallies_[static_cast<std::size_t>(bodies.species[k])];
        put(its.energy, bodies.energy[k]);
        put(its.speed, bodies.speed[k]);
        for (Eigen::Index axis = 0; axis < bodies.velocity.cols(); ++axis) {
            const double v = bodies.velocity(k, axis);
            if (v != 0.0) put(momentum_[static_cast<std::size_t>(axis)], bodies.mass[k] * v);
        }
    }
}

// Like thermal_motion(), computed from the sums of the present sample: the kinetic energy less that
// of the drift. None if the drift is so large that the difference would lose digits.
std::optional<ThermalMotion> RunStatistics::present_motion() const {
    constexpr double most_drift = 1.0 / 16.0;
    ExactSum all;
    for (const Tally& its : tallies_) all.add(its.energy);
    const double energy = all.finite_value();
    double drift = 0.0;
    for (std::size_t axis = 0; axis < is_conserved_.size(); ++axis) {
        if (!is_conserved_[axis]) continue;
        const double momentum = momentum_[axis].value();
        drift += 0.5 * momentum * momentum / mass_;
    }
    if (drift > most_drift * energy) return std::nullopt;
    return ThermalMotion{energy - drift, degrees_of_freedom_};
}

void RunStatistics::finish(double time, const ThermalMotion& motion,
                           const AdvanceResult& advanced) {
    pressure_.see(time, advanced.impulses, advanced.surfaces);
    ExactSum energy;
    last_.momentum.resize(box_.dimension);
    for (Eigen::Index axis = 0; axis < box_.dimension; ++axis)
        last_.momentum[axis] = momentum_[static_cast<std::size_t>(axis)].value();
    // Each sample is summed separately: a running sum of millions of terms would lose digits.
    for (std::size_t s = 0; s < sums_.size(); ++s) {
        energy.add(tallies_[s].energy);
        sums_[s].energy += tallies_[s].energy.value();
        sums_[s].speed += tallies_[s].speed.value();
        all_counts_[s] += counts_[s];
    }
    last_.energy = energy.value();
    if (seen_ == 0) first_ = last_;
    if (first_.energy > 0.0)
        largest_energy_error_ =
            std::max(largest_energy_error_, std::abs(last_.energy - first_.energy) / first_.energy);
    thermal_energy_ += motion.energy;
    all_degrees_ += degrees_of_freedom_;
    if (is_followed_) {
        speeds_.count_held();
        energies_.count_held();
    }
    ++seen_;
    time_ = time;
}

std::vector<SpeciesMeans> RunStatistics::species_means() const {
    std::vector<SpeciesMeans> means;
    for (std::size_t s = 0; s < sums_.size(); ++s) {
        const auto values = static_cast<double>(all_counts_[s]);
        means.push_back({first_counts_[s], if_finite(sums_[s].energy / values),
                         if_finite(sums_[s].speed / values)});
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
    const double degrees = all_degrees_ / static_cast<double>(seen_);
    summary.temperature = if_finite(ThermalMotion{thermal, degrees}.temperature());
    summary.species = species_means();
    summary.speeds = speeds_.counts();
    summary.energies = energies_.counts();
    return summary;
}

}  // namespace carom
