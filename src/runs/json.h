// JSON as carom writes it and reads it back.
#pragma once

#include <concepts>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "util/text.h"

namespace carom {

using Json = nlohmann::ordered_json;

/// The JSON as UTF-8 text; invalid bytes, for example of a path, are replaced. Each level is
/// indented by `indent` blanks; with a negative `indent` all is on one line.
inline std::string text_of(const Json& json, int indent = -1) {
    constexpr bool ascii_only = false;
    return json.dump(indent, ' ', ascii_only, Json::error_handler_t::replace);
}

/// Parses a text. Returns a discarded value (neither object nor array) if it is not JSON, or is
/// nested deeper than any JSON that carom writes.
inline Json json_in(std::string_view text) {
    constexpr int deepest = 32;
    constexpr bool may_throw = false;
    if (nests_deeper(text, deepest)) return Json(Json::value_t::discarded);
    return Json::parse(text, nullptr, may_throw);
}

/// What is wrong with JSON that was read, without the identifier of the exception.
inline std::string cause_of(const Json::exception& error) {
    const std::string_view all = error.what();
    const std::size_t end = all.starts_with('[') ? all.find("] ") : std::string_view::npos;
    return std::string(end == std::string_view::npos ? all : all.substr(end + 2));
}

/// The value of a whole number. Throws Json::exception if the JSON is not a whole number, or if it
/// does not fit into `Number`.
template <std::integral Number>
Number whole_in(const Json& json) {
    const auto value = json.get_ref<const Json::number_integer_t&>();
    if (!std::in_range<Number>(value))
        throw Json::out_of_range::create(406, "number is too large", &json);
    return static_cast<Number>(value);
}

}  // namespace carom
