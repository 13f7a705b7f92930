// Runs other programs from tests: carom itself, and independent readers of its files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/files.h"

namespace carom::test {

struct Outcome {
    int exit_code = -1;  ///< 128 + signal when killed
    std::string out, err;
};

/// Runs a program (found on PATH) with arguments and waits; `folder` is its working directory.
Outcome run(const std::vector<std::string>& command, const std::filesystem::path& folder = ".");

/// Like run(), through `sh -c`, which allows limits and pipes.
Outcome shell(const std::string& script, const std::filesystem::path& folder = ".");

/// Whether a program of this name is on PATH.
bool is_installed(const std::string& program);

}  // namespace carom::test
