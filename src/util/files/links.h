// Symbolic links: what they point to, and names that they take.
#pragma once

#include <filesystem>

namespace carom {

/// Returns the path that a symbolic link finally points to, which need not exist yet; `path` itself
/// if it is not a symbolic link. Throws SystemError if links form a cycle, or cannot be read.
std::filesystem::path behind_links(const std::filesystem::path& path);

/// Whether the path names something that exists; a symbolic link counts, wherever it points to.
bool is_taken(const std::filesystem::path& path);

}  // namespace carom
