// Scans of YAML text that complement the parser: they find what it accepts silently, and the place
// where a mistake begins that the parser reports elsewhere.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace carom {

/// Returns the index of the quotation mark that closes the quotation opened at `start`; npos if it
/// is not closed.
std::size_t end_of_quotation(std::string_view text, std::size_t start);

/// Returns the index of the quotation mark, or else of the innermost bracket, that is still open at
/// the end of `text`; npos if nothing is open.
std::size_t open_mark(std::string_view text);

/// Returns the place of the first value after `most` values, counted from `begin` by brackets,
/// commas and colons; npos if there are no more than `most`. Separators within quoted texts count,
/// too; lines that are comments do not. Called before the parser, which allocates memory for a
/// whole bracketed list before it reports anything.
std::size_t place_beyond(std::string_view text, std::size_t begin, std::size_t most);

/// Returns the index of the first backslash that begins an escape of YAML within a formula, between
/// `$` signs, of the double-quoted text that begins at `start`, and that letters follow as those of
/// a command; npos if there is none, or if the text there is not double-quoted. A doubled backslash
/// is one of the formula; a single letter, as in `\n^2`, is no command.
std::size_t escape_in_formula(std::string_view text, std::size_t start);

/// Returns the length of the command of a formula whose backslash stands at `at`.
std::size_t command_bytes(std::string_view text, std::size_t at);

/// Returns a hint if `text` contains a space, colon or comma other than those of the keyboard,
/// which YAML takes for a letter; otherwise an empty text.
std::string odd_space_hint(std::string_view text);

/// Returns the place of the line above `mistake` if it lacks a `: `, so that YAML takes the line
/// with the mistake for the rest of a text that begins there; otherwise npos.
std::size_t line_without_key(std::string_view text, std::size_t mistake);

/// Returns a hint on how such a line is written as a key with its value.
std::string key_hint(std::string_view line);

/// Returns whether `text` contains an unquoted colour as a value, which YAML takes for a comment.
bool has_bare_color(std::string_view text);

}  // namespace carom
