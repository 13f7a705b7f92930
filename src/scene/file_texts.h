// The texts of the files of a scene.
#pragma once

#include <map>
#include <string>

namespace carom {

/// Texts of files by their paths.
using FileTexts = std::map<std::string, std::string>;

}  // namespace carom
