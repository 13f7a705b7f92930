// carom check --accessible: what keeps viewers from a film is named with its criterion, and
// mended as the hint says it is gone.
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

namespace {

std::string scene(const std::string& gas, const std::string& film,
                  const std::string& description = "What there is to see.") {
    return "title: T\n" + (description.empty() ? "" : "description: " + description + "\n") +
           "box: {size: [40, 30]}\ngas:\n" + gas + "run: {until: 10}\nfilm: {" + film + "}\n";
}

const std::string two = "  - {name: a, count: 9}\n  - {name: b, count: 9";

Outcome checked(const std::string& text, const std::vector<std::string>& options = {}) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", text);
    std::vector<std::string> command{program, "check", "scene.yaml", "--accessible"};
    command.insert(command.end(), options.begin(), options.end());
    return run(command, folder.path());
}

bool is_accessible(const std::string& text, const std::vector<std::string>& options = {}) {
    const Outcome outcome = checked(text, options);
    CAPTURE(outcome.err);
    CHECK((outcome.exit_code == 0 || outcome.exit_code == 2));
    return outcome.exit_code == 0 && outcome.err.empty();
}

// Whether the first barrier is this one, and the exit code says so.
bool refuses(const std::string& criterion, const std::string& text,
             const std::vector<std::string>& options = {}) {
    const Outcome outcome = checked(text, options);
    CAPTURE(outcome.err);
    return outcome.exit_code == 2 && has(outcome.err, "error: WCAG " + criterion);
}

}  // namespace

TEST_CASE("carom check --accessible names each barrier, and none where there is none") {
    const std::string one = "  - {count: 9}\n", film = "seconds: 10";
    CHECK(is_accessible(scene(one, film)));
    CHECK(refuses("1.1.1", scene(one, film, "")));
    CHECK(refuses("1.4.1", scene(two + "}\n", film + ", color_by: species")));
    CHECK(is_accessible(scene(two + "}\n", film)));  // by speed: nothing tells them apart
    CHECK(refuses("1.4.3", scene(one, film + ", ground: none"), {"--format", "webm"}));
    CHECK(refuses("1.4.4", scene(one, film + ", size: [640, 360]")));
    CHECK(is_accessible(scene(one, film + ", size: [960, 540]")));
    CHECK(refuses("2.2.2", scene(one, film + ", fps: 25"), {"--format", "gif"}));
    CHECK(is_accessible(scene(one, "seconds: 5, fps: 25"), {"--format", "gif"}));
    CHECK(is_accessible(scene(one, film), {"--format", "mp4"}));
}

TEST_CASE("species may differ in more than colour: rings, size, trails, numbers on single disks") {
    const std::string by_species = "seconds: 10, color_by: species";
    const auto told = [&](const std::string& gas, const std::string& film = "") {
        return is_accessible(scene(gas, by_species + film));
    };
    const auto by_color = [&](const std::string& gas, const std::string& film = "") {
        return refuses("1.4.1", scene(gas, by_species + film));
    };
    CHECK(told(two + ", fill: false}\n"));
    CHECK(told(two + ", radius: 0.7}\n"));
    const auto colored = [](const std::string& other) {
        return "  - {name: a, count: 9, color: red}\n  - {name: b, count: 9, color: " + other +
               "}\n";
    };
    CHECK(told(colored("red")));  // they are not told apart at all
    CHECK(by_color(colored("blue")));
    CHECK(told(two + ", trail: 1}\n"));
    CHECK(told(two + "}\n", ", theme: print"));
    CHECK(told(two + "}\n", ", trails: {of: [b], seconds: 1}"));
    CHECK(by_color(two + ", label: b}\n"));  // words stand beside single particles only
    CHECK(by_color(two + "}\n", ", trails: {of: [a, b], seconds: 1}"));
    CHECK(by_color(two + "}\n", ", labels: index"));
    // A colour of their own tells them apart whatever the other colours mean.
    CHECK(refuses("1.4.1", scene(two + ", color: red}\n", "seconds: 10")));

    // Disks of a pixel are dots, as rings too.
    const std::string dots =
        "  - {name: a, count: 9, radius: 0.03}\n  - {name: b, count: 9, radius: 0.03, fill: "
        "false}\n";
    CHECK(by_color(dots));

    const auto single = [](const std::string& radius) {
        return "  - {name: a, radius: " + radius +
               ", mass: 2, position: [9, 9]}\n  - {name: b, radius: " + radius +
               ", position: [20, 20]}\n";
    };
    CHECK(by_color(single("2")));
    CHECK(told(single("2"), ", labels: index"));
    CHECK(told(single("2"), ", labels: mass"));
    CHECK(by_color(single("0.2"), ", labels: index"));                   // no room for a number
    CHECK(told("  - {name: a, count: 20}\n  - {name: b, count: 1}\n"));  // has a trail by itself
}

TEST_CASE("every scene and set that comes with carom is accessible") {
    std::vector<std::string> command{program, "check", "--accessible", "--json"};
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "scenes"))
        if (entry.path().extension() == ".yaml") command.push_back(entry.path().string());
    CHECK(command.size() > 50);
    const Outcome outcome = run(command);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    for (const json& file : json::parse(outcome.out)) {
        CAPTURE(file.dump());
        CHECK(file["barriers"].empty());
    }
}

// 459 disks of radius 0.5 cover 0.3 of the box and come past a place 0.38 times while they fly one
// unit of length; in 10 seconds of film with 8.6 of motion these are 8.6 units at speed 1.
TEST_CASE("fast and dense gases are refused as flashing, slow or dilute ones are not") {
    const auto gas = [](const char* count, const char* speed) {
        return std::string("  - {count: ") + count + ", speed: " + speed + "}\n";
    };
    CHECK(is_accessible(scene(gas("459", "1"), "seconds: 10")));
    CHECK(refuses("2.3.1", scene(gas("459", "10"), "seconds: 10")));
    CHECK(is_accessible(scene(gas("459", "10"), "seconds: 60")));
    CHECK(is_accessible(scene(gas("300", "10"), "seconds: 10")));
}

// Spheres: fast ones before the ground flash; where they fill the view, hardly a place of the
// ground is seen, and slow ones pass less often. 4800 of radius 0.5 cover 4.7 of a box of 40 by 20,
// 480 of them 0.47: a place is bright some 0.29 times while they fly one unit of length.
TEST_CASE("fast spheres are refused as flashing where the ground is seen between them") {
    const auto gas = [](const char* count, const char* speed) {
        return std::string(
                   "title: T\ndescription: D\nbox: {size: [40, 20, 40]}\ngas:\n  - {count: ") +
               count + ", radius: 0.5, speed: " + speed +
               "}\nrun: {until: 10}\nfilm: {seconds: 10, size: [1280, 720]}\n";
    };
    CHECK(refuses("2.3.1", gas("480", "20")));
    CHECK(is_accessible(gas("480", "5")));
    CHECK(is_accessible(gas("4800", "20")));
}

TEST_CASE("barriers stand in the JSON document, each with its hint") {
    const Outcome outcome =
        checked(scene("  - {count: 9}\n", "seconds: 10, size: [640, 360]"), {"--json"});
    CHECK(outcome.exit_code == 2);
    CHECK(has(outcome.err, "1 barrier"));
    const json found = json::parse(outcome.out)[0];
    CHECK(found["valid"] == true);
    CHECK(found["errors"].empty());
    REQUIRE(found["barriers"].size() == 1);
    CHECK(has(found["barriers"][0]["message"], "WCAG 1.4.4"));
    CHECK(has(found["barriers"][0]["hint"], "1.2 times as large"));
}

TEST_CASE("what a scene is made from has one name, and another when a part of it changes") {
    const auto name = [](const std::string& text, const std::vector<std::string>& options = {}) {
        std::vector<std::string> all{"--json"};
        all.insert(all.end(), options.begin(), options.end());
        return json::parse(checked(text, all).out)[0]["made_from"].get<std::string>();
    };
    const std::string text = scene("  - {count: 9}\n", "seconds: 10");
    CHECK(name(text) == name(text));
    CHECK(name(text) != name(text + "# more\n"));
    CHECK(name(text) != name(text, {"--set", "gas.0.count=8"}));
    CHECK(name(text) != name(text, {"--template", "data"}));
}
