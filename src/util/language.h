// The program's own words in the languages that a picture can have, and numbers and lists as each
// language writes them. The English words are the key, as they stand where they are used; the table
// is phrases.inc. What a scene says stays as it is, and so do messages, CSV and JSON.
#pragma once

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace carom {

enum class Language { english, german, french, spanish };
inline constexpr std::size_t language_count = 4;

/// Words of the program in English, with {} or {0} where something is filled in.
struct Phrase {
    std::string_view english;
    bool operator==(const Phrase&) const = default;
};

/// Those words in a language; in English where the table has none.
std::string say(Language language, Phrase phrase);

/// What stands between numbers in a row: a semicolon where they may have commas themselves.
constexpr std::string_view between_numbers(Language language) {
    return language == Language::english ? ", " : "; ";
}

/// A number as written in English, with the decimal sign of a language.
std::string localised(Language language, std::string number);

/// As the functions of util/text.h without a language.
std::string three_digits(Language language, double value);
std::string three_digits_of_power(Language language, double exponent);
std::string with_error(Language language, double value, double error);
std::string steady_number(Language language, double value, std::pair<double, double> range);
std::string plain_number(Language language, double value);
std::string listed(Language language, std::span<const std::string> words);

/// Whether a language has the singular beside a count.
bool is_singular(Language language, long long count);

namespace phrases {

/// The English words and those of the other languages, in the order of the enum.
using Row = std::array<std::string_view, language_count>;
std::span<const Row> all();
std::string_view translated(Language language, std::string_view english);

template <class Arg>
auto shown(Language language, const Arg& arg) {
    if constexpr (std::floating_point<Arg>)
        return localised(language, fmt::format("{}", arg));
    else
        return std::decay_t<const Arg>(arg);
}

template <class Arg>
using Shown = decltype(shown(Language::english, std::declval<const Arg&>()));

}  // namespace phrases

/// A phrase, filled; numbers with decimals as the language writes them.
template <class... Args>
std::string say(Language language, fmt::format_string<phrases::Shown<Args>...> english,
                const Args&... args) {
    const fmt::string_view key = english;
    const std::string_view words = phrases::translated(language, {key.data(), key.size()});
    const auto shown = std::tuple(phrases::shown(language, args)...);
    return std::apply(
        [&](const auto&... each) {
            return fmt::vformat(fmt::string_view(words.data(), words.size()),
                                fmt::make_format_args(each...));
        },
        shown);
}

/// "1 collision", "30 collisions": of a phrase for one and a phrase for other numbers.
std::string counted(Language language, long long count, Phrase one, Phrase more);

}  // namespace carom
