// The scenes of tests/scenes_bad/, each with mistakes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/files.h"

namespace carom::test {

/// All of them, by paths from the top of the checkout, which must be the working folder: messages
/// give the path. Without the files that only other scenes ask for, as templates.
inline std::vector<std::filesystem::path> bad_scenes() {
    std::vector<std::filesystem::path> scenes = yaml_files("tests/scenes_bad");
    std::erase_if(scenes, [](const std::filesystem::path& path) {
        return path.stem().string().starts_with("with_");
    });
    return scenes;
}

}  // namespace carom::test
