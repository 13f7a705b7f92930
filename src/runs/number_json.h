// Numbers of runs as JSON: what a number is, in the plan of a sweep and in its summary, and the
// numbers themselves, in these and in reports.
#pragma once

#include <optional>

#include "physics/units/quantity.h"
#include "runs/json.h"
#include "runs/run_numbers.h"

namespace carom {

/// The name, and the unit by name.
Json to_json(const RunNumber& number);

/// Reads what to_json() gave. Throws Json::exception if it is not such a number.
RunNumber run_number_from(const Json& json);

/// A number with what it is.
struct Amount {
    std::optional<double> value;
    Quantity quantity;
    UnitSystem units = UnitSystem::reduced;  ///< of the value
};

/// As JSON the value, of real units in the SI; null if there is none, or it is not finite.
void to_json(Json& json, const Amount& amount);

}  // namespace carom
