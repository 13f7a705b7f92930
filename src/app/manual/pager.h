// Text for a reader: through a pager on a terminal.
#pragma once

#include <string>

namespace carom {

/// Shows the text with $PAGER where standard output is a terminal and PAGER is set, else prints it.
/// Throws SystemError where it cannot be written.
void show_pages(const std::string& text);

}  // namespace carom
