// Resolution of symbolic links.
#pragma once

#include <filesystem>

namespace carom {

/// Returns the path that a symbolic link finally points to, which need not exist yet; `path` itself
/// if it is not a symbolic link. Throws SystemError if links form a cycle, or cannot be read.
std::filesystem::path behind_links(const std::filesystem::path& path);

}  // namespace carom
