#include "util/files/stored_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr mode_t rights_of_folders = 0777;  // less the umask

int opened_at(int at, const char* name, int flags) {
    int descriptor = -1;
    do descriptor = openat(at, name, O_RDONLY | O_DIRECTORY | O_CLOEXEC | flags);
    while (descriptor < 0 && errno == EINTR);
    return descriptor;
}

// The system reports a link as something that is no folder.
Descriptor opened_below(int at, const char* name) {
    Descriptor folder(opened_at(at, name, O_NOFOLLOW));
    const int cause = errno;
    struct stat status = {};
    if (!folder.is_open() && cause == ENOTDIR &&
        fstatat(at, name, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(status.st_mode))
        errno = ELOOP;
    else if (!folder.is_open())
        errno = cause;
    return folder;
}

Descriptor opened_root(const fs::path& folder, MissingFolders missing) {
    const fs::path path = folder.empty() ? fs::path(".") : folder;
    if (missing == MissingFolders::create) {
        std::error_code error;
        fs::create_directories(path, error);
        if (error) {
            errno = error.value();
            return {};
        }
    }
    return Descriptor(opened_at(AT_FDCWD, path.c_str(), 0));
}

}  // namespace

Descriptor opened_folder_of(const StoredFile& file, MissingFolders missing) {
    Descriptor folder = opened_root(file.folder, missing);
    for (const fs::path& part : file.name.parent_path()) {
        if (!folder.is_open()) return {};
        if (part == ".." || part.is_absolute()) {
            errno = EINVAL;
            return {};
        }
        if (missing == MissingFolders::create &&
            mkdirat(folder.number(), part.c_str(), rights_of_folders) != 0 && errno != EEXIST)
            return {};
        folder = opened_below(folder.number(), part.c_str());
    }
    return folder;
}

bool remove_stored(const StoredFile& file) {
    const Descriptor folder = opened_folder_of(file, MissingFolders::fail);
    return folder.is_open() && unlinkat(folder.number(), file.name.filename().c_str(), 0) == 0;
}

std::string cause_of_failure(int error) {
    if (error == ELOOP) return "there is a symbolic link in its place, and links are not followed";
    if (error == EINVAL) return "its name leads out of its folder";
    return std::generic_category().message(error);
}

}  // namespace carom
