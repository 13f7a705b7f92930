// The films of the library, by what carom check says of them.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("disks of the library's films can be seen and followed") {
    std::vector<std::string> command{program, "check", "--json"};
    for (const auto& entry : fs::recursive_directory_iterator(root / "scenes"))
        if (entry.path().extension() == ".yaml" && entry.path().parent_path().filename() != "sets")
            command.push_back(entry.path().string());
    REQUIRE(command.size() > 45);
    const Outcome outcome = run(command);
    REQUIRE(outcome.exit_code == 0);
    int looked_at = 0;
    for (const json& scene : json::parse(outcome.out)) {
        const std::string file = scene.at("scene");
        CAPTURE(file);
        const std::string text = contents(file);
        // A time lapse says so; a streak joins the places of a disk in two frames.
        const bool may_jump = has(text, "Time lapse") || has(text, "streaks: true");
        for (const json& disk : scene.at("film").at("disks")) {
            CHECK(disk.at("pixels") > 11.95);
            if (!may_jump) CHECK(disk.at("diameters_a_frame") < 0.7);
            ++looked_at;
        }
    }
    CHECK(looked_at > 45);
}
