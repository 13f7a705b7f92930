// A study: independent runs of one gas, and what is known of the numbers that they measure.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "validation/row.h"

namespace carom::validation {

/// Which of the independent runs, and how long: the share of the usual duration.
struct RunOf {
    std::uint64_t seed = 1;
    double effort = 1.0;
};

struct Study {
    std::string field;  ///< the heading of its rows
    std::string how;    ///< Markdown: what is simulated, and what is corrected
    int runs = 1;
    std::function<std::vector<double>(const RunOf&)> measure;  ///< a number for each truth
    std::vector<Truth> truths;
};

// Each field of physics has a file.
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
