// What captions, descriptions and other words of the library's scenes claim about their runs. A
// bound is what the words allow, whatever the run shows.
#pragma once

#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "captions/course.h"

namespace carom::test {

struct Bounds {
    double least, most;
};

inline Bounds at_least(double least) { return {least, std::numeric_limits<double>::infinity()}; }
inline Bounds at_most(double most) { return {-std::numeric_limits<double>::infinity(), most}; }
/// "twice", "half": to a tenth.
inline Bounds about(double value) { return {0.9 * value, 1.1 * value}; }
/// Numbers that words give: to half a unit of the last digit, or exactly.
inline Bounds exactly(double value, double rounding = 1e-9) {
    return {value - rounding, value + rounding};
}
/// "as many on either side": a number of `all` that are thrown into two halves, to two standard
/// deviations.
inline Bounds half_of(double all) {
    return {0.5 * all - std::sqrt(all), 0.5 * all + std::sqrt(all)};
}
/// "the same temperature", "the same mean energy": the ratio of the means over `a` and `b` disks in
/// equilibrium, to two standard deviations. The energy of a disk deviates by its mean.
inline Bounds same_for(double a, double b) {
    const double deviation = std::sqrt(1.0 / a + 1.0 / b);
    return {1.0 - 2.0 * deviation, 1.0 + 2.0 * deviation};
}
/// "hotter", "denser", "more": by a fifth.
inline Bounds more() { return at_least(1.2); }
/// "hot", "fast", "many": half as much again as that with which it is compared.
inline Bounds much_more() { return at_least(1.5); }
/// "cold", "few", "slow".
inline Bounds much_less() { return at_most(1.0 / 1.5); }
/// "nearly all" of a number, and "almost as before".
inline Bounds nearly_all_of(double all) { return at_least(7.0 / 8.0 * all); }

struct Claim {
    std::string words;  ///< a part of a sentence of the scene
    Measure measured;
    Bounds bounds;
    std::optional<double> shown_from = {};  ///< the time of the caption, if it is one
};

struct SceneClaims {
    std::string scene;
    std::vector<Claim> claims;
};

inline std::vector<SceneClaims> joined(std::initializer_list<std::vector<SceneClaims>> parts) {
    std::vector<SceneClaims> table;
    for (const auto& part : parts) table.insert(table.end(), part.begin(), part.end());
    return table;
}

std::vector<SceneClaims> claims_of_classics();
std::vector<SceneClaims> claims_of_gaslab();
std::vector<SceneClaims> claims_of_others();
std::vector<SceneClaims> claims_of_beads();
std::vector<SceneClaims> claims_of_space();

/// Measures each claim in the run of its scene.
void check(const std::vector<SceneClaims>& table);

}  // namespace carom::test
