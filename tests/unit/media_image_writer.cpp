#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "media/image_writer.h"
#include "support/files.h"
#include "util/atomic_file.h"
#include "util/diagnostics.h"

using namespace carom;
using test::TemporaryFolder;
namespace fs = std::filesystem;

TEST_CASE("a PNG is written whole, in a folder that is made for it") {
    const TemporaryFolder folder;
    Canvas canvas({320, 200});
    canvas.fill_all(rgb(0x123456));
    const fs::path path = folder.path() / "new" / "picture.png";
    write_image(canvas, path);
    const std::string bytes = read_file(path, 1 << 20);
    const std::vector<std::uint8_t> expected = canvas.file();
    CHECK(bytes == std::string(expected.begin(), expected.end()));
    CHECK(std::distance(fs::directory_iterator(path.parent_path()), {}) == 1);
}

TEST_CASE("an unwritable place for a PNG is named") {
    const TemporaryFolder folder;
    Canvas canvas({2, 2});
    const fs::path path = folder.path() / "picture.png";
    fs::create_directory(path);
    try {
        write_image(canvas, path);
        FAIL("no error");
    } catch (const SystemError& error) {
        CHECK(std::string(error.what()).find(path.string()) != std::string::npos);
    }
}
