// A file, or a folder of files, that appears whole or not at all: written beside its final name,
// synced, then renamed.
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

/// Writes to a temporary file in the folder of `path`; `commit()` gives it its name, replacing an
/// earlier one. Of a symbolic link, in the folder and by the name that it leads to. Destroyed
/// uncommitted, it leaves nothing.
class AtomicFile : public PendingOutput {
  public:
    /// Creates the folder of `path` when it is missing. Throws SystemError naming the path and the
    /// cause, for a device or a pipe too; UsageError where `path` was read (one_use_paths.h), or
    /// another output is written.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile() override;

    void write(std::span<const std::uint8_t> bytes);  ///< all of them, or SystemError
    void write(std::string_view text);
    std::int64_t size() const;  ///< bytes written so far (the end of the file)
    void settle() override;     ///< fsync
    void commit() override;
    std::string name() const override { return path_.string(); }

    const std::filesystem::path& path() const { return path_; }

    /// Where it is until commit(), for a library that opens it by path.
    std::filesystem::path temporary() const;

  private:
    bool appears();

    std::filesystem::path path_;
    std::filesystem::path target_;    ///< behind links
    std::optional<OutputPath> only_;  ///< until it has its name
    TemporaryFile file_;
    std::optional<MustCleanUp> named_;  ///< while it has a temporary name
    bool is_settled_ = false;
};

/// Fills a temporary folder beside `path`; `commit()` gives it its name. It never replaces
/// anything: only an empty folder may be there already. Destroyed uncommitted, it leaves nothing.
class AtomicFolder : public PendingOutput {
  public:
    /// Creates the folders above `path` when they are missing. Throws SystemError naming the path
    /// and the cause.
    explicit AtomicFolder(std::filesystem::path path);
    ~AtomicFolder() override;

    /// A new file in it, synced; or SystemError. From any thread, if every name is given once.
    void write(const std::string& name, std::span<const std::uint8_t> bytes) const;
    void settle() override;
    void commit() override;
    std::string name() const override { return path_.string(); }

  private:
    std::filesystem::path path_;
    TemporaryFile folder_;
    MustCleanUp named_;
};

/// Writes a file, whole or not at all. Throws as AtomicFile does.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Reads a whole file of at most `most` bytes. Throws SystemError (cannot be read; or larger, with
/// both numbers).
std::string read_file(const std::filesystem::path& path, std::int64_t most);

}  // namespace carom
