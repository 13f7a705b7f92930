// Theoretical growth rate of infinitesimal differences in a gas of hard disks or spheres. This
// growth limits the return of a reversed gas, whether the difference began as round-off or as a
// perturbation. Nothing is measured here.
#pragma once

namespace carom {

/// The number of bits s by which the distance between two states of one gas grows per collision of
/// a particle, as long as it is far below a radius: a distance d becomes d 2^(s c) after c
/// collisions of each particle with other particles, where c = 2 * collisions / N. Which gases it
/// holds for, law() knows (LawOf::error_growth). Returns 0 for a packing fraction of 0.
///
///     s = 3.85 log2(1 + 0.115 / packing)      disks
///     s = 3.3 log2(1 + 0.075 / packing)       spheres
///
/// Conservative upper fits to echoes of equal particles between walls, simulated with 1024 bits. Of
/// 50 to 400 disks at packing fractions from 0.05 to 0.6 (reversal_growth_rate.csv): 1 to 15 %
/// above the measured values up to a packing fraction of 0.4, up to 43 % above at 0.6. Of spheres
/// at packing fractions from 0.02 to 0.35 (reversal_growth_rate_spheres.csv): 8 to 14 % above those
/// of 500, up to 38 % above those of 32, most of which are near a wall. s ln 2 is the largest
/// Lyapunov exponent in units of a particle's collision rate (Dellago, Posch and Hoover, Phys. Rev.
/// E 53, 1485, 1996). `dimension` is 2 or 3.
double bits_lost_per_collision(int dimension, double packing);

}  // namespace carom
