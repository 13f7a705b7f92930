// Pages of the manual for man(1).
#pragma once

#include <string>

#include "app/manual/page.h"

namespace carom {

/// The page in the man macros of roff, section 1.
std::string roff_of(const ManualPage& page);

}  // namespace carom
