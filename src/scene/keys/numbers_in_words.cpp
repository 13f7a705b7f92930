#include "scene/keys/numbers_in_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/yaml/node.h"
#include "scene/yaml/scalar.h"
#include "util/formula/formula.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr char begins_mark = '\x0e', ends_mark = '\x0f';
constexpr std::string_view usual_number = "0.123";
constexpr int most_digits = 12;

/// What is wrong with words, and how to write them.
struct WordsProblem {
    std::string message, hint;
};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// The digits of ".3" or ".2f".
bool read_format(std::string_view format, NumberInWords& number) {
    number.are_decimals = format.ends_with('f');
    if (number.are_decimals) format.remove_suffix(1);
    if (!format.starts_with('.')) return false;
    const auto digits = parse_number(format.substr(1));
    const double least = number.are_decimals ? 0.0 : 1.0;
    if (!digits || *digits < least || *digits > most_digits) return false;
    number.digits = static_cast<int>(*digits);
    return *digits == number.digits;
}

// What stands between braces: NAME, NAME at TIME, each with :.3 or :.2f at its end.
std::optional<WordsProblem> read_number(std::string_view text, NumberInWords& number) {
    const auto written = [&] { return in_quotes("{" + std::string(text) + "}"); };
    std::string_view rest = text;
    // Names may contain colons, before anything but digits.
    std::size_t colon = rest.rfind(':');
    if (colon != std::string_view::npos &&
        rest.find_first_not_of(" .0123456789fdegx", colon + 1) != std::string_view::npos)
        colon = std::string_view::npos;
    if (colon != std::string_view::npos) {
        if (!read_format(trimmed(rest.substr(colon + 1)), number))
            return WordsProblem{fmt::format("{} has no format of a number", written()),
                                "`:.3` gives three digits, `:.2f` two after the point"};
        rest = rest.substr(0, colon);
    }
    if (const std::size_t at = rest.rfind(" at "); at != std::string_view::npos) {
        number.at = parse_number(trimmed(rest.substr(at + 4)));
        if (!number.at)
            return WordsProblem{fmt::format("{} has no time after `at`", written()),
                                "for instance `{temperature at 40}`"};
        rest = rest.substr(0, at);
    }
    number.name = trimmed(rest);
    if (!number.name.empty()) return std::nullopt;
    return WordsProblem{fmt::format("{} names no number", written()),
                        "for instance `{temperature}`; `{{` is a brace"};
}

// Calls `take` with each piece: plain words without escapes, or what stands between braces.
std::optional<WordsProblem> in_pieces(std::string_view words,
                                      const std::function<void(std::string_view, bool)>& take) {
    for (std::size_t i = 0; i < words.size();) {
        const std::size_t brace = std::min(words.find_first_of("{}", i), words.size());
        take(words.substr(i, brace - i), false);
        if (brace == words.size()) break;
        i = brace + 1;
        if (i < words.size() && words[i] == words[brace]) {
            take(words.substr(i++, 1), false);
            continue;
        }
        const std::size_t end = words.find_first_of("{}", i);
        if (words[brace] == '}' || end == std::string_view::npos || words[end] == '{')
            return WordsProblem{
                fmt::format("a single `{}` in words", words[brace]),
                fmt::format("numbers stand between braces, for instance `{{temperature}}`; for the "
                            "brace itself write `{0}{0}`",
                            words[brace])};
        take(words.substr(i, end - i), true);
        i = end + 1;
    }
    return std::nullopt;
}

// The same for the plain parts of words with formulae.
std::optional<WordsProblem> outside_formulas(
    const std::string& words, const std::function<void(std::string_view, bool)>& take) {
    const std::vector<formula::Span> spans = formula::spans_of(words);
    for (std::size_t k = 0; k < spans.size(); ++k) {
        // Formulae are kept with their signs, plain words as they are escaped.
        const std::size_t from = spans[k].at - (spans[k].is_formula ? 1 : 0);
        const std::size_t next = k + 1 < spans.size()
                                     ? spans[k + 1].at - (spans[k + 1].is_formula ? 1 : 0)
                                     : words.size();
        const std::string_view part = std::string_view(words).substr(from, next - from);
        if (spans[k].is_formula)
            take(part, false);
        else if (auto problem = in_pieces(part, take))
            return problem;
    }
    return std::nullopt;
}

std::string mark_of(std::size_t index) {
    return fmt::format("{}{}{}", begins_mark, index, ends_mark);
}

}  // namespace

std::string with_marks(const std::string& words, const Node& node,
                       std::vector<NumberInWords>& numbers, Errors& errors) {
    if (words.find_first_of("{}") == std::string::npos) return words;
    std::string marked;
    std::optional<WordsProblem> wrong;
    const auto problem = outside_formulas(words, [&](std::string_view piece, bool is_number) {
        if (!is_number) {
            marked += piece;
            return;
        }
        NumberInWords number{.name = {}, .place = place_of(node)};
        if (const auto its = read_number(piece, number); its && !wrong) wrong = its;
        marked += mark_of(numbers.size());
        numbers.push_back(std::move(number));
    });
    if (problem) wrong = problem;
    if (!wrong) return marked;
    errors.add(node, wrong->message, wrong->hint);
    return words;
}

std::string filled(std::string_view marked,
                   const std::function<std::string(std::size_t)>& words_for) {
    std::string words;
    for (std::size_t i = 0; i < marked.size();) {
        const std::size_t begin = std::min(marked.find(begins_mark, i), marked.size());
        words += marked.substr(i, begin - i);
        if (begin == marked.size()) break;
        const std::size_t end = marked.find(ends_mark, begin);
        words += words_for(std::stoul(std::string(marked.substr(begin + 1, end - begin - 1))));
        i = end + 1;
    }
    return words;
}

std::vector<std::size_t> numbers_in(std::string_view marked) {
    std::vector<std::size_t> indices;
    filled(marked, [&](std::size_t index) {
        indices.push_back(index);
        return std::string();
    });
    return indices;
}

std::string with_usual_numbers(std::string_view marked) {
    return filled(marked, [](std::size_t) { return std::string(usual_number); });
}

int letters_with_usual_numbers(const std::string& words) {
    std::string shown;
    try {
        if (outside_formulas(words, [&](std::string_view piece, bool is_number) {
                shown += is_number ? usual_number : piece;
            }))
            return code_points(words);
    } catch (const formula::Error&) {  // is reported where formulae are checked
        return code_points(words);
    }
    return code_points(shown);
}

}  // namespace carom
