// The changelog is a list for users: short lines, and few of them.
#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "support/test_root.h"

TEST_CASE("the changelog fits on a page or two") {
    constexpr int most_lines = 80;
    constexpr std::size_t most_letters = 160;
    std::ifstream file(carom::test::checkout() / "CHANGELOG.md");
    int lines = 0;
    for (std::string line; std::getline(file, line); ++lines) {
        CAPTURE(line);
        CHECK(line.size() < most_letters);
    }
    CHECK(lines > 10);
    CHECK(lines <= most_lines);
}
