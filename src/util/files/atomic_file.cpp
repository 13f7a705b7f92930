#include "util/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

#include "util/diagnostics.h"
#include "util/files/links.h"
#include "util/files/new_file.h"
#include "util/memory/memory_reserve.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(std::string_view what, const fs::path& path, int error = errno) {
    throw_system_error(fmt::format("cannot {} {}: {}", what, path.string(), std::strerror(error)),
                       error);
}

void create_folder_of(const fs::path& path) {
    std::error_code error;
    fs::create_directories(folder_of(path), error);
    if (error) fail("create the folder", folder_of(path), error.value());
}

// A temporary file or folder is accessible to its owner only; the finished one gets the permissions
// of any new file or folder.
mode_t usual_rights(mode_t all) {
    const mode_t mask = umask(0);
    umask(mask);
    return all & ~mask;
}

void sync_folder(const fs::path& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);  // some file systems refuse to sync a folder; the rename has happened
                        // nevertheless
    close(descriptor);
}

}  // namespace

void commit_together(const std::vector<PendingOutput*>& outputs) {
    for (PendingOutput* output : outputs) output->settle();
    const MustCleanUp together;
    std::string there;
    for (PendingOutput* output : outputs) {
        std::string next = there + (there.empty() ? "" : ", ") + output->name();
        try {
            output->commit();
        } catch (const SystemError& error) {
            if (there.empty()) throw;
            throw SystemError(fmt::format("{}; already written: {}", error.what(), there));
        } catch (const std::bad_alloc&) {
            if (there.empty()) throw;
            throw SystemError(fmt::format("cannot write {}: not enough memory; already written: {}",
                                          output->name(), there));
        }
        there.swap(next);
    }
}

// A symbolic link is kept: the file that it points to is written.
AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)), target_(behind_links(path_)) {
    only_.emplace(path_, target_);
    std::error_code error;
    const fs::file_status status = fs::status(target_, error);
    if (fs::is_directory(status)) fail("write", path_, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw SystemError(fmt::format(
            "cannot write {}: a device or a pipe would be replaced by a file", path_.string()));
    create_folder_of(target_);
    named_.emplace();
    file_ = temporary_file(target_);
    if (file_.name.empty()) named_.reset();
    if (file_.descriptor < 0) fail("write", path_);
    fchmod(file_.descriptor, usual_rights(0666));
}

AtomicFile::~AtomicFile() {
    if (!file_.name.empty()) unlink(file_.name.c_str());
    if (file_.descriptor >= 0) close(file_.descriptor);
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
    write_all(file_.descriptor, bytes, path_);
}

void AtomicFile::write(std::string_view text) {
    write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::int64_t AtomicFile::size() const {
    struct stat status = {};
    if (fstat(file_.descriptor, &status) != 0) fail("write", path_);
    return status.st_size;
}

fs::path AtomicFile::temporary() const {
    return file_.name.empty() ? path_of_descriptor(file_.descriptor) : file_.name;
}

void AtomicFile::settle() {
    if (!is_settled_) sync_file(file_.descriptor, path_);
    is_settled_ = true;
}

// A new name is given in a single step. To replace an earlier file, the file first gets a temporary
// name, for as short a time as possible.
bool AtomicFile::appears() {
    if (file_.name.empty()) {
        if (linkat(AT_FDCWD, temporary().c_str(), AT_FDCWD, target_.c_str(), AT_SYMLINK_FOLLOW) ==
            0)
            return true;
        if (errno != EEXIST) return false;
        named_.emplace();
        file_.name = named_beside(target_, file_.descriptor);
        if (file_.name.empty()) return false;
    }
    if (rename(file_.name.c_str(), target_.c_str()) != 0) return false;
    file_.name.clear();
    named_.reset();
    return true;
}

// The file is closed after it has its name, because until then its lock shows that it is not
// abandoned. Errors that close() could report have already been reported by fsync().
void AtomicFile::commit() {
    settle();
    const fs::path folder = folder_of(target_);  // allocates while that may still fail
    throw_if_memory_ran_out();
    if (!appears()) fail("write", path_);
    note_output();
    only_.reset();
    close(file_.descriptor);
    file_.descriptor = -1;
    sync_folder(folder);
}

AtomicFolder::AtomicFolder(fs::path path) : path_(std::move(path)) {
    if (!path_.has_filename()) path_ = path_.parent_path();  // removes a slash at the end
    std::error_code error;
    const fs::file_status found = fs::status(path_, error);
    if (fs::is_directory(found)) {
        const bool empty = fs::is_empty(path_, error);
        if (!error && !empty) fail("write", path_, ENOTEMPTY);
        if (!error) path_ = fs::canonical(path_, error);  // a link to the folder is kept
        if (error) fail("write", path_, error.value());
    } else if (fs::exists(found)) {
        fail("write", path_, ENOTDIR);
    }
    create_folder_of(path_);
    folder_ = temporary_folder(path_);
    if (folder_.descriptor < 0) fail("write", path_);
}

AtomicFolder::~AtomicFolder() {
    std::error_code error;
    if (!folder_.name.empty()) fs::remove_all(folder_.name, error);
    if (folder_.descriptor >= 0) close(folder_.descriptor);
}

void AtomicFolder::write(const std::string& name, std::span<const std::uint8_t> bytes) const {
    write_new_file(folder_.name / name, bytes, path_ / name);
}

void AtomicFolder::settle() {
    if (chmod(folder_.name.c_str(), usual_rights(0777)) != 0) fail("write", path_);
    sync_folder(folder_.name);
}

// rename() replaces an empty folder in a single step, and fails for any other folder.
void AtomicFolder::commit() {
    settle();
    const fs::path folder = folder_of(path_);
    throw_if_memory_ran_out();
    if (rename(folder_.name.c_str(), path_.c_str()) != 0) fail("write", path_);
    note_output();
    folder_.name.clear();
    sync_folder(folder);
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
