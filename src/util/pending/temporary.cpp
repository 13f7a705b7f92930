#include "util/pending/temporary.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <new>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view unique = "XXXXXX";

// Locks may be visible on one machine only, so that a file that another machine is writing looks
// abandoned here. The name of the machine is therefore part of the pattern.
std::string mark() {
    std::array<char, 256> host = {};
    gethostname(host.data(), host.size() - 1);
    constexpr std::size_t enough = 20;
    return fmt::format(".carom-{}.", std::string_view(host.data()).substr(0, enough));
}

// File names have at most 255 bytes: of a long name, takes the beginning, cut between code points.
std::string pattern_beside(const fs::path& path) {
    std::string name = path.filename().string();
    constexpr std::size_t enough = 200;
    std::size_t length = std::min(name.size(), enough);
    while (length > 0 && length < name.size() && (name[length] & 0xC0) == 0x80) --length;
    name.resize(length);
    return (folder_of(path) / ("." + name + mark() + std::string(unique))).string();
}

// Returns as many digits as `unique` has. Temporary names are not results: they need not be
// reproducible.
std::string random_ending() {
    constexpr unsigned digits = 0xFFFFFF;
    return fmt::format("{:06x}", std::random_device()() & digits);
}

bool is_temporary(std::string_view name) {
    const std::string middle = mark();
    if (name.size() < 1 + middle.size() + unique.size() || name.front() != '.') return false;
    name.remove_suffix(unique.size());
    return name.ends_with(middle);
}

bool is_still_there(int descriptor, const std::string& name) {
    struct stat open = {}, found = {};
    return fstat(descriptor, &open) == 0 && lstat(name.c_str(), &found) == 0 &&
           open.st_ino == found.st_ino && open.st_dev == found.st_dev;
}

// The names in a folder, which is open only while they are read.
std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    DIR* const entries = opendir(folder.c_str());
    if (entries == nullptr) return names;
    while (const dirent* const entry = readdir(entries))
        if (const std::string_view name = entry->d_name; name != "." && name != "..")
            names.emplace_back(name);
    closedir(entries);
    return names;
}

// std::filesystem::remove_all() keeps a descriptor open for each level of folders, and fails where
// all descriptors are in use.
int remove_tree(const fs::path& path) {
    const auto is_removed = [&] { return std::remove(path.c_str()) == 0 || errno == ENOENT; };
    if (is_removed()) return 0;
    if (errno != ENOTEMPTY && errno != EEXIST) return errno;
    for (const std::string& name : names_in(path))
        if (const int error = remove_tree(path / name); error != 0) return error;
    return is_removed() ? 0 : errno;
}

// A lock ends with its process: if a file can be locked, nobody owns it.
void remove_if_dead(const fs::path& path) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) remove_tree(path);
    close(descriptor);
}

// Whether a folder is seen for the first time, by whatever path.
bool is_first_look_at(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> seen;
    std::error_code error;
    fs::path place = fs::canonical(folder, error);
    if (error) return false;
    const std::lock_guard lock(mutex);
    return seen.insert(std::move(place)).second;
}

// Waits for the lock: between the creation and the locking of a file, another process may take it
// for abandoned, lock and remove it; then `make` creates another one.
template <class Make>
TemporaryFile locked(const fs::path& path, const Make& make) {
    constexpr int most_tries = 100;
    for (int i = 0; i < most_tries; ++i) {
        std::string name = pattern_beside(path);
        const int descriptor = make(name);
        if (descriptor < 0) return {};
        flock(descriptor, LOCK_EX);
        try {
            if (is_still_there(descriptor, name)) return {descriptor, name};
        } catch (const std::bad_alloc&) {  // when copying the name
            std::remove(name.c_str());
            close(descriptor);
            throw;
        }
        close(descriptor);
    }
    errno = EEXIST;
    return {};
}

int unnamed_file(const fs::path& folder) {
#ifdef O_TMPFILE
    int descriptor = -1;
    do descriptor = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0) return -1;
    // Without /proc it could not be given a name.
    if (!path_of_descriptor(descriptor).empty()) return descriptor;
    close(descriptor);
#endif
    errno = EOPNOTSUPP;
    return -1;
}

}  // namespace

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path path_of_descriptor(int descriptor) {
    std::string path = fmt::format("/proc/self/fd/{}", descriptor);
    return access(path.c_str(), F_OK) == 0 ? fs::path(std::move(path)) : fs::path();
}

void remove_abandoned(const fs::path& folder) {
    if (!is_first_look_at(folder)) return;
    for (const std::string& name : names_in(folder))
        if (is_temporary(name)) remove_if_dead(folder / name);
}

// It is closed first: removing what is in a folder takes a descriptor.
int remove_temporary(TemporaryFile& file) noexcept {
    if (file.descriptor >= 0) close(std::exchange(file.descriptor, -1));
    if (file.name.empty()) return 0;
    try {
        return remove_tree(std::exchange(file.name, {}));
    } catch (const std::bad_alloc&) {
        return ENOMEM;
    }
}

TemporaryFile temporary_file(const fs::path& path) {
    remove_abandoned(folder_of(path));
    const int unnamed = unnamed_file(folder_of(path));
    if (unnamed >= 0) {
        flock(unnamed, LOCK_EX);  // protects it while it has a temporary name, see named_beside()
        return {unnamed, {}};
    }
    return locked(path, [](std::string& name) { return mkostemp(name.data(), O_CLOEXEC); });
}

// Does not allocate once the name exists, so that the name cannot be lost.
fs::path named_beside(const fs::path& path, int descriptor) {
    constexpr int most_tries = 100;
    for (int i = 0; i < most_tries; ++i) {
        std::string text = pattern_beside(path);
        text.replace(text.size() - unique.size(), unique.size(), random_ending());
        fs::path name = std::move(text);
        if (linkat(AT_FDCWD, path_of_descriptor(descriptor).c_str(), AT_FDCWD, name.c_str(),
                   AT_SYMLINK_FOLLOW) == 0)
            return name;
        if (errno != EEXIST && errno != EINTR) return {};
    }
    return {};
}

TemporaryFile temporary_folder(const fs::path& path) {
    remove_abandoned(folder_of(path));
    return locked(path, [](std::string& name) {
        if (mkdtemp(name.data()) == nullptr) return -1;
        const int descriptor = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor < 0) {
            const int cause = errno;
            rmdir(name.c_str());
            errno = cause;
        }
        return descriptor;
    });
}

}  // namespace carom
