// Runs other programs from tests: carom itself, and independent readers of its files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom::test {

struct Outcome {
    int exit_code = -1;  ///< 128 + signal when killed
    std::string out, err;
};

/// Runs a program (found on PATH) with arguments and waits; `folder` is its working directory.
Outcome run(const std::vector<std::string>& command, const std::filesystem::path& folder = ".");

/// The same through `sh -c`, for limits and pipes.
Outcome shell(const std::string& script, const std::filesystem::path& folder = ".");

/// Whether a program of this name is on PATH.
bool is_installed(const std::string& program);

/// Bytes of a file; empty if there is none.
std::string contents(const std::filesystem::path& path);

/// A fresh folder that is removed at the end of the test.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::vector<std::string> names() const;  ///< of all entries, sorted

  private:
    std::filesystem::path path_;
};

}  // namespace carom::test
