#include "stats/paths/time_averages.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "physics/mechanics.h"

namespace carom {
namespace {

constexpr int absent = -1;  // instead of a species

}  // namespace

TimeAverages::TimeAverages(const Box& box, const Particles& particles, int species,
                           std::vector<double> velocity_changes)
    : dimension_(box.dimension),
      particles_(particles),
      species_(particles.species),
      needs_samples_(!velocity_changes.empty() || box.surfaces.has_gravity()),
      paths_(box, std::move(velocity_changes)),
      counts_(static_cast<std::size_t>(species)),
      before_{counts_, counts_, counts_},
      integrals_{counts_, counts_} {
    for (int axis = 0; axis < box.dimension; ++axis)
        is_conserved_[static_cast<std::size_t>(axis)] = conserves_momentum(box, particles, axis);
    count();
}

// What depends on which particles are present, and on their species.
void TimeAverages::count() {
    const Eigen::ArrayXd& inverse_mass = particles_.inverse_mass;
    counts_.assign(counts_.size(), 0.0);
    double movable = 0.0;
    Eigen::ArrayXd mass = 1.0 / inverse_mass;
    for (Eigen::Index i = 0; i < species_.size(); ++i) {
        if (species_[i] == absent) {
            mass[i] = 0.0;
            continue;
        }
        counts_[static_cast<std::size_t>(species_[i])] += 1.0;
        if (inverse_mass[i] > 0.0) movable += 1.0;
    }
    freedom_ = dimension_ * movable;
    const bool all_finite = (inverse_mass > 0.0).all();
    if (all_finite) mass_ = mass.sum();
    for (const bool is_conserved : is_conserved_)
        if (is_conserved && movable > 0.0) freedom_ -= 1.0;
}

void TimeAverages::add(const PathPiece& piece, Integrals& to) const {
    if (species_[piece.particle] == absent) return;
    const double span = piece.span();
    const Vec middle = piece.velocity_after(0.5 * span);
    const auto species = static_cast<std::size_t>(species_[piece.particle]);
    to.speed[species] +=
        length_of_way(middle, piece.acceleration, span) - span * first_speed_[piece.particle];
    const double inverse = particles_.inverse_mass[piece.particle];
    if (inverse == 0.0) return;
    // The mean of v^2 is that halfway, and what the acceleration adds.
    const double squared = square(middle) + square(piece.acceleration) * span * span / 12.0;
    to.energy[species] += span * (0.5 * squared / inverse - first_energy_[piece.particle]);
}

void TimeAverages::begin(const Sample& sample) {
    const Eigen::ArrayXd& inverse_mass = particles_.inverse_mass;
    start_ = since_ = time_ = sample.time;
    first_energy_ = first_speed_ = Eigen::ArrayXd::Zero(inverse_mass.size());
    for (Eigen::Index i = 0; i < inverse_mass.size(); ++i) {
        const Vec v = vec_in(sample.velocity, i);
        first_speed_[i] = length(v);
        if (inverse_mass[i] > 0.0) first_energy_[i] = 0.5 * square(v) / inverse_mass[i];
    }
    is_first_ = false;
}

void TimeAverages::look_for_drift(const Sample& sample) {
    drift_ = 0.0;
    for (int axis = 0; axis < dimension_; ++axis) {
        if (!is_conserved_[static_cast<std::size_t>(axis)]) continue;
        Eigen::ArrayXd each = sample.velocity.col(axis) / particles_.inverse_mass;
        for (Eigen::Index i = 0; i < each.size(); ++i)
            if (species_[i] == absent) each[i] = 0.0;
        const double momentum = each.sum();
        drift_ += 0.5 * momentum * momentum / mass_;
    }
}

// What has been true since the last change, up to a time.
void TimeAverages::add_times_until(double time, Times& to) const {
    const double span = time - since_;
    for (std::size_t k = 0; k < counts_.size(); ++k) to.counts[k] += span * counts_[k];
    for (Eigen::Index i = 0; i < species_.size(); ++i) {
        if (species_[i] == absent) continue;
        const auto its = static_cast<std::size_t>(species_[i]);
        to.energy[its] += span * first_energy_[i];
        to.speed[its] += span * first_speed_[i];
    }
    to.freedom += span * freedom_;
}

void TimeAverages::see(const Sample& sample, std::span<const Collision> collisions) {
    const bool is_first = is_first_;
    if (is_first) begin(sample);
    const auto take = [this](const PathPiece& piece) { add(piece, integrals_); };
    paths_.see_whole(sample, collisions, take);
    drift_integral_ += drift_ * (sample.time - time_);
    const bool is_changed = membership_.see(sample, particles_);
    if (is_changed) {
        paths_.end_flights(sample, take);
        add_times_until(sample.time, before_);
        since_ = sample.time;
        species_ = species_at(sample, particles_);
        for (Eigen::Index i = 0; i < species_.size(); ++i)
            if (!is_present(sample, i)) species_[i] = absent;
        count();
    }
    if (is_first || needs_samples_ || is_changed) look_for_drift(sample);
    time_ = sample.time;
}

TimeAverages::Values TimeAverages::averages() const {
    Integrals all = integrals_;
    paths_.see_open([&](const PathPiece& piece) { add(piece, all); });
    const double span = time_ - start_, share = (time_ - since_) / span;
    Values averages{all.energy, all.speed, std::numeric_limits<double>::quiet_NaN()};
    for (std::size_t k = 0; k < counts_.size(); ++k) {
        averages.energy[k] = (averages.energy[k] + before_.energy[k]) / span;
        averages.speed[k] = (averages.speed[k] + before_.speed[k]) / span;
    }
    for (Eigen::Index i = 0; i < species_.size(); ++i) {
        if (species_[i] == absent) continue;
        averages.energy[static_cast<std::size_t>(species_[i])] += share * first_energy_[i];
        averages.speed[static_cast<std::size_t>(species_[i])] += share * first_speed_[i];
    }
    const double energy = std::accumulate(averages.energy.begin(), averages.energy.end(), 0.0);
    for (std::size_t k = 0; k < counts_.size(); ++k) {
        const double count = before_.counts[k] / span + share * counts_[k];
        averages.energy[k] /= count;
        averages.speed[k] /= count;
    }
    const double freedom = before_.freedom / span + share * freedom_;
    if (freedom > 0.0) averages.temperature = 2.0 * (energy - drift_integral_ / span) / freedom;
    return averages;
}

}  // namespace carom
