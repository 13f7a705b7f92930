// Queries about the particles of a gas, which are numbered species by species as in Gas: the size
// that they cover, those with listed positions, and those on a lattice; also beads from left to
// right. Nothing is drawn or placed here.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/vec.h"

namespace carom {

/// Whether the positions of a species follow this rule.
template <typename Rule>
bool has_position(const Species& species) {
    return std::holds_alternative<Rule>(species.position);
}

/// The size covered by particles of these radii: the lengths of beads, the areas of disks or the
/// volumes of spheres.
template <typename Radii>
double sum_of_sizes(const Box& box, const Radii& radii) {
    const double sum = box.dimension == 1   ? radii.sum()
                       : box.dimension == 2 ? radii.square().sum()
                                            : radii.cube().sum();
    return content_of_ball(1.0, box.dimension) * sum;
}

/// Calls f(species, its first particle, how many it has) for each species.
template <typename Function>
void for_each_species(const Gas& gas, Function&& f) {
    Eigen::Index first = 0;
    for (std::size_t s = 0; s < gas.species.size(); ++s) {
        const auto count = static_cast<Eigen::Index>(gas.species[s].count);
        f(s, first, count);
        first += count;
    }
}

/// Calls f(species, particle, its place) for each particle whose place is listed.
template <typename Function>
void for_each_listed(const Gas& gas, Function&& f) {
    for_each_species(gas, [&](std::size_t s, Eigen::Index first, Eigen::Index) {
        if (const auto* places = std::get_if<Places>(&gas.species[s].position))
            for (const Vec& place : places->values) f(s, first++, place);
    });
}

/// The particles of all species that are placed on the lattice, and their largest and smallest
/// radii.
struct OnLattice {
    std::vector<Eigen::Index> numbers;
    double largest = 0.0, smallest = 0.0;
};

inline OnLattice particles_on_lattice(const Gas& gas, const Particles& particles) {
    OnLattice found;
    for_each_species(gas, [&](std::size_t s, Eigen::Index first, Eigen::Index count) {
        if (!has_position<LatticePlaces>(gas.species[s])) return;
        for (Eigen::Index i = first; i < first + count; ++i) found.numbers.push_back(i);
    });
    if (found.numbers.empty()) return found;
    found.largest = particles.radius(found.numbers).maxCoeff();
    found.smallest = particles.radius(found.numbers).minCoeff();
    return found;
}

/// Beads, or other particles along an axis: coordinate and number.
using Beads = std::vector<std::pair<double, Eigen::Index>>;

/// All particles sorted by their coordinate along an axis; at equal coordinates by number.
inline Beads beads_along(const Sample& sample, Eigen::Index axis) {
    Beads beads;
    for (Eigen::Index i = 0; i < sample.position.rows(); ++i)
        beads.emplace_back(sample.position(i, axis), i);
    std::ranges::sort(beads);
    return beads;
}

/// Calls f(left, right, distance of their centres) for each bead and the next one, also across the
/// end of a periodic line. Beads cannot pass one another: no others can overlap.
template <typename Function>
void for_each_two_neighbours(const Box& box, const Beads& from_left, Function&& f) {
    for (std::size_t k = 1; k < from_left.size(); ++k)
        f(from_left[k - 1].second, from_left[k].second,
          from_left[k].first - from_left[k - 1].first);
    if (box.is_periodic(0) && from_left.size() > 1)
        f(from_left.back().second, from_left.front().second,
          from_left.front().first + box.size[0] - from_left.back().first);
}

}  // namespace carom
