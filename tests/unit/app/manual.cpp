// The manual is made from the table of commands: its examples are calls of carom, and its pages
// hold what roff and readers need.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/commands/command_line.h"
#include "app/manual/page.h"
#include "app/manual/page_text.h"
#include "app/manual/roff.h"
#include "support/test_root.h"
#include "util/diagnostics.h"

using namespace carom;

namespace {

// The words behind `carom`, up to where a shell would send the output.
std::vector<std::string> words_of(const std::string& call) {
    std::istringstream text(call);
    std::vector<std::string> words;
    for (std::string word; text >> word && word != ">";) words.push_back(word);
    REQUIRE(words.size() > 1);
    REQUIRE(words.front() == "carom");
    words.erase(words.begin());
    return words;
}

}  // namespace

TEST_CASE("each command has three examples, which are calls of it with scenes that exist") {
    for (const Command& command : all_commands()) {
        CAPTURE(command.name);
        CHECK(command.text.examples.size() == 3);
        CHECK_FALSE(command.text.description.empty());
        for (const auto& example : command.text.examples) {
            const std::string call = example.call;
            CAPTURE(call);
            const std::vector<std::string> words = words_of(call);
            CHECK(words.front() == command.name);
            CHECK_NOTHROW(check_command_line(words));
            for (const std::string& word : words)
                if (word.starts_with("scenes/"))
                    CHECK(std::filesystem::exists(test::checkout() / word));
        }
    }
    CHECK_THROWS_AS(check_command_line({"render", "scene.yaml", "--loud"}), UsageError);
}

TEST_CASE("each call of a synopsis begins with its command, and names its words") {
    for (const Command& command : all_commands()) {
        CAPTURE(command.name);
        REQUIRE_FALSE(command.text.synopsis.empty());
        for (const std::string& call : command.text.synopsis)
            CHECK(call.starts_with("carom " + command.name));
        const std::string help = text_of(help_of(command));
        for (const Option& option : command.options) {
            CAPTURE(option.name);
            const std::string flags = flags_of(option), word = word_of(option);
            const std::string flag = flags.substr(flags.find(',') + 1);
            CHECK(help.find(!flag.starts_with('-') ? "  " + word
                            : word.empty()         ? flag + " "
                                                   : flag + " " + word) != std::string::npos);
            // A value has a name.
            if (!std::holds_alternative<bool*>(option.value)) CHECK_FALSE(word_of(option).empty());
        }
    }
}

TEST_CASE("plain text keeps to 80 columns where its words allow it") {
    const ManualPage page{"carom-x",
                          "does something",
                          {{.title = "Options",
                            .definitions = {{"-o, --output FILE", std::string(30, 'a') + " " +
                                                                      std::string(30, 'b') + " c"},
                                            {"--x", "short"}}}}};
    CHECK(text_of(page) ==
          "carom-x: does something\n\nOptions:\n"
          "  -o, --output FILE  " +
              std::string(30, 'a') + "\n" + std::string(21, ' ') + std::string(30, 'b') +
              " c\n"
              "  --x                short\n");
}

TEST_CASE("roff takes letters for what they are") {
    const ManualPage page{
        "carom-x", "does", {{.title = "Files", .paragraphs = {".a\\b 'c' `d` -e"}}}};
    CHECK(roff_of(page).find("\\&.a\\eb \\(aqc\\(aq \\(gad\\(ga \\-e\n") != std::string::npos);
}
