// Names of files where only UTF-8 may stand, such as JSON, without loss.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// A name of any bytes as UTF-8: those that are none as \xHH, a backslash as two.
std::string utf8_of_name(std::string_view name);

/// The name that utf8_of_name() was given.
std::string name_of_utf8(std::string_view text);

}  // namespace carom
