// Files are opened by name in few places only, so that what is in the place of a file is looked at
// in one of them.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

#include "support/test_root.h"

namespace fs = std::filesystem;

TEST_CASE("nothing opens a file by its name but what looks at the file that it gets") {
    const std::map<std::string, std::string> allowed{
        {"util/files/input_file.cpp", "reads regular files"},
        {"util/files/stored_file.cpp", "opens folders, step by step, without following links"},
        {"util/files/new_file.cpp", "creates files that do not exist"},
        {"util/files/atomic_file.cpp", "opens folders, to sync them"},
        {"util/pending/temporary.cpp", "creates temporary files, and removes abandoned ones"},
        {"draw/fonts/fonts.cpp", "finds out why the system's font cannot be read"},
        {"media/libav.cpp", "/dev/null"},
        {"app/main.cpp", "/dev/null"},
        {"app/output.cpp", "writes to devices and pipes that the user has named"},
        {"app/granted_cores.cpp", "reads what the system tells in /proc and /sys"},
    };
    const std::regex opening(
        R"(\bO_(RDONLY|WRONLY|RDWR)\b|\b(basic_)?[io]?f(stream|ilebuf)\b|\bf(re)?open(64)?\()"
        R"(|\b(opendir|creat|mkstemp|mkostemp|mkdtemp|avio_open)\()");
    const fs::path source = carom::test::checkout() / "src";
    std::map<std::string, bool> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path());
        const std::string name = fs::relative(entry.path(), source).string();
        for (std::string text; std::getline(file, text);)
            if (std::regex_search(text, opening)) found[name] = true;
    }
    for (const auto& [name, any] : found) {
        CAPTURE(name);
        CHECK(allowed.contains(name));
    }
    for (const auto& [name, reason] : allowed) {
        CAPTURE(name);
        CHECK(found.contains(name));
    }
}
