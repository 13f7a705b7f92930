// The part of a report about distributions that carom cannot draw from as they are written: normal
// distributions of quantities that are never negative.
#pragma once

#include <string>
#include <vector>

#include "runs/json.h"

namespace carom {

struct Gas;

/// A normal distribution of which more than 1 % is below 0.
struct CutDistribution {
    std::string words;  ///< of whom, and what is drawn instead
    Json value;         ///< the same for programs
};

/// Those of a gas, in order of its species.
std::vector<CutDistribution> cut_distributions(const Gas& gas);

}  // namespace carom
