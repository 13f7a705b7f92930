#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "draw/canvas.h"
#include "media/base64.h"
#include "support/files.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"

using namespace carom;
using test::TemporaryFolder;
namespace fs = std::filesystem;

TEST_CASE("a PNG is written whole, in a folder that is made for it") {
    const TemporaryFolder folder;
    Canvas canvas({320, 200});
    canvas.fill_all(rgb(0x123456));
    const fs::path path = folder.path() / "new" / "picture.png";
    write_file(path, canvas.file());
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
        write_file(path, canvas.file());
        FAIL("no error");
    } catch (const SystemError& error) {
        CHECK(std::string(error.what()).find(path.string()) != std::string::npos);
    }
}

TEST_CASE("base64 is that of RFC 4648") {
    const std::vector<std::pair<std::string, std::string>> of_the_rfc{{"", ""},
                                                                      {"f", "Zg=="},
                                                                      {"fo", "Zm8="},
                                                                      {"foo", "Zm9v"},
                                                                      {"foob", "Zm9vYg=="},
                                                                      {"fooba", "Zm9vYmE="},
                                                                      {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : of_the_rfc) CHECK(base64(bytes) == text);
    CHECK(base64(std::string("\xFF\xFE\x00\xFB", 4)) == "//4A+w==");
}
