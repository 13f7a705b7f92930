// The scenes that the manual shows are valid: whole ones as they stand, parts of one beside the
// smallest sections that they leave out.
#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "support/files.h"
#include "support/scene_text.h"
#include "support/test_root.h"

using namespace carom;

namespace {

// The blocks of a document between ```yaml and ```.
std::vector<std::string> yaml_blocks(const std::string& document) {
    const std::string text = test::contents(carom::test::checkout() / document);
    const std::string open = "```yaml\n";
    std::vector<std::string> blocks;
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        at += open.size();
        blocks.push_back(text.substr(at, text.find("```", at) - at));
    }
    return blocks;
}

std::string completed(const std::string& part) {
    static const std::array<std::pair<std::string, std::string>, 4> sections{
        {{"title", "\"A gas\""},
         {"box", "{size: [64, 48]}"},
         {"gas", "[{count: 50, speed: 1}]"},
         {"run", "{until: 30}"}}};
    std::string whole;
    for (const auto& [key, value] : sections)
        if (("\n" + part).find("\n" + key + ":") == std::string::npos)
            whole.append(key).append(": ").append(value).append("\n");
    return whole + part;
}

}  // namespace

TEST_CASE("the scenes of README.md, docs/films.md and docs/walls.md are valid") {
    const std::vector<std::string> first = yaml_blocks("README.md");
    REQUIRE(first.size() == 1);
    CHECK_NOTHROW(test::scene_from(first.front()));
    for (const char* page : {"docs/films.md", "docs/walls.md"}) {
        const std::vector<std::string> parts = yaml_blocks(page);
        REQUIRE(parts.size() >= 5);
        for (const std::string& part : parts) {
            CAPTURE(part);
            CHECK_NOTHROW(test::scene_from(completed(part)));
        }
    }
}
