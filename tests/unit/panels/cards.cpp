// The cards before and after a film, as they are drawn.
#include "panels/callouts/cards.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "draw/formula/words.h"
#include "draw/text.h"
#include "panels/layout.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::pixels_of;
using test::Shot;

namespace {

std::string scene_text(const std::string& film, const std::string& title = "title: T") {
    return title +
           "\nbox: {size: [40, 30]}\ngas: [{count: 40, radius: 0.5, speed: 1}]\nrun: {until: 4}\n"
           "film: {" +
           film + "}\n";
}

int bright(std::uint32_t pixel) { return static_cast<int>(pixel >> 8 & 0xFF); }

double apart(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(bright(a[i]) - bright(b[i]));
    return sum / double(a.size());
}

std::set<std::string> words_in(const std::string& text) {
    std::set<std::string> all;
    std::istringstream rest(text);
    for (std::string word; rest >> word;) all.insert(escape_markup(word));
    return all;
}

std::vector<DrawnLine> painted(FramePainter& painter, const FrameData& frame) {
    const TextLog log;
    painter.paint(frame);
    return log.lines;
}

// Of the lines that a frame draws those of a text: whole lines of it, or its single words.
std::vector<DrawnLine> lines_of(const std::string& text, const std::vector<DrawnLine>& drawn) {
    const std::set<std::string> words = words_in(text);
    std::vector<DrawnLine> lines;
    for (const DrawnLine& line : drawn) {
        const std::set<std::string> its = words_in(line.markup);
        if (!its.empty() && std::ranges::includes(words, its)) lines.push_back(line);
    }
    return lines;
}

Rect around(const std::vector<DrawnLine>& lines) {
    double left = 1e9, top = 1e9, right = 0.0, bottom = 0.0;
    for (const DrawnLine& line : lines) {
        left = std::min(left, line.ink.x);
        top = std::min(top, line.ink.y);
        right = std::max(right, line.ink.right());
        bottom = std::max(bottom, line.ink.bottom());
    }
    return {left, top, right - left, bottom - top};
}

bool cross(const Rect& a, const Rect& b) {
    constexpr double touch = 1.0;
    return a.x + touch < b.right() && b.x + touch < a.right() && a.y + touch < b.bottom() &&
           b.y + touch < a.bottom();
}

}  // namespace

TEST_CASE("a title card stands before the first frame, which appears while the title goes there") {
    const std::string rest = "seconds: 30, fps: 20, size: [320, 180], panels: [speed-histogram]";
    const Shot film(test::scene_from(scene_text(rest + ", title_card: true, end_card: The end")));
    const Shot plain(test::scene_from(
        scene_text("seconds: 23, fps: 20, size: [320, 180], panels: [speed-histogram]")));
    FramePainter painter(*film.panels), other(*plain.panels);
    const auto gas = pixels_of(other.paint(plain.frames.front()));
    const auto frame = [&](std::size_t i) { return pixels_of(painter.paint(film.frames[i])); };
    const auto card = frame(0);
    CHECK(frame(43) == card);  // it moves in the last 0.8 s, of three
    const double far = apart(card, gas);
    double last = far;
    for (std::size_t i = 44; i < 60; ++i) {
        CHECK(film.frames[i].tick.phase == Phase::title_card);
        const double now = apart(frame(i), gas);
        CHECK(std::abs(now - last) < 0.3 * far);
        last = now;
    }
    CHECK(last < 0.1 * far);
    CHECK(frame(60) == gas);

    // Of the first frame an eighth is seen behind the words: where disks are, and not on the page.
    const int page = bright(gas.front());
    int seen = 0;
    for (std::size_t i = 0; i < card.size(); ++i) {
        const int disk = bright(gas[i]) - page, behind = bright(card[i]) - page;
        if (i / 320 < 120 || disk < 60 || behind > 40) continue;  // below the words
        CHECK(std::abs(behind - 0.12 * disk) < 2.0);
        ++seen;
    }
    CHECK(seen > 50);
}

TEST_CASE("an end card stands over the gas alone, which is seen at 30 %") {
    const std::string rest = ", seconds: 30, fps: 10, size: [640, 360], end_card: The end";
    const Shot film(
        test::scene_from(scene_text("template: lecture, panels: [temperature]" + rest)));
    FramePainter painter(*film.panels);
    const auto card = pixels_of(painter.paint(film.frames.back()));
    std::size_t before = film.frames.size() - 1;
    while (card_cover(film.scene.film, film.frames[before].tick) > 0.0) --before;
    const auto gas = pixels_of(painter.paint(film.frames[before]));
    const Grid grid(film.scene.film.layout, film.scene.film.size);
    const Rect box = film.panels->boxes(grid).front();
    const int page = bright(gas.front());
    int seen = 0;
    for (int y = 0; y < 360; ++y)
        for (int x = 0; x < 640; ++x) {
            const auto i = static_cast<std::size_t>(y * 640 + x);
            if (y > 140 && y < 220) continue;  // words
            const bool is_in =
                x > box.x + 1 && x < box.right() - 1 && y > box.y + 1 && y < box.bottom() - 1;
            const bool is_out =
                x < box.x - 1 || x > box.right() + 1 || y < box.y - 1 || y > box.bottom() + 1;
            if (is_out) CHECK(std::abs(bright(card[i]) - page) <= 1);
            if (!is_in) continue;
            CHECK(std::abs(bright(card[i]) - page - 0.3 * (bright(gas[i]) - page)) < 3.0);
            seen += bright(gas[i]) - page > 60;
        }
    CHECK(seen > 100);
}

TEST_CASE("a panel over the gas gives way to an end card without a jump") {
    const std::string rest = ", seconds: 12, fps: 20, size: [640, 360], end_card: The end";
    const Shot film(
        test::scene_from(scene_text("template: hero, panels: [speed-histogram]" + rest)));
    const Shot bare(test::scene_from(scene_text(
        "template: hero, panels: [{kind: speed-histogram, show: {until: 0.1}}]" + rest)));
    FramePainter painter(*film.panels), other(*bare.panels);
    CHECK(apart(pixels_of(painter.paint(film.frames.back())),
                pixels_of(other.paint(bare.frames.back()))) < 0.01);
    std::size_t first = 0;
    while (film.frames[first].tick.phase != Phase::end_card) ++first;
    auto last = pixels_of(painter.paint(film.frames[first - 11]));
    const double all = apart(last, pixels_of(painter.paint(film.frames[first])));
    for (std::size_t i = first - 10; i <= first; ++i) {
        const auto now = pixels_of(painter.paint(film.frames[i]));
        CHECK(apart(last, now) < 0.35 * all);
        last = now;
    }
}

TEST_CASE("title and subtitle go from the card to the places where the film shows them") {
    struct Case {
        std::string film;
        double letters;  // the size of the title on the card; design: 88, 1.35 times that on phones
    };
    const std::string beside =
        ", beside: {own_label: cold, label: hot, set: gas.0.speed=2}, panels: [temperature]";
    const std::vector<Case> cases{{"template: lecture", 88.0},
                                  {"template: hero, panels: [speed-histogram]", 88.0},
                                  {"template: data", 88.0},
                                  {"template: side-by-side" + beside, 88.0},
                                  {"template: wide-gas", 88.0},
                                  {"template: minimal", 88.0},
                                  {"template: square", 88.0},
                                  {"template: portrait", 117.0},
                                  {"template: lecture, size: [1080, 1920]", 49.0}};
    const std::vector<std::string> titles{
        "Zinc", "Quiet zebras exchange stripes, not hooves or manes",
        "A very lengthy sentence telling everything worth knowing before anybody sees it happen"};
    const std::string subtitle = "Whichever begins fastest finally becomes ordinary";
    for (const Case& one : cases)
        for (const std::string& title : titles) {
            CAPTURE(one.film);
            CAPTURE(title);
            const Shot film(
                test::scene_from(scene_text(one.film + ", seconds: 9, fps: 30, title_card: 1.5",
                                            "title: " + title + "\nsubtitle: " + subtitle)),
                47);
            FramePainter painter(*film.panels);
            REQUIRE(film.frames[44].tick.phase == Phase::title_card);
            REQUIRE(film.frames[45].tick.phase == Phase::opening);
            const auto [width, height] = film.scene.film.size;
            const std::vector<DrawnLine> card = painted(painter, film.frames[0]);
            const std::vector<DrawnLine> first = lines_of(title, card);
            const Rect at_first = around(first);
            CHECK(std::abs(at_first.x - 160.0 / 1920.0 * width) < 0.1 * first.front().size);
            CHECK(at_first.right() < (1.0 - 150.0 / 1920.0) * width);
            if (title.size() < 60) {
                CHECK(first.front().size == doctest::Approx(one.letters).epsilon(0.02));
                const double top = first.back().ink.y - 440.0 / 1080.0 * height;
                CHECK(top > 0.0);  // of letters in a line that begins there
                CHECK(top < 0.45 * first.front().size);
            }
            const Rect sub = around(lines_of(subtitle, card));
            CHECK(sub.y > at_first.bottom());
            CHECK(sub.x == doctest::Approx(at_first.x).epsilon(0.1));
            for (std::size_t i = 21; i <= 44; ++i) {
                CAPTURE(i);
                const std::vector<DrawnLine> drawn = painted(painter, film.frames[i]);
                std::vector<DrawnLine> words = lines_of(title, drawn);
                const std::size_t of_title = words.size();
                for (const DrawnLine& line : lines_of(subtitle, drawn)) words.push_back(line);
                for (std::size_t a = 0; a < words.size(); ++a)
                    for (std::size_t b = 0; b < a; ++b) {
                        const bool is_of_one = (a < of_title) == (b < of_title);
                        CHECK_FALSE((is_of_one && cross(words[a].ink, words[b].ink)));
                    }
            }
            // Each step is no longer than the one before it, and the last one ends in the frame.
            FramePainter fresh(*film.panels);  // whose ground is not drawn yet
            const std::vector<DrawnLine> at_43 = painted(painter, film.frames[43]),
                                         at_44 = painted(painter, film.frames[44]),
                                         at_45 = painted(fresh, film.frames[45]);
            const auto lands = [&](const std::string& text) {
                const Rect before = around(lines_of(text, at_43));
                const Rect last = around(lines_of(text, at_44));
                const Rect there = around(lines_of(text, at_45));
                const auto step = [&](double Rect::*edge) {
                    constexpr double pixel = 1.0;  // to which words are set
                    CHECK(std::abs(there.*edge - last.*edge) <=
                          std::abs(last.*edge - before.*edge) + 1.5 * pixel);
                };
                step(&Rect::x);
                step(&Rect::y);
                step(&Rect::width);
                step(&Rect::height);
            };
            lands(title);
            if (subtitle_showing(film.scene)) lands(subtitle);
        }
}

TEST_CASE("words on cards are balanced, and are never cut where they fit in smaller letters") {
    const TextStyle style{.size = 88, .weight = 600, .max_width = 1600};
    for (const std::string words :
         {"Light and heavy disks share energy, not speed", "One word more than a single line holds",
          "A very long title that takes three lines or even more, since it tells the whole "
          "story",
          "Every disk has $\\frac12 mv^2 = kT$ in the end, whatever its mass is"}) {
        CAPTURE(words);
        const std::vector<std::string> lines = balanced(words, style, 8);
        CHECK(lines.size() == wrapped_words(words, style, 8).size());
        if (lines.size() > 1) CHECK(lines.back().find(' ') != std::string::npos);
        double longest = 0.0, shortest = 1e9;
        for (const std::string& line : lines) {
            const double width = measure_words(line, {.size = 88, .weight = 600}).width;
            CHECK(width <= 1600.0);
            longest = std::max(longest, width);
            shortest = std::min(shortest, width);
        }
        CHECK(shortest > 0.5 * longest);
    }
    for (const std::string size : {"[1920, 1080]", "[1080, 1920]", "[1080, 1080]", "[480, 270]"})
        for (const std::string end :
             {"A last sentence of some length that says with a number what was seen: 3.14",
              "With a formula, too: $\\langle v^2\\rangle = \\frac{2kT}{m}$, which is long "
              "enough for several lines of words"}) {
            CAPTURE(size);
            CAPTURE(end);
            const Shot film(test::scene_from(scene_text("seconds: 10, size: " + size +
                                                        ", title_card: true, panels: [], "
                                                        "end_card: '" +
                                                        end + "'")),
                            1);
            for (const std::string& what : FramePainter(*film.panels).cut_words()) {
                CAPTURE(what);
                CHECK(what.find("card") == std::string::npos);
            }
        }
}

TEST_CASE("a title or subtitle with dollar signs is no formula") {
    const Shot film(test::scene_from(scene_text("seconds: 9, fps: 10, title_card: true",
                                                "title: A gas for $5 or $6\nsubtitle: Not $7")));
    FramePainter painter(*film.panels);
    CHECK(lines_of("A gas for $5 or $6", painted(painter, film.frames[0])).size() == 1);
    CHECK(lines_of("Not $7", painted(painter, film.frames[0])).size() == 1);
    CHECK(lines_of("Not $7", painted(painter, film.frames[31])).size() == 1);
}
