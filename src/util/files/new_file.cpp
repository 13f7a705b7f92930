#include "util/files/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <string>
#include <system_error>

#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {

namespace fs = std::filesystem;

void throw_unwritable(const fs::path& shown, int error) {
    throw_system_error(
        fmt::format("cannot write {}: {}", shown.string(), std::generic_category().message(error)),
        error);
}

void write_all(int descriptor, std::span<const std::uint8_t> bytes, const fs::path& shown) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) throw_unwritable(shown, written == 0 ? ENOSPC : errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

int write_at(int descriptor, std::int64_t place, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = pwrite(descriptor, bytes.data(), bytes.size(), place);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written == 0 ? ENOSPC : errno;
        place += written;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

std::optional<std::size_t> read_at(int descriptor, std::int64_t place, std::span<std::byte> to) {
    std::size_t done = 0;
    while (done < to.size()) {
        const ssize_t count = pread(descriptor, to.data() + done, to.size() - done,
                                    place + static_cast<std::int64_t>(done));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return std::nullopt;
        if (count == 0) break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

// Some file systems cannot sync. That costs only safety, so that it is not an error; a failure to
// write is one.
void sync_file(int descriptor, const fs::path& shown) {
    while (fsync(descriptor) != 0) {
        if (errno == EINVAL || errno == EROFS) return;
        if (errno != EINTR) throw_unwritable(shown, errno);
    }
}

void write_new_file(const fs::path& path, const std::function<void(const TakePiece&)>& copy,
                    const fs::path& shown) {
    const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) throw_unwritable(shown, errno);
    try {
        copy([&](std::string_view piece) {
            write_all(descriptor,
                      {reinterpret_cast<const std::uint8_t*>(piece.data()), piece.size()}, shown);
        });
        sync_file(descriptor, shown);
    } catch (...) {
        close(descriptor);
        throw;
    }
    if (close(descriptor) != 0) throw_unwritable(shown, errno);
}

void write_new_file(const fs::path& path, std::span<const std::uint8_t> bytes,
                    const fs::path& shown) {
    write_new_file(
        path,
        [&](const TakePiece& take) {
            take({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        },
        shown);
}

void discard(TemporaryFile& file) noexcept {
    try {
        const std::string name = printable(file.name.string());
        const int error = remove_temporary(file);
        if (error == 0) return;
        write_to_standard_error({"carom: cannot remove ", name, ": ",
                                 std::generic_category().message(error),
                                 "; the next command that writes there removes it\n"});
    } catch (const std::bad_alloc&) {
        remove_temporary(file);
    }
}

}  // namespace carom
