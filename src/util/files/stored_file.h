// The files that carom keeps in a folder and reads back: plans and their chunks, caches, lists of
// what it wrote. A stranger may have filled the folder, so that nothing in it is followed.
#pragma once

#include <filesystem>
#include <string>

#include "util/pending/descriptor.h"

namespace carom {

/// The name of a file in a folder of carom. Links on the way to the folder are followed, as the
/// user has named it. Below it neither the file nor a folder on the way to it may be a link.
struct StoredFile {
    std::filesystem::path folder;
    std::filesystem::path name;  ///< relative to the folder, without `..`

    std::filesystem::path path() const { return folder / name; }
};

/// Whether the folders on the way to a stored file are created if they are missing.
enum class MissingFolders { fail, create };

/// Opens the folder that directly contains the file. On failure the descriptor is closed and errno
/// is set: ELOOP for a link on the way, EINVAL for a name that leads out of the folder.
Descriptor opened_folder_of(const StoredFile& file, MissingFolders missing);

/// Removes the file, or the link in its place; returns false and sets errno if that fails.
bool remove_stored(const StoredFile& file);

/// The cause of a failure with this errno value, in words.
std::string cause_of_failure(int error);

}  // namespace carom
