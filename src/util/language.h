// The program's own words in the languages that a picture can have, and numbers and lists as each
// language writes them. The English words, as they appear in the code, are the keys of the table in
// phrases.inc. Words from a scene are not translated, nor are messages, CSV and JSON.
#pragma once

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace carom {

enum class Language { english, german, french, spanish };
inline constexpr std::size_t language_count = 4;

/// A text of the program in English, with {} or {0} where a value is filled in.
struct Phrase {
    std::string_view english;
    bool operator==(const Phrase&) const = default;
};

/// Returns a phrase in a language; in English if the table has no translation.
std::string say(Language language, Phrase phrase);

/// Returns the separator of numbers in a row: a semicolon in languages with a decimal comma.
constexpr std::string_view between_numbers(Language language) {
    return language == Language::english ? ", " : "; ";
}

/// Converts a number as written in English to the decimal sign of a language.
std::string localised(Language language, std::string number);

/// Like the functions of the same names in util/text.h, for a language.
std::string three_digits(Language language, double value);
std::string three_digits_of_power(Language language, double exponent);
std::string with_error(Language language, double value, double error);
std::string steady_number(Language language, double value, std::pair<double, double> range);
std::string plain_number(Language language, double value);
std::string listed(Language language, std::span<const std::string> words);

/// Returns whether a language uses the singular with a count.
bool is_singular(Language language, long long count);

namespace phrases {

/// The English words and their translations, in the order of the enum.
using Row = std::array<std::string_view, language_count>;
std::span<const Row> all();
std::string_view translated(Language language, std::string_view english);

/// Fills the values into a phrase in a language.
std::string filled(Language language, std::string_view english, fmt::format_args values);

/// What a value is formatted as.
template <class Arg>
using Shown = std::conditional_t<std::floating_point<Arg>, std::string, Arg>;

}  // namespace phrases

/// Returns a phrase in a language with its values filled in; floating-point numbers get the decimal
/// sign of the language.
template <class... Args>
std::string say(Language language, fmt::format_string<phrases::Shown<Args>...> english,
                const Args&... args) {
    const fmt::string_view key = english;
    return phrases::filled(language, {key.data(), key.size()}, fmt::make_format_args(args...));
}

/// Returns a count with its noun, "1 collision" or "30 collisions", from a phrase for one and a
/// phrase for other numbers.
std::string counted(Language language, long long count, Phrase one, Phrase more);

}  // namespace carom
