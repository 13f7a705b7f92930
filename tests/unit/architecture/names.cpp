// A name means one type: two of one name in a namespace are one to the linker, which then takes the
// code of either for both.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "support/test_root.h"

namespace fs = std::filesystem;

TEST_CASE("no two files define types of one name in one namespace") {
    const std::regex opening(R"(namespace ?([\w:]*) \{)"), closing(R"(\}  // namespace.*)"),
        type(
            R"((?:struct|class|enum class)(?: \[\[.*\]\]| alignas\(\w+\))* (\w+)(?: final)?(?: : .*)? \{.*)");
    std::map<std::string, std::string> files;  // by the names of types
    std::smatch match;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(carom::test::checkout() / "src")) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        std::ifstream file(entry.path());
        std::vector<std::string> spaces;  // "" is one without a name, of this file alone
        for (std::string line; std::getline(file, line);) {
            if (std::regex_match(line, match, opening))
                spaces.push_back(match[1]);
            else if (std::regex_match(line, closing) && !spaces.empty())
                spaces.pop_back();
            if (!std::regex_match(line, match, type)) continue;
            std::string name;
            bool is_local = false;
            for (const std::string& space : spaces) {
                is_local = is_local || space.empty();
                name += space + "::";
            }
            if (is_local) continue;
            name += match[1];
            CAPTURE(name);
            const std::string& first = files.try_emplace(name, entry.path().string()).first->second;
            CHECK(first == entry.path().string());
        }
    }
    CHECK(files.size() > 300);
}
