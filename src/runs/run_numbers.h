// The numbers that summarise a run, each with a name and what it is. The list is the same for all
// runs of a scene, so that runs can be tabulated, averaged and plotted against a varied parameter.
#pragma once

#include <string>
#include <vector>

#include "physics/units/quantity.h"
#include "runs/run.h"

namespace carom {

struct Scene;

/// One of the numbers of a run.
struct RunNumber {
    std::string name;  ///< "virial pressure"
    Quantity quantity;
    bool operator==(const RunNumber&) const = default;
};

/// The numbers of a scene's runs, in the order of lists and tables. Which numbers there are depends
/// on the scene's box, species, surfaces and reversals, not on what happens in a run.
std::vector<RunNumber> numbers_of_runs(const Scene& scene);

/// The values of numbers_of_runs() in a run of that scene, in the same order: NaN if a number has
/// no meaning for the run or is infinite.
std::vector<double> values_of(const Scene& scene, const RunReport& report);

}  // namespace carom
