#include "util/files/scratch_file.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "support/environment.h"
#include "support/files.h"
#include "util/diagnostics.h"

using namespace carom;

namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

std::string read(const ScratchFile& file, std::int64_t place, std::size_t length) {
    std::string text(length, '\0');
    file.read(place, std::as_writable_bytes(std::span(text)));
    return text;
}

}  // namespace

TEST_CASE("a scratch file gives back what was added, from where it was added") {
    ScratchFile file;
    CHECK(file.append(bytes_of("one")) == 0);
    CHECK(file.append({}) == 3);
    CHECK(file.append(bytes_of("three")) == 3);
    CHECK(read(file, 3, 5) == "three");
    CHECK(read(file, 0, 3) == "one");
    CHECK_THROWS_AS(read(file, 6, 3), SystemError);
}

TEST_CASE("a scratch file takes no more than it may") {
    ScratchFile file(6);
    CHECK(file.append(bytes_of("four")) == 0);
    CHECK_FALSE(file.append(bytes_of("six")));
    CHECK(file.append(bytes_of("in")) == 4);
    CHECK(read(file, 0, 6) == "fourin");
    ScratchFile none(0);
    CHECK_FALSE(none.append(bytes_of("a")));
}

TEST_CASE("where there can be no scratch file nothing is added, and no name is left of one") {
    const test::TemporaryFolder folder;
    {
        const test::EnvironmentVariable nowhere("TMPDIR", folder.path() / "missing");
        CHECK(ScratchFile::room() == 0);
        CHECK_FALSE(ScratchFile().append(bytes_of("a")));
    }
    const test::EnvironmentVariable here("TMPDIR", folder.path());
    ScratchFile file;
    CHECK(file.append(bytes_of("a")) == 0);
    CHECK(std::filesystem::is_empty(folder.path()));
}
