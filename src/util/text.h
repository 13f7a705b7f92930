// Small services on text: UTF-8 steps, nearest spelling, numbers as a viewer reads them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace carom {

/// Index of the byte after the code point that begins at `index`; invalid bytes count as one code
/// point each.
std::size_t next_code_point(std::string_view text, std::size_t index);

/// Number of code points (invalid bytes count as one each).
int code_points(std::string_view text);

/// Whether `text` is well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates, at most
/// U+10FFFF).
bool is_utf8(std::string_view text);

/// The text with U+FFFD for each byte that is not of well-formed UTF-8: a file may be called
/// anything.
std::string as_utf8(std::string_view text);

/// The number of printable characters of ASCII that a text begins with.
std::size_t plain_length(std::string_view text);

/// Whether a code point (its UTF-8 bytes) is a control character: C0, delete or C1.
bool is_control(std::string_view code_point);

/// Words of strangers (names of files, words of the command line, titles) for one line on a
/// terminal: what it would obey or could not show is U+FFFD: bytes that are not of well-formed
/// UTF-8, control characters but the tab, ends of lines, and what turns the direction of writing
/// (Unicode's bidirectional controls), so that words do not read as others.
std::string printable(std::string_view words);

/// Whether brackets in a text of JSON are open in one another deeper than `most`; those in its
/// strings do not count. For texts of strangers, of which a reader keeps each level in memory.
bool nests_deeper(std::string_view json, int most);

/// The candidate with the smallest Damerau-Levenshtein distance (optimal string alignment) to
/// `word`, if at most a third of its length; none for a single letter.
std::optional<std::string> nearest_spelling(std::string_view word,
                                            std::span<const std::string> candidates);

/// A hint for a word that is none of the candidates: "did you mean `candidate`?" of the nearest
/// spelling, or `fallback` where none is near.
std::string spelling_hint(std::string_view word, std::span<const std::string> candidates,
                          const std::string& fallback);

/// "a", "a and b", "a, b and c", each between `quote`s.
std::string listed(std::span<const std::string> words, std::string_view last = "and",
                   std::string_view quote = "");

/// Ended by a full stop, unless it ends as a sentence does.
std::string sentence(const std::string& words);

/// With a large first letter, if that is one of ASCII or Latin-1; at least one letter.
std::string capitalised(std::string words);

/// A number a little farther from 0, by less than any reader sees: what lies half-way between two
/// digits but for round-off is then rounded one way, wherever it is shown.
double off_the_tie(double value);

/// As a part of an address: all but ASCII letters, digits and `plain` ones become %XX.
std::string percent_encoded(std::string_view text, std::string_view plain);

/// An integer in raised figures: ⁻⁷.
std::string superscript(int value);

/// Three significant digits, as on an axis: 0.0123, 1.23, 1230, 1.23×10⁷, with U+2212 for
/// minus.
std::string three_digits(double value);

/// "0.123 ± 0.004": as many decimals as show two digits of a standard error; the number alone where
/// the error is not positive and finite.
std::string with_error(double value, double error);

/// A number with as many decimals as show three digits of the one farther from 0 of a range, and
/// room for a sign where some of the range are negative: a readout in which only digits change.
std::string steady_number(double value, std::pair<double, double> range);

/// The same for a power of ten with any exponent, also where no double is so small or so large;
/// 0 for minus infinity.
std::string three_digits_of_power(double exponent);

/// A number as it would be given: 12, 0.25, with at most six digits.
std::string plain_number(double value);

/// "1 frame", "30 frames".
std::string counted(long long count, std::string_view what);

/// An integer with thin spaces (U+2009) between groups of three digits, from five digits on: 1234,
/// 12 345.
std::string grouped(long long value);

}  // namespace carom
