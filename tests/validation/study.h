// A study: independent runs of one gas, and the known values of the quantities that they measure.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "validation/row.h"

namespace carom::validation {

/// One of the independent runs: its seed, and its length as a share of the usual duration.
struct RunOf {
    std::uint64_t seed = 1;
    double effort = 1.0;
};

struct Study {
    std::string field;  ///< the heading of its rows
    std::string how;    ///< Markdown: the simulation and its corrections
    int runs = 1;
    std::function<std::vector<double>(const RunOf&)> measure;  ///< one number for each truth
    std::vector<Truth> truths;
};

// The studies of each field of physics; each field has its own source file.
std::vector<Study> pressures();
std::vector<Study> kinetic_theory();
std::vector<Study> equilibria();
std::vector<Study> wires();
std::vector<Study> gravity();
std::vector<Study> pistons();
std::vector<Study> baths();
std::vector<Study> partitions();
std::vector<Study> billiards();
std::vector<Study> flows();
std::vector<Study> drags();

std::vector<Study> all_studies();

}  // namespace carom::validation
