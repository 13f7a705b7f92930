// Folders for what is not where it belongs yet.
#include "app/scratch_folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>

#include "support/files.h"
#include "util/diagnostics.h"

using namespace carom;
namespace fs = std::filesystem;

TEST_CASE("scratch folders in one folder are of several names, and gone in the end") {
    const test::TemporaryFolder folder;
    const fs::path in = folder.path() / "new/site";
    {
        const ScratchFolder one(in);
        std::optional<ScratchFolder> two(std::in_place, in);
        CHECK(one.path() != two->path());
        CHECK(one.path().parent_path() == in);
        CHECK(one.path().filename().string().starts_with("."));
        fs::create_directory(one.path() / "films");
        two.reset();
        CHECK(fs::exists(one.path() / "films"));
    }
    CHECK(fs::is_empty(in));
    folder.write("file", "");
    CHECK_THROWS_AS(ScratchFolder(folder.path() / "file/in"), SystemError);
}
