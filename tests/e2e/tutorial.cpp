// The tutorial: its steps lead from scene to scene as they are shown, its commands work as they are
// written, and its pictures are there.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const fs::path folder = root / "docs/tutorial";

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
    Lines lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// A step of the tutorial: what it shows.
struct Step {
    int number = 0;
    std::string text;
    std::vector<Lines> added, commands;  // blocks

    Step(int its_number, const std::string& its_text) : number(its_number), text(its_text) {
        const std::regex block("```(yaml|sh)\n([^`]*)```");
        for (std::sregex_iterator it(text.begin(), text.end(), block), end; it != end; ++it)
            ((*it)[1] == "yaml" ? added : commands).push_back(lines_of((*it)[2]));
    }
};

std::vector<Step> steps() {
    const std::string page = contents(root / "docs/tutorial.md");
    const std::regex heading("\n## ([0-9]+)\\. ");
    std::vector<Step> all;
    for (std::sregex_iterator it(page.begin(), page.end(), heading), end; it != end; ++it) {
        const auto begin = static_cast<std::size_t>(it->position()) + 1;
        all.emplace_back(std::stoi((*it)[1]),
                         page.substr(begin, page.find("\n## ", begin) - begin));
    }
    return all;
}

// The scene after a step: that of the step before where none is added to.
fs::path scene_after(int step) {
    while (!fs::exists(folder / (std::to_string(step) + ".yaml"))) --step;
    return folder / (std::to_string(step) + ".yaml");
}

bool has_block(const Lines& all, const Lines& block) {
    return std::ranges::search(all, block).begin() != all.end();
}

// The scene at 6 frames a second, so that its films are made in a fifth of the time.
std::string with_few_frames(std::string scene) {
    const std::string film = "\nfilm:\n";
    const std::size_t at = scene.find(film);
    if (at == std::string::npos) return scene + "film: {fps: 6}\n";
    return scene.insert(at + film.size(), "  fps: 6\n");
}

std::string name_in(const Lines& commands, const std::string& pattern) {
    std::smatch found;
    for (const std::string& line : commands)
        if (std::regex_search(line, found, std::regex(pattern))) return found[1];
    return "";
}

}  // namespace

TEST_CASE("the tutorial has ten steps, each with a command and a picture") {
    const std::vector<Step> all = steps();
    REQUIRE(all.size() == 10);
    for (std::size_t i = 0; i < all.size(); ++i) {
        CAPTURE(all[i].number);
        CHECK(all[i].number == static_cast<int>(i) + 1);
        CHECK(all[i].commands.size() == 1);
        CHECK(has(all[i].text, "](tutorial/" + std::to_string(all[i].number) + ".png)"));
    }
}

TEST_CASE("each step of the tutorial shows the lines by which its scene differs from the last") {
    Lines before;
    for (const Step& step : steps()) {
        CAPTURE(step.number);
        const Lines after = lines_of(contents(scene_after(step.number)));
        std::set<std::string> shown;
        for (const Lines& block : step.added) {
            CHECK(has_block(after, block));
            shown.insert(block.begin(), block.end());
        }
        for (const std::string& line : after) {
            CAPTURE(line);
            const bool is_old = std::ranges::find(before, line) != before.end();
            CHECK((is_old || shown.contains(line)));
        }
        before = after;
    }
}

TEST_CASE("the commands of the tutorial work as they are written") {
    const std::string path = fs::path(program).parent_path().string() + ":" + std::getenv("PATH");
    for (const Step& step : steps()) {
        CAPTURE(step.number);
        const TemporaryFolder work;
        REQUIRE(step.commands.size() == 1);
        const Lines& commands = step.commands.front();
        const std::string name = name_in(commands, " ([a-z-]+\\.yaml)");
        const std::string scene = contents(scene_after(step.number));
        for (const std::string& command : commands) {
            CAPTURE(command);
            work.write(name, has(command, "--max-size") ? scene : with_few_frames(scene));
            const Outcome outcome = shell("PATH='" + path + "' " + command, work.path());
            CAPTURE(outcome.err);
            CHECK(outcome.exit_code == 0);
            CHECK_FALSE(has(outcome.err, "carom: "));
            const std::string output = name_in({command}, " -o ([^ ]+)");
            if (!output.empty()) CHECK(fs::exists(work.path() / output));
            const std::string most = name_in({command}, "--max-size ([0-9]+)MB");
            if (!most.empty())
                CHECK(fs::file_size(work.path() / output) <= 1000000U * std::stoul(most));
        }
        if (step.number == 7) CHECK(fs::file_size(work.path() / "out/gas.mp4") > 1000000);
        if (step.number == 8)
            for (const char* made :
                 {"spreading.pdf", "entropy.svg", "entropy.csv", "captions.json"})
                CHECK(fs::exists(work.path() / "figures" / made));
        if (step.number == 10) CHECK(has(contents(work.path() / "out/gas-de.html"), "lang=\"de\""));
    }
}

TEST_CASE("the folder of the tutorial has a small picture for each step, and nothing else") {
    std::set<std::string> expected, found;
    for (const Step& step : steps()) {
        expected.insert(std::to_string(step.number) + ".png");
        expected.insert(scene_after(step.number).filename().string());
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        CAPTURE(entry.path());
        found.insert(entry.path().filename().string());
        CHECK(entry.file_size() < 60000);
    }
    CHECK(found == expected);
}
