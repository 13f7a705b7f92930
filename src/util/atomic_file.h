// A file, or a folder of files, that appears whole or not at all: written beside its final name,
// synced, then renamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace carom {

/// The folder that a path names a file of; "." for a name alone.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// Writes to a temporary file in the folder of `path`; `commit()` gives it its name, replacing an
/// earlier one. Of a symbolic link, in the folder and by the name that it leads to. Destroyed
/// uncommitted, it leaves nothing.
class AtomicFile {
  public:
    /// Creates the folder of `path` when it is missing. Throws SystemError naming the path and the
    /// cause.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::span<const std::uint8_t> bytes);  ///< all of them, or SystemError
    void write(std::string_view text);
    std::int64_t size() const;  ///< bytes written so far (the end of the file)
    void
    commit();  ///< fsync, rename, fsync of the folder; SystemError leaves an earlier file as it was

    const std::filesystem::path& path() const { return path_; }

    /// Where it is until commit(), for a library that writes by path.
    const std::filesystem::path& temporary() const { return temporary_; }

  private:
    std::filesystem::path path_;
    std::filesystem::path target_;  ///< behind links
    std::filesystem::path temporary_;
    int descriptor_ = -1;
};

/// Fills a temporary folder beside `path`; `commit()` gives it its name. It never replaces
/// anything: only an empty folder may be there already. Destroyed uncommitted, it leaves nothing.
class AtomicFolder {
  public:
    /// Creates the folders above `path` when they are missing. Throws SystemError naming the path
    /// and the cause.
    explicit AtomicFolder(std::filesystem::path path);
    ~AtomicFolder();
    AtomicFolder(const AtomicFolder&) = delete;
    AtomicFolder& operator=(const AtomicFolder&) = delete;

    /// A new file in it, synced; or SystemError. From any thread, if every name is given once.
    void write(const std::string& name, std::span<const std::uint8_t> bytes) const;
    void commit();  ///< SystemError leaves what is there as it was

  private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
};

/// Writes a file, whole or not at all. Throws as AtomicFile does.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Reads a whole file of at most `most` bytes. Throws SystemError (cannot be read; or larger, with
/// both numbers).
std::string read_file(const std::filesystem::path& path, std::int64_t most);

}  // namespace carom
