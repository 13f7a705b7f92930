// The particles of a run: their constant properties (Particles) and their state at one instant
// (Sample), both in the order in which the scene lists them.
#pragma once

#include <Eigen/Core>

#include "physics/vec.h"

namespace carom {

/// Constant properties of N particles.
struct Particles {
    Eigen::ArrayXd radius;        ///< N, length
    Eigen::ArrayXd inverse_mass;  ///< N, 1/mass; 0 for an infinite mass
    Eigen::ArrayXi species;       ///< N, index into Gas::species

    Eigen::Index count() const { return radius.size(); }

    /// Whether all particles have the same radius and the same mass.
    bool are_equal() const {
        return count() == 0 ||
               ((radius == radius[0]).all() && (inverse_mass == inverse_mass[0]).all());
    }
};

/// Positions and velocities of all particles at one time.
struct Sample {
    double time = 0.0;
    Eigen::ArrayXXd position;  ///< N x dimension, length
    Eigen::ArrayXXd velocity;  ///< N x dimension, length/time
};

/// The position or the velocity of one particle: a row of `values`, N x dimension.
inline Vec vec_in(const Eigen::ArrayXXd& values, Eigen::Index particle) {
    Vec vec;
    for (Eigen::Index axis = 0; axis < values.cols(); ++axis) vec[axis] = values(particle, axis);
    return vec;
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
