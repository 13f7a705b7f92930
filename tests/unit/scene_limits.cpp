// docs/limits.md lists the ceilings as they are.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "scene/keys.h"
#include "scene/limits.h"

using namespace carom;

namespace {

std::string content(const std::string& path) {
    std::ifstream file(std::string{CAROM_TEST_ROOT} + path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> rows_of_table(const std::string& page) {
    std::vector<std::string> rows;
    std::istringstream lines(page);
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
    CHECK(rows_of_table(content("/docs/limits.md")) == expected);
}

TEST_CASE("the list of ceilings is whole") {
    const std::string header = content("/src/scene/limits.h");
    std::size_t declared = 0;
    for (std::size_t at = 0; (at = header.find("inline constexpr Limit ", at)) != std::string::npos;
         ++at)
        ++declared;
    CHECK(declared == limits.size());
}
