// Files that carom keeps in caches and plans and reads back: nothing that stands in their place is
// followed, waited for or trusted.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "e2e/program.h"
#include "e2e/two_disks.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// 137 if the command waits for something that never comes.
Outcome carom_in(const TemporaryFolder& folder, const std::string& arguments) {
    return shell(fmt::format("timeout -s KILL 60 '{}' {}", program, arguments), folder.path());
}

const std::string still = "still scene.yaml -o still.png --size 128x96 --cache cache";
const std::string plan = "plan scene.yaml -o plan --size 128x96 --quality draft --quiet";
const std::string chunk = "render plan --chunk 1 --quiet";
const std::string join = "join plan -o film.mp4 --quiet";

void succeed(const TemporaryFolder& folder, const std::vector<std::string>& commands) {
    for (const std::string& command : commands) {
        const Outcome outcome = carom_in(folder, command);
        CAPTURE(command);
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
    }
}

// Of the first of the commands that fails; otherwise of the last.
Outcome first_failure(const TemporaryFolder& folder, const std::vector<std::string>& commands) {
    Outcome outcome;
    for (const std::string& command : commands) {
        outcome = carom_in(folder, command);
        if (outcome.exit_code != 0) break;
    }
    return outcome;
}

fs::path only_file_in(const fs::path& folder) { return *fs::directory_iterator(folder); }

// What a stranger may put in the place of a file.
enum class Kind { link, hard_link, pipe, folder };
constexpr std::array kinds{Kind::link, Kind::hard_link, Kind::pipe, Kind::folder};

void replace(const fs::path& file, Kind kind, const fs::path& victim) {
    fs::remove_all(file);
    if (kind == Kind::link) fs::create_symlink(fs::absolute(victim), file);
    if (kind == Kind::hard_link) fs::create_hard_link(victim, file);
    if (kind == Kind::pipe) REQUIRE(mkfifo(file.c_str(), 0666) == 0);
    if (kind == Kind::folder) fs::create_directory(file);
}

// Puts each kind in the place of each of these files, which the commands write: they replace it and
// make the same output, but refuse a folder, which stays.
void check_replaced(const TemporaryFolder& folder, const std::vector<std::string>& files,
                    const std::vector<std::string>& commands, const std::string& output) {
    const std::string made = contents(folder.path() / output);
    for (const std::string& name : files)
        for (const Kind kind : kinds) {
            CAPTURE(name);
            CAPTURE(static_cast<int>(kind));
            const fs::path file = folder.path() / name;
            folder.write("victim", "mine");
            replace(file, kind, folder.path() / "victim");
            if (kind == Kind::folder) {
                const Outcome outcome = first_failure(folder, commands);
                CHECK(outcome.exit_code == 1);
                CHECK(has(outcome.err, name));
                CHECK(fs::is_directory(file));
                fs::remove(file);
            }
            succeed(folder, commands);
            CHECK(contents(folder.path() / "victim") == "mine");
            CHECK(fs::is_regular_file(fs::symlink_status(file)));
            CHECK(contents(folder.path() / output) == made);
        }
}

}  // namespace

TEST_CASE("what stands in the place of a file of a cache is neither followed nor waited for") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    succeed(folder, {still});
    const std::string picture = contents(folder.path() / "still.png");
    const fs::path axes = only_file_in(folder.path() / "cache");
    for (const Kind kind : kinds) {
        CAPTURE(static_cast<int>(kind));
        folder.write("victim", "mine");
        fs::remove(folder.path() / "still.png");
        replace(axes, kind, folder.path() / "victim");
        const Outcome outcome = carom_in(folder, still);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 0);
        CHECK(contents(folder.path() / "still.png") == picture);
        CHECK(contents(folder.path() / "victim") == "mine");
        CHECK(fs::is_regular_file(fs::symlink_status(axes)) == (kind != Kind::folder));
        CHECK(has(outcome.err, "nothing is kept for the next time") == (kind == Kind::folder));
    }
}

TEST_CASE("a cache that cannot be written costs a warning, and one that is no folder is refused") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    const std::string plain = "still scene.yaml -o still.png --size 128x96 --cache ";
    const Outcome outcome = carom_in(folder, plain + "/proc/cache");
    CHECK(outcome.exit_code == 0);
    CHECK(has(outcome.err, "carom: --cache: cannot write /proc/cache/"));
    CHECK(fs::exists(folder.path() / "still.png"));
    CHECK(carom_in(folder, plain + "scene.yaml").exit_code == 1);
}

TEST_CASE("what stands in the place of a file of a plan is neither followed nor waited for") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    succeed(folder, {plan, chunk, join});
    check_replaced(folder, {"plan/chunks/0001.json", "plan/chunks/0001.chunk"}, {chunk, join},
                   "film.mp4");
    for (const std::string name : {"starts/0001.start", "film.plan", "plan.json"})
        for (const Kind kind : kinds) {
            CAPTURE(name);
            CAPTURE(static_cast<int>(kind));
            const fs::path file = folder.path() / "plan" / name;
            const std::string earlier = contents(file);
            folder.write("victim", "mine");
            replace(file, kind, folder.path() / "victim");
            const Outcome outcome = carom_in(folder, chunk + " --force");
            CAPTURE(outcome.err);
            CHECK((outcome.exit_code == 1 || outcome.exit_code == 2));
            CHECK(contents(folder.path() / "victim") == "mine");
            fs::remove_all(file);
            folder.write("plan/" + name, earlier);
        }
    fs::rename(folder.path() / "plan/chunks", folder.path() / "elsewhere");
    fs::create_symlink("../elsewhere", folder.path() / "plan/chunks");
    const std::string earlier = contents(folder.path() / "elsewhere/0001.chunk");
    folder.write("elsewhere/0001.chunk", "mine");
    const Outcome outcome = carom_in(folder, chunk);
    CHECK(outcome.exit_code == 1);
    CHECK(has(outcome.err, "there is a symbolic link in its place"));
    CHECK(contents(folder.path() / "elsewhere/0001.chunk") == "mine");
}

TEST_CASE("the chunks of a sweep are not written through links either") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    const std::string run = "run sweep --chunk 1 --quiet", sum = "join sweep -o s.json --quiet";
    succeed(folder, {"plan scene.yaml --seeds 2 --chunks 1 -o sweep --quiet", run, sum});
    check_replaced(folder,
                   {"sweep/chunks/0001.runs", "sweep/chunks/0001.json", "sweep/summary.json"},
                   {run, sum}, "s.json");
}

TEST_CASE(
    "what stands in the place of a figure or of their list is neither followed nor waited for") {
    const TemporaryFolder folder;
    folder.write("films/scene.yaml", two_disks + "figures: [{name: one, kind: gas}]\n");
    const std::string figures = "figures films/scene.yaml -o figures --quiet";
    const std::string site = "gallery films -o site --size 128x96 --quality draft --quiet";
    succeed(folder, {figures, site});
    for (const auto& [name, command] :
         {std::pair<std::string, std::string>{"figures/one.svg", figures},
          {"figures/captions.json", figures},
          {"figures/figures.json", figures},
          {"site/index.html", site},
          {"site/gallery.json", site},
          {"site/films/scene.mp4", site}})
        for (const Kind kind : kinds) {
            CAPTURE(name);
            CAPTURE(static_cast<int>(kind));
            const fs::path file = folder.path() / name;
            const std::string earlier = contents(file);
            folder.write("victim", "mine");
            replace(file, kind, folder.path() / "victim");
            const Outcome outcome = carom_in(folder, command + " --force");
            CAPTURE(outcome.err);
            // A list is read before anything is written; a hard link leads to what is no list.
            const bool is_list = name == "figures/figures.json" || name == "site/gallery.json";
            const bool is_replaced = !is_list && kind != Kind::folder;
            const int refused = is_list && kind == Kind::hard_link ? 2 : 1;
            CHECK(outcome.exit_code == (is_replaced ? 0 : refused));
            CHECK(contents(folder.path() / "victim") == "mine");
            CHECK(fs::is_regular_file(fs::symlink_status(file)) ==
                  (is_replaced || kind == Kind::hard_link));
            if (is_replaced) CHECK(contents(file) == earlier);
            fs::remove_all(file);
            folder.write(name, earlier);
        }
}

TEST_CASE("a scene in the folder of a plan, which would have no effect, is refused") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    succeed(folder, {plan});
    folder.write("plan/scene.yaml", two_disks);
    for (const std::string& command :
         {plan, chunk, join, std::string("plan plan --missing"), std::string("plan plan --list")}) {
        CAPTURE(command);
        const Outcome outcome = carom_in(folder, command);
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err, "plan/scene.yaml"));
    }
    fs::remove(folder.path() / "plan/scene.yaml");
    succeed(folder, {chunk, join});
}

TEST_CASE("a scene comes from a pipe as standard input; a pipe that is named as one is refused") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    REQUIRE(mkfifo((folder.path() / "pipe").c_str(), 0666) == 0);
    const Outcome read =
        shell(fmt::format("timeout 60 cat scene.yaml >pipe & timeout 60 '{}' check - <pipe; "
                          "code=$?; wait; exit $code",
                          program),
              folder.path());
    CHECK(read.exit_code == 0);
    CHECK(has(read.out, "<stdin>: valid"));
    const Outcome named = carom_in(folder, "check pipe");  // nobody writes into it
    CHECK(named.exit_code == 2);
    CHECK(named.err == "pipe: error: cannot be read: it is no ordinary file\n");
}
