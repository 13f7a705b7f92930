#include "util/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "util/diagnostics.h"
#include "util/files/links.h"
#include "util/files/new_file.h"
#include "util/files/scratch_file.h"
#include "util/memory/memory_reserve.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(std::string_view what, const fs::path& path, int error = errno) {
    throw_system_error(fmt::format("cannot {} {}: {}", what, path.string(),
                                   std::generic_category().message(error)),
                       error);
}

std::span<const std::uint8_t> as_bytes(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// In messages.
fs::path name_of_scratch(const char* what) {
    return fmt::format("a temporary {} in {}", what, folder_for_scratch().string());
}

void create_folder_of(const fs::path& path) {
    std::error_code error;
    fs::create_directories(folder_of(path), error);
    if (error) fail("create the folder", folder_of(path), error.value());
}

// `shown`: the path as the user has named it.
void refuse_other_kinds(const fs::path& target, const fs::path& shown) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) fail("write", shown, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw SystemError(fmt::format(
            "cannot write {}: a device or a pipe would be replaced by a file", shown.string()));
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

void refuse_existing(const fs::path& path) {
    throw UsageError(
        fmt::format("{} exists already and was left unchanged; give another name", path.string()));
}

void commit_together(const std::vector<PendingOutput*>& outputs) {
    for (PendingOutput* output : outputs) output->settle();
    const MustCleanUp together;
    std::string there;
    const auto with_those = [&](std::string_view failure) {
        return fmt::format("{}; already written: {}", failure, there);
    };
    for (PendingOutput* output : outputs) {
        std::string next = there + (there.empty() ? "" : ", ") + output->name();
        try {
            output->commit();
        } catch (const TemporaryError& error) {
            if (there.empty()) throw;
            throw TemporaryError(with_those(error.what()));
        } catch (const SystemError& error) {
            if (there.empty()) throw;
            throw SystemError(with_those(error.what()));
        } catch (const std::bad_alloc&) {
            if (there.empty()) throw;
            throw SystemError(
                with_those(fmt::format("cannot write {}: not enough memory", output->name())));
        }
        there.swap(next);
    }
}

// A symbolic link to a file that may be replaced is kept: the file that it points to is written.
AtomicFile::AtomicFile(fs::path path, Earlier earlier)
    : path_(std::move(path)),
      target_(earlier == Earlier::kept ? path_ : behind_links(path_)),
      earlier_(earlier) {
    if (earlier_ == Earlier::replaced) refuse_other_kinds(target_, path_);
    create_folder_of(target_);
    begin();
}

// The path by way of the open folder leads there even if somebody puts a link in the place of the
// folder meanwhile.
AtomicFile::AtomicFile(const StoredFile& file)
    : folder_(opened_folder_of(file, MissingFolders::create)), path_(file.path()) {
    if (!folder_.is_open()) {
        const int cause = errno;
        throw_system_error(
            fmt::format("cannot write {}: {}", path_.string(), cause_of_failure(cause)), cause);
    }
    const fs::path name = file.name.filename(), opened = path_of_descriptor(folder_.number());
    target_ = opened.empty() ? path_ : opened / name;
    struct stat status = {};
    if (fstatat(folder_.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
        S_ISDIR(status.st_mode))
        fail("write", path_, EISDIR);
    begin();
}

AtomicFile::AtomicFile(Scratch) : path_(name_of_scratch("file")) {
    require_folder_for_scratch();
    open_beside(folder_for_scratch() / "scratch");
}

void AtomicFile::begin() {
    struct stat status = {};
    if (lstat(target_.c_str(), &status) != 0 && errno == ENAMETOOLONG) fail("write", path_);
    only_.emplace(path_, folder_.is_open() ? path_ : target_);
    open_beside(target_);
    fchmod(file_.descriptor, usual_rights(0666));
}

void AtomicFile::open_beside(const fs::path& path) {
    named_.emplace();
    file_ = temporary_file(path);
    if (file_.name.empty()) named_.reset();
    if (file_.descriptor < 0) fail("write", path_);
}

AtomicFile::~AtomicFile() { discard(file_); }

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
    write_all(file_.descriptor, bytes, path_);
}

void AtomicFile::write(std::string_view text) { write(as_bytes(text)); }

void AtomicFile::write_at(std::int64_t place, std::span<const std::uint8_t> bytes) {
    if (const int error = carom::write_at(file_.descriptor, place, std::as_bytes(bytes));
        error != 0)
        throw_unwritable(path_, error);
}

std::size_t AtomicFile::read_at(std::int64_t place, std::span<std::uint8_t> to) const {
    const auto count = carom::read_at(file_.descriptor, place, std::as_writable_bytes(to));
    if (!count) fail("read back", path_);
    return *count;
}

std::int64_t AtomicFile::size() const {
    struct stat status = {};
    if (fstat(file_.descriptor, &status) != 0) fail("write", path_);
    return status.st_size;
}

void AtomicFile::settle() {
    if (!is_settled_ && !target_.empty()) sync_file(file_.descriptor, path_);
    is_settled_ = true;
}

// A new name is given in a single step. To replace an earlier file, the file first gets a temporary
// name, for as short a time as possible.
bool AtomicFile::appears() {
    if (file_.name.empty()) {
        if (linkat(AT_FDCWD, path_of_descriptor(file_.descriptor).c_str(), AT_FDCWD,
                   target_.c_str(), AT_SYMLINK_FOLLOW) == 0)
            return true;
        if (errno != EEXIST || earlier_ == Earlier::kept) return false;
        named_.emplace();
        file_.name = named_beside(target_, file_.descriptor);
        if (file_.name.empty()) return false;
    }
    if (!takes_its_name()) return false;
    file_.name.clear();
    named_.reset();
    return true;
}

bool AtomicFile::takes_its_name() {
    if (earlier_ == Earlier::replaced) return rename(file_.name.c_str(), target_.c_str()) == 0;
#ifdef RENAME_NOREPLACE
    if (renameat2(AT_FDCWD, file_.name.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0)
        return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
#endif
    if (link(file_.name.c_str(), target_.c_str()) != 0) return false;
    unlink(file_.name.c_str());
    return true;
}

// The file is closed after it has its name, because until then its lock shows that it is not
// abandoned. Errors that close() could report have already been reported by fsync().
void AtomicFile::commit() {
    if (target_.empty()) throw std::logic_error("a temporary file gets no name");
    settle();
    const fs::path folder = folder_of(target_);  // allocates while that may still fail
    throw_if_memory_ran_out();
    if (!appears()) {
        if (errno == EEXIST && earlier_ == Earlier::kept) refuse_existing(path_);
        fail("write", path_);
    }
    note_output();
    only_.reset();
    close(file_.descriptor);
    file_.descriptor = -1;
    sync_folder(folder);
}

namespace {

// A finished file on its way to another folder of the same file system.
class MovedFile : public PendingOutput {
  public:
    MovedFile(fs::path from, fs::path to) : from_(std::move(from)), to_(std::move(to)) {}

    void settle() override {
        std::error_code error;
        if (fs::is_directory(fs::symlink_status(to_, error))) fail("write", to_, EISDIR);
    }
    void commit() override {
        if (rename(from_.c_str(), to_.c_str()) != 0) fail("write", to_);
    }
    std::string name() const override { return to_.string(); }

  private:
    fs::path from_, to_;
};

}  // namespace

AtomicFolder::AtomicFolder(fs::path path, Earlier earlier) : path_(std::move(path)) {
    if (!path_.has_filename()) path_ = path_.parent_path();  // removes a slash at the end
    std::error_code error;
    const fs::file_status found = fs::status(path_, error);
    if (fs::is_directory(found)) {
        is_filled_ = !fs::is_empty(path_, error);
        if (!error && is_filled_ && earlier == Earlier::kept) fail("write", path_, ENOTEMPTY);
        if (!error) path_ = fs::canonical(path_, error);  // a link to the folder is kept
        if (error) fail("write", path_, error.value());
    } else if (fs::exists(found)) {
        fail("write", path_, ENOTDIR);
    }
    create_folder_of(path_);
    folder_ = temporary_folder(is_filled_ ? path_ / "files" : path_);
    if (folder_.descriptor < 0) fail("write", path_);
}

AtomicFolder::AtomicFolder(Scratch) : path_(name_of_scratch("folder")), is_scratch_(true) {
    require_folder_for_scratch();
    folder_ = temporary_folder(folder_for_scratch() / "scratch");
    if (folder_.descriptor < 0) fail("write", path_);
}

AtomicFolder::~AtomicFolder() { discard(folder_); }

void AtomicFolder::write(const std::string& name, std::span<const std::uint8_t> bytes) const {
    write_pieces(name, [&](const TakePiece& take) {
        take({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
}

void AtomicFolder::write_pieces(const std::string& name,
                                const std::function<void(const TakePiece&)>& copy) const {
    write_new_file(folder_.name / name, copy, is_scratch_ ? path_ : path_ / name);
}

void AtomicFolder::settle() {
    if (is_scratch_ || is_filled_) return;
    if (chmod(folder_.name.c_str(), usual_rights(0777)) != 0) fail("write", path_);
    sync_folder(folder_.name);
}

// What is in the temporary folder then is removed with it.
void AtomicFolder::commit_files() {
    std::vector<std::unique_ptr<PendingOutput>> files;
    for (const auto& entry : fs::directory_iterator(folder_.name))
        files.push_back(std::make_unique<MovedFile>(entry.path(), path_ / entry.path().filename()));
    std::ranges::sort(files, {}, [](const auto& file) { return file->name(); });
    std::vector<PendingOutput*> together;
    for (const auto& file : files) together.push_back(file.get());
    commit_together(together);
    note_output();
    sync_folder(path_);
    discard(folder_);
}

// rename() replaces an empty folder in a single step, and fails for any other folder.
void AtomicFolder::commit() {
    if (is_scratch_) throw std::logic_error("a temporary folder gets no name");
    if (is_filled_) return commit_files();
    settle();
    const fs::path folder = folder_of(path_);
    throw_if_memory_ran_out();
    if (rename(folder_.name.c_str(), path_.c_str()) != 0) fail("write", path_);
    note_output();
    folder_.name.clear();
    sync_folder(folder);
}

namespace {

void write_and_commit(AtomicFile&& file, std::span<const std::uint8_t> bytes) {
    file.write(bytes);
    file.commit();
}

}  // namespace

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
    write_and_commit(AtomicFile(path), bytes);
}

void write_file(const fs::path& path, std::string_view text) { write_file(path, as_bytes(text)); }

void write_file(const StoredFile& file, std::span<const std::uint8_t> bytes) {
    write_and_commit(AtomicFile(file), bytes);
}

void write_file(const StoredFile& file, std::string_view text) { write_file(file, as_bytes(text)); }

}  // namespace carom
