// JSON as carom writes it, and reads it back.
#pragma once

#include <concepts>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "util/text.h"

namespace carom {

using Json = nlohmann::ordered_json;

/// JSON in UTF-8, also where a path has bytes that are none, each level indented by so many blanks;
/// without `indent` in one line.
inline std::string text_of(const Json& json, int indent = -1) {
    constexpr bool ascii_only = false;
    return json.dump(indent, ' ', ascii_only, Json::error_handler_t::replace);
}

/// The value of a text; discarded (and neither object nor array) where it is no JSON, or nested
/// deeper than carom writes any.
inline Json json_in(std::string_view text) {
    constexpr int deepest = 32;
    constexpr bool may_throw = false;
    if (nests_deeper(text, deepest)) return Json(Json::value_t::discarded);
    return Json::parse(text, nullptr, may_throw);
}

/// The value of a whole number. Throws Json::exception where it is none, or too large.
template <std::integral Number>
Number whole_in(const Json& json) {
    const auto value = json.get_ref<const Json::number_integer_t&>();
    if (!std::in_range<Number>(value))
        throw Json::out_of_range::create(406, "number is too large", &json);
    return static_cast<Number>(value);
}

}  // namespace carom
