#include "scene/yaml/scalar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "util/text.h"

namespace carom {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t skip_digits(std::string_view text, std::size_t i) {
    while (i < text.size() && is_digit(text[i])) ++i;
    return i;
}

bool is_decimal(std::string_view text) {
    const std::size_t whole = skip_digits(text, 0);
    if (whole > 1 && text[0] == '0') return false;
    std::size_t i = whole;
    std::size_t digits = whole;
    if (i < text.size() && text[i] == '.') {
        const std::size_t end = skip_digits(text, i + 1);
        digits += end - i - 1;
        i = end;
    }
    if (digits == 0) return false;
    if (i == text.size()) return true;
    if (text[i] != 'e' && text[i] != 'E') return false;
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    return i < text.size() && skip_digits(text, i) == text.size();
}

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

std::string without(std::string text, std::string_view letters) {
    std::erase_if(text, [&](char c) { return letters.find(c) != std::string_view::npos; });
    return text;
}

// Returns whether the text after a number continues an expression with an operator or pi: "2*3", "2
// pi", not "30/s".
bool begins_expression(const std::string& rest) {
    const auto is_letter = [](char c) { return lower({c})[0] >= 'a' && lower({c})[0] <= 'z'; };
    if (rest.starts_with("π")) return true;
    if (rest.starts_with("pi")) return rest.size() == 2 || !is_letter(rest[2]);
    if (rest[0] == '/') return rest.size() == 1 || !is_letter(rest[1]) || rest.starts_with("/pi");
    return rest[0] == '*' || rest[0] == '^';
}

// Returns the number of a quantity with a unit, such as "5mm" or "2.5 m/s"; empty if there is no
// number or no unit, as in "2*pi".
std::string before_unit(const std::string& text) {
    const std::size_t end = text.find_last_of("0123456789.");
    std::size_t unit = text.find_first_not_of("0123456789.+-");
    if (unit == std::string::npos || unit == 0) return "";
    if (text[unit] == 'e' || text[unit] == 'E') {  // 1e3 m/s
        const std::size_t after = text.find_first_not_of("0123456789+-", unit + 1);
        if (after != std::string::npos && parse_number(text.substr(0, after))) unit = after;
    }
    const std::string number = text.substr(0, unit), rest = without(text.substr(unit), " ");
    if (rest.empty() || begins_expression(rest)) return "";
    const bool is_one_number = end == unit - 1 || text.find_first_of("/^²³", unit) != text.npos;
    return is_one_number && parse_number(number) ? number : "";
}

// A comma is a decimal point to some, and parts thousands for others.
std::string separator_hint(const std::string& text) {
    const std::string plain = without(text, "_,' ");
    if (plain == text) return "";
    const std::size_t comma = text.find(',');
    if (comma != std::string::npos && text.find_first_of(",.", comma + 1) == std::string::npos) {
        const std::string whole = without(text.substr(0, comma), "_.' ");
        const std::string pointed = whole + "." + text.substr(comma + 1);
        const bool may_be_thousands =
            whole.size() == comma && text.size() - comma == 4 && parse_number(plain);
        if (may_be_thousands)
            return fmt::format("write `{}`, or `{}` with a decimal point", plain, pointed);
        if (parse_number(pointed)) return fmt::format("write `{}`, with a point", pointed);
    }
    return parse_number(plain) ? fmt::format("write `{}`, without separators", plain) : "";
}

// Returns a number before a comment that other languages would begin there.
std::string comment_hint(const std::string& text) {
    const std::size_t mark = std::min(text.find("//"), text.find('#'));
    if (mark == std::string::npos) return "";
    const std::string number =
        text.substr(0, text.find_last_not_of(' ', mark == 0 ? 0 : mark - 1) + 1);
    return parse_number(number)
               ? fmt::format("write `{}`: a comment begins with a space and `#`", number)
               : "";
}

// Typographic minus signs and dashes are letters to YAML.
std::string sign_hint(const std::string& text) {
    for (const std::string_view sign : {"−", "–", "—"})
        if (text.starts_with(sign) && parse_number(text.substr(sign.size())))
            return fmt::format("write `-{}`, with the minus sign of the keyboard",
                               text.substr(sign.size()));
    return "";
}

// 5x10^-3, 5*10^-3, 10^-3
std::string power_hint(const std::string& text) {
    const std::size_t ten = text.find("10^");
    if (ten == std::string::npos) return "";
    std::string factor = without(text.substr(0, ten), " ");
    for (const std::string_view times : {"x", "X", "*", "×", "·"})
        if (factor.ends_with(times)) factor.resize(factor.size() - times.size());
    const std::string number =
        (factor.empty() ? "1" : factor) + "e" + without(text.substr(ten + 3), " {}()");
    return parse_number(number) ? fmt::format("write `{}`", number) : "";
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    if (!is_decimal(text)) return std::nullopt;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return negative ? -value : value;
}

std::optional<double> number_in(const Node& node) {
    if (!node.is_scalar() || node.quoted) return std::nullopt;
    return parse_number(node.text);
}

std::optional<bool> flag_in(const Node& node) {
    if (!node.is_scalar() || node.quoted) return std::nullopt;
    if (node.text == "true") return true;
    if (node.text == "false") return false;
    return std::nullopt;
}

std::string number_hint(const Node& node) {
    if (!node.is_scalar()) return "";
    for (const std::string& hint :
         {comment_hint(node.text), sign_hint(node.text), power_hint(node.text)})
        if (!hint.empty()) return hint;
    const std::string word = lower(node.text);
    if (node.quoted) return parse_number(node.text) ? "write the number without quotes" : "";
    if (is_one_of(without(word, "+-."), {"nan", "inf", "infinity"}))
        return "numbers are finite: write a large one, for instance `1.0e+6`";
    if (word.starts_with("0x") || word.starts_with("0o") || word.starts_with("0b"))
        return "write the number in decimal";
    if (const std::string hint = separator_hint(node.text); !hint.empty()) return hint;
    const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
    const std::size_t zeros = word.find_first_not_of('0', sign);
    if (zeros != std::string::npos && zeros > sign && parse_number(node.text.substr(zeros)))
        return fmt::format("write `{}{}`, without leading zeros", node.text.substr(0, sign),
                           node.text.substr(zeros));
    if (const std::size_t slash = node.text.find('/'); slash != std::string::npos)
        if (parse_number(node.text.substr(0, slash)) && parse_number(node.text.substr(slash + 1)))
            return "a quotient is written as one number, in decimal";
    if (const auto share = parse_number(node.text.substr(0, node.text.size() - 1));
        node.text.ends_with('%') && share)
        return fmt::format("write `{}`", 0.01 * *share);
    if (const std::size_t colon = node.text.find(':'); colon != std::string::npos) {
        const auto minutes = parse_number(node.text.substr(0, colon));
        const auto seconds = parse_number(node.text.substr(colon + 1));
        if (minutes && seconds) return fmt::format("write `{}`", 60.0 * *minutes + *seconds);
    }
    if (const std::string number = before_unit(node.text); !number.empty())
        return fmt::format("write `{}`: numbers have units only in a scene with `units: real`",
                           number);
    const bool has_digit = word.find_first_of("0123456789") != std::string::npos;
    if (has_digit && (word.find_first_of("*^/") != std::string::npos || word.ends_with("pi") ||
                      word.ends_with("π")))
        return "expressions are not evaluated: write one number, in decimal";
    if (!word.empty() && is_decimal(std::string_view{word}.substr(sign)))
        return "too large or too small for a number of double precision";
    return "";
}

std::string flag_hint(const Node& node) {
    if (!node.is_scalar()) return "";
    const std::string word = lower(node.text);
    if (is_one_of(word, {"true", "yes", "on", "y", "1"})) return "write `true`";
    if (is_one_of(word, {"false", "no", "off", "n", "0"})) return "write `false`";
    return "";
}

}  // namespace carom
