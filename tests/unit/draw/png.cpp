// Words in PNG files: chunks as the specification lays them out, with the check sums of another
// program.
#include "draw/png.h"

#include <doctest/doctest.h>

#include <string>

using namespace carom;

namespace {

using Bytes = std::vector<std::uint8_t>;

const Bytes header(8 + 25, 1);  // the signature and IHDR, which nothing reads

Bytes bytes(const std::string& text) { return {text.begin(), text.end()}; }

Bytes joined(const std::vector<Bytes>& parts) {
    Bytes all;
    for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace

TEST_CASE("words follow the header as chunks of text, each with its check sum") {
    const Bytes rest = bytes("pixels");
    const Bytes five(5, 0);
    // Python's zlib.crc32(b'iTXtTitle\0\0\0\0\0T\xc3\xa4') is 0xC0C2DD6C.
    const Bytes expected = joined({header,
                                   {0, 0, 0, 13},
                                   bytes("iTXtTitle"),
                                   five,
                                   bytes("Tä"),
                                   {0xC0, 0xC2, 0xDD, 0x6C},
                                   rest});
    CHECK(with_words(joined({header, rest}), {.title = "Tä", .description = ""}) == expected);
}

TEST_CASE("a resolution follows the header, in dots per metre") {
    // 300 dots per inch are 11811.02 per metre; zlib.crc32(b'pHYs\0\0\x2e\x23\0\0\x2e\x23\1') is
    // 0x78A53F76.
    const Bytes expected = joined({header,
                                   {0, 0, 0, 9},
                                   bytes("pHYs"),
                                   {0, 0, 0x2E, 0x23, 0, 0, 0x2E, 0x23, 1},
                                   {0x78, 0xA5, 0x3F, 0x76},
                                   bytes("pixels")});
    CHECK(with_resolution(joined({header, bytes("pixels")}), 300.0) == expected);
}

TEST_CASE("a picture without words stays as it is") {
    const Bytes picture = joined({header, bytes("pixels")});
    CHECK(with_words(picture, {}) == picture);
}
