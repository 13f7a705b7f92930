#include "util/csv.h"

#include <fmt/format.h>

namespace carom {

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + "\"";
}

std::string csv_number(double value) { return fmt::format("{}", value); }

std::string csv_number(float value) { return fmt::format("{}", value); }

}  // namespace carom
