#include "app/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

#include "util/diagnostics.h"
#include "util/files/links.h"
#include "util/interrupt.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// Under such a name even an ordinary file cannot be replaced by renaming: the folder is the
// system's.
bool is_open_already(const std::string& path) {
    return path == "/dev/stderr" || path.starts_with("/dev/fd/") || path.starts_with("/proc/");
}

[[noreturn]] void fail(const std::string& path) {
    const int error = errno;
    if (error == EPIPE && Output::is_standard_output(path)) throw ClosedPipe();
    throw_system_error(fmt::format("cannot write {}: {}",
                                   Output::is_standard_output(path) ? "standard output" : path,
                                   std::generic_category().message(error)),
                       error);
}

void refuse_folder(const std::string& path) {
    if (path.ends_with('/'))
        throw UsageError(fmt::format(
            "{}: one file is written there, and a name with a slash at its end is that of a "
            "folder; name a file, {}out for instance",
            path, path));
}

// The status of the file at a path; nothing if there is none.
std::optional<struct stat> status_of(const std::string& path) {
    struct stat status = {};
    const int failed = Output::is_standard_output(path) ? fstat(STDOUT_FILENO, &status)
                                                        : stat(path.c_str(), &status);
    return failed == 0 ? std::optional(status) : std::nullopt;
}

// Outputs to /dev/null are not mixed: all of it is discarded.
bool is_null_device(const struct stat& status) {
    struct stat null = {};
    return S_ISCHR(status.st_mode) && stat("/dev/null", &null) == 0 &&
           status.st_rdev == null.st_rdev;
}

// Opening a named pipe blocks until another process opens it for reading.
int opened(const std::string& path) {
    while (true) {
        const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor >= 0) return descriptor;
        if (errno != EINTR) fail(path);
        throw_if_interrupted();
    }
}

}  // namespace

bool Output::is_stream(const fs::path& path) {
    if (is_standard_output(path.native())) return true;
    if (is_open_already(path.lexically_normal().string())) return true;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

bool Output::are_same(const std::string& a, const std::string& b) {
    if (a == b || (is_standard_output(a) && is_standard_output(b))) return true;
    const auto one = status_of(a), other = status_of(b);
    if (one && other)
        return one->st_dev == other->st_dev && one->st_ino == other->st_ino &&
               !is_null_device(*one);
    std::error_code error;
    return !one && !other &&
           fs::absolute(a, error).lexically_normal() == fs::absolute(b, error).lexically_normal();
}

void Output::refuse_used(const fs::path& path) {
    if (!is_stream(path)) const OutputPath free(path, behind_links(path));
}

Output::Output(std::string path) : path_(std::move(path)) {
    if (is_standard_output(path_)) {
        descriptor_ = STDOUT_FILENO;
        if ((fcntl(descriptor_, F_GETFL) & O_ACCMODE) == O_RDONLY) {
            errno = EBADF;
            fail(path_);
        }
    } else if (is_stream(path_)) {
        descriptor_ = opened(path_);
        owned_ = true;
    } else {
        refuse_folder(path_);
        file_.emplace(path_);
    }
}

Output::~Output() {
    if (owned_) close(descriptor_);
}

void Output::write(std::string_view text) {
    if (file_) return file_->write(text);
    streamed_ = streamed_ || !text.empty();
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor_, text.data(), text.size());
        if (written < 0 && errno == EINTR) {  // Ctrl-C must work even if nobody reads
            throw_if_interrupted();
            continue;
        }
        if (written <= 0) fail(path_);
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string Output::left_behind() const {
    if (!streamed_) return "";
    return (is_standard_output(path_) ? "standard output" : path_) + " is incomplete";
}

void Output::settle() {
    if (file_) file_->settle();
}

void Output::commit() {
    if (file_) file_->commit();
}

}  // namespace carom
