// The program that is tested, and the files that it comes with.
#pragma once

#include <filesystem>
#include <string>

#include "support/library.h"
#include "support/test_root.h"

namespace carom::test {

inline const std::string program = CAROM_PROGRAM;
inline const std::filesystem::path root = carom::test::checkout();

/// The path of a scene of the library.
inline std::string library_scene(const std::string& name) {
    return carom::test::library_file(name).string();
}

inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace carom::test
