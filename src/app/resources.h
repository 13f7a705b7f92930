// Where carom's own files are: beside the program in an install tree, above it in a build tree.
#pragma once

#include <filesystem>

namespace carom {

/// The folder templates/ (holding films/). Throws SystemError when it is nowhere near the program.
std::filesystem::path templates_folder();

}  // namespace carom
