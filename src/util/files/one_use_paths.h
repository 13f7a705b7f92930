// Ensures that each path has only one use in a process: a file that was read as an input is not
// overwritten by an output, and no two outputs are written to one path at the same time.
// Thread-safe.
#pragma once

#include <filesystem>
#include <string>

namespace carom {

/// Records that the file at `path` was read as an input: from now on no output may replace it.
/// Throws UsageError if an output to it is already open.
void keep_source(const std::filesystem::path& path);

/// Reserves the path of an output while it is being written.
class OutputPath {
  public:
    /// `target` is `path` with links followed. Throws UsageError if it is an input, or if another
    /// output is being written there.
    OutputPath(const std::filesystem::path& path, const std::filesystem::path& target);
    ~OutputPath();
    OutputPath(const OutputPath&) = delete;
    OutputPath& operator=(const OutputPath&) = delete;

  private:
    std::string place_;
};

}  // namespace carom
