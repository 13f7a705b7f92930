#include "util/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "util/diagnostics.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(std::string_view what, const fs::path& path, int error = errno) {
    throw SystemError(fmt::format("cannot {} {}: {}", what, path.string(), std::strerror(error)));
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

int create_beside(const fs::path& path, fs::path& temporary) {
    std::string name = (folder_of(path) / ("." + path.filename().string() + ".XXXXXX")).string();
    const int descriptor = mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0) fail("write", path);
    temporary = name;
    return descriptor;
}

// mkstemp makes a private file; the finished one has the rights any new file would have.
void give_usual_rights(int descriptor) {
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, 0666 & ~mask);
}

void sync_folder(const fs::path& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);  // some file systems refuse to sync a folder: the rename has happened all
                        // the same
    close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
    std::error_code error;
    if (fs::is_directory(path_, error)) fail("write", path_, EISDIR);
    error.clear();
    fs::create_directories(folder_of(path_), error);
    if (error) fail("create the folder", folder_of(path_), error.value());
    descriptor_ = create_beside(path_, temporary_);
    give_usual_rights(descriptor_);
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail("write", path_, written == 0 ? ENOSPC : errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void AtomicFile::write(std::string_view text) {
    write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void AtomicFile::seek(std::int64_t offset) {
    if (lseek(descriptor_, offset, SEEK_SET) < 0) fail("write", path_);
}

std::int64_t AtomicFile::read(std::span<std::uint8_t> bytes) {
    while (true) {
        const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail("read back", path_);
        return count;
    }
}

std::int64_t AtomicFile::size() const {
    struct stat status = {};
    if (fstat(descriptor_, &status) != 0) fail("write", path_);
    return status.st_size;
}

void AtomicFile::commit() {
    if (fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail("write", path_);
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (close(descriptor) != 0) fail("write", path_);
    if (rename(temporary_.c_str(), path_.c_str()) != 0) fail("write", path_);
    temporary_.clear();
    sync_folder(folder_of(path_));
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
