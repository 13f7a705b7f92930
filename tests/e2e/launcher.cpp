// ./carom and ./dev where nothing may be written, and where there is no repository.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// A checkout with both scripts, a source, and a program that was built after it.
struct Checkout {
    TemporaryFolder folder;

    Checkout() {
        for (const std::string script : {"carom", "dev", "dependencies.txt"})
            fs::copy(root / script, folder.path() / script);
        for (const std::string part : {"src", "cmake", "tests", "build/release/bin"})
            fs::create_directories(folder.path() / part);
        folder.write("CMakeLists.txt", "");
        folder.write("src/a.cpp", "");
        make_program("build/release/bin/carom", "echo \"ran $*\"");
        fs::permissions(folder.path(), fs::perms{0755});
        REQUIRE(shell("touch -d '1 minute ago' src/a.cpp src cmake CMakeLists.txt dependencies.txt",
                      folder.path())
                    .exit_code == 0);
    }

    void make_program(const std::string& name, const std::string& script) const {
        folder.write(name, "#!/bin/sh\n" + script + "\n");
        fs::permissions(folder.path() / name, fs::perms{0755});
    }

    // As somebody who may not write here.
    Outcome as_guest(const std::string& command) const {
        if (geteuid() == 0)
            return shell("setpriv --reuid=65534 --regid=65534 --clear-groups " + command,
                         folder.path());
        shell("chmod -R a-w build");
        const Outcome outcome = shell(command, folder.path());
        shell("chmod -R u+w build");
        return outcome;
    }
};

}  // namespace

TEST_CASE("what is built runs where nothing may be written") {
    const Checkout checkout;
    const Outcome outcome = checkout.as_guest("./carom check scene.yaml");
    CHECK(outcome.err.empty());
    CHECK(outcome.out == "ran check scene.yaml\n");
    CHECK(outcome.exit_code == 0);
}

TEST_CASE("a shell that completes a command line asks for no build") {
    const Checkout checkout;
    checkout.make_program("dev", "echo asked");
    const auto said = [&](const std::string& call) {
        return shell("./carom " + call, checkout.folder.path());
    };
    CHECK(has(said("check scene.yaml").err, "asked"));
    const Outcome outcome = said("__complete bash che");
    CHECK(outcome.err.empty());
    CHECK(outcome.out == "ran __complete bash che\n");
}

TEST_CASE("what was built after its last change runs without asking for a build") {
    const Checkout checkout;
    checkout.make_program("dev", "echo \"asked $*\"");
    checkout.folder.write("CMakePresets.json", "");
    checkout.folder.write("build/release/.current", "");
    const auto touch = [&](const std::string& when, const std::string& file) {
        REQUIRE(shell("touch -d '" + when + "' " + file, checkout.folder.path()).exit_code == 0);
    };
    const auto asks = [&] {
        const Outcome outcome = shell("./carom check scene.yaml", checkout.folder.path());
        CHECK(outcome.out == "ran check scene.yaml\n");
        CHECK((outcome.err.empty() || outcome.err == "asked build carom\n"));
        return !outcome.err.empty();
    };
    touch("1 minute ago", "CMakePresets.json");
    touch("1 minute", "build/release/.current");
    CHECK_FALSE(asks());
    for (const std::string changed :
         {"src/a.cpp", "src", "cmake", "CMakeLists.txt", "CMakePresets.json", "dependencies.txt"}) {
        CAPTURE(changed);
        touch("2 minutes", changed);
        CHECK(asks());
        touch("1 minute ago", changed);
        CHECK_FALSE(asks());
    }
    // A library was installed since.
    touch("2000-01-01", "build/release/.current");
    CHECK(asks());
    REQUIRE(shell("rm build/release/.current", checkout.folder.path()).exit_code == 0);
    CHECK(asks());
}

TEST_CASE("the launcher is found by a link, from any folder") {
    const Checkout checkout;
    checkout.make_program("dev", ":");
    for (const std::string& command :
         {"cd / && '" + (checkout.folder.path() / "link").string() + "' a",
          std::string("./carom a"), std::string("bash carom a")}) {
        CAPTURE(command);
        shell("ln -sf carom link", checkout.folder.path());
        CHECK(shell(command, checkout.folder.path()).out == "ran a\n");
    }
}

TEST_CASE("what is out of date where nothing may be written is told with what is not writable") {
    const Checkout checkout;
    REQUIRE(shell("touch -d '1 minute' src/a.cpp", checkout.folder.path()).exit_code == 0);
    for (const std::string command : {"./carom --version", "./dev test"}) {
        CAPTURE(command);
        const Outcome outcome = checkout.as_guest(command);
        CHECK(outcome.exit_code == 1);
        CHECK(outcome.out.empty());
        CHECK(outcome.err ==
              "carom: cannot build: " + (fs::canonical(checkout.folder.path()) / "build").string() +
                  " is not writable\n");
    }
}

TEST_CASE("the layout is checked and made without a repository") {
    const Checkout checkout;
    checkout.make_program("clang-format", "echo \"$*\"");
    checkout.make_program("shellcheck", ":");
    checkout.folder.write("tests/b.h", "");
    checkout.folder.write("build/.setup-lint", "");
    const auto said = [&](const std::string& command) {
        return shell("PATH=$PWD:$PATH ./dev " + command, checkout.folder.path()).out;
    };
    CHECK(said("format") == "-i src/a.cpp tests/b.h\n");
    CHECK(said("lint") == "--dry-run --Werror src/a.cpp tests/b.h\n");
}
