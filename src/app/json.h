// JSON as the program writes it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace carom {

using Json = nlohmann::ordered_json;

/// JSON in UTF-8, also where a path has bytes that are none, each level indented by so many blanks;
/// without `indent` in one line.
inline std::string text_of(const Json& json, int indent = -1) {
    constexpr bool ascii_only = false;
    return json.dump(indent, ' ', ascii_only, Json::error_handler_t::replace);
}

}  // namespace carom
