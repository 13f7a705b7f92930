#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "util/atomic_file.h"
#include "util/diagnostics.h"

using namespace carom;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path =
        fs::temp_directory_path() / fs::path("carom-files-" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    long entries() const { return std::distance(fs::directory_iterator(path), {}); }
};

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("an atomic file appears whole, or not at all and the earlier one stays") {
    const Folder folder;
    const fs::path path = folder.path / "film.mp4";
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
    CHECK(folder.entries() == 1);
}

TEST_CASE("a folder in the place of the file is a clear error") {
    const Folder folder;
    CHECK_THROWS_WITH_AS(AtomicFile(folder.path), doctest::Contains("Is a directory"), SystemError);
}

TEST_CASE("a file over the ceiling is refused with the number") {
    const Folder folder;
    std::ofstream(folder.path / "big") << std::string(100, 'x');
    CHECK_THROWS_WITH_AS(read_file(folder.path / "big", 99), doctest::Contains("99"), SystemError);
    CHECK(read_file(folder.path / "big", 100).size() == 100);
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
