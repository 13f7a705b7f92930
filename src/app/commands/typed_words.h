// The words of a command line, written out before they are parsed.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"

namespace carom {

/// Turns `--set a=1 b=2` into `--set a=1 --set b=2`, unless a file has such a name.
std::vector<std::string> with_each_set(std::vector<std::string> words);

/// Gives options whose value may be missing (Option::absent) the one that they have then. A scene
/// that follows is not the value.
void fill_absent_values(std::vector<std::string>& words, const std::vector<Option>& options);

}  // namespace carom
