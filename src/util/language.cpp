#include "util/language.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "util/text.h"

namespace carom {
namespace {

constexpr phrases::Row table[] = {
#include "util/phrases.inc"
};

constexpr std::size_t count_of_phrases = std::size(table);

// The indices of the phrases in the table, sorted by their English words.
constexpr auto in_order = [] {
    std::array<std::uint16_t, count_of_phrases> order{};
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<std::uint16_t>(k);
    std::ranges::sort(order, {}, [](std::uint16_t k) { return table[k][0]; });
    return order;
}();

// The Spanish "y" (and) becomes "e" before the sound of i.
bool begins_with_i(std::string_view word) {
    const std::string letters = lower(std::string(word.substr(0, 3)));
    return letters.starts_with("i") || letters.starts_with("í") ||
           (letters.starts_with("hi") && !letters.starts_with("hie"));
}

}  // namespace

std::span<const phrases::Row> phrases::all() { return table; }

std::string_view phrases::translated(Language language, std::string_view english) {
    if (language == Language::english) return english;
    const auto found = std::ranges::lower_bound(in_order, english, {},
                                                [](std::uint16_t k) { return table[k][0]; });
    if (found == in_order.end() || table[*found][0] != english) return english;
    return table[*found][static_cast<std::size_t>(language)];
}

// Values are formatted where their types are no longer known, which keeps the many calls of say()
// small.
std::string phrases::filled(Language language, std::string_view english, fmt::format_args values) {
    using Value = fmt::format_args::format_arg;
    std::vector<Value> shown;
    std::deque<std::string> numbers;  // which `shown` refers to
    const auto text_of_number = [&](auto value) -> std::optional<std::string> {
        if constexpr (std::floating_point<decltype(value)>)
            return localised(language, fmt::format("{}", value));
        else
            return std::nullopt;
    };
    for (int k = 0; const Value value = values.get(k); ++k) {
        if (const std::optional<std::string> number =
                fmt::visit_format_arg(text_of_number, value)) {
            const std::string& kept = numbers.emplace_back(*number);
            const auto store = fmt::make_format_args(kept);
            shown.push_back(fmt::format_args(store).get(0));
        } else {
            shown.push_back(value);
        }
    }
    const std::string_view words = translated(language, english);
    return fmt::vformat(fmt::string_view(words.data(), words.size()),
                        fmt::format_args(shown.data(), static_cast<int>(shown.size())));
}

std::string say(Language language, Phrase phrase) {
    return std::string(phrases::translated(language, phrase.english));
}

std::string localised(Language language, std::string number) {
    if (language != Language::english) std::ranges::replace(number, '.', ',');
    return number;
}

std::string three_digits(Language language, double value) {
    return localised(language, three_digits(value));
}

std::string three_digits_of_power(Language language, double exponent) {
    return localised(language, three_digits_of_power(exponent));
}

std::string with_error(Language language, double value, double error) {
    return localised(language, with_error(value, error));
}

std::string steady_number(Language language, double value, std::pair<double, double> range) {
    return localised(language, steady_number(value, range));
}

std::string plain_number(Language language, double value) {
    return localised(language, plain_number(value));
}

std::string listed(Language language, std::span<const std::string> words) {
    const bool is_e =
        language == Language::spanish && !words.empty() && begins_with_i(words.back());
    return listed(words, is_e ? "e" : say(language, Phrase{"and"}));
}

bool is_singular(Language language, long long count) {
    return count == 1 || (language == Language::french && count == 0);
}

std::string counted(Language language, long long count, Phrase one, Phrase more) {
    const std::string words = say(language, is_singular(language, count) ? one : more);
    return fmt::format(fmt::runtime(words), grouped(count));
}

}  // namespace carom
