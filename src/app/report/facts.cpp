#include "app/report/facts.h"

#include <fmt/format.h>

#include <cmath>

namespace carom {

Json number_or_null(std::optional<double> value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::string table_of(const Facts& facts, int label_width) {
    std::string text;
    for (const Fact& fact : facts)
        text += fact.label.empty()
                    ? fact.words
                    : fmt::format("  {:<{}} {}\n", fact.label, label_width, fact.words);
    return text;
}

Json json_of(const Facts& facts) {
    Json object = Json::object();
    for (const Fact& fact : facts)
        if (!fact.name.empty()) object[fact.name] = fact.value;
    return object;
}

}  // namespace carom
