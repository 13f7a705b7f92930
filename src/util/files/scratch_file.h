// A temporary file for bytes that do not fit into memory and are read back later. It has no name
// and vanishes with the process, however that ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace carom {

/// Returns the folder for temporary files: $TMPDIR or, if that is not set, /var/tmp or /tmp.
std::filesystem::path folder_for_scratch();

/// Throws SystemError if that folder does not exist.
void require_folder_for_scratch();

class ScratchFile {
  public:
    /// The largest size of one scratch file, however much space is free.
    static constexpr std::int64_t most_bytes = std::int64_t{32} << 30;

    /// Creates the file in folder_for_scratch(). It grows to at most `most` bytes and at most half
    /// of the space that is free there now.
    explicit ScratchFile(std::int64_t most = most_bytes);
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    /// Appends bytes and returns the place where they begin; nothing if there is no room for them,
    /// or if the file could not be created. From one thread only.
    std::optional<std::int64_t> append(std::span<const std::byte> bytes);

    /// Reads bytes that were appended at a place. May be called by several threads. Throws
    /// SystemError.
    void read(std::int64_t place, std::span<std::byte> to) const;

    /// Returns how large a new scratch file may become, in bytes.
    static std::int64_t room();

  private:
    int descriptor_ = -1;
    std::int64_t size_ = 0, most_ = 0;
};

}  // namespace carom
