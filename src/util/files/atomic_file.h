// Files and folders of files that appear complete or not at all: they are written in the folder of
// their final name, synced, then renamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "util/files/one_use_paths.h"
#include "util/interrupt.h"
#include "util/pending/pending_output.h"
#include "util/pending/temporary.h"

namespace carom {

/// A file that is written as a temporary file in the folder of `path`; `commit()` gives it its name
/// and replaces an earlier file. If `path` is a symbolic link, the folder and the name are those of
/// the file that it points to. Destroyed without commit(), it leaves nothing behind.
class AtomicFile : public PendingOutput {
  public:
    /// Creates the folder of `path` if it is missing. Throws SystemError, naming the path and the
    /// cause, also for a device or a pipe; UsageError if `path` was read as an input
    /// (one_use_paths.h), or if another output is being written to it.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile() override;

    void write(std::span<const std::uint8_t> bytes);  ///< all of them; throws SystemError
    void write(std::string_view text);
    std::int64_t size() const;  ///< bytes written so far (the end of the file)
    void settle() override;     ///< fsync
    void commit() override;
    std::string name() const override { return path_.string(); }

    const std::filesystem::path& path() const { return path_; }

    /// Returns its path until commit(), for a library that opens it by path.
    std::filesystem::path temporary() const;

  private:
    bool appears();

    std::filesystem::path path_;
    std::filesystem::path target_;    ///< `path_` with links followed
    std::optional<OutputPath> only_;  ///< until the file has its name
    TemporaryFile file_;
    std::optional<MustCleanUp> named_;  ///< while the file has a temporary name
    bool is_settled_ = false;
};

/// A folder that is filled under a temporary name next to `path`; `commit()` gives it its name. It
/// never replaces anything: at most an empty folder may already exist there. Destroyed without
/// commit(), it leaves nothing behind.
class AtomicFolder : public PendingOutput {
  public:
    /// Creates the folders above `path` if they are missing. Throws SystemError, naming the path
    /// and the cause.
    explicit AtomicFolder(std::filesystem::path path);
    ~AtomicFolder() override;

    /// Writes a new file in the folder and syncs it. Throws SystemError. May be called by several
    /// threads if each name is used once.
    void write(const std::string& name, std::span<const std::uint8_t> bytes) const;
    void settle() override;
    void commit() override;
    std::string name() const override { return path_.string(); }

  private:
    std::filesystem::path path_;
    TemporaryFile folder_;
    MustCleanUp named_;
};

/// Writes a file, complete or not at all. Throws as AtomicFile does.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Returns the content of a file of at most `most` bytes. Throws SystemError if it cannot be read,
/// or is larger (with both numbers).
std::string read_file(const std::filesystem::path& path, std::int64_t most);

}  // namespace carom
