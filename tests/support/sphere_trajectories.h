// The trajectories of hard spheres in tests/reference/sphere_trajectories.csv, which an independent
// program has calculated with 700 decimal digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "support/bodies.h"
#include "support/csv.h"
#include "support/space.h"

namespace carom::test {

struct Trajectory {
    /// A collision: of two spheres, first < second, or with a side of the box, -1 - its number.
    struct Event {
        std::int64_t number;  ///< among all collisions, from 1
        std::int32_t first, second;
        double time;
    };
    std::string name;
    Box box;
    double end = 0.0;                            ///< time, right after the last collision
    std::vector<Sphere> start = {}, there = {};  ///< at time 0 and at the end
    std::vector<Event> events = {};              ///< the first 30, each 25th, and the last
};

inline std::vector<Trajectory> sphere_trajectories() {
    std::vector<Trajectory> all;
    for (const std::vector<std::string>& row : reference_rows("sphere_trajectories.csv")) {
        const auto number = [&](std::size_t cell) { return std::stod(row.at(cell)); };
        const auto vec = [&](std::size_t cell) {
            return Vec{number(cell), number(cell + 1), number(cell + 2)};
        };
        if (row.at(1) == "box") {
            Walls walls{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                walls.at(axis) = row.at(6 + axis) == "1" ? Wall::periodic : Wall::solid;
            all.push_back({row[0], space_of(vec(3), walls), number(9)});
            continue;
        }
        Trajectory& its = all.back();
        if (row[1] == "start") {
            its.start.push_back({vec(3), vec(6), number(9), 1.0 / number(10)});
        } else if (row[1] == "end") {
            its.there.push_back({vec(3), vec(6)});
        } else {
            its.events.push_back(
                {std::stol(row[2]), std::stoi(row.at(3)), std::stoi(row.at(4)), number(5)});
        }
    }
    return all;
}

}  // namespace carom::test
