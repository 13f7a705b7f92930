// What a number of runs is, as JSON in the plan of a sweep and in its summary.
#pragma once

#include "runs/json.h"
#include "runs/run_numbers.h"

namespace carom {

/// The name, and the unit by name.
Json to_json(const RunNumber& number);

/// Reads what to_json() gave. Throws Json::exception if it is not such a number.
RunNumber run_number_from(const Json& json);

}  // namespace carom
