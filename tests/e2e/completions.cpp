// What bash, zsh and fish complete, each asked itself.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

using namespace carom::test;

namespace {

using Words = std::set<std::string>;

// The words that a shell offers behind a line; without what all have in common before `=`.
using Complete = std::function<Words(const std::string& line)>;

Words lines_of(const std::string& text) {
    Words lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        if (!line.empty()) lines.insert(line);
    return lines;
}

class Completions {
  public:
    Completions() {
        folder_.write("work/gas.yaml", "");
        folder_.write("work/words.txt", "");
        folder_.write("work/plan/plan.json", "");
        REQUIRE(run({program, "help", "--files", (folder_.path() / "share").string()}).exit_code ==
                0);
    }

    Words in_bash(const std::string& line) const {
        return asked({"bash", "--norc", "-c",
                      "source ../share/bash-completion/completions/carom; COMP_LINE=$1; "
                      "COMP_POINT=${#COMP_LINE}; _carom; printf '%s\\n' \"${COMPREPLY[@]}\"",
                      "bash", line});
    }
    Words in_fish(const std::string& line) const {
        return asked(
            {"fish", "--no-config", "-c",
             "source ../share/fish/vendor_completions.d/carom.fish; complete -C $argv[1] | "
             "string replace -r '\\t.*' ''",
             line});
    }
    Words in_zsh(const std::string& line) const {
        return asked({"zsh", "-f", (root / "tests/e2e/complete.zsh").string(),
                      "../share/zsh/site-functions", line});
    }

  private:
    // The scripts call the program by the name that is typed.
    Words asked(std::vector<std::string> command) const {
        const std::string folder = std::filesystem::path(program).parent_path().string();
        command.insert(command.begin(), {"env", "PATH=" + folder + ":" + std::getenv("PATH")});
        const Outcome outcome = run(command, folder_.path() / "work");
        CHECK(outcome.err == "");
        return lines_of(outcome.out);
    }

    TemporaryFolder folder_;
};

bool holds(const Words& all, const Words& some) { return std::ranges::includes(all, some); }

// What is the same in all shells.
void check_words(const Complete& complete) {
    CHECK(complete("carom re") == Words{"render"});
    CHECK(holds(complete("carom "), {"render", "still", "help", "completions"}));
    // fish 4 adds words that have the letters with others between them, as --from for --fo.
    CHECK(complete("carom render --for") == Words{"--force", "--format"});
    CHECK(complete("carom render --format ") == Words{"gif", "mp4", "pdf", "png", "webm"});
    CHECK(complete("carom render --quality ") == Words{"draft", "final", "standard"});
    CHECK(complete("carom still a.yaml --theme ") == Words{"dark", "light", "print"});
    CHECK(holds(complete("carom still --template "), {"lecture", "portrait"}));
    CHECK(complete("carom figure --kind speed-h") == Words{"speed-histogram"});
    CHECK(complete("carom run --set gas.0.cou") == Words{"gas.0.count="});
    CHECK(complete("carom run --set gas.light.cou") == Words{"gas.light.count="});
    CHECK(complete("carom run --set film.panels.2.bin") == Words{"film.panels.2.bins="});
    CHECK(complete("carom run --set run.until=2 film.sec") == Words{"film.seconds="});
    CHECK(complete("carom plan gas.yaml --vary gas.2.cou") == Words{"gas.2.count="});
    CHECK(complete("carom help comp") == Words{"completions"});
    CHECK(complete("carom help pan") == Words{"panel"});
    CHECK(complete("carom help panel speed-h") == Words{"speed-histogram"});
    CHECK(complete("carom help scene equil") == Words{"equilibrate"});
    CHECK(complete("carom help render re") == Words{});
    CHECK(complete("carom new mine --from crad") == Words{"cradle"});
}

}  // namespace

TEST_CASE("bash completes commands, options, words, keys and files") {
    const Completions completions;
    const Complete complete = [&](const std::string& line) { return completions.in_bash(line); };
    check_words(complete);
    CHECK(complete("carom run --set film.theme=d") == Words{"dark"});
    CHECK(complete("carom render --quality=d") == Words{"draft"});
    CHECK(complete("carom figures --formats svg,p") == Words{"svg,pdf", "svg,png"});
    CHECK(complete("carom check ") == Words{"gas.yaml", "plan"});
    CHECK(complete("carom join ") == Words{"plan"});
    CHECK(holds(complete("carom render -o "), {"words.txt"}));
}

TEST_CASE("fish completes commands, options, words, keys and files") {
    const Completions completions;
    const Complete complete = [&](const std::string& line) { return completions.in_fish(line); };
    check_words(complete);
    CHECK(complete("carom run --set film.theme=d") == Words{"film.theme=dark"});
    CHECK(complete("carom render --quality=d") == Words{"--quality=draft"});
    CHECK(complete("carom figures --formats svg,p") == Words{"svg,pdf", "svg,png"});
    CHECK(complete("carom check ") == Words{"gas.yaml", "plan/"});
    CHECK(complete("carom join ") == Words{"plan/"});
    CHECK(holds(complete("carom render -o "), {"words.txt"}));
}

TEST_CASE("zsh completes commands, options, words, keys and files") {
    const Completions completions;
    const Complete complete = [&](const std::string& line) { return completions.in_zsh(line); };
    check_words(complete);
    CHECK(complete("carom run --set film.theme=d") == Words{"film.theme=dark"});
    CHECK(complete("carom render --quality=d") == Words{"draft"});
    CHECK(complete("carom figures --formats svg,p") == Words{"pdf", "png"});
    CHECK(complete("carom check ") == Words{"gas.yaml", "plan"});
    CHECK(complete("carom join ") == Words{"plan"});
    CHECK(holds(complete("carom render -o "), {"words.txt"}));
}

TEST_CASE("where nothing is known, nothing is said") {
    const std::vector<std::vector<std::string>> calls{{},
                                                      {"bash"},
                                                      {"zsh", "explode", ""},
                                                      {"fish", "render", "--fps", ""},
                                                      {"bash", "run", "--loud="}};
    for (const std::vector<std::string>& words : calls) {
        std::vector<std::string> command{program, "__complete"};
        command.insert(command.end(), words.begin(), words.end());
        const Outcome outcome = run(command);
        CHECK(outcome.exit_code == 0);
        CHECK(outcome.err == "");
        CHECK(outcome.out == "");
    }
    CHECK_FALSE(has(run({program, "--help"}).out + run({program, "help"}).out, "__complete"));
}

TEST_CASE("an option is offered once, unless it may be repeated") {
    const Outcome outcome =
        run({program, "__complete", "bash", "run", "--quiet", "--set", "seed=1", "a.yaml", "--"});
    const Words flags = lines_of(outcome.out);
    CHECK(holds(flags, {"--help", "--json", "--seed", "--set"}));
    CHECK_FALSE(flags.contains("--quiet"));
}

TEST_CASE("zsh and fish are given the meaning of each candidate") {
    const auto says = [](const std::string& shell, const std::string& word) {
        return lines_of(run({program, "__complete", shell, word}).out);
    };
    CHECK(says("fish", "").contains("join\tput together what the chunks of a plan have made"));
    CHECK(says("zsh", "--ver").contains("--version:print the version"));
    CHECK(says("bash", "--ver") == Words{"--version"});
}
