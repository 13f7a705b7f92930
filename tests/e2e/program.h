// The program that is tested, and the files that it comes with.
#pragma once

#include <filesystem>
#include <string>

#include "support/files.h"
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

/// The path of a copy of a scene of the library without the card at its end, which does not move.
inline std::string without_card(const TemporaryFolder& folder, const std::string& name) {
    const std::string text = contents(library_scene(name));
    const std::size_t from = text.find("  end_card:"), to = text.find('\n', from);
    return folder.write(name + ".yaml", text.substr(0, from) + text.substr(to + 1)).string();
}

}  // namespace carom::test
