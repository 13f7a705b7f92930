// YAML text looked at before and beside the parser: what it accepts silently, and where a mistake
// began that it reports elsewhere.
#pragma once

#include <cstddef>
#include <string_view>

namespace carom {

/// Where the quotation that begins at `start` ends; npos if it does not.
std::size_t end_of_quotation(std::string_view text, std::size_t start);

/// The quotation mark or else the innermost bracket that is open at the end of `text`; npos if
/// there is none.
std::size_t open_mark(std::string_view text);

/// The place of the value after `most` values, if brackets, commas and colons part so many: those
/// in texts count, too, those in lines that are comments do not. npos if there are fewer. For what
/// is too much for the parser, which takes memory for all of a bracket before it tells of it.
std::size_t place_beyond(std::string_view text, std::size_t begin, std::size_t most);

/// Whether a colour stands in `text` without quotes, so that YAML takes it for a comment.
bool has_bare_color(std::string_view text);

}  // namespace carom
