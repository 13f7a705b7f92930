// Small gases whose panels are measured in several ways: scenes without title, run and film.
#pragma once

#include <string>

namespace carom::test {

inline const std::string two_masses =
    "box: {size: [20, 15]}\ngas: [{name: light, count: 24, radius: 0.4, temperature: 1}, "
    "{name: heavy, count: 2, radius: 1, mass: 9, temperature: 1}]\n";
inline const std::string falling_disks =
    "box: {size: [20, 15]}\ngravity: [0, -0.2]\n"
    "gas: [{name: light, count: 12, radius: 0.4, temperature: 1}]\n";
inline const std::string rods_and_points =
    "box: {length: 12}\ngas: [{name: a, count: 4, radius: 0.1, mass: 2, temperature: 1}, "
    "{name: b, count: 3, radius: 0, speed: 1}]\n";

}  // namespace carom::test
