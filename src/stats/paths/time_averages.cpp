#include "stats/paths/time_averages.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "physics/mechanics.h"

namespace carom {

TimeAverages::TimeAverages(const Box& box, const Particles& particles, int species,
                           std::vector<double> velocity_changes)
    : dimension_(box.dimension),
      inverse_mass_(particles.inverse_mass),
      species_(particles.species),
      needs_samples_(!velocity_changes.empty() || box.surfaces.has_gravity()),
      paths_(box, std::move(velocity_changes)),
      counts_(static_cast<std::size_t>(species)),
      integrals_{counts_, counts_} {
    const bool all_finite = (inverse_mass_ > 0.0).all();
    freedom_ = box.dimension * static_cast<double>((inverse_mass_ > 0.0).count());
    for (Eigen::Index i = 0; i < inverse_mass_.size(); ++i)
        counts_[static_cast<std::size_t>(species_[i])] += 1.0;
    if (all_finite) mass_ = (1.0 / inverse_mass_).sum();
    for (int axis = 0; axis < box.dimension; ++axis)
        if (all_finite && conserves_momentum(box, particles, axis)) {
            is_conserved_[static_cast<std::size_t>(axis)] = true;
            freedom_ -= 1.0;
        }
}

void TimeAverages::add(const PathPiece& piece, Integrals& to) const {
    const double span = piece.span();
    const Vec middle = piece.velocity_after(0.5 * span);
    const auto species = static_cast<std::size_t>(species_[piece.particle]);
    to.speed[species] +=
        length_of_way(middle, piece.acceleration, span) - span * first_speed_[piece.particle];
    const double inverse = inverse_mass_[piece.particle];
    if (inverse == 0.0) return;
    // The mean of v^2 is that halfway, and what the acceleration adds.
    const double squared = square(middle) + square(piece.acceleration) * span * span / 12.0;
    to.energy[species] += span * (0.5 * squared / inverse - first_energy_[piece.particle]);
}

void TimeAverages::begin(const Sample& sample) {
    start_ = time_ = sample.time;
    first_energy_ = first_speed_ = Eigen::ArrayXd::Zero(inverse_mass_.size());
    for (Eigen::Index i = 0; i < inverse_mass_.size(); ++i) {
        const Vec v = vec_in(sample.velocity, i);
        first_speed_[i] = length(v);
        if (inverse_mass_[i] > 0.0) first_energy_[i] = 0.5 * square(v) / inverse_mass_[i];
    }
    is_first_ = false;
}

void TimeAverages::look_for_drift(const Sample& sample) {
    drift_ = 0.0;
    for (int axis = 0; axis < dimension_; ++axis) {
        if (!is_conserved_[static_cast<std::size_t>(axis)]) continue;
        const double momentum = (sample.velocity.col(axis) / inverse_mass_).sum();
        drift_ += 0.5 * momentum * momentum / mass_;
    }
}

void TimeAverages::see(const Sample& sample, std::span<const Collision> collisions) {
    const bool is_first = is_first_;
    if (is_first) begin(sample);
    paths_.see_whole(sample, collisions,
                     [this](const PathPiece& piece) { add(piece, integrals_); });
    drift_integral_ += drift_ * (sample.time - time_);
    if (is_first || needs_samples_) look_for_drift(sample);
    time_ = sample.time;
}

TimeAverages::Values TimeAverages::averages() const {
    Integrals all = integrals_;
    paths_.see_open([&](const PathPiece& piece) { add(piece, all); });
    const double span = time_ - start_;
    Values averages{all.energy, all.speed, std::numeric_limits<double>::quiet_NaN()};
    for (std::vector<double>* each : {&averages.energy, &averages.speed})
        for (double& sum : *each) sum /= span;
    for (Eigen::Index i = 0; i < inverse_mass_.size(); ++i) {
        averages.energy[static_cast<std::size_t>(species_[i])] += first_energy_[i];
        averages.speed[static_cast<std::size_t>(species_[i])] += first_speed_[i];
    }
    const double energy = std::accumulate(averages.energy.begin(), averages.energy.end(), 0.0);
    for (std::size_t k = 0; k < counts_.size(); ++k) {
        averages.energy[k] /= counts_[k];
        averages.speed[k] /= counts_[k];
    }
    if (freedom_ > 0.0) averages.temperature = 2.0 * (energy - drift_integral_ / span) / freedom_;
    return averages;
}

}  // namespace carom
