// The states in docs/portability.md, which every machine must reach.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

using namespace carom::test;

TEST_CASE("runs end in the states of docs/portability.md, bit for bit") {
    const std::string page = contents(root / "docs/portability.md");
    static const std::regex row(R"(\]\(\.\./(scenes/[^)]*)\) \| `([0-9a-f]{32})`)");
    int rows = 0;
    for (std::sregex_iterator found(page.begin(), page.end(), row), end; found != end; ++found) {
        const std::string scene = (*found)[1];
        CAPTURE(scene);
        const Outcome outcome =
            run({program, "run", (root / scene).string(), "--json", "-", "--quiet"});
        REQUIRE(outcome.exit_code == 0);
        CHECK(nlohmann::json::parse(outcome.out)["state"] == (*found)[2].str());
        ++rows;
    }
    CHECK(rows >= 12);
}
