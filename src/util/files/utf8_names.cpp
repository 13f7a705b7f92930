#include "util/files/utf8_names.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>

#include "util/text.h"

namespace carom {
namespace {

// Returns the length of the code point at the beginning of a text; 0 if there is no valid one.
std::size_t length_of_first(std::string_view text) {
    constexpr std::size_t longest = 4;
    for (std::size_t length = 1; length <= longest && length <= text.size(); ++length)
        if (is_utf8(text.substr(0, length))) return length;
    return 0;
}

}  // namespace

std::string utf8_of_name(std::string_view name) {
    std::string text;
    while (!name.empty()) {
        const std::size_t length = length_of_first(name);
        if (length == 0)
            text += fmt::format("\\x{:02X}", static_cast<unsigned char>(name.front()));
        else
            text += name.front() == '\\' ? "\\\\" : name.substr(0, length);
        name.remove_prefix(length == 0 ? 1 : length);
    }
    return text;
}

std::string name_of_utf8(std::string_view text) {
    constexpr std::size_t digits = 2, escape = 2 + digits;  // \xHH
    constexpr int hexadecimal = 16;
    std::string name;
    while (!text.empty()) {
        unsigned char byte = 0;
        std::size_t length = 1;
        if (text.starts_with("\\\\")) {
            length = 2;
        } else if (text.starts_with("\\x") && text.size() >= escape &&
                   std::from_chars(text.data() + 2, text.data() + escape, byte, hexadecimal).ptr ==
                       text.data() + escape) {
            name += static_cast<char>(byte);
            text.remove_prefix(escape);
            continue;
        }
        name += text.front();
        text.remove_prefix(length);
    }
    return name;
}

}  // namespace carom
