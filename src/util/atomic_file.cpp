#include "util/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "util/diagnostics.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(std::string_view what, const fs::path& path, int error = errno) {
    throw_system_error(fmt::format("cannot {} {}: {}", what, path.string(), std::strerror(error)),
                       error);
}

// Names have room for 255 bytes: of a long one the beginning, as whole code points.
std::string pattern_beside(const fs::path& path) {
    std::string name = path.filename().string();
    constexpr std::size_t enough = 200;
    std::size_t length = std::min(name.size(), enough);
    while (length > 0 && length < name.size() && (name[length] & 0xC0) == 0x80) --length;
    name.resize(length);
    return (folder_of(path) / ("." + name + ".XXXXXX")).string();
}

// A link stays one: what it leads to is written, which need not be there yet.
fs::path behind_links(const fs::path& path) {
    constexpr int most = 40;  // as the system follows
    fs::path target = path;
    std::error_code error;
    for (int i = 0; fs::is_symlink(fs::symlink_status(target, error)); ++i) {
        if (i == most) fail("write", path, ELOOP);
        target = folder_of(target) / fs::read_symlink(target, error);
        if (error) fail("write", path, error.value());
    }
    return target;
}

void create_folder_of(const fs::path& path) {
    std::error_code error;
    fs::create_directories(folder_of(path), error);
    if (error) fail("create the folder", folder_of(path), error.value());
}

int create_beside(const fs::path& path, const fs::path& target, fs::path& temporary) {
    std::string name = pattern_beside(target);
    const int descriptor = mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0) fail("write", path);
    temporary = name;
    return descriptor;
}

// mkstemp and mkdtemp make what is private; the finished one has the rights any new one would have.
mode_t usual_rights(mode_t all) {
    const mode_t mask = umask(0);
    umask(mask);
    return all & ~mask;
}

void write_all(int descriptor, std::span<const std::uint8_t> bytes, const fs::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail("write", path, written == 0 ? ENOSPC : errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

// Some file systems cannot sync, which loses nothing but safety; an error of writing is one.
void sync_file(int descriptor, const fs::path& path) {
    if (fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS) fail("write", path);
}

void sync_folder(const fs::path& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);  // some file systems refuse to sync a folder: the rename has happened all
                        // the same
    close(descriptor);
}

}  // namespace

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)), target_(behind_links(path_)) {
    std::error_code error;
    if (fs::is_directory(target_, error)) fail("write", path_, EISDIR);
    create_folder_of(target_);
    descriptor_ = create_beside(path_, target_, temporary_);
    fchmod(descriptor_, usual_rights(0666));
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
    write_all(descriptor_, bytes, path_);
}

void AtomicFile::write(std::string_view text) {
    write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::int64_t AtomicFile::size() const {
    struct stat status = {};
    if (fstat(descriptor_, &status) != 0) fail("write", path_);
    return status.st_size;
}

void AtomicFile::commit() {
    sync_file(descriptor_, path_);
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (close(descriptor) != 0) fail("write", path_);
    if (rename(temporary_.c_str(), target_.c_str()) != 0) fail("write", path_);
    temporary_.clear();
    sync_folder(folder_of(target_));
}

AtomicFolder::AtomicFolder(fs::path path) : path_(std::move(path)) {
    if (!path_.has_filename()) path_ = path_.parent_path();  // a slash at its end
    std::error_code error;
    const fs::file_status found = fs::status(path_, error);
    if (fs::is_directory(found)) {
        const bool empty = fs::is_empty(path_, error);
        if (!error && !empty) fail("write", path_, ENOTEMPTY);
        if (!error) path_ = fs::canonical(path_, error);  // a link to it stays one
        if (error) fail("write", path_, error.value());
    } else if (fs::exists(found)) {
        fail("write", path_, ENOTDIR);
    }
    create_folder_of(path_);
    std::string name = pattern_beside(path_);
    if (mkdtemp(name.data()) == nullptr) fail("write", path_);
    temporary_ = name;
}

AtomicFolder::~AtomicFolder() {
    std::error_code error;
    if (!temporary_.empty()) fs::remove_all(temporary_, error);
}

void AtomicFolder::write(const std::string& name, std::span<const std::uint8_t> bytes) const {
    const fs::path shown = path_ / name;
    const int descriptor =
        open((temporary_ / name).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) fail("write", shown);
    try {
        write_all(descriptor, bytes, shown);
        sync_file(descriptor, shown);
    } catch (...) {
        close(descriptor);
        throw;
    }
    if (close(descriptor) != 0) fail("write", shown);
}

// The system renames a folder onto an empty one in a single step, and onto no other.
void AtomicFolder::commit() {
    if (chmod(temporary_.c_str(), usual_rights(0777)) != 0) fail("write", path_);
    sync_folder(temporary_);
    if (rename(temporary_.c_str(), path_.c_str()) != 0) fail("write", path_);
    temporary_.clear();
    sync_folder(folder_of(path_));
}

void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void write_file(const std::filesystem::path& path, std::string_view text) {
    write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string read_file(const fs::path& path, std::int64_t most) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail("read", path);
    struct Closer {
        int descriptor;
        ~Closer() { close(descriptor); }
    } closer{descriptor};

    std::string text;
    std::vector<char> buffer(1 << 16);
    while (true) {
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail("read", path);
        if (count == 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(count));
        if (static_cast<std::int64_t>(text.size()) > most)
            throw SystemError(
                fmt::format("cannot read {}: it is larger than {} bytes", path.string(), most));
    }
}

}  // namespace carom
