// Names of files and words of strangers do not command a terminal, nor read as other words there.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// An escape sequence, a line of its own, a sequence of C1, and writing from right to left.
const std::string evil = "a\x1b[31m\ncarom: forged\r\u009b2J\u202egnp";

const std::string scene =
    "title: \"T \u202egnp\u2066\"\nbox: {size: [10, 10]}\n"
    "gas: [{name: \"A \u202eb\", count: 2, speed: 1}]\nrun: {until: 1}\nfilm: {seconds: 1}\n";

void check_text(const std::string& text) {
    CAPTURE(text);
    CHECK(std::ranges::all_of(text, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return c == '\n' || c == '\t' || (byte >= 0x20 && byte != 0x7f);
    }));
    for (const char* letter : {"\u009b", "\u202e", "\u2066"}) CHECK_FALSE(has(text, letter));
    CHECK_FALSE(has(text, "\ncarom: forged"));
}

}  // namespace

TEST_CASE("no command writes to a terminal what a name of a file or a word of a scene commands") {
    const TemporaryFolder folder;
    const std::string name = evil + ".yaml", broken = evil + "2.yaml";
    folder.write(name, scene);
    folder.write(broken, "title: \"\u202e\"\n\"k\u202e\\e\": [\n");
    const std::vector<std::vector<std::string>> calls{
        {"check", name},
        {"check", broken},
        {"check", evil},
        {"check", name, "--set", evil + "=1"},
        {"check", name, "--set", "gas.0.speed=" + evil},
        {"render", name, "--size", "320x180", "--seconds", "0.2"},
        {"render", name, "-o", evil},
        {"render", name, "--join"},
        {"render", broken},
        {"still", name, "--size", "320x180"},
        {"still", name, "--at", evil},
        {"still", name, "--format", evil},
        {"still", name, "-o", evil},
        {"figure", name, "--kind", "speed-histogram"},
        {"figure", name, "--kind", evil},
        {"figure", name, "--kind", "gas", "--at", evil},
        {"figures", name},
        {"run", name},
        {"run", name, "--csv", evil + ".csv"},
        {"plan", name, "--seeds", "1..2", "-o", evil + "plan/"},
        {"plan", name, "--seeds", "1..2", "-o", evil + "plan/"},
        {"plan", name, "--size", "320x180", "-o", evil + "film/"},
        {"plan", name, "--seeds", evil},
        {"join", evil},
        {"join", evil + "plan/"},
        {"new", evil},
        {"new", evil},
        {"help", evil},
        {evil},
        {"check", "--" + evil},
    };
    for (std::vector<std::string> call : calls) {
        CAPTURE(call.front());
        CAPTURE(call.back());
        call.insert(call.begin(), program);
        const Outcome outcome = run(call, folder.path());
        check_text(outcome.out);
        check_text(outcome.err);
        CHECK(outcome.out.size() + outcome.err.size() > 0);
    }
}
