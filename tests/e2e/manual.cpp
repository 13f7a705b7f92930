// The manual says what the program does: its options, its outputs, and where its links lead.
#include <doctest/doctest.h>

#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string manual = contents(root / "docs/commands.md");

std::set<std::string> flags_in(const std::string& text) {
    static const std::regex flag("--[a-z]+");
    return {std::sregex_token_iterator(text.begin(), text.end(), flag),
            std::sregex_token_iterator()};
}

// What stands in the manual after `$ COMMAND`, up to the end of its block.
std::string shown_output(const std::string& command) {
    const std::string line = "$ " + command + "\n";
    const std::size_t begin = manual.find(line);
    if (begin == std::string::npos) return "";
    const std::size_t output = begin + line.size();
    return manual.substr(output, manual.find("```", output) - output);
}

// Without the estimates of time, which depends on the machine.
std::string without_cost(const std::string& text) {
    return std::regex_replace(text, std::regex(" *(rough cost|memory |CPU time) .*\n"), "");
}

std::vector<fs::path> documents() {
    std::vector<fs::path> files{root / "README.md", root / "CHANGELOG.md"};
    for (const auto& entry : fs::directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    return files;
}

std::string without_code(const std::string& text) {
    return std::regex_replace(text, std::regex("(^|\n)```[^`]*```|\n    [^\n]*|`[^`\n]*`"), "\n");
}

// Where links to headings of a document may lead: "a-panel", of a second heading "a-panel-1".
const std::set<std::string>& places_in(const fs::path& document) {
    static std::map<fs::path, std::set<std::string>> known;
    const auto [found, is_new] = known.try_emplace(fs::canonical(document));
    if (!is_new) return found->second;
    const std::string text = "\n" + contents(document);
    const std::regex heading("\n#+ ([^\n]*)");
    for (std::sregex_iterator it(text.begin(), text.end(), heading), end; it != end; ++it) {
        std::string place = std::regex_replace((*it)[1].str(), std::regex("[^A-Za-z0-9 _-]"), "");
        for (char& letter : place)
            letter = letter == ' ' ? '-' : static_cast<char>(std::tolower(letter));
        std::string name = place;
        for (int again = 1; !found->second.insert(name).second; ++again)
            name = place + "-" + std::to_string(again);
    }
    return found->second;
}

}  // namespace

TEST_CASE("the manual knows every option of every command, and no other") {
    std::set<std::string> known;
    const std::string all = run({program, "--help"}).out;
    static const std::regex line("\n  ([a-z]+)  ");
    for (std::sregex_iterator found(all.begin(), all.end(), line), end; found != end; ++found) {
        const std::string command = (*found)[1];
        const Outcome help = run({program, command, "--help"});
        REQUIRE(help.exit_code == 0);
        for (const std::string& flag : flags_in(help.out)) known.insert(flag);
    }
    REQUIRE(known.contains("--kind"));
    known.erase("--output");  // written -o
    const std::set<std::string> documented = flags_in(manual);
    for (const std::string& flag : known) {
        CAPTURE(flag);
        CHECK(documented.contains(flag));
    }
    for (const std::string& flag : documented) {
        CAPTURE(flag);
        CHECK((known.contains(flag) || flag == "--help"));
    }
}

TEST_CASE("the manual shows the calls of every command as its help does") {
    const std::string all = run({program, "--help"}).out;
    int calls = 0;
    static const std::regex line("\n  ([a-z]+)  "), call("\n  (carom [^\n]*)");
    for (std::sregex_iterator found(all.begin(), all.end(), line), end; found != end; ++found) {
        std::string usage = run({program, (*found)[1], "--help"}).out;
        usage.resize(usage.find("\n\nOptions:"));
        for (std::sregex_iterator one(usage.begin(), usage.end(), call); one != end; ++one) {
            const std::string shown = (*one)[1];
            CAPTURE(shown);
            CHECK(manual.find("    " + shown + "\n") != std::string::npos);
            ++calls;
        }
    }
    CHECK(calls > 12);
}

TEST_CASE("the manual shows what carom check and carom run print") {
    for (const std::string command :
         {"check scenes/mixed-masses.yaml", "run scenes/time-reversal.yaml"}) {
        const std::string shown = shown_output("carom " + command);
        REQUIRE_FALSE(shown.empty());
        const std::size_t space = command.find(' ');
        const Outcome outcome =
            run({program, command.substr(0, space), command.substr(space + 1)}, root);
        CHECK(without_cost(outcome.out) == without_cost(shown));
    }
}

TEST_CASE("links from document to document lead to files and headings") {
    const std::regex link(R"re(\]\(([^)#\s]*)(#([^)]*))?\))re");
    int headings = 0;
    for (const fs::path& document : documents()) {
        const std::string text = without_code(contents(document));
        for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
            const std::string target = (*it)[1], place = (*it)[3];
            if (target.starts_with("http")) continue;
            CAPTURE(document.string());
            CAPTURE(target);
            CAPTURE(place);
            const fs::path file = target.empty() ? document : document.parent_path() / target;
            CHECK(fs::exists(file));
            if (place.empty()) continue;
            CHECK(places_in(file).contains(place));
            ++headings;
        }
    }
    CHECK(headings > 150);
}

TEST_CASE("the citation names the version that the program has") {
    const std::string version = run({program, "--version"}).out;  // "carom 0.1.0\n"
    REQUIRE(version.starts_with("carom "));
    CHECK(has(contents(root / "CITATION.cff"), "\nversion: " + version.substr(6)));
}
