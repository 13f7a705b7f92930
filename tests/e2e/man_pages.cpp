// The man pages: what other programs think of them, and that they are installed.
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <string>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// In which nothing but the date is missing: pages do not depend on the day on which they are made.
std::string complaints(const fs::path& page) {
    const std::string by_mandoc = run({"mandoc", "-T", "lint", "-W", "warning", page.string()}).out;
    const std::string by_groff =
        shell("LC_ALL=C.UTF-8 man --warnings -l '" + page.string() + "' 2>&1 >/dev/null").out;
    return std::regex_replace(by_mandoc, std::regex("[^\n]*missing date[^\n]*\n"), "") + by_groff;
}

}  // namespace

TEST_CASE("mandoc and groff find nothing wrong with the man pages") {
    const TemporaryFolder folder;
    REQUIRE(run({program, "help", "--files", folder.path().string()}).exit_code == 0);
    int pages = 0;
    for (const auto& entry : fs::directory_iterator(folder.path() / "man/man1")) {
        CAPTURE(entry.path().filename().string());
        CHECK(complaints(entry.path()) == "");
        ++pages;
    }
    CHECK(pages == 14);
    const Outcome broken = run({"mandoc", "-T", "lint", "-W", "warning",
                                folder.write("broken.1", ".TH X 1\n.SH NAME\n.XX\n").string()});
    CHECK(broken.exit_code != 0);
}

TEST_CASE("man shows each option with its meaning") {
    const TemporaryFolder folder;
    REQUIRE(run({program, "help", "--files", folder.path().string()}).exit_code == 0);
    const Outcome shown = shell(
        "MANPATH=$PWD/man MANWIDTH=100 LC_ALL=C.UTF-8 man carom-render | col -b", folder.path());
    for (const std::string part :
         {"carom render SCENE... [options]", "-o, --output FILM", "--format mp4|webm|gif|pdf|png",
          "carom render scenes/one-hot-particle.yaml", "set a value of the scene"}) {
        CAPTURE(part);
        CHECK(has(shown.out, part));
    }
}

TEST_CASE("carom help prints the manual of a command, or of the program") {
    const Outcome all = run({program, "help"}), one = run({program, "help", "join"});
    CHECK(has(all.out, "\nEnvironment:\n"));
    CHECK(has(all.out, "carom-render(1)"));
    CHECK(has(one.out, "carom-join: put together what the chunks of a plan have made\n"));
    CHECK(has(one.out, "\nExit status:\n"));
    const Outcome wrong = run({program, "help", "rendre"});
    CHECK(wrong.exit_code == 2);
    CHECK(wrong.err == "carom: there is no command `rendre`; did you mean `render`?\n");
}

TEST_CASE("carom help goes through the pager on a terminal only") {
    CHECK_FALSE(has(shell("PAGER='sed s/^/paged:/' '" + program + "' help join").out, "paged:"));
    // script gives it a terminal.
    const auto on_terminal = [](const std::string& pager) {
        return shell("PAGER='" + pager + "' script -qec \"'" + program +
                     "' help join\" /dev/null </dev/null")
            .out;
    };
    CHECK(has(on_terminal("sed s/^/paged:/"), "paged:carom-join: "));
    CHECK(has(on_terminal("there-is-no-such-pager"), "carom-join: "));
    CHECK(has(on_terminal(""), "carom-join: "));
}
