// Small functions on text: UTF-8, nearest spelling, and numbers in the form in which viewers read
// them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace carom {

/// Returns the index of the byte after the code point that begins at `index`; each invalid byte
/// counts as one code point.
std::size_t next_code_point(std::string_view text, std::size_t index);

/// Returns the number of code points; each invalid byte counts as one.
int code_points(std::string_view text);

/// Returns whether `text` is well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates, at most
/// U+10FFFF).
bool is_utf8(std::string_view text);

/// Returns the text with U+FFFD for each byte that is not part of well-formed UTF-8: names of files
/// may contain any bytes.
std::string as_utf8(std::string_view text);

/// Returns the number of printable ASCII characters at the beginning of a text.
std::size_t plain_length(std::string_view text);

/// Returns whether a code point (given as its UTF-8 bytes) is a control character: C0, delete or
/// C1.
bool is_control(std::string_view code_point);

/// Returns untrusted text (names of files, words of the command line, titles) made safe for one
/// line on a terminal. U+FFFD replaces bytes that are not well-formed UTF-8, control characters
/// except the tab, line ends, and Unicode's bidirectional controls, which could make a text read as
/// another one.
std::string printable(std::string_view words);

/// Returns whether the brackets of a JSON text are nested deeper than `most`, not counting those in
/// its strings. For untrusted texts: a parser keeps every level in memory.
bool nests_deeper(std::string_view json, int most);

/// Returns the candidate with the smallest Damerau-Levenshtein distance (optimal string alignment)
/// to `word`, if that is at most a third of its length; nothing for a single letter.
std::optional<std::string> nearest_spelling(std::string_view word,
                                            std::span<const std::string> candidates);

/// Returns a hint for a word that is none of the candidates: "did you mean `candidate`?" with the
/// nearest spelling, or `fallback` if none is near.
std::string spelling_hint(std::string_view word, std::span<const std::string> candidates,
                          const std::string& fallback);

/// "a", "a and b", "a, b and c", each between `quote`s.
std::string listed(std::span<const std::string> words, std::string_view last = "and",
                   std::string_view quote = "");

/// Returns words ended by a full stop, unless they already end as a sentence does.
std::string sentence(const std::string& words);

/// Returns words with the first letter capitalised if it is an ASCII or Latin-1 letter. `words`
/// must not be empty.
std::string capitalised(std::string words);

/// Returns words with the ASCII letters in lower case.
std::string lower(std::string words);

/// The same in upper case.
std::string upper_case(std::string words);

/// Returns a number moved away from 0 by less than any reader can see. A value that lies half-way
/// between two digits except for round-off is then always rounded in the same direction, wherever
/// it is shown.
double off_the_tie(double value);

/// Returns a text as part of a URL: every byte except ASCII letters, digits and the characters
/// `plain` becomes %XX.
std::string percent_encoded(std::string_view text, std::string_view plain);

/// Returns an integer in superscript digits: ⁻⁷.
std::string superscript(int value);

/// Returns a number with three significant digits, as on an axis: 0.0123, 1.23, 1230, 1.23×10⁷,
/// with U+2212 as the minus sign.
std::string three_digits(double value);

/// "0.123 ± 0.004": as many decimals as show two digits of a standard error; the number alone where
/// the error is not positive and finite.
std::string with_error(double value, double error);

/// Returns a number with as many decimals as show three digits of the end of `range` that is
/// farther from 0, and with room for a sign if the range includes negative numbers: in such a
/// readout only digits change.
std::string steady_number(double value, std::pair<double, double> range);

/// Like three_digits(), for ten to the power `exponent`, even if that is too small or too large for
/// a double; 0 for an exponent of minus infinity.
std::string three_digits_of_power(double exponent);

/// Returns a number as a user would write it, 12 or 0.25, with at most six digits.
std::string plain_number(double value);

/// "1 frame", "30 frames".
std::string counted(long long count, std::string_view what);

/// Returns an integer with thin spaces (U+2009) between groups of three digits, if it has five
/// digits or more: 1234, 12 345.
std::string grouped(long long value);

}  // namespace carom
