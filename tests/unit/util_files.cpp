#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/files.h"
#include "util/atomic_file.h"
#include "util/diagnostics.h"

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

TEST_CASE("a folder in the place of the file is a clear error") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH_AS(AtomicFile(folder.path()), doctest::Contains("Is a directory"),
                         SystemError);
}

TEST_CASE("a file over the ceiling is refused with the number") {
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
