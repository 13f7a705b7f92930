#include "scene/limits.h"

#include <fmt/format.h>

namespace carom {

std::string to_text(const Limit& limit) {
    if (limit.meaning.empty()) return "";
    return fmt::format("the limit is {} {}", number_text(limit.value), limit.meaning);
}

std::string number_text(double value) {
    std::string text = fmt::format("{}", value);
    if (value >= 1e9 && text.ends_with("000000000")) text = fmt::format("{:g}", value);
    std::erase(text, '+');
    if (const std::size_t zero = text.find("e-0"); zero != std::string::npos)
        text.erase(zero + 2, 1);  // 1e-9, as it is written by hand
    return text;
}

}  // namespace carom
