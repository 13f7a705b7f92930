#include "stats/paths/thermal_times.h"

#include "physics/mechanics.h"

namespace carom {

ThermalTimes::ThermalTimes(const Box& box, const Particles& particles,
                           std::vector<ThermalPart> parts, std::vector<double> velocity_changes)
    : box_(box),
      particles_(particles),
      parts_(std::move(parts)),
      paths_(box, std::move(velocity_changes)),
      integrals_(parts_.size()) {
    is_member_.resize(parts_.size());
    for (std::size_t k = 0; k < parts_.size(); ++k) choose(k, std::move(parts_[k].members));
    if ((particles.inverse_mass > 0.0).all()) mass_ = (1.0 / particles.inverse_mass).sum();
    for (int axis = 0; axis < box.dimension; ++axis)
        is_conserved_[static_cast<std::size_t>(axis)] = conserves_momentum(box, particles, axis);
}

void ThermalTimes::choose(std::size_t part, std::vector<Eigen::Index> members) {
    std::vector<bool>& is_member = is_member_[part];
    is_member.assign(static_cast<std::size_t>(particles_.count()), false);
    for (const Eigen::Index i : members) is_member[static_cast<std::size_t>(i)] = true;
    parts_[part].members = std::move(members);
}

const std::vector<ThermalIntegrals>& ThermalTimes::see(const Sample& sample,
                                                       std::span<const Collision> collisions) {
    paths_(sample, collisions, [this](const PathPiece& piece) { fly(piece); });
    look_for_drift(sample);
    return integrals_;
}

std::vector<ThermalIntegrals> ThermalTimes::moment(const Sample& sample) {
    look_for_drift(sample);
    std::vector<ThermalIntegrals> now(parts_.size());
    for (std::size_t k = 0; k < parts_.size(); ++k)
        for (const Eigen::Index i : parts_[k].members) {
            if (particles_.inverse_mass[i] == 0.0) continue;
            if (parts_[k].region && !is_in(box_, *parts_[k].region, vec_in(sample.position, i)))
                continue;
            const Vec velocity = vec_in(sample.velocity, i) - drift_;
            now[k].energy += 0.5 * square(velocity) / particles_.inverse_mass[i];
            now[k].half_freedom += half_freedom(i);
        }
    return now;
}

// The drift of the whole gas is not thermal motion and is subtracted. The drift found at one sample
// is used until the next.
void ThermalTimes::look_for_drift(const Sample& sample) {
    const auto of_present = [&](const Eigen::ArrayXd& values) {
        if (!some_are_absent_) return values.sum();
        return Eigen::ArrayXd(sample.membership->is_present.select(values, 0.0)).sum();
    };
    const bool is_changed = membership_.see(sample, particles_);
    if (is_changed) some_are_absent_ = sample.membership && !sample.membership->is_present.all();
    if (is_changed && mass_ > 0.0) mass_ = of_present(1.0 / particles_.inverse_mass);
    for (Eigen::Index axis = 0; axis < box_.dimension; ++axis)
        if (is_conserved(axis))
            drift_[axis] = of_present(sample.velocity.col(axis) / particles_.inverse_mass) / mass_;
}

double ThermalTimes::half_freedom(Eigen::Index particle) const {
    double sum = 0.0;
    for (Eigen::Index axis = 0; axis < box_.dimension; ++axis)
        sum += is_conserved(axis) ? 1.0 - 1.0 / (particles_.inverse_mass[particle] * mass_) : 1.0;
    return 0.5 * sum;
}

void ThermalTimes::fly(const PathPiece& piece) {
    if (particles_.inverse_mass[piece.particle] == 0.0) return;
    for (std::size_t k = 0; k < parts_.size(); ++k)
        if (is_member_[k][static_cast<std::size_t>(piece.particle)]) add(piece, k);
}

// The mean energy of a stay is that at its middle plus a term for the change of velocity by
// gravity: exact, as the velocity is linear in time.
void ThermalTimes::add_stay(const PathPiece& piece, double from, double to,
                            ThermalIntegrals& into) const {
    const double inverse_mass = particles_.inverse_mass[piece.particle], span = to - from;
    const Vec velocity = piece.velocity_after(0.5 * (from + to)) - drift_;
    const Vec bent = piece.acceleration * span;
    into.energy += 0.5 * span * (square(velocity) + square(bent) / 12.0) / inverse_mass;
    into.half_freedom += span * half_freedom(piece.particle);
}

void ThermalTimes::add(const PathPiece& piece, std::size_t part) {
    const std::optional<Region>& region = parts_[part].region;
    if (!region) return add_stay(piece, 0.0, piece.span(), integrals_[part]);
    find_stays(box_, *region, piece, stays_);
    for (const Stay& stay : stays_)
        if (stay.is_inside) add_stay(piece, stay.from, stay.to, integrals_[part]);
}

}  // namespace carom
