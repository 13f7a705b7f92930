// What has no room in memory and is wanted again: bytes in a temporary file without a name, which
// is gone with the process, however that ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace carom {

/// $TMPDIR, where it is set and not empty.
std::optional<std::filesystem::path> asked_folder_for_scratch();

class ScratchFile {
  public:
    /// Bytes that one may have at most, whatever is free.
    static constexpr std::int64_t most_bytes = std::int64_t{32} << 30;

    /// In $TMPDIR, or where that is not set in /var/tmp or /tmp. It grows up to `most` bytes, and
    /// up to half of what is free there now.
    explicit ScratchFile(std::int64_t most = most_bytes);
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    /// Adds bytes at the end; gives the place where they begin, or nothing where there is no room
    /// for them, or no such file. From one thread only.
    std::optional<std::int64_t> append(std::span<const std::byte> bytes);

    /// Reads what was added at a place, from any thread. Throws SystemError.
    void read(std::int64_t place, std::span<std::byte> to) const;

    /// How large a new one may become.
    static std::int64_t room();

  private:
    int descriptor_ = -1;
    std::int64_t size_ = 0, most_ = 0;
};

}  // namespace carom
