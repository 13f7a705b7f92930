// Files that are read. Only regular files are: a pipe or a device, of which reading might wait for
// ever, is refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "util/files/stored_file.h"

namespace carom {

class InputFile {
  public:
    /// Opens a file that the user has named: links are followed.
    explicit InputFile(const std::filesystem::path& path);
    /// Opens a file that carom keeps: links are not followed.
    explicit InputFile(const StoredFile& file);

    bool is_open() const { return file_.is_open(); }
    bool is_missing() const;      ///< nothing has this name
    bool is_other_kind() const;   ///< a folder, a pipe or a device has this name, or a link that is
                                  ///< not followed
    bool may_pass() const;        ///< the failure is one of those of TemporaryError
    std::string problem() const;  ///< why it could not be opened, in words

    /// Throws SystemError with the path and the cause if the file could not be opened,
    /// TemporaryError if that may pass.
    void require_open() const;

    /// Reads the next bytes and returns how many there were: fewer than asked for only at the end
    /// of the file. Throws SystemError.
    std::size_t read(std::span<char> to);

    /// Reads the rest of the file, up to one byte more than `most`. Throws SystemError.
    std::string rest(std::int64_t most);

    std::int64_t size() const;  ///< in bytes; throws SystemError

    /// Throws SystemError: `cannot read PATH: CAUSE`.
    [[noreturn]] void refuse(const std::string& cause) const;

  private:
    void accept(int descriptor);
    std::string cannot_read(const std::string& cause) const;
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;
    bool is_stored_ = false;
    Descriptor file_;
    int error_ = 0;  ///< errno; 0: what has the name is no regular file
};

/// Returns the content of a file of at most `most` bytes. Throws SystemError if it cannot be read,
/// or is larger (with both numbers).
std::string read_file(const std::filesystem::path& path, std::int64_t most);
std::string read_file(const StoredFile& file, std::int64_t most);

/// Returns the fingerprint of a file's content (util/fingerprint.h); nothing if there is no regular
/// file of that name. Throws SystemError if it cannot be read.
std::optional<std::string> fingerprint_of_file(const std::filesystem::path& path);
std::optional<std::string> fingerprint_of_file(const StoredFile& file);

}  // namespace carom
