// JSON as carom writes it and reads it back.
#pragma once

#include <concepts>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace carom {

using Json = nlohmann::ordered_json;

/// The JSON as UTF-8 text; invalid bytes, for example of a path, are replaced. Each level is
/// indented by `indent` blanks; with a negative `indent` all is on one line.
std::string text_of(const Json& json, int indent = -1);

/// Parses a text. Returns a discarded value (neither object nor array) if it is not JSON, or is
/// nested deeper than any JSON that carom writes.
Json json_in(std::string_view text);

/// What is wrong with JSON that was read, without the identifier of the exception.
std::string cause_of(const Json::exception& error);

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
