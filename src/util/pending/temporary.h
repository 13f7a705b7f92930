// Temporary files and folders for outputs that do not have their final names yet. If the system
// supports it, such a file has no name; otherwise its name allows a later process to recognise
// those that killed processes left behind.
#pragma once

#include <filesystem>

namespace carom {

/// Returns the folder of the file at a path; "." for a bare file name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// A file descriptor, open for writing, and the file's name. A named file is locked while the
/// descriptor is open.
struct TemporaryFile {
    int descriptor = -1;
    std::filesystem::path name;  ///< empty: it has no name and vanishes when closed
};

/// Creates a temporary file in the folder of `path`; on failure the descriptor is -1 and errno is
/// set. The first call for a folder removes from it the temporary files of killed processes of this
/// machine.
TemporaryFile temporary_file(const std::filesystem::path& path);

/// Gives a file without a name a temporary one in the folder of `path` and returns it; on failure
/// returns an empty path and sets errno.
std::filesystem::path named_beside(const std::filesystem::path& path, int descriptor);

/// Like temporary_file(), for a folder that only its owner may access.
TemporaryFile temporary_folder(const std::filesystem::path& path);

/// Returns the path under which the system lists an open file, by which it can be opened again and
/// given a name.
std::filesystem::path path_of_descriptor(int descriptor);

}  // namespace carom
