#include "util/files/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <vector>

#include "util/diagnostics.h"
#include "util/fingerprint.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t block = 1 << 18;

// Does not wait for the other end of a pipe.
int opened(int at, const char* name, int flags) {
    int descriptor = -1;
    do descriptor = openat(at, name, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | flags);
    while (descriptor < 0 && errno == EINTR);
    return descriptor;
}

std::string all_of(InputFile& file, std::int64_t most) {
    file.require_open();
    std::string text = file.rest(most);
    if (static_cast<std::int64_t>(text.size()) > most)
        file.refuse(fmt::format("it is larger than {} bytes", most));
    return text;
}

std::optional<std::string> fingerprint_of(InputFile& file) {
    if (file.is_missing() || file.is_other_kind()) return std::nullopt;
    file.require_open();
    GrowingFingerprint all;
    std::vector<char> buffer(block);
    for (std::size_t count = buffer.size(); count == buffer.size();) {
        count = file.read(buffer);
        all.add({buffer.data(), count});
    }
    return all.digits();
}

}  // namespace

InputFile::InputFile(const fs::path& path) : path_(path) {
    accept(opened(AT_FDCWD, path.c_str(), 0));
}

InputFile::InputFile(const StoredFile& file) : path_(file.path()), is_stored_(true) {
    const Descriptor folder = opened_folder_of(file, MissingFolders::fail);
    if (folder.is_open())
        accept(opened(folder.number(), file.name.filename().c_str(), O_NOFOLLOW));
    else
        error_ = errno;
}

void InputFile::accept(int descriptor) {
    error_ = errno;
    Descriptor file(descriptor);
    if (!file.is_open()) return;
    struct stat status = {};
    const bool is_known = fstat(descriptor, &status) == 0;
    error_ = !is_known ? errno : S_ISDIR(status.st_mode) ? EISDIR : 0;
    if (is_known && S_ISREG(status.st_mode)) file_ = std::move(file);
}

bool InputFile::is_missing() const { return !is_open() && (error_ == ENOENT || error_ == ENOTDIR); }

// A socket, or a device without a driver, cannot even be opened.
bool InputFile::is_other_kind() const {
    constexpr std::array kinds{0, EISDIR, ELOOP, EINVAL, ENXIO, ENODEV};
    return !is_open() && std::ranges::find(kinds, error_) != kinds.end();
}

bool InputFile::may_pass() const { return !is_open() && is_transient(error_); }

std::string InputFile::problem() const {
    if (error_ == EISDIR) return "it is a folder";
    if (error_ == 0 || error_ == ENXIO || error_ == ENODEV) return "it is no ordinary file";
    return is_stored_ ? cause_of_failure(error_) : std::generic_category().message(error_);
}

void InputFile::require_open() const {
    if (!is_open()) throw_system_error(cannot_read(problem()), error_);
}

std::string InputFile::cannot_read(const std::string& cause) const {
    return fmt::format("cannot read {}: {}", path_.string(), cause);
}

void InputFile::refuse(const std::string& cause) const { throw SystemError(cannot_read(cause)); }

void InputFile::fail(int error) const {
    throw_system_error(cannot_read(std::generic_category().message(error)), error);
}

std::size_t InputFile::read(std::span<char> to) {
    std::size_t done = 0;
    while (done < to.size()) {
        const ssize_t count = ::read(file_.number(), to.data() + done, to.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(errno);
        if (count == 0) break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

std::string InputFile::rest(std::int64_t most) {
    const auto enough = static_cast<std::size_t>(most) + 1;
    std::string text;
    std::vector<char> buffer(block);
    for (std::size_t count = buffer.size(); count == buffer.size() && text.size() < enough;) {
        count = read(buffer);
        text.append(buffer.data(), std::min(count, enough - text.size()));
    }
    return text;
}

std::int64_t InputFile::size() const {
    struct stat status = {};
    if (fstat(file_.number(), &status) != 0) fail(errno);
    return status.st_size;
}

std::string read_file(const fs::path& path, std::int64_t most) {
    InputFile file(path);
    return all_of(file, most);
}

std::string read_file(const StoredFile& stored, std::int64_t most) {
    InputFile file(stored);
    return all_of(file, most);
}

std::optional<std::string> fingerprint_of_file(const fs::path& path) {
    InputFile file(path);
    return fingerprint_of(file);
}

std::optional<std::string> fingerprint_of_file(const StoredFile& stored) {
    InputFile file(stored);
    return fingerprint_of(file);
}

}  // namespace carom
