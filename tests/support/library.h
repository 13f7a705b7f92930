// The scenes that are shipped with carom, in all their folders.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/test_root.h"

namespace carom::test {

/// The files of all scenes, sorted. Figure sets, which have a folder of their own, are not
/// included.
inline std::vector<std::filesystem::path> library_files() {
    const std::filesystem::path folder = checkout() / "scenes";
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".yaml" && entry.path().parent_path() != folder / "sets")
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// The file of the scene with this name, in any of the folders.
inline std::filesystem::path library_file(const std::string& name) {
    for (std::filesystem::path& file : library_files())
        if (file.stem() == name) return std::move(file);
    throw std::runtime_error("no scene of the library is called " + name);
}

}  // namespace carom::test
