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
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

constexpr const char* scene =
    "title: Two disks\nbox: {size: [8, 6]}\ngas: [{count: 2, radius: 0.5, speed: 1}]\n"
    "run: {until: 1}\nfilm: {seconds: 0.4, fps: 15, panels: [temperature]}\n";

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

}  // namespace

TEST_CASE("what stands in the place of a file of a cache is neither followed nor waited for") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
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
    folder.write("scene.yaml", scene);
    const std::string plain = "still scene.yaml -o still.png --size 128x96 --cache ";
    const Outcome outcome = carom_in(folder, plain + "/proc/cache");
    CHECK(outcome.exit_code == 0);
    CHECK(has(outcome.err, "carom: --cache: cannot write /proc/cache/"));
    CHECK(fs::exists(folder.path() / "still.png"));
    CHECK(carom_in(folder, plain + "scene.yaml").exit_code == 1);
}

TEST_CASE("what stands in the place of a file of a plan is neither followed nor waited for") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    succeed(folder, {plan, chunk, join});
    const std::string film = contents(folder.path() / "film.mp4");
    for (const std::string name : {"chunks/0001.json", "chunks/0001.chunk"})
        for (const Kind kind : {Kind::link, Kind::hard_link, Kind::pipe}) {
            CAPTURE(name);
            CAPTURE(static_cast<int>(kind));
            folder.write("victim", "mine");
            replace(folder.path() / "plan" / name, kind, folder.path() / "victim");
            succeed(folder, {chunk, join});
            CHECK(contents(folder.path() / "victim") == "mine");
            CHECK(fs::is_regular_file(fs::symlink_status(folder.path() / "plan" / name)));
            CHECK(contents(folder.path() / "film.mp4") == film);
        }
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
    CHECK(has(outcome.err, "a symbolic link stands in its place"));
    CHECK(contents(folder.path() / "elsewhere/0001.chunk") == "mine");
}

TEST_CASE("the chunks of a sweep are not written through links either") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const std::string run = "run sweep --chunk 1 --quiet", sum = "join sweep -o s.json --quiet";
    succeed(folder, {"plan scene.yaml --seeds 2 --chunks 1 -o sweep --quiet", run, sum});
    const std::string summary = contents(folder.path() / "s.json");
    for (const std::string name : {"chunks/0001.runs", "chunks/0001.json", "summary.json"})
        for (const Kind kind : {Kind::link, Kind::hard_link, Kind::pipe}) {
            CAPTURE(name);
            CAPTURE(static_cast<int>(kind));
            folder.write("victim", "mine");
            replace(folder.path() / "sweep" / name, kind, folder.path() / "victim");
            succeed(folder, {run, sum});
            CHECK(contents(folder.path() / "victim") == "mine");
            CHECK(contents(folder.path() / "s.json") == summary);
        }
}

TEST_CASE(
    "what stands in the place of a figure or of their list is neither followed nor waited for") {
    const TemporaryFolder folder;
    folder.write("films/scene.yaml", fmt::format("{}figures: [{{name: one, kind: gas}}]\n", scene));
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
            CHECK(outcome.exit_code <= 2);
            CHECK(contents(folder.path() / "victim") == "mine");
            if (outcome.exit_code == 0) CHECK(contents(file) == earlier);
            fs::remove_all(file);
            folder.write(name, earlier);
        }
}

TEST_CASE("a scene in the folder of a plan, which would have no effect, is refused") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    succeed(folder, {plan});
    folder.write("plan/scene.yaml", scene);
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

TEST_CASE("devices and pipes that the user names are read as before") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const Outcome piped =
        shell(fmt::format("cat scene.yaml | timeout 60 '{}' check -", program), folder.path());
    CHECK(piped.exit_code == 0);
}
