#include "scene/yaml/yaml_text.h"

#include <algorithm>
#include <vector>

namespace carom {

std::size_t end_of_quotation(std::string_view text, std::size_t start) {
    const char quote = text[start];
    for (std::size_t i = start + 1; i < text.size(); ++i) {
        if (quote == '"' && text[i] == '\\')
            ++i;
        else if (text[i] == quote && quote == '\'' && i + 1 < text.size() && text[i + 1] == quote)
            ++i;
        else if (text[i] == quote)
            return i;
    }
    return std::string_view::npos;
}

std::size_t open_mark(std::string_view text) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool first = i == 0 || std::string_view{" \t\n,:[{"}.find(text[i - 1]) != text.npos;
        if (first && (c == '"' || c == '\'')) {
            const std::size_t end = end_of_quotation(text, i);
            if (end == text.npos) return i;
            i = end;
        } else if (first && c == '#') {
            i = std::min(text.find('\n', i), text.size());
        } else if (c == '[' || c == '{') {
            open.push_back(i);
        } else if ((c == ']' || c == '}') && !open.empty()) {
            open.pop_back();
        }
    }
    return open.empty() ? std::string_view::npos : open.back();
}

bool has_bare_color(std::string_view text) {
    for (std::size_t at = text.find(": #"); at != std::string_view::npos;
         at = text.find(": #", at + 1)) {
        const std::size_t end = text.find_first_not_of("0123456789abcdefABCDEF", at + 3);
        if (std::min(end, text.size()) - at - 3 == 6) return true;
    }
    return false;
}

}  // namespace carom
