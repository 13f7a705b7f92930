// JSON as the program writes it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

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
inline Json json_in(const std::string& text) {
    constexpr int deepest = 32;
    constexpr bool may_throw = false;
    if (nests_deeper(text, deepest)) return Json(Json::value_t::discarded);
    return Json::parse(text, nullptr, may_throw);
}

}  // namespace carom
