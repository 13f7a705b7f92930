// Each path has one use in a process: a file that it was asked to read is no output as well, and no
// two outputs are written to one path at once. May be used by several threads.
#pragma once

#include <filesystem>
#include <string>

namespace carom {

/// The file at `path` was read for the user: no output takes its place from now on. Throws
/// UsageError where one is about to.
void keep_source(const std::filesystem::path& path);

/// The path of an output, as long as it is written.
class OutputPath {
  public:
    /// `target` is where `path` leads to. Throws UsageError where it is a source, or another output
    /// is being written there.
    OutputPath(const std::filesystem::path& path, const std::filesystem::path& target);
    ~OutputPath();
    OutputPath(const OutputPath&) = delete;
    OutputPath& operator=(const OutputPath&) = delete;

  private:
    std::string place_;
};

}  // namespace carom
