// Lossless conversion of file names to UTF-8, for formats that allow nothing else, such as JSON.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// Returns a name of arbitrary bytes as UTF-8: bytes that are not UTF-8 become \xHH, and a
/// backslash is doubled.
std::string utf8_of_name(std::string_view name);

/// Returns the name that utf8_of_name() converted to `text`.
std::string name_of_utf8(std::string_view text);

}  // namespace carom
