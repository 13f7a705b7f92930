// Spools of pieces of bytes (util/files/spool.h).
#include "util/files/spool.h"

#include <doctest/doctest.h>

#include <string>

#include "support/environment.h"
#include "support/process.h"
#include "util/archive.h"

using namespace carom;

namespace {

std::string piece(std::size_t k, std::size_t length) {
    std::string bytes(length, static_cast<char>(k));
    if (length > 0) bytes.front() = '\0';
    return bytes;
}

}  // namespace

TEST_CASE("a spool gives back its pieces, from memory and from the file") {
    constexpr std::size_t length = 1000;
    for (const std::size_t in_memory : {std::size_t{0}, 3 * length + 1, 100 * length}) {
        CAPTURE(in_memory);
        Spool spool(in_memory);
        for (std::size_t k = 0; k < 10; ++k) spool.add(piece(k, k % 3 == 2 ? 0 : length + k));
        REQUIRE(spool.size() == 10);
        for (std::size_t k = 10; k-- > 0;) {
            CHECK(spool.piece(k) == piece(k, k % 3 == 2 ? 0 : length + k));
            CHECK(spool.piece(k) == spool.piece(k));
        }
    }
}

TEST_CASE("a spool that is written is read back whole") {
    Spool spool(1500);
    for (std::size_t k = 0; k < 4; ++k) spool.add(piece(k, 1000));
    Archive written;
    written(spool);
    Archive read(written.finished(), "a spool");
    Spool again(0);
    read(again);
    read.expect_end();
    REQUIRE(again.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) CHECK(again.piece(k) == piece(k, 1000));
}

TEST_CASE("a spool that has no file for its pieces keeps them in memory") {
    const test::TemporaryFolder folder;
    const test::EnvironmentVariable nowhere("TMPDIR", folder.path() / "missing");
    Spool spool(0);
    spool.add(piece(1, 10));
    CHECK(spool.piece(0) == piece(1, 10));
}
