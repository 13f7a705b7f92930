// docs/limits.md lists the ceilings as they are.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "scene/keys.h"
#include "scene/limits.h"
#include "support/files.h"

using namespace carom;

namespace {

std::string text_of(const std::string& path) {
    return test::contents(std::string{CAROM_TEST_ROOT} + path);
}

std::vector<std::string> rows_of_table(const std::string& text) {
    std::vector<std::string> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("| ") && !line.starts_with("| ---") && !line.starts_with("| ceiling"))
            rows.push_back(line);
    return rows;
}

}  // namespace

TEST_CASE("the page of ceilings is current") {
    std::vector<std::string> expected;
    for (const Limit& limit : limits)
        expected.push_back(fmt::format("| {} | {} |", number_text(limit.value), limit.meaning));
    CHECK(rows_of_table(text_of("/docs/limits.md")) == expected);
}

TEST_CASE("the list of ceilings is whole") {
    const std::string header = text_of("/src/scene/limits.h");
    std::size_t declared = 0;
    for (std::size_t at = 0; (at = header.find("inline constexpr Limit ", at)) != std::string::npos;
         ++at)
        ++declared;
    CHECK(declared == limits.size());
}
