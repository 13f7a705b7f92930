// The numbers that a run is summed up in, each with a name and a unit: a table of the same rows for
// all runs of a scene, so that runs can be listed, averaged and drawn against what is varied.
#pragma once

#include <string>
#include <vector>

#include "runs/run.h"

namespace carom {

/// One of the numbers of a run.
struct RunNumber {
    std::string name;  ///< "virial pressure"
    std::string unit;  ///< in words: "energy/area"; empty: a pure number
    bool operator==(const RunNumber&) const = default;
};

/// Those of a scene's runs, in the order of lists and tables: which they are depends on its box,
/// its species, its surfaces and its reversals, not on what happens.
std::vector<RunNumber> numbers_of_runs(const Scene& scene);

/// Their values in a run of that scene: NaN where a number has no meaning for it, or is infinite.
std::vector<double> values_of(const Scene& scene, const RunReport& report);

}  // namespace carom
