// What ./dev setup asks of the package managers: programs of their names write down their calls.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t debian = 0, role = 6;
const Cells managers{"apt-get", "dnf", "pacman", "brew"};  // by their columns

const std::string small_table =
    "# Debian | Fedora         | Arch | macOS | found by | minimum | for   | why\n"
    "one      | one-devel      | two  | -     | pkg one  | 1       | build | a library\n"
    "two      | two(x) two-bin | two  | two   | -        | 1       | run   | a program and its "
    "data\n"
    "three    | none           | -    | none  | -        | 1       | test  | a judge\n"
    "two      | two(x)         | two  | two   | -        | 1       | test  | the same\n"
    "four     | four           | four | four  | -        | 1       | lint  | not asked for\n";

// A machine with a checkout, some package managers, and hardly more than dev needs.
class Machine {
  public:
    Machine(const std::string& system, const std::string& table) {
        // It must not ask the system that the test runs on.
        std::string script = contents(root / "dev");
        for (const std::string file = "/etc/os-release"; has(script, file);)
            script.replace(script.find(file), file.size(), "./os-release");
        make_program("dev", script);
        folder_.write("dependencies.txt", table);
        folder_.write("installed", "");
        folder_.write("calls", "");
        if (!system.empty()) folder_.write("os-release", system);
        for (const std::string file : {"tests/npm/package.json", "tests/npm/package-lock.json"})
            folder_.write(file, contents(root / file));
        for (const std::string tool : {"awk", "basename", "bash", "cat", "cp", "dirname", "env",
                                       "grep", "mkdir", "readlink", "tail", "touch"}) {
            const Outcome found = shell("command -v " + tool);
            REQUIRE(found.exit_code == 0);
            fs::create_directories(folder_.path() / "bin");
            fs::create_symlink(found.out.substr(0, found.out.find('\n')),
                               folder_.path() / "bin" / tool);
        }
        add("uname", "echo Darwin");
        set_user(1000);
    }

    // A program that writes down its call after `script`.
    void add(const std::string& name, const std::string& script) const {
        make_program("bin/" + name, "#!/bin/sh\n" + script + "\n");
    }

    // With the program that is asked what is installed.
    void add_manager(const std::string& name) const {
        const std::string call = "echo " + name + " \"$@\" >>calls\n";
        const std::string asked = "for last; do :; done\ngrep -qxF -- \"$last\" installed";
        add(name, call);
        if (name == "apt-get") add("dpkg-query", asked + " && printf installed");
        if (name == "dnf") add("rpm", asked);
        if (name == "pacman")
            add(name, "if [ \"$1\" = -T ]; then " + asked + "; exit; fi\n" + call);
        if (name == "brew")
            add(name, "if [ \"$1\" = list ]; then " + asked + "; exit; fi\n" + call);
    }

    void set_user(int id) const { add("id", "echo " + std::to_string(id)); }

    void add_sudo() const { add("sudo", "printf 'sudo ' >>calls\n\"$@\""); }

    void install(const Cells& packages) const {
        std::ofstream file(folder_.path() / "installed", std::ios::app);
        for (const std::string& package : packages) file << package << '\n';
    }

    Outcome dev(const std::string& arguments) const {
        return shell("env -i PATH=$PWD/bin ./dev " + arguments, folder_.path());
    }

    std::string calls() const { return contents(folder_.path() / "calls"); }
    std::string log() const { return contents(folder_.path() / "build/setup.log"); }

  private:
    void make_program(const std::string& name, const std::string& script) const {
        folder_.write(name, script);
        fs::permissions(folder_.path() / name, fs::perms{0755});
    }

    TemporaryFolder folder_;
};

const std::string bookworm = "PRETTY_NAME=\"Debian GNU/Linux 12\"\nID=debian\nVERSION_ID=\"12\"\n";
const std::string fedora = "PRETTY_NAME='Fedora Linux 43'\nID=fedora\nVERSION_ID=43\n";
const std::string arch = "PRETTY_NAME='Arch Linux'\nID=arch\n";
const std::string macos;  // has no such file

std::string untried(const std::string& system) {
    return "carom: carom was not tried on this system (" + system + "), only on Debian 12 and 13\n";
}

// The rows of dependencies.txt as cells without the spaces around them.
std::vector<Cells> table() {
    std::vector<Cells> rows;
    std::ifstream file(root / "dependencies.txt");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        Cells cells;
        for (std::size_t begin = 0; begin != std::string::npos;) {
            const std::size_t end = line.find('|', begin);
            std::string cell = line.substr(begin, end - begin);
            cell.erase(0, cell.find_first_not_of(' '));
            cell.erase(cell.find_last_not_of(' ') + 1);
            cells.push_back(cell);
            begin = end == std::string::npos ? end : end + 1;
        }
        rows.push_back(cells);
    }
    return rows;
}

// What a column lists for these roles, each name once, with a space before it.
std::string names(std::size_t column, const Cells& roles) {
    Cells seen;
    std::string list;
    for (const Cells& row : table()) {
        if (std::ranges::find(roles, row.at(role)) == roles.end()) continue;
        std::istringstream cell(row.at(column));
        for (std::string name; cell >> name;) {
            if (name == "-" || name == "none" || std::ranges::count(seen, name) > 0) continue;
            seen.push_back(name);
            list += " " + name;
        }
    }
    return list;
}

}  // namespace

TEST_CASE("set-up asks the system's package manager for its own names of what is missing") {
    struct Case {
        std::string manager, system, said, calls;
    };
    const std::vector<Case> cases{
        {"apt-get", bookworm, "carom: installing with apt-get: one two three\n",
         "sudo apt-get update -qq\n"
         "sudo apt-get install -y -qq --no-install-recommends one two three\n"},
        {"dnf", fedora,
         untried("Fedora Linux 43") +
             "carom: dnf has no package for what Debian calls three; dependencies.txt says what "
             "they are for\n"
             "carom: installing with dnf: one-devel two(x) two-bin\n",
         "sudo dnf install -y --setopt=install_weak_deps=False one-devel two(x) two-bin\n"},
        {"pacman", arch, untried("Arch Linux") + "carom: installing with pacman: two\n",
         "sudo pacman -S --needed --noconfirm two\n"},
        {"brew", macos,
         untried("macOS") +
             "carom: brew has no package for what Debian calls three; dependencies.txt says what "
             "they are for\n"
             "carom: installing with brew: two\n",
         "brew install two\n"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.manager);
        const Machine machine(c.system, small_table);
        machine.add_manager(c.manager);
        machine.add_sudo();
        const Outcome outcome = machine.dev("setup");
        CHECK(outcome.exit_code == 0);
        CHECK(outcome.err == c.said);
        CHECK(machine.calls() == c.calls);
        CHECK(machine.dev("setup").err.empty());  // the table has not changed
    }
}

TEST_CASE("set-up leaves alone what is installed") {
    const Machine machine(fedora, small_table);
    machine.add_manager("dnf");
    machine.add_sudo();
    machine.install({"one-devel", "two-bin"});
    machine.dev("setup");
    CHECK(machine.calls() == "sudo dnf install -y --setopt=install_weak_deps=False two(x)\n");

    const Machine complete(bookworm, small_table);
    complete.add_manager("apt-get");
    complete.install({"one", "two", "three"});
    const Outcome outcome = complete.dev("setup");
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(complete.calls().empty());
}

TEST_CASE("the first of several package managers is asked") {
    for (std::size_t first = 0; first < managers.size(); ++first) {
        const Machine machine(bookworm, small_table);
        machine.add_sudo();
        for (std::size_t i = first; i < managers.size(); ++i) machine.add_manager(managers[i]);
        CHECK(has(machine.dev("setup").err, "installing with " + managers[first] + ":"));
    }
}

TEST_CASE("set-up needs root or sudo, and with brew neither") {
    const Machine machine(bookworm, small_table);
    machine.add_manager("apt-get");
    const Outcome outcome = machine.dev("setup");
    CHECK(outcome.exit_code == 1);
    CHECK(
        outcome.err ==
        "carom: these packages are missing, and neither root nor sudo is at hand: one two three\n");
    CHECK(machine.calls().empty());

    const Machine rooted(arch, small_table);
    rooted.add_manager("pacman");
    rooted.set_user(0);
    CHECK(rooted.dev("setup").exit_code == 0);
    CHECK(rooted.calls() == "pacman -S --needed --noconfirm two\n");

    const Machine brewed(macos, small_table);
    brewed.add_manager("brew");
    brewed.set_user(0);
    const Outcome refused = brewed.dev("setup");
    CHECK(refused.exit_code == 1);
    CHECK(has(refused.err,
              "carom: brew does not work as root, and these packages are missing: two\n"));
    CHECK(brewed.calls().empty());
}

TEST_CASE("a package manager that fails is quoted") {
    const Machine machine(bookworm, small_table);
    machine.add_manager("apt-get");
    machine.add("apt-get", "echo 'E: Unable to locate package one'; exit 100");
    machine.set_user(0);
    const Outcome outcome = machine.dev("setup");
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.err ==
          "carom: installing with apt-get: one two three\n"
          "E: Unable to locate package one\n"
          "carom: apt-get failed; all it said: build/setup.log\n");
    CHECK(machine.log() == "E: Unable to locate package one\n");
}

TEST_CASE("without a package manager set-up goes on, for what was installed by hand") {
    const Machine machine(macos, small_table);
    const Outcome outcome = machine.dev("setup");
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err ==
          untried("macOS") +
              "carom: this system has none of apt-get, dnf, pacman and brew; install "
              "by hand what dependencies.txt lists\n");
}

TEST_CASE("the table of dependencies has a cell for each system") {
    const std::vector<Cells> rows = table();
    REQUIRE(rows.size() > 40);
    for (const Cells& row : rows) {
        CAPTURE(row[debian]);
        CHECK(row.size() == 8);
        CHECK(std::ranges::none_of(row, &std::string::empty));
        CHECK_FALSE(has(row[debian], " "));
    }
}

TEST_CASE("of the table of dependencies each system gets its own column") {
    const Cells prefix{"sudo apt-get install -y -qq --no-install-recommends",
                       "sudo dnf install -y --setopt=install_weak_deps=False",
                       "sudo pacman -S --needed --noconfirm", "brew install"};
    for (std::size_t column = 0; column < managers.size(); ++column) {
        CAPTURE(managers[column]);
        const Machine machine(bookworm, contents(root / "dependencies.txt"));
        machine.add_manager(managers[column]);
        machine.add_sudo();
        machine.add("npm", "echo npm \"$@\" >>../../calls");  // it works in build/npm
        CHECK(machine.dev("setup full").exit_code == 0);
        std::string calls;
        for (const Cells& roles : {Cells{"build", "run", "test"}, Cells{"lint", "full"}}) {
            if (column == debian) calls += "sudo apt-get update -qq\n";
            calls += prefix[column] + names(column, roles) + "\n";
        }
        calls += "npm ci --ignore-scripts --no-audit --no-fund\n";
        CHECK(machine.calls() == calls);
        CHECK(machine.dev("setup full").exit_code == 0);
        CHECK(machine.calls() == calls);
    }
}

TEST_CASE(
    "where npm is not there, it is installed first, and its registry is no part of the list") {
    const Machine machine(bookworm, contents(root / "dependencies.txt"));
    machine.add_manager("apt-get");
    machine.add_sudo();
    CHECK(machine.dev("setup full").exit_code != 0);  // as the package does nothing here
    CHECK(has(machine.calls(),
              "install -y -qq --no-install-recommends" + names(debian, {"npm"}) + "\n"));
    CHECK_FALSE(has(contents(root / "tests/npm/package-lock.json"), "resolved"));
}
