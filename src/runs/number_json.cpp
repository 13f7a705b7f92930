#include "runs/number_json.h"

#include <cmath>
#include <string>

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
    json = amount.value && std::isfinite(*amount.value) ? Json(*amount.value) : Json(nullptr);
}

}  // namespace carom
