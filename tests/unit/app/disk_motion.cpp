// How far disks travel from frame to frame, and how wide they are.
#include "app/check/disk_motion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "films/cost/trial_run.h"
#include "panels/layout.h"
#include "panels/panel_set.h"
#include "physics/placement/draws.h"
#include "scene/scene.h"
#include "support/first_frame.h"
#include "support/pixels.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

std::vector<DiskMotion> motion_in(const Scene& scene) {
    const auto [particles, sample] = draw_gas(scene.gas);
    const PanelSet panels(scene, particles, sample);
    return disk_motion(scene, particles, counts_of(scene).speeds,
                       panels.scale(Grid(scene.film.layout, scene.film.size)));
}

Scene scene_of(const std::string& gas, const std::string& film, const std::string& until = "10") {
    return test::scene_from("title: T\nbox: {size: [40, 30]}\ngas: [" + gas +
                            "]\nrun: {until: " + until + "}\nfilm: {panels: [], " + film + "}\n");
}

std::string words_of(const Scene& scene) {
    std::string words;
    for (const Fact& row : motion_rows(scene, motion_in(scene)))
        words += row.label + ": " + row.words + "\n";
    return words;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// One disk that meets only walls.
const std::string alone = "{name: lonely, radius: 0.5, position: [20, 15], velocity: [3, 0]}";

}  // namespace

TEST_CASE("the way from frame to frame is the speed times the step, in diameters") {
    const Scene scene = scene_of(alone, "seconds: 10");
    const std::vector<DiskMotion> disks = motion_in(scene);
    REQUIRE(disks.size() == 1);
    CHECK(disks[0].species == "lonely");
    CHECK(disks[0].diameters == doctest::Approx(3.0 * 10.0 / moving_steps(scene.film, scene.run)));
}

TEST_CASE("disks that are drawn larger are as wide as they are drawn, and only these") {
    const auto look = [](const std::string& radius) {
        const Scene scene = scene_of(
            "{name: a, position: [20, 15], velocity: [0, 0], color: \"#3366cc\", radius: " +
                radius + "}",
            "seconds: 10, color_by: species, theme: light, size: [640, 360]");
        const auto pixels = test::pixels_of(test::FirstFrame(scene).view);
        return std::pair(motion_in(scene).at(0).pixels,
                         std::ranges::count_if(
                             pixels, [](auto pixel) { return (pixel & 0xFFFFFF) == 0x3366CC; }));
    };
    CHECK(look("0.01, drawn_radius: 2") == look("2"));
    CHECK(look("0.01, drawn_radius: 2").second > 100);
    CHECK(look("0.01").second < look("2").second / 2);
}

TEST_CASE("the fastest stage of a film counts") {
    const Scene scene = scene_of(alone, "seconds: 10, slow: [{from: 0, to: 5, factor: 0.1}]");
    const std::vector<Tick> ticks = timeline(scene);
    double longest = 0.0;
    for (std::size_t k = 1; k < ticks.size(); ++k)
        longest = std::max(longest, ticks[k].time - ticks[k - 1].time);
    const std::vector<DiskMotion> disks = motion_in(scene);
    CHECK(disks[0].diameters == doctest::Approx(3.0 * longest));
    CHECK(disks[0].time > 5.0);
}

TEST_CASE("speeds are those of the run, not of its start") {
    // A fast disk among many at rest, which soon has a fiftieth of the energy as all others.
    const Scene scene = scene_of(
        "{name: hot, radius: 0.6, position: [2, 2], velocity: [70, 30]}, "
        "{name: cold, count: 99, radius: 0.6, speed: 0}",
        "seconds: 10", "30");
    const std::vector<DiskMotion> disks = motion_in(scene);
    REQUIRE(disks.size() == 2);
    const double step = 30.0 / moving_steps(scene.film, scene.run);
    CHECK(disks[0].diameters == doctest::Approx(std::hypot(70.0, 30.0) * step / 1.2));
    CHECK(disks[0].time < 1.0);
    // In equilibrium the mean speed is sqrt(pi T / 2), with T = 5800 / 200; here the largest of
    // some moments, and without the energy of the hot disk.
    const double mean = std::sqrt(0.5 * std::numbers::pi * 29.0) * step / 1.2;
    CHECK(disks[1].diameters > 0.9 * mean);
    CHECK(disks[1].diameters < 1.25 * mean);
}

TEST_CASE("a disk's width is that of the picture") {
    const Scene scene = scene_of(alone, "seconds: 10, size: [1920, 1080], template: minimal");
    const auto [particles, sample] = draw_gas(scene.gas);
    const PanelSet panels(scene, particles, sample);
    const Grid grid(scene.film.layout, scene.film.size);
    const Rect box = panels.boxes(grid).front();
    const std::vector<DiskMotion> disks = motion_in(scene);
    CHECK(disks[0].pixels == doctest::Approx(box.width / 40.0).epsilon(0.01));
}

TEST_CASE("what moves too far is named with what helps, and what is too small") {
    const std::string hint = words_of(scene_of(alone, "seconds: 2"));
    CHECK(has(hint, "motion: "));
    CHECK(has(hint, "lonely "));
    CHECK(has(hint, "`streaks: true`"));
    CHECK(has(hint, "`fps: 60`"));
    CHECK(has(hint, "`seconds: "));
    CHECK_FALSE(has(hint, "small disks"));
    CHECK(words_of(scene_of(alone, "seconds: 30")).empty());
    CHECK(words_of(scene_of(alone, "seconds: 2, streaks: true")).empty());
    CHECK_FALSE(has(words_of(scene_of(alone, "seconds: 1, fps: 60")), "`fps: 60`"));

    const std::string small =
        "{name: dust, count: 30, radius: 0.1, speed: 0.1}, {name: rock, count: 1, radius: 1, "
        "speed: 0.1}";
    const std::string words = words_of(scene_of(small, "seconds: 10"));
    CHECK(has(words, "small disks: "));
    CHECK(has(words, "dust "));
    CHECK_FALSE(has(words, "rock"));
    // A picture of 540 lines is seen as large as one of 1080.
    CHECK(has(words_of(scene_of(small, "seconds: 10, size: [960, 540]")), "fewer than 6 "));
}

TEST_CASE("a film with the `seconds` that are named has the way of half a diameter") {
    const std::string words = words_of(scene_of(alone, "seconds: 2"));
    const std::string key = "`seconds: ";
    const std::size_t at = words.find(key) + key.size();
    const std::string seconds = words.substr(at, words.find('`', at) - at);
    const double way = motion_in(scene_of(alone, "seconds: " + seconds)).at(0).diameters;
    CHECK(way <= 0.5);
    CHECK(way > 0.3);
}

TEST_CASE("beads on a line have no diameters") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {length: 20}\ngas: [{count: 5, radius: 0.1, speed: 1}]\nrun: {until: "
        "5}\n");
    CHECK(disk_motion(scene, draw_gas(scene.gas).first, counts_of(scene).speeds, 1.0).empty());
}
