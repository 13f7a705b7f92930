// What a film with a reversal says of time and of the return, and when.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draw/text.h"
#include "panels/frame.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

constexpr double turn_at = 4.0;

// Words that a frame draws, whatever was drawn before.
std::vector<std::string> words_at(const test::Shot& film, std::size_t frame) {
    FramePainter painter(*film.panels);
    const TextLog log;
    painter.paint(film.frames[frame]);
    std::vector<std::string> words;
    for (const DrawnLine& line : log.lines) words.push_back(line.markup);
    return words;
}

bool has_words(const std::vector<std::string>& all, const std::string& part) {
    return std::ranges::any_of(
        all, [&](const std::string& words) { return words.find(part) != std::string::npos; });
}

std::string reversed_scene(double until, const std::string& film) {
    return "title: T\nbox: {size: [40, 30]}\ngas: [{count: 12, radius: 0.5, speed: 1}]\n"
           "run: {until: " +
           std::to_string(until) +
           ", events: [{at: 4, reverse: velocities}]}\n"
           "film: {fps: 5, size: [640, 360], " +
           film + "}\n";
}

}  // namespace

TEST_CASE("the clock counts up to a reversal and back to zero, and the first time again is zero") {
    const test::Shot film(test::scene_from(reversed_scene(8, "seconds: 12, panels: []")));
    double largest = 0.0, last = 0.0;
    for (std::size_t i = 0; i < film.frames.size(); ++i) {
        double shown = -1.0;
        for (const std::string& words : words_at(film, i))
            if (words.starts_with("t = ")) shown = std::stod(words.substr(4));
        if (film.frames[i].tick.phase != Phase::moving) continue;  // numbers wait for 1/5 s at most
        CHECK(std::abs(shown - (turn_at - std::abs(film.frames[i].tick.time - turn_at))) < 0.011);
        largest = std::max(largest, shown);
        last = shown;
    }
    CHECK(largest == turn_at);
    CHECK(last == 0.0);
}

TEST_CASE("the return error and its name are shown from the reversal to the start, and not else") {
    for (const std::string film :
         {"template: lecture, monitors: [return-distance], panels: []",
          "template: lecture, monitors: [collisions, return-distance], panels: []",
          "template: lecture, monitors: [return-distance, collisions], panels: []",
          "template: lecture, panels: [{kind: monitors, numbers: [return-distance, mean-speed]}]",
          "template: wide-gas, monitors: [return-distance, mean-energy], panels: [], "
          "beside: {set: seed=9, own_label: a, label: b}"}) {
        CAPTURE(film);
        const test::Shot shot(test::scene_from(reversed_scene(12, "seconds: 14, " + film)));
        int before = 0, during = 0, after = 0;
        for (std::size_t i = 0; i < shot.frames.size(); ++i) {
            const Tick& tick = shot.frames[i].tick;
            const std::vector<std::string> words = words_at(shot, i);
            CAPTURE(tick.time);
            CHECK_FALSE(has_words(words, "–"));
            if (tick.time < turn_at) {
                CHECK_FALSE(has_words(words, "return error"));
                ++before;
            } else if (tick.time > turn_at + 0.5 && tick.time < 2.0 * turn_at - 0.5) {
                CHECK(has_words(words, "return error"));
                CHECK(has_words(words, "×10⁻"));
                ++during;
            } else if (tick.time > 2.0 * turn_at + 0.5) {
                CHECK_FALSE(has_words(words, "return error"));
                ++after;
            }
        }
        CHECK(before > 5);
        CHECK(during > 5);
        CHECK(after > 5);
    }
}
