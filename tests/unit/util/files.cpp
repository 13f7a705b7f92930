#include "support/files.h"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"
#include "util/text.h"

using namespace carom;
using test::contents;
using test::TemporaryFolder;
namespace fs = std::filesystem;

TEST_CASE("an atomic file appears whole, or not at all and the earlier one stays") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "film.mp4";
    {
        AtomicFile file(path);
        file.write("first");
        CHECK_FALSE(fs::exists(path));
        file.commit();
    }
    CHECK(contents(path) == "first");
    {
        AtomicFile file(path);
        file.write("second, never finished");
    }
    CHECK(contents(path) == "first");
    CHECK(folder.names().size() == 1);
}

TEST_CASE("of a link what it leads to is written, and the link stays one") {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "disk");
    folder.write("disk/film.mp4", "earlier");
    fs::create_symlink("disk/film.mp4", folder.path() / "link.mp4");
    fs::create_symlink("link.mp4", folder.path() / "second.mp4");
    fs::create_symlink("new/film.mp4", folder.path() / "dangling.mp4");
    for (const char* name : {"second.mp4", "dangling.mp4"}) {
        CAPTURE(name);
        AtomicFile file(folder.path() / name);
        file.write("film");
        file.commit();
        CHECK(fs::is_symlink(folder.path() / name));
        CHECK(contents(folder.path() / name) == "film");
    }
    CHECK(contents(folder.path() / "disk/film.mp4") == "film");
    CHECK(contents(folder.path() / "new/film.mp4") == "film");
    fs::create_symlink("ring", folder.path() / "ring");
    CHECK_THROWS_WITH_AS(AtomicFile(folder.path() / "ring"),
                         doctest::Contains("Too many levels of symbolic links"), SystemError);
    CHECK(folder.names() == std::vector<std::string>{"dangling.mp4", "disk", "link.mp4", "new",
                                                     "ring", "second.mp4"});
}

TEST_CASE("a name may be as long as the system allows") {
    const TemporaryFolder folder;
    std::string long_name = "x";  // so that no cut falls between code points by chance
    while (long_name.size() < 251) long_name += "ä";
    long_name += ".mp4";
    REQUIRE(long_name.size() == 255);
    AtomicFile file(folder.path() / long_name);
    const AtomicFolder frames(folder.path() / long_name);
    CHECK(is_utf8(folder.names().front()));
    file.write("film");
    file.commit();
    CHECK(folder.names().back() == long_name);
}

TEST_CASE("a folder in the place of the file is a clear error") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH_AS(AtomicFile(folder.path()), doctest::Contains("Is a directory"),
                         SystemError);
}

TEST_CASE("a pipe in the place of the file stays one") {
    const test::TemporaryFolder folder;
    const fs::path pipe = folder.path() / "pipe", link = folder.path() / "link";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    fs::create_symlink("pipe", link);
    CHECK_THROWS_AS(AtomicFile{pipe}, SystemError);
    CHECK_THROWS_AS(AtomicFile{link}, SystemError);
    CHECK(fs::is_fifo(link));
}

TEST_CASE("an atomic folder appears whole, or not at all") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "above" / "frames";
    const std::vector<std::uint8_t> bytes{1, 2, 3};
    {
        AtomicFolder frames(path / "");
        frames.write("a", bytes);
        CHECK_FALSE(fs::exists(path));
    }
    CHECK(fs::is_empty(path.parent_path()));
    {
        AtomicFolder frames(path / "");
        frames.write("a", bytes);
        frames.write("b", bytes);
        frames.commit();
    }
    CHECK(contents(path / "a") == "\1\2\3");
    CHECK(std::distance(fs::directory_iterator(path), {}) == 2);
    CHECK(std::distance(fs::directory_iterator(path.parent_path()), {}) == 1);
    fs::create_directory(folder.path() / "usual");
    CHECK(fs::status(path).permissions() == fs::status(folder.path() / "usual").permissions());
}

TEST_CASE("an atomic folder replaces nothing, also what came while it was filled") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "frames";
    fs::create_directory(path);
    {
        AtomicFolder frames(path);
        frames.write("a", {});
        std::ofstream(path / "mine") << "mine";
        CHECK_THROWS_WITH_AS(frames.commit(), doctest::Contains("Directory not empty"),
                             SystemError);
    }
    CHECK_THROWS_WITH_AS(AtomicFolder{path}, doctest::Contains("Directory not empty"), SystemError);
    CHECK(contents(path / "mine") == "mine");
    CHECK(folder.names() == std::vector<std::string>{"frames"});
    CHECK_THROWS_WITH_AS(AtomicFolder{path / "mine"}, doctest::Contains("Not a directory"),
                         SystemError);
}

TEST_CASE("files appear together in a folder that keeps its others") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "site";
    fs::create_directory(path);
    std::ofstream(path / "mine") << "mine";
    std::ofstream(path / "b") << "earlier";
    const auto add = [](const AtomicFolder& files) {
        files.write("a", {});
        files.write_pieces("b", [](const TakePiece& take) {
            take("in ");
            take("pieces");
        });
    };
    {
        AtomicFolder files(path, Earlier::replaced);
        CHECK_FALSE(files.is_new());
        add(files);
    }
    CHECK(contents(path / "b") == "earlier");
    CHECK(std::distance(fs::directory_iterator(path), {}) == 2);
    {
        AtomicFolder files(path, Earlier::replaced);
        add(files);
        files.write("mine", {});
        fs::remove(path / "mine");
        fs::create_directory(path / "mine");
        CHECK_THROWS_WITH_AS(files.commit(), doctest::Contains("site/mine: Is a directory"),
                             SystemError);
    }
    CHECK(contents(path / "b") == "earlier");
    CHECK(std::distance(fs::directory_iterator(path), {}) == 2);
    {
        AtomicFolder files(path, Earlier::replaced);
        add(files);
        files.commit();
    }
    CHECK(contents(path / "b") == "in pieces");
    CHECK(fs::is_directory(path / "mine"));
    CHECK(std::distance(fs::directory_iterator(path), {}) == 3);
    CHECK(AtomicFolder(folder.path() / "new", Earlier::replaced).is_new());
}

TEST_CASE("a file over the limit is refused with the number") {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "big") << std::string(100, 'x');
    CHECK_THROWS_WITH_AS(read_file(folder.path() / "big", 99), doctest::Contains("99"),
                         SystemError);
    CHECK(read_file(folder.path() / "big", 100).size() == 100);
}

TEST_CASE("a diagnostic shows the line with a caret under the value") {
    const Diagnostic diagnostic{
        {"scene.yaml", 3, 9, 4}, "expected a number, found a word", "write 0.5", "radius: huge"};
    CHECK(to_text(diagnostic) ==
          "scene.yaml:3:9: error: expected a number, found a word\n"
          "    3 | radius: huge\n"
          "      |         ^^^^\n"
          "  hint: write 0.5");
}

namespace {

// In another process, which is killed before it can clean up.
template <class Work>
void do_and_be_killed(const Work& work) {
    const pid_t child = fork();
    if (child == 0) {
        work();
        raise(SIGKILL);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
}

}  // namespace

TEST_CASE("a process that is killed leaves no file, and the next run removes its folder") {
    const TemporaryFolder folder;
    do_and_be_killed([&] {
        auto* const file = new AtomicFile(folder.path() / "film.mp4");
        file->write("half");
    });
    CHECK(folder.names().empty());
    do_and_be_killed([&] {
        auto* const frames = new AtomicFolder(folder.path() / "frames");
        frames->write("a", {});
    });
    REQUIRE(folder.names().size() == 1);
    const AtomicFolder alive(folder.path() / "own");  // this process removes the dead one
    CHECK(folder.names().size() == 1);
    CHECK(folder.names().front().starts_with(".own."));
    do_and_be_killed([&] { const AtomicFile another(folder.path() / "film.mp4"); });
    CHECK(folder.names().size() == 1);  // what is alive is left alone
}

TEST_CASE("files appear together, or none, or the message names those that have") {
    const TemporaryFolder folder;
    AtomicFile film(folder.path() / "film.mp4"), words(folder.path() / "film.txt");
    film.write("film");
    words.write("words");
    fs::create_directory(folder.path() / "film.txt");
    CHECK_THROWS_WITH_AS(commit_together({&film, &words}), doctest::Contains("already written: "),
                         SystemError);
    CHECK(contents(folder.path() / "film.mp4") == "film");
    AtomicFile again(folder.path() / "film.mp4");
    again.write("again");
    struct Failing : PendingOutput {
        void settle() override { throw SystemError("full"); }
        void commit() override {}
        std::string name() const override { return "it"; }
    } failing;
    CHECK_THROWS_WITH_AS(commit_together({&again, &failing}), "full", SystemError);
    CHECK(contents(folder.path() / "film.mp4") == "film");
    CHECK(fs::is_empty(folder.path() / "film.txt"));
}
