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
/// set. Calls remove_abandoned() for the folder.
TemporaryFile temporary_file(const std::filesystem::path& path);

/// Gives a file without a name a temporary one in the folder of `path` and returns it; on failure
/// returns an empty path and sets errno.
std::filesystem::path named_beside(const std::filesystem::path& path, int descriptor);

/// Like temporary_file(), for a folder that only its owner may access.
TemporaryFile temporary_folder(const std::filesystem::path& path);

/// Removes a temporary file or folder, with what is in it, and closes it. If that fails returns
/// errno, otherwise 0. Needs no more descriptors than the one it closes.
int remove_temporary(TemporaryFile& file) noexcept;

/// Removes the temporary files and folders that killed processes of this machine have left in a
/// folder, if this process has not done so yet.
void remove_abandoned(const std::filesystem::path& folder);

/// Returns the path under which the system lists an open file, by which it can be opened again and
/// given a name; empty if the system has no such list (/proc).
std::filesystem::path path_of_descriptor(int descriptor);

}  // namespace carom
