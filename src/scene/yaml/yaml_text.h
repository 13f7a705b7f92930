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

/// Whether a colour stands in `text` without quotes, so that YAML takes it for a comment.
bool has_bare_color(std::string_view text);

}  // namespace carom
