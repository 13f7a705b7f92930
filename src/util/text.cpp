#include "util/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace carom {
namespace {

struct Decoded {
    std::size_t length;
    bool valid;
};

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

Decoded decode(std::string_view text, std::size_t index) {
    const auto lead = static_cast<unsigned char>(text[index]);
    if (lead < 0x80) return {1, true};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || index + length > text.size()) return {1, false};
    for (std::size_t i = 1; i < length; ++i)
        if (!is_continuation(text[index + i])) return {1, false};
    const auto second = static_cast<unsigned char>(text[index + 1]);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool surrogate = lead == 0xED && second >= 0xA0;
    const bool too_large = lead == 0xF4 && second >= 0x90;
    if (overlong || surrogate || too_large) return {1, false};
    return {length, true};
}

// Separators of lines and paragraphs, and the bidirectional controls of Unicode Standard Annex 9:
// U+061C, U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069. In UTF-8, the order of code points is
// that of their bytes.
bool ends_line_or_turns(std::string_view letter) {
    return letter == "\u061C" || (letter >= "\u200E" && letter <= "\u200F") ||
           (letter >= "\u2028" && letter <= "\u202E") || (letter >= "\u2066" && letter <= "\u2069");
}

// Counts insertions, deletions, substitutions and transpositions of neighbours; keeps only three
// rows of the table.
int edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<int> rows(3 * width);
    int *before = rows.data(), *last = before + width, *row = last + width;
    for (std::size_t j = 0; j < width; ++j) last[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j < width; ++j) {
            const int change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

}  // namespace

std::size_t next_code_point(std::string_view text, std::size_t index) {
    return index + decode(text, index).length;
}

int code_points(std::string_view text) {
    int count = 0;
    for (std::size_t i = 0; i < text.size(); i = next_code_point(text, i)) ++count;
    return count;
}

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const Decoded decoded = decode(text, i);
        if (!decoded.valid) return false;
        i += decoded.length;
    }
    return true;
}

std::string as_utf8(std::string_view text) {
    std::string valid;
    for (std::size_t i = 0; i < text.size();) {
        const Decoded decoded = decode(text, i);
        valid += decoded.valid ? text.substr(i, decoded.length) : "\uFFFD";
        i += decoded.length;
    }
    return valid;
}

std::size_t plain_length(std::string_view text) {
    const auto other = std::ranges::find_if(text, [](char c) { return c < ' ' || c > '~'; });
    return static_cast<std::size_t>(other - text.begin());
}

bool is_control(std::string_view code_point) {
    const auto lead = static_cast<unsigned char>(code_point[0]);
    if (code_point.size() == 1) return lead < 0x20 || lead == 0x7F;
    return lead == 0xC2 && static_cast<unsigned char>(code_point[1]) < 0xA0;
}

std::string printable(std::string_view words) {
    std::string shown;
    for (std::size_t i = 0; i < words.size();) {
        const std::size_t plain = plain_length(words.substr(i));
        shown += words.substr(i, plain);
        i += plain;
        if (i == words.size()) break;
        const Decoded decoded = decode(words, i);
        const std::string_view letter = words.substr(i, decoded.length);
        const bool good =
            letter == "\t" || (decoded.valid && !is_control(letter) && !ends_line_or_turns(letter));
        shown += good ? letter : "\uFFFD";
        i += decoded.length;
    }
    return shown;
}

bool nests_deeper(std::string_view json, int most) {
    int depth = 0;
    bool is_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"') is_string = !is_string;
        if (is_string && c == '\\') ++i;
        if (is_string) continue;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > most) return true;
    }
    return false;
}

namespace {

bool is_same_but_case(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace

std::optional<std::string> nearest_spelling(std::string_view word,
                                            std::span<const std::string> candidates) {
    constexpr std::size_t longest_compared = 64;  // a longer word is not a misspelt key
    // Any single letter is one edit away from any other.
    if (word.size() < 2 || word.size() > longest_compared) return std::nullopt;
    for (const std::string& candidate : candidates)
        if (is_same_but_case(word, candidate)) return candidate;
    std::optional<std::string> best;
    int least = static_cast<int>(std::max<std::size_t>(1, word.size() / 3)) + 1;
    const auto length = static_cast<int>(word.size());
    for (const std::string& candidate : candidates) {
        if (std::abs(length - static_cast<int>(candidate.size())) >= least) continue;
        const int distance = edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

std::string spelling_hint(std::string_view word, std::span<const std::string> candidates,
                          const std::string& fallback) {
    const std::optional<std::string> near = nearest_spelling(word, candidates);
    return near ? "did you mean `" + *near + "`?" : fallback;
}

std::string percent_encoded(std::string_view text, std::string_view plain) {
    std::string encoded;
    for (const char c : text) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                              (c >= '0' && c <= '9') || plain.find(c) != std::string_view::npos;
        encoded +=
            is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return encoded;
}

std::string superscript(int value) {
    constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = value < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(value)))
        text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

std::string listed(std::span<const std::string> words, std::string_view last,
                   std::string_view quote) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " " + std::string(last) + " " : ", ";
        text.append(quote).append(words[i]).append(quote);
    }
    return text;
}

std::string sentence(const std::string& words) {
    const bool ends = words.ends_with('.') || words.ends_with('!') || words.ends_with('?');
    return ends ? words : words + ".";
}

std::string capitalised(std::string words) {
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    const bool is_latin = words.size() > 1 && words[0] == '\xC3';  // à to þ, but ÷
    const auto second = static_cast<unsigned char>(words.size() > 1 ? words[1] : 0);
    if (is_latin && second >= 0xA0 && second <= 0xBE && second != 0xB7)
        words[1] = static_cast<char>(second - 0x20);
    return words;
}

std::string upper_case(std::string words) {
    for (char& c : words)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return words;
}

std::string lower(std::string words) {
    for (char& c : words)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return words;
}

double off_the_tie(double value) { return value * (1.0 + 1e-9); }

std::string three_digits(double value) {
    if (!std::isfinite(value)) return "–";
    std::string text;
    const double size = std::abs(off_the_tie(value));
    if (size == 0.0) {
        text = "0";
    } else if (size < 1e-3 || size >= 99999.5) {
        text = fmt::format("{:.2e}", size);
        const std::size_t e = text.find('e');
        text = text.substr(0, e) + "×10" + superscript(std::stoi(text.substr(e + 1)));
    } else {
        int before = static_cast<int>(std::floor(std::log10(size))) + 1;
        if (size >= 0.9995 * std::pow(10.0, before)) ++before;  // rounds to one digit more
        text = fmt::format("{:.{}f}", size, std::max(0, 3 - before));
    }
    return value < 0 ? "\u2212" + text : text;
}

std::string with_error(double value, double error) {
    if (!(error > 0.0) || !std::isfinite(error)) return three_digits(value);
    constexpr int most_decimals = 5;
    constexpr double most_plain = 1e5;
    const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(error))));
    if (decimals > most_decimals || std::abs(value) >= most_plain || error >= most_plain)
        return three_digits(value) + " ± " + three_digits(error);
    std::string number = fmt::format("{:.{}f} ± {:.{}f}", off_the_tie(std::abs(value)), decimals,
                                     off_the_tie(error), decimals);
    const bool is_zero = number.find_first_of("123456789") > number.find(' ');
    return value < 0.0 && !is_zero ? "\u2212" + number : number;
}

std::string steady_number(double value, std::pair<double, double> range) {
    if (!std::isfinite(value)) return "–";
    const double largest = std::max(std::abs(range.first), std::abs(range.second));
    if (!(largest > 0.0)) return "0";
    const int before = static_cast<int>(std::floor(std::log10(largest))) + 1;
    if (before < -2 || before > 5) return three_digits(value);
    const std::string digits =
        fmt::format("{:.{}f}", std::abs(off_the_tie(value)), std::max(0, 3 - before));
    const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
    if (value < 0.0 && !is_zero) return "\u2212" + digits;
    return range.first < 0.0 ? "\u2007" + digits : digits;  // a figure space
}

std::string three_digits_of_power(double exponent) {
    constexpr double plain = 300.0;  // within this, doubles have full precision
    if (!std::isfinite(exponent)) return exponent < 0.0 ? "0" : "–";
    if (std::abs(exponent) < plain) return three_digits(std::pow(10.0, exponent));
    double whole = std::floor(exponent);
    double digits = std::round(std::pow(10.0, exponent - whole + 2.0));
    if (digits == 1000.0) {
        digits = 100.0;
        whole += 1.0;
    }
    return fmt::format("{:.2f}×10", digits / 100.0) + superscript(static_cast<int>(whole));
}

std::string plain_number(double value) {
    const bool is_plain = std::abs(value) >= 1e-4 && std::abs(value) < 1e6;
    if (value != 0.0 && !is_plain) return three_digits(value);
    return (value < 0.0 ? "\u2212" : "") + fmt::format("{:g}", std::abs(value));
}

std::string counted(long long count, std::string_view what) {
    return fmt::format("{} {}{}", grouped(count), what, count == 1 ? "" : "s");
}

std::string grouped(long long value) {
    std::string digits = std::to_string(value < 0 ? -value : value);
    constexpr std::size_t fewest_grouped = 5;  // digits: ISO 80000-1 leaves fewer together
    const bool is_long = digits.size() >= fewest_grouped;
    for (int i = static_cast<int>(digits.size()) - 3; is_long && i > 0; i -= 3)
        digits.insert(static_cast<std::size_t>(i), "\u2009");
    return value < 0 ? "\u2212" + digits : digits;
}

}  // namespace carom
