// What is left of a normal distribution from which only values above 0 are wanted.
#pragma once

#include "physics/value_rule.h"

namespace carom {

/// A normal distribution after its values below 0 have been replaced.
struct CutNormal {
    double share;            ///< of the values that were below 0
    double mean, deviation;  ///< of those that take part
};

/// Values below 0 are drawn again, as for radii, masses and densities. The mean must not be
/// negative.
CutNormal truncated_at_zero(const NormalDistribution& normal);

/// Values below 0 lose their sign, as for speeds.
CutNormal folded_at_zero(const NormalDistribution& normal);

}  // namespace carom
