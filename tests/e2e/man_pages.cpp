// The man pages: what other programs think of them, and that they are installed.
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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

TEST_CASE("carom help panel shows what the reference says of a panel") {
    const auto help = [](const std::vector<std::string>& words) {
        std::vector<std::string> command{program, "help"};
        command.insert(command.end(), words.begin(), words.end());
        return run(command);
    };
    const std::string all = help({"panel"}).out;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "docs/panels")) {
        if (entry.path().extension() != ".yaml" || entry.path().stem() == "panels") continue;
        const std::string kind = entry.path().stem().string();
        CAPTURE(kind);
        CHECK(has(all, "\n  " + kind + "\n"));
        const Outcome page = help({"panel", kind});
        CHECK(page.exit_code == 0);
        CHECK_FALSE(has(page.out, "]("));
        std::istringstream scene(contents(entry.path()));
        for (std::string line; std::getline(scene, line);) CHECK(has(page.out, "  " + line + "\n"));
    }
    CHECK(has(help({"panel", "sweep"}).out, "carom panel sweep: a kind of figure\n"));
    const std::string pressure = help({"panel", "pressure"}).out;
    CHECK(has(pressure, "\n  gauge "));
    CHECK(has(pressure, "\nKeys in figures:\n  seeds "));
    CHECK_FALSE(has(pressure, "\n  lags "));
    CHECK(has(help({"panel", "sweep"}).out, "see Figures (figures.md)."));
}

TEST_CASE("carom help scene shows sections, keys and what paths lead to") {
    const auto help = [](const std::string& name) { return run({program, "help", "scene", name}); };
    CHECK(has(run({program, "help", "scene"}).out, "\n  measure "));
    const std::string gas = help("gas").out;
    CHECK(has(gas, "\nAn item of `gas`:\n"));
    CHECK(has(gas, "\nAn item of `gas` on a wire:\n  radius        Half the length of each bead"));
    const std::string temperature = help("temperature").out;
    CHECK(has(temperature,
              "\ntemperature, of a wall that acts, an item of `partitions` and an item of "
              "`events`:\n  Makes it a heat bath"));
    CHECK(has(temperature, "\ntemperature, of an item of `gas`:\n"));
    CHECK(has(help("film.slow.factor").out, "\nfilm.slow.factor:\n  The speed of the film there"));
    CHECK(has(help("gas.0.count").out, "\ngas.0.count:\n  The number of particles."));
    CHECK(has(help("run.events").out, "\nAn item of `events`:\n"));
    CHECK(has(help("layout").out, "\n  color_bar "));
    for (const auto& [name, hint] : {std::pair{"equilibrat", "did you mean `equilibrate`?"},
                                     {"run.untl", "carom help scene lists them"},
                                     {"entropy", "write carom help panel entropy"}}) {
        const Outcome wrong = help(name);
        CHECK(wrong.exit_code == 2);
        CHECK(has(wrong.err, hint));
    }
    const Outcome wrong = run({program, "help", "panel", "presure"});
    CHECK(wrong.exit_code == 2);
    CHECK(wrong.err == "carom: there is no panel `presure`; did you mean `pressure`?\n");
    CHECK(run({program, "help", "render", "film"}).exit_code == 2);
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
