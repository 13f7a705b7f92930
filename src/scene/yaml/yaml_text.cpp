#include "scene/yaml/yaml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "util/text.h"

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

std::size_t place_beyond(std::string_view text, std::size_t begin, std::size_t most) {
    bool is_line_empty = true;                           // so far
    bool is_after_comma = false, is_after_mark = false;  // whether a value may follow
    std::size_t values = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\n') is_line_empty = true;
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r') continue;
        if (c == '#' && is_line_empty) {
            i = std::min(text.find('\n', i), text.size()) - 1;
            continue;
        }
        is_line_empty = false;
        const bool ends_list = is_after_comma && (c == ']' || c == '}');
        if (is_after_mark && !ends_list && ++values > most) return i;
        const bool is_of_key = (c == ':' || c == '?') &&
                               (i + 1 == text.size() ||
                                std::string_view{" \t\r\n\"'[{,"}.find(text[i + 1]) != text.npos);
        is_after_comma = c == ',';
        is_after_mark = c == '[' || c == '{' || is_after_comma || is_of_key;
    }
    return std::string_view::npos;
}

std::size_t escape_in_formula(std::string_view text, std::size_t start) {
    if (start >= text.size() || text[start] != '"') return std::string_view::npos;
    const std::size_t end = std::min(end_of_quotation(text, start), text.size());
    std::size_t escape = std::string_view::npos;
    bool is_formula = false;
    for (std::size_t i = start + 1; i < end; ++i) {
        if (text[i] == '$') {
            if (is_formula && escape != std::string_view::npos) return escape;
            is_formula = !is_formula;
        } else if (text[i] == '\\') {
            ++i;
            const bool is_backslash = text[i] == '\\';
            const bool is_command = std::isalpha(static_cast<unsigned char>(text[i])) != 0 &&
                                    command_bytes(text, i - 1) > 2;
            if (is_formula && is_command) escape = std::min(escape, i - 1);
            const bool is_dollar = is_backslash && !is_formula && i + 1 < end && text[i + 1] == '$';
            if (is_dollar) ++i;
        }
    }
    return std::string_view::npos;  // what follows the last `$` is no formula
}

std::size_t command_bytes(std::string_view text, std::size_t at) {
    std::size_t end = at + 1;
    while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
    return std::max<std::size_t>(end - at, 2);
}

std::string odd_space_hint(std::string_view text) {
    struct Odd {
        std::string_view letter, name, instead = "an ordinary space";
    };
    constexpr std::array<Odd, 9> odd{{{"\u00A0", "a no-break space (U+00A0)"},
                                      {"\u202F", "a narrow no-break space (U+202F)"},
                                      {"\u2007", "a figure space (U+2007)"},
                                      {"\u2009", "a thin space (U+2009)"},
                                      {"\u200B", "a zero-width space (U+200B)"},
                                      {"\u3000", "an ideographic space (U+3000)"},
                                      {"\uFEFF", "a byte order mark (U+FEFF)"},
                                      {"\uFF1A", "a full-width colon (U+FF1A)", "`: `"},
                                      {"\uFF0C", "a full-width comma (U+FF0C)", "`, `"}}};
    for (const auto& [letter, name, instead] : odd) {
        const std::size_t at = text.find(letter);
        if (at == std::string_view::npos) continue;
        const std::string before = printable(text.substr(0, at));
        return fmt::format("{} stands {}: write {} instead", name,
                           before.empty() ? "at its beginning" : "after `" + before + "`", instead);
    }
    return "";
}

std::size_t line_without_key(std::string_view text, std::size_t mistake) {
    const std::size_t begin = text.rfind('\n', mistake) + 1;  // 0 in the first line
    if (begin < 2 || begin > mistake) return std::string_view::npos;
    const std::size_t above = text.rfind('\n', begin - 2) + 1;
    const std::string_view line = text.substr(above, begin - 1 - above);
    const std::size_t column = line.find_first_not_of(' ');
    if (column == line.npos || line[column] == '#' || line[column] == '-') return line.npos;
    if (line.find(": ") != line.npos || line.ends_with(':')) return line.npos;
    return above + column;
}

std::string key_hint(std::string_view line) {
    if (const std::string hint = odd_space_hint(line); !hint.empty()) return hint;
    const std::size_t mark = line.find_first_of("=: ");
    if (mark == line.npos) return "write `key: value`";
    const std::size_t value = line.find_first_not_of("=: ", mark);
    return fmt::format("put a colon and a space after a key: `{}: {}`",
                       printable(line.substr(0, mark)),
                       printable(value == line.npos ? "" : line.substr(value)));
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
