// The destination of a command's results: a file that appears complete or not at all, or a stream
// such as standard output.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "util/files/atomic_file.h"

namespace carom {

/// Thrown where standard output is a pipe whose reader has ended: the program then ends, too,
/// without a message.
class ClosedPipe : public std::runtime_error {
  public:
    ClosedPipe() : std::runtime_error("the reader of standard output has ended") {}
};

/// `-` and `/dev/stdout` are standard output. A device, a pipe or an open file descriptor
/// (`/dev/fd/3`) is a stream and is written directly; any other path is written as an AtomicFile.
class Output : public PendingOutput {
  public:
    /// Throws SystemError if the path cannot be written, UsageError if it ends in a slash and so
    /// names a folder.
    explicit Output(std::string path);
    ~Output() override;

    void write(std::string_view text);  ///< writes all of it, or throws SystemError
    void settle() override;
    void commit() override;  ///< gives a file its final name; throws SystemError if it cannot
    std::string name() const override { return path_; }

    /// A message about what remains in a stream after the work was stopped. Empty if nothing was
    /// written to it, or if the output is a file, which then does not appear.
    std::string left_behind() const;

    static bool is_standard_output(std::string_view path) {
        return path == "-" || path == "/dev/stdout";
    }

    /// Whether the path is written directly, without a temporary file; true for standard output
    /// too.
    static bool is_stream(const std::filesystem::path& path);

    /// Whether both paths lead to the same file, device or pipe, so that outputs to them would be
    /// mixed. False for /dev/null.
    static bool are_same(const std::string& a, const std::string& b);

    /// Throws UsageError if an output to this file would replace a file that was read, or another
    /// output that is being written. To be called before the work for outputs that are begun late.
    static void refuse_used(const std::filesystem::path& path);

  private:
    std::string path_;
    std::optional<AtomicFile> file_;
    int descriptor_ = -1;  ///< of the stream, if the output is not a file
    bool owned_ = false;
    bool streamed_ = false;  ///< something was written to the stream
};

}  // namespace carom
