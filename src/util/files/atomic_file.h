// Files and folders of files that appear complete or not at all: they are written in the folder of
// their final name, synced, then renamed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "util/files/new_file.h"
#include "util/files/one_use_paths.h"
#include "util/files/stored_file.h"
#include "util/interrupt.h"
#include "util/pending/pending_output.h"
#include "util/pending/temporary.h"

namespace carom {

/// In place of a path: the file or folder is in the folder for temporary files (scratch_file.h),
/// and vanishes with its object, because it is only read back. It cannot be committed.
struct Scratch {};

/// What becomes of an earlier file of the same name.
enum class Earlier { replaced, kept };

/// A file that is written as a temporary file in the folder of its path; `commit()` gives it its
/// name and replaces an earlier file. Destroyed without commit(), it leaves nothing behind.
class AtomicFile : public PendingOutput {
  public:
    /// For a file that the user has named. Creates its folder if it is missing. If `path` is a
    /// symbolic link, the folder and the name are those of the file that it points to. Throws
    /// SystemError, naming the path and the cause, also for a device or a pipe; UsageError if
    /// `path` was read as an input (one_use_paths.h), or if another output is being written to it.
    /// With Earlier::kept nothing is replaced, not even a link, or what another process creates at
    /// the moment: commit() then throws UsageError.
    explicit AtomicFile(std::filesystem::path path, Earlier earlier = Earlier::replaced);

    /// For a file that carom keeps. It replaces whatever is in its place except a folder: a link,
    /// a pipe or a device is neither followed nor opened. Throws as above, also for a link among
    /// the folders.
    explicit AtomicFile(const StoredFile& file);

    explicit AtomicFile(Scratch);
    ~AtomicFile() override;

    void write(std::span<const std::uint8_t> bytes);  ///< all of them; throws SystemError
    void write(std::string_view text);

    /// Writes bytes at a place, which may be beyond the end. Throws SystemError.
    void write_at(std::int64_t place, std::span<const std::uint8_t> bytes);

    /// Reads back the bytes at a place and returns how many there were: fewer than asked for only
    /// at the end of the file. Throws SystemError.
    std::size_t read_at(std::int64_t place, std::span<std::uint8_t> to) const;

    std::int64_t size() const;  ///< bytes written so far (the end of the file)
    void settle() override;     ///< fsync
    void commit() override;
    std::string name() const override { return path_.string(); }

    const std::filesystem::path& path() const { return path_; }

  private:
    void begin();
    void open_beside(const std::filesystem::path& path);
    bool appears();
    bool takes_its_name();

    Descriptor folder_;  ///< of a stored file
    std::filesystem::path path_;
    std::filesystem::path target_;  ///< `path_` with links followed; empty: it gets no name
    Earlier earlier_ = Earlier::replaced;
    std::optional<OutputPath> only_;  ///< until the file has its name
    TemporaryFile file_;
    std::optional<MustCleanUp> named_;  ///< while the file has a temporary name
    bool is_settled_ = false;
};

/// A folder that is filled under a temporary name next to `path`; `commit()` gives it its name.
/// Destroyed without commit(), it leaves nothing behind.
class AtomicFolder : public PendingOutput {
  public:
    /// Creates the folders above `path` if they are missing. With Earlier::kept at most an empty
    /// folder may already exist there. With Earlier::replaced a folder with other files keeps them:
    /// it is filled inside of it, and commit() moves each file to its place, where it replaces an
    /// earlier one. Throws SystemError, naming the path and the cause.
    explicit AtomicFolder(std::filesystem::path path, Earlier earlier = Earlier::kept);
    explicit AtomicFolder(Scratch);
    ~AtomicFolder() override;

    /// Writes a new file in the folder and syncs it. Throws SystemError. May be called by several
    /// threads if each name is used once.
    void write(const std::string& name, std::span<const std::uint8_t> bytes) const;

    /// The same for bytes that come in pieces.
    void write_pieces(const std::string& name,
                      const std::function<void(const TakePiece&)>& copy) const;

    /// Whether the folder appears as a whole, rather than file by file in one that has others.
    bool is_new() const { return !is_filled_; }

    void settle() override;
    void commit() override;
    std::string name() const override { return path_.string(); }

  private:
    void commit_files();

    std::filesystem::path path_;
    bool is_scratch_ = false;
    bool is_filled_ = false;  ///< there is a folder that keeps its files
    TemporaryFile folder_;
    MustCleanUp named_;
};

/// Throws the UsageError that the file exists already and is not replaced.
[[noreturn]] void refuse_existing(const std::filesystem::path& path);

/// Writes a file, complete or not at all. Throws as AtomicFile does.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);
void write_file(const StoredFile& file, std::span<const std::uint8_t> bytes);
void write_file(const StoredFile& file, std::string_view text);

}  // namespace carom
