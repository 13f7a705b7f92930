// Paths that have one use in a process (util/files/one_use_paths.h).
#include "util/files/one_use_paths.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>

#include "support/process.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"

using namespace carom;
namespace fs = std::filesystem;

TEST_CASE("no output takes the place of a file that was read, under whatever name") {
    const test::TemporaryFolder folder;
    folder.write("scene.yaml", "title: A gas");
    fs::create_symlink("scene.yaml", folder.path() / "link.yaml");
    fs::create_directory(folder.path() / "sub");
    const fs::path scene = folder.path() / "scene.yaml";
    write_file(scene, std::string_view("before it is read"));
    keep_source(folder.path() / "link.yaml");
    keep_source(scene);
    for (const fs::path& path :
         {scene, folder.path() / "link.yaml", folder.path() / "sub" / ".." / "scene.yaml"}) {
        CAPTURE(path.string());
        CHECK_THROWS_AS(AtomicFile{path}, UsageError);
    }
    CHECK(read_file(scene, 100) == "before it is read");
    write_file(folder.path() / "other.yaml", std::string_view("is no source"));
}

TEST_CASE("a file that is being written is not read as a source, nor written twice at once") {
    const test::TemporaryFolder folder;
    fs::create_symlink("out", folder.path() / "dangling");
    std::optional<AtomicFile> output(folder.path() / "out");
    CHECK_THROWS_AS(AtomicFile{folder.path() / "dangling"}, UsageError);
    CHECK_THROWS_AS(keep_source(folder.path() / "out"), UsageError);
    output->write(std::string_view("done"));
    output->commit();
    output.reset();
    write_file(folder.path() / "dangling", std::string_view("one after the other"));
    CHECK(read_file(folder.path() / "out", 100) == "one after the other");
}
