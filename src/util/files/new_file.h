// The bytes of files that have not got their names yet. Messages call them `shown`. All throw
// SystemError.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace carom {

/// Says that it cannot be written, and why.
[[noreturn]] void throw_unwritable(const std::filesystem::path& shown, int error);

/// Writes all of them, to an open file.
void write_all(int descriptor, std::span<const std::uint8_t> bytes,
               const std::filesystem::path& shown);

/// Waits until all of an open file is on the disk, where the file system can tell.
void sync_file(int descriptor, const std::filesystem::path& shown);

/// Makes a file of these bytes, synced, where there is none.
void write_new_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                    const std::filesystem::path& shown);

}  // namespace carom
