// Where symbolic links lead to.
#pragma once

#include <filesystem>

namespace carom {

/// What a path leads to, which need not be there yet: itself, where it is no symbolic link. Throws
/// SystemError where links lead to one another, or cannot be read.
std::filesystem::path behind_links(const std::filesystem::path& path);

}  // namespace carom
