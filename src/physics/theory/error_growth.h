// How fast the smallest of differences grows in a gas of hard disks, in theory: what leads a
// reversed gas astray, whether it began as round-off or as a perturbation. Measures nothing itself.
#pragma once

#include <optional>
#include <string>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// By how many bits a distance between two states of one gas grows with each collision of a
/// particle, while it is far below a radius: a distance d becomes d 2^(s c) after c collisions of
/// each particle with others, c = 2 * collisions / N. 0 where nothing is packed.
///
///     s = 3.85 log2(1 + 0.115 / packing)
///
/// A safe upper fit to echoes of equal disks between walls, in numbers of 1024 bits, of 50 to 400
/// disks at packing fractions from 0.05 to 0.6 (reversal_growth_rate.csv): 1 to 15 % above what was
/// measured up to 0.4, up to 43 % at 0.6. s ln 2 is the largest Lyapunov exponent in units of a
/// particle's collision rate (Dellago, Posch and Hoover, Phys. Rev. E 53, 1485, 1996).
double bits_lost_per_collision(double packing);

/// The same for a gas whose growth law is known: two equal disks or more, none of infinite mass.
/// Nothing for mixtures, and on a line, where neighbours part far more slowly.
std::optional<double> bits_lost_per_collision(const Box& box, const Particles& particles);

/// Why the growth law of a gas is not known, before it is placed; nothing if it is, and of a gas
/// that cannot be drawn.
std::optional<std::string> why_no_growth_law(const Gas& gas);

}  // namespace carom
