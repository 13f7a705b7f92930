// The particles of a run: their constant properties (Particles) and their state at one instant
// (Sample), both in the order in which the scene lists them. The number of particles is constant;
// which of them are present, and which species each belongs to, are part of the state.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "physics/vec.h"

namespace carom {

static_assert(
    EIGEN_MAX_ALIGN_BYTES == 64,
    "compile with -DEIGEN_MAX_ALIGN_BYTES=64, as carom is: arrays that one part allocates "
    "are freed by another (the CMake target carom::physics has this definition)");

/// Constant properties of N particles.
struct Particles {
    Eigen::ArrayXd radius;        ///< N, length
    Eigen::ArrayXd inverse_mass;  ///< N, 1/mass; 0 for an infinite mass
    Eigen::ArrayXi species;       ///< N, index into Gas::species, at the start

    Eigen::Index count() const { return radius.size(); }

    /// Whether all particles have the same radius and the same mass.
    bool are_equal() const {
        return count() == 0 ||
               ((radius == radius[0]).all() && (inverse_mass == inverse_mass[0]).all());
    }
};

/// Which particles are present at one time, and which species each belongs to.
struct Membership {
    Eigen::ArrayXi species;                            ///< N, index into Gas::species
    Eigen::Array<bool, Eigen::Dynamic, 1> is_present;  ///< N
};

/// The membership at the start of a run: all particles are present.
inline std::shared_ptr<const Membership> membership_at_start(const Particles& particles) {
    return std::make_shared<const Membership>(
        Membership{particles.species,
                   Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(particles.count(), true)});
}

/// Positions, velocities and membership of all particles at one time.
struct Sample {
    double time = 0.0;
    Eigen::ArrayXXd position = {};  ///< N x dimension, length
    Eigen::ArrayXXd velocity = {};  ///< N x dimension, length/time
    /// The same object for all samples of a run between which it does not change; null for a sample
    /// that was not taken from a run, where it is that of the start.
    std::shared_ptr<const Membership> membership = {};
};

/// The position or the velocity of one particle: a row of `values`, N x dimension.
inline Vec vec_in(const Eigen::ArrayXXd& values, Eigen::Index particle) {
    const double* first = values.data() + particle;
    const Eigen::Index rows = values.rows(), dimension = values.cols();
    return {first[0], dimension > 1 ? first[rows] : 0.0, dimension > 2 ? first[2 * rows] : 0.0};
}
inline void put(const Vec& vec, Eigen::ArrayXXd& values, Eigen::Index particle) {
    for (Eigen::Index axis = 0; axis < values.cols(); ++axis) values(particle, axis) = vec[axis];
}

/// Speeds |v| of all particles, N.
inline Eigen::ArrayXd speeds(const Sample& sample) {
    return sample.velocity.square().rowwise().sum().sqrt();
}

/// Kinetic energies m v^2 / 2, N; infinite for a moving particle of infinite mass, 0 for one at
/// rest.
inline Eigen::ArrayXd kinetic_energies(const Particles& particles, const Sample& sample) {
    const Eigen::ArrayXd square = sample.velocity.square().rowwise().sum();
    return (square > 0.0).select(0.5 * square / particles.inverse_mass, 0.0);
}

}  // namespace carom
