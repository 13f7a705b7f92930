// Pages of the manual as plain text, for --help and `carom help`.
#pragma once

#include <string>

#include "app/manual/page.h"

namespace carom {

/// The page in lines of at most 80 columns, where words allow it; ends with a line break.
std::string text_of(const ManualPage& page);

}  // namespace carom
