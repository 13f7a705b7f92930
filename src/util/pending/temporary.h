// What is written under a name of its own before it gets the final one: temporary files without a
// name where the system has them, else with one by which those of dead processes can be told.
#pragma once

#include <filesystem>

namespace carom {

/// The folder that a path names a file of; "." for a name alone.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// A file descriptor, open for writing, and how it is named. A named one is locked for as long as
/// the descriptor is open.
struct TemporaryFile {
    int descriptor = -1;
    std::filesystem::path name;  ///< empty: it has none, and is gone when it is closed
};

/// A new file in the folder of `path`; descriptor -1 and errno where there can be none. The first
/// in a folder removes from it what processes of this machine left that were killed.
TemporaryFile temporary_file(const std::filesystem::path& path);

/// Gives a file without a name a temporary one in the folder of `path`; empty and errno where that
/// cannot be.
std::filesystem::path named_beside(const std::filesystem::path& path, int descriptor);

/// The same as temporary_file for a folder, which is private.
TemporaryFile temporary_folder(const std::filesystem::path& path);

/// Where the system shows an open file; by this path it can be opened again, and given a name.
std::filesystem::path path_of_descriptor(int descriptor);

}  // namespace carom
