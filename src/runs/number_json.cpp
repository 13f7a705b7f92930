#include "runs/number_json.h"

#include <cmath>
#include <string>

#include "physics/units/unit_table.h"

namespace carom {

Json to_json(const RunNumber& number) {
    return {{"name", number.name}, {"unit", unit_text(number.quantity, UnitSystem::reduced_names)}};
}

RunNumber run_number_from(const Json& json) {
    const std::string unit = json.at("unit");
    const auto quantity = quantity_with_unit(unit, UnitSystem::reduced_names);
    if (!quantity) throw Json::other_error::create(501, "unknown unit: " + unit, &json);
    return {json.at("name"), *quantity};
}

void to_json(Json& json, const Amount& amount) {
    if (!amount.value || !std::isfinite(*amount.value))
        json = nullptr;
    else if (amount.units == UnitSystem::real)
        json = in_si(*amount.value, amount.quantity);
    else
        json = *amount.value;
}

}  // namespace carom
