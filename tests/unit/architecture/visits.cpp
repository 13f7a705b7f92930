// What a surface or an event does is decided by a visit with a function for each alternative, so
// that the compiler names all places that a new alternative concerns
// (physics/surfaces/behaviours.h, physics/run.h).
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/test_root.h"

namespace fs = std::filesystem;

namespace {

const fs::path code = carom::test::checkout() / "src";

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

std::vector<fs::path> all_code() {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(code))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
            files.push_back(entry.path());
    return files;
}

// The alternatives of a variant as a pattern: "Reflecting|Bath|...".
std::string alternatives(const std::string& header, const std::string& name) {
    const std::string text = text_of(code / header);
    const std::regex definition("using " + name + " = std::variant<([^>]*)>;");
    std::smatch match;
    REQUIRE(std::regex_search(text, match, definition));
    return std::regex_replace(match[1].str(), std::regex(R"(,\s*)"), "|");
}

// From an opening brace to the one that closes it.
std::string braced(const std::string& text, std::size_t open) {
    int depth = 0;
    for (std::size_t k = open; k < text.size(); ++k) {
        if (text[k] == '{') ++depth;
        if (text[k] == '}' && --depth == 0) return text.substr(open, k - open);
    }
    return text.substr(open);
}

}  // namespace

TEST_CASE("only the headers of behaviours and events ask which alternative one is") {
    const std::string behaviours = "physics/surfaces/behaviours.h", events = "physics/run.h";
    const std::string any =
        alternatives(behaviours, "Behaviour") + "|" + alternatives(events, "RunAction");
    const std::regex question("(get_if|holds_alternative|get)<(const )?(" + any + ")>");
    for (const fs::path& file : all_code()) {
        const std::string path = fs::relative(file, code).string();
        if (path == behaviours || path == events) continue;
        CAPTURE(path);
        std::smatch found;
        const std::string text = text_of(file);
        const bool asks = std::regex_search(text, found, question);
        CAPTURE(found.str());
        CHECK_FALSE(asks);
    }
}

TEST_CASE("no set of functions for a visit has a generic one") {
    const std::regex generic(R"(\]\s*\((const )?auto\b)");
    int sets = 0;
    for (const fs::path& file : all_code()) {
        const std::string text = text_of(file), begin = "Overloaded{";
        for (std::size_t at = text.find(begin); at != std::string::npos;
             at = text.find(begin, at + 1)) {
            ++sets;
            CAPTURE(file.string());
            CHECK_FALSE(std::regex_search(braced(text, at + begin.size() - 1), generic));
        }
    }
    CHECK(sets > 20);
}
