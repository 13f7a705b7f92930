// The scenes that are shipped with carom, in all their folders.
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
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

/// What makes the run of a scene of the library short where it is long for its many particles
/// alone: fewer of them, for tests of what frames look like. Panels and words are the same but for
/// numbers.
inline std::vector<std::string> fewer_particles(const std::filesystem::path& file) {
    static const std::map<std::string, std::string> counts{
        {"freezing", "60"}, {"freezing-in-space", "60"}, {"sound-pulse", "300"}};
    const auto found = counts.find(file.stem().string());
    if (found == counts.end()) return {};
    return {"gas.0.count=" + found->second};
}

}  // namespace carom::test
