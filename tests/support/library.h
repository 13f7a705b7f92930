// The scenes that come with carom, in all their folders.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/test_root.h"

namespace carom::test {

/// All scenes, sorted; figure sets, in a folder of their own, are none.
inline std::vector<std::filesystem::path> library_files() {
    const std::filesystem::path folder = checkout() / "scenes";
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".yaml" && entry.path().parent_path() != folder / "sets")
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// The scene of a name, in whichever folder it is.
inline std::filesystem::path library_file(const std::string& name) {
    for (std::filesystem::path& file : library_files())
        if (file.stem() == name) return std::move(file);
    throw std::runtime_error("no scene of the library is called " + name);
}

}  // namespace carom::test
