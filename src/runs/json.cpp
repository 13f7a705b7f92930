#include "runs/json.h"

#include <cstddef>

#include "util/text.h"

namespace carom {

std::string text_of(const Json& json, int indent) {
    constexpr bool ascii_only = false;
    return json.dump(indent, ' ', ascii_only, Json::error_handler_t::replace);
}

Json json_in(std::string_view text) {
    constexpr int deepest = 32;
    constexpr bool may_throw = false;
    if (nests_deeper(text, deepest)) return Json(Json::value_t::discarded);
    return Json::parse(text, nullptr, may_throw);
}

std::string cause_of(const Json::exception& error) {
    const std::string_view all = error.what();
    const std::size_t end = all.starts_with('[') ? all.find("] ") : std::string_view::npos;
    return std::string(end == std::string_view::npos ? all : all.substr(end + 2));
}

}  // namespace carom
