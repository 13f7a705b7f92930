// Spheres at random places of a box, without the placement of the program.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "physics/box.h"
#include "support/bodies.h"
#include "util/random.h"

namespace carom::test {

/// So many spheres that do not overlap, of random radii, masses and velocities. Does not look at
/// partitions and obstacles.
inline std::vector<Sphere> scattered(const Box& box, Random& random, int count, double smallest,
                                     double largest) {
    std::vector<Sphere> all;
    while (std::ssize(all) < count) {
        Sphere one;
        one.radius = random.uniform(smallest, largest);
        one.inverse_mass = random.uniform(0.2, 5.0);
        for (int axis = 0; axis < 3; ++axis) {
            const double margin = box.is_periodic(axis) ? 0.0 : one.radius;
            one.place[axis] = random.uniform(margin, box.size[axis] - margin);
            one.velocity[axis] = random.normal();
        }
        if (std::ranges::all_of(all, [&](const Sphere& other) {
                return length(box.nearest(one.place - other.place)) > one.radius + other.radius;
            }))
            all.push_back(one);
    }
    return all;
}

}  // namespace carom::test
