// Where a command's results go: a file that appears whole or not at all, or standard output.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "util/files/atomic_file.h"

namespace carom {

/// `-` and `/dev/stdout` are standard output. A device, a pipe or a file that is open already
/// (`/dev/fd/3`) is written as it stands, any other path as an AtomicFile.
class Output : public PendingOutput {
  public:
    /// Throws SystemError when it cannot be written, UsageError where a slash at its end says that
    /// it is a folder.
    explicit Output(std::string path);
    ~Output() override;

    void write(std::string_view text);             ///< all of it, or SystemError
    void copy(const std::filesystem::path& file);  ///< all that is in it
    void settle() override;
    void commit() override;  ///< a file gets its name; SystemError if it cannot
    std::string name() const override { return path_; }

    /// What stands in a stream although the work was stopped; empty: nothing, or a file that will
    /// not appear.
    std::string left_behind() const;

    static bool is_standard_output(std::string_view path) {
        return path == "-" || path == "/dev/stdout";
    }

    /// Whether that is written as it stands: standard output too.
    static bool is_stream(const std::filesystem::path& path);

    /// Whether what is written to both would be mixed in one file, device or pipe.
    static bool are_same(const std::string& a, const std::string& b);

    /// Throws UsageError where an output to this file would take the place of one that was read, or
    /// of another that is being written: for those that are begun late, before the work.
    static void refuse_used(const std::filesystem::path& path);

  private:
    std::string path_;
    std::optional<AtomicFile> file_;
    int descriptor_ = -1;  ///< of a stream, when there is no file
    bool owned_ = false;
    bool streamed_ = false;  ///< something went to a stream
};

}  // namespace carom
