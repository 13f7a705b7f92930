// Writing the bytes of files that do not have their final names yet. Messages refer to such a file
// as `shown`. Functions that take `shown` throw SystemError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "util/pending/temporary.h"

namespace carom {

/// Throws the error that the file cannot be written, with its cause.
[[noreturn]] void throw_unwritable(const std::filesystem::path& shown, int error);

/// Writes all bytes to an open file.
void write_all(int descriptor, std::span<const std::uint8_t> bytes,
               const std::filesystem::path& shown);

/// Writes all bytes at a place of an open file, which may be beyond its end. Returns 0, or the
/// error of the system.
int write_at(int descriptor, std::int64_t place, std::span<const std::byte> bytes);

/// Reads the bytes at a place of an open file and returns how many there were: fewer than asked for
/// only at its end; nothing, with errno, if it cannot be read.
std::optional<std::size_t> read_at(int descriptor, std::int64_t place, std::span<std::byte> to);

/// Waits until all of an open file is on the disk, if the file system supports that.
void sync_file(int descriptor, const std::filesystem::path& shown);

/// Passes bytes on, in order and in pieces.
using TakePiece = std::function<void(std::string_view)>;

/// Creates a file and syncs it. `copy` gives it its bytes. It must not exist yet.
void write_new_file(const std::filesystem::path& path,
                    const std::function<void(const TakePiece&)>& copy,
                    const std::filesystem::path& shown);
void write_new_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                    const std::filesystem::path& shown);

/// Removes a temporary file or folder and closes it. If that fails, a line on standard error names
/// what remains.
void discard(TemporaryFile& file) noexcept;

}  // namespace carom
