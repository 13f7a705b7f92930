// The pictures of panels in docs/panels/, which the page of the scene language shows.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "support/files.h"
#include "support/process.h"
#include "support/test_root.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string program = CAROM_PROGRAM;
const fs::path panels = checkout() / "docs/panels";

// Width and height of a PNG.
std::array<std::uint32_t, 2> size_of(const std::string& png) {
    const auto number = [&](std::size_t place) {
        std::uint32_t value = 0;
        for (std::size_t i = place; i < place + 4; ++i)
            value = value << 8U | static_cast<unsigned char>(png.at(i));
        return value;
    };
    return {number(16), number(20)};
}

// What carom says of the pictures, whatever its version.
nlohmann::json captions_in(const fs::path& folder) {
    auto captions = nlohmann::json::parse(contents(folder / "captions.json"));
    captions.erase("carom");
    return captions;
}

}  // namespace

// The captions have numbers of collisions and measured values: what the simulations give.
TEST_CASE("the pictures of panels are those of their scenes") {
    const TemporaryFolder folder;
    const Outcome drawn = run({program, "figures", (panels / "panels.yaml").string(), "-o",
                               folder.path().string(), "--formats", "png", "--quiet"});
    REQUIRE(drawn.exit_code == 0);
    INFO("make them anew with ./dev docs");
    const nlohmann::json captions = captions_in(panels);
    CHECK(captions == captions_in(folder.path()));
    for (const auto& figure : captions.at("figures")) {
        const std::string name = figure.at("files").at(0);
        CAPTURE(name);
        const auto [width, height] = size_of(contents(panels / name));
        const auto [its_width, its_height] = size_of(contents(folder.path() / name));
        CHECK(width == 840);
        CHECK(height == doctest::Approx(840.0 * its_height / its_width).epsilon(0.005));
    }
}

TEST_CASE("the folder of panels has a small picture for each scene, and nothing else") {
    std::set<std::string> expected{"panels.yaml", "captions.json"}, found;
    const nlohmann::json captions = captions_in(panels);
    for (const auto& figure : captions.at("figures"))
        for (const char* ending : {".yaml", ".png"})
            expected.insert(figure.at("name").get<std::string>() + ending);
    std::uintmax_t all = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(panels)) {
        found.insert(entry.path().filename().string());
        CAPTURE(entry.path());
        CHECK(entry.file_size() < 40000);
        all += entry.file_size();
    }
    CHECK(found == expected);
    CHECK(all < 1200000);
}
