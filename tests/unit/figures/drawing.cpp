// Figures: what they show, how large they are, and that they are the same every time.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draw/text.h"
#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "panels/plots/histogram_panel.h"
#include "physics/mechanics.h"
#include "support/figure_run.h"
#include "support/scene_text.h"
#include "util/text.h"

using namespace carom;
using test::run_of;

namespace {

constexpr std::optional<VectorFormat> pixels{};

Scene scene_of(const std::string& figures) {
    return test::scene_from(
        "title: Ten disks\nbox: {size: [40, 30]}\n"
        "gas: [{count: 10, radius: 1, speed: 2}]\nrun: {until: 10}\nfilm: {seconds: 2}\n"
        "figures:\n" +
        figures);
}

Canvas drawn(const FigureRun& run, std::size_t index, std::optional<VectorFormat> format = {}) {
    return draw_figure(run, run.figures()[index], format, {"title", "words"});
}

// How much of the vertical axis the tallest bar of each figure takes.
std::vector<double> shares_of_height(const std::string& scene) {
    const FigureRun run = run_of(test::scene_from(scene));
    std::vector<double> shares;
    for (const Figure& figure : run.figures()) {
        const auto& panel = dynamic_cast<const HistogramPanel&>(*figure.panel);
        double tallest = 0.0;
        for (const MeanHistogram& bars : HistogramPanel::histograms(*figure.moments.back().state))
            tallest = std::max(tallest, std::ranges::max(bars.counts));
        shares.push_back(tallest / panel.tallest());
    }
    return shares;
}

}  // namespace

TEST_CASE("a style gives figures the size of their text") {
    FigureSpec figure;
    CHECK(smallest_type(figure) == 6.9);
    Style style;
    style.film_text = 1.25;
    style.figure_text = 9.2;
    figure.style = std::make_shared<const Style>(style);
    CHECK(smallest_type(figure) == 9.2);
    figure.slide = true;
    CHECK(smallest_type(figure) == 30.0);
}

TEST_CASE("a figure has the width of a column, a page or a slide, and type to match") {
    const Scene scene = scene_of(
        "  - {name: a, kind: speed-histogram}\n  - {name: b, kind: gas, size: page}\n"
        "  - {name: c, kind: gas, size: slide}\n  - {name: d, kind: entropy, size: [10, 5]}\n");
    const FigureRun run = run_of(scene);
    const auto centimetres = [](int pixels, double dots) { return pixels / dots * 2.54; };
    // Whole pixels: half of one is 0.04 mm in PNG, 0.13 mm in vector pictures.
    CHECK(std::abs(centimetres(drawn(run, 0).size().width, 300) - 8.9) < 0.005);
    CHECK(std::abs(centimetres(drawn(run, 0, VectorFormat::svg).size().width, 96) - 8.9) < 0.014);
    CHECK(std::abs(centimetres(drawn(run, 1, VectorFormat::pdf).size().width, 96) - 18.3) < 0.014);
    const Canvas slide = drawn(run, 2);
    CHECK(slide.size().width == 1920);
    CHECK(slide.size().height == 1080);
    const PixelSize own = drawn(run, 3).size();
    CHECK(std::abs(centimetres(own.width, 300) - 10.0) < 0.005);
    CHECK(std::abs(centimetres(own.height, 300) - 5.0) < 0.005);
    // Type of 6 to 8 points in print, at least 24 on slides; titles are 1.15 times the smallest.
    CHECK(smallest_type(scene.figures[0]) >= 6.0);
    CHECK(1.15 * smallest_type(scene.figures[0]) <= 8.0);
    CHECK(smallest_type(scene.figures[2]) >= 24.0);
}

TEST_CASE("a figure with a width alone is as high as its content") {
    const Scene scene =
        scene_of("  - {name: a, kind: gas, size: 8}\n  - {name: b, kind: gas, size: [8, 6]}\n");
    const FigureRun run = run_of(scene);
    const PixelSize own = drawn(run, 0).size();
    CHECK(std::abs(own.width / 300.0 * 2.54 - 8.0) < 0.005);
    CHECK(drawn(run, 1).size().height == std::lround(6.0 / 2.54 * 300));
    // The picture of a box of half the height is half as high; margins stay.
    Scene wide = scene;
    wide.gas.box.size = {80, 30};
    const PixelSize lower = drawn(run_of(wide), 0).size();
    CHECK(lower.width == own.width);
    const double margins = 2.0 * lower.height - own.height;
    CHECK(margins > 0.0);
    CHECK(margins < 0.2 * own.height);
}

TEST_CASE("no figure of a text is higher than its page") {
    Scene scene = scene_of("  - {name: a, kind: gas, size: page}\n");
    scene.gas.box.size = {40, 400};
    const FigureRun run = run_of(scene);
    CHECK(drawn(run, 0).size().height <= std::lround(17.0 / 2.54 * 300));
}

TEST_CASE("a figure shows the gas at its very time, whatever frames the film has") {
    const Scene scene = scene_of(
        "  - {name: a, kind: gas, at: 3.14159}\n  - {name: b, kind: gas, strip: [0, 1.5, 10]}\n"
        "  - {name: c, kind: speed-histogram, over: [2, 5.25]}\n  - {name: d, kind: entropy}\n");
    const FigureRun run = run_of(scene);
    Simulation simulation(scene.gas, scene.run);
    const auto times = [&](std::size_t index) {
        std::vector<double> all;
        for (const FigureMoment& moment : run.figures()[index].moments) all.push_back(moment.time);
        return all;
    };
    CHECK(times(0) == std::vector<double>{3.14159});
    CHECK(times(1) == std::vector<double>{0.0, 1.5, 10.0});
    CHECK(times(2) == std::vector<double>{5.25});
    CHECK(times(3) == std::vector<double>{10.0});
    CHECK(run.figures()[0].moments[0].collisions.particle ==
          simulation.advance_to(3.14159).counts.particle);
    CHECK(scene.figures[2].panel.over->window == 3.25);
}

// The third figure is of a collision that does not happen, which its own measurement finds.
TEST_CASE("what is not asked for is not measured, and does not change what is") {
    const std::string two =
        "title: T\nbox: {size: [40, 30]}\ngas: [{name: a, count: 30, radius: 1, speed: 2}, "
        "{name: b, count: 2, radius: 1, velocity: [0, 0], position: [[1.1, 1.1], [38.9, 28.9]]}]\n"
        "run: {until: 2}\nfilm: {seconds: 2}\nfigures:\n"
        "  - {name: speeds, kind: speed-histogram, at: 1.23}\n  - {name: gas, kind: gas, at: "
        "0.7}\n";
    const Scene scene =
        test::scene_from(two + "  - {name: pair, kind: single-collision, of: [30, 31]}\n");
    CHECK_THROWS_AS(run_of(scene), SceneError);
    const FigureRun one(scene, 1, {}, {"speeds"});
    REQUIRE(one.figures().size() == 1);
    CHECK(one.figures()[0].spec->name == "speeds");
    const FigureRun all(test::scene_from(two));
    CHECK(drawn(one, 0).file() == drawn(all, 0).file());
}

TEST_CASE("`over` of a figure is an interval, or as a panel has it") {
    const auto picture = [](const std::string& keys) {
        return drawn(run_of(scene_of("  - {name: a, kind: speed-histogram, " + keys + "}\n")), 0)
            .file();
    };
    CHECK(picture("over: [2, 5.25]") == picture("at: 5.25, over: {window: 3.25}"));
    CHECK(picture("at: 6") == picture("at: 6, over: now"));
    CHECK(picture("at: 6, over: start") != picture("at: 6"));
    CHECK(picture("over: [2, 6]") != picture("at: 6"));
}

TEST_CASE("the vertical axis of a mean over an interval is that of its own bars") {
    const std::string figure = "  - {kind: speed-histogram, theory: false, ";
    for (const std::string& scene :
         {// All begin with the same speed, in one bar.
          "title: A gas\nbox: {size: [40, 30]}\ngas: [{count: 200, radius: 0.5, speed: 2}]\n"
          "run: {until: 12}\nfilm: {seconds: 2}\nfigures:\n" +
              figure + "name: a, over: [4, 12]}\n" + figure +
              "name: b, at: 0, over: {window: 8}}\n",
          // Of so many not every frame is looked at: in one such interval lie two frames.
          "title: A gas\nbox: {size: [60, 60]}\ngas: [{count: 2000, radius: 0.4, speed: 10}]\n"
          "run: {until: 20}\nfilm: {seconds: 30}\nfigures:\n" +
              figure + "name: a, over: [0.12, 0.195]}\n" + figure +
              "name: b, over: [0.12, 0.205]}\n",
          // Runs of other lengths, whose frames are others.
          "title: A gas\nbox: {size: [100, 100]}\n"
          "gas: [{count: 100, radius: 0.01, speed: {uniform: [0.5, 3]}}]\n"
          "run: {until: 10}\nfilm: {seconds: 2}\nfigures:\n" +
              figure +
              "name: a, over: start, compare: [{label: a}, {label: b, "
              "set: [gas.0.speed=1.5, run.until=40]}]}\n" +
              figure +
              "name: b, over: [2, 8], compare: [{label: a}, {label: b, "
              "set: [gas.0.speed=1.55, run.until=40]}]}\n"}) {
        CAPTURE(scene);
        for (const double share : shares_of_height(scene)) {
            CHECK(share > 0.55);  // 1.1 times the bars, rounded up by half at most: 0.61; of probes
            CHECK(share <= 1.0);
        }
    }
}

// Equal speeds at the start lie inside a bar, of a film and of a mean long after that.
TEST_CASE("the bars of a mean over an interval are those of the film") {
    const FigureRun run = run_of(test::scene_from(
        "title: A gas\nbox: {size: [60, 40]}\ngas: [{count: 300, radius: 0.5, speed: 1}]\n"
        "run: {until: 200}\nfigures:\n"
        "  - {name: a, kind: speed-histogram, at: 200}\n"
        "  - {name: b, kind: speed-histogram, over: [100, 200]}\n"));
    const auto width = [&](std::size_t index) {
        return HistogramPanel::histograms(*run.figures()[index].moments.back().state)
            .front()
            .bins.width();
    };
    CHECK(width(1) == width(0));
}

TEST_CASE("two runs give the same bytes in every format") {
    const Scene scene =
        scene_of("  - {name: a, kind: gas, strip: [0, 5]}\n  - {name: b, kind: speed-histogram}\n");
    const FigureRun one = run_of(scene), two = run_of(scene);
    for (const std::optional<VectorFormat> format :
         {std::optional(VectorFormat::svg), std::optional(VectorFormat::pdf), pixels})
        for (const std::size_t index : {0U, 1U})
            CHECK(drawn(one, index, format).file() == drawn(two, index, format).file());
}

TEST_CASE("captions are the scene's, or made of true numbers") {
    const Scene scene = scene_of(
        "  - {name: a, kind: gas, at: 5, caption: Mine, alt: \"Seen, in words\"}\n"
        "  - {name: b, kind: speed-histogram, at: 5}\n");
    const FigureRun run = run_of(scene);
    CHECK(words_of(run, run.figures()[0]).caption == "Mine");
    CHECK(words_of(run, run.figures()[0]).alt == "Seen, in words");
    Simulation simulation(scene.gas, scene.run);
    const auto count = simulation.advance_to(5.0).counts.particle;
    CHECK(words_of(run, run.figures()[1]).caption ==
          "Ten disks. Speed histogram at time 5: 10 disks, " + std::to_string(count) +
              (count == 1 ? " collision" : " collisions") +
              " between them by then; reduced units. Mean " +
              three_digits(speeds(simulation.sample()).mean()) + ".");
}

TEST_CASE("cards before and after a film change nothing in its figures") {
    // The start is unlike the rest: seen for long it would have another axis.
    const auto pictures = [](const std::string& cards) {
        const Scene scene = test::scene_from(
            "title: Ten disks\nbox: {size: [40, 30]}\n"
            "gas: [{name: cold, count: 40, radius: 1, speed: 0.05}, "
            "{name: hot, count: 1, radius: 1, speed: 30}]\nrun: {until: 10}\n"
            "film: {pace: 0.5, fps: 10" +
            cards +
            "}\nfigures:\n"
            "  - {name: a, kind: energy-histogram}\n"
            "  - {name: b, kind: energy-by-species}\n  - {name: c, kind: gas, at: 0}\n");
        const FigureRun run = run_of(scene);
        std::vector<std::string> all;
        for (const std::size_t index : {0U, 1U, 2U}) {
            const auto bytes = drawn(run, index).file();
            all.push_back({bytes.begin(), bytes.end()});
            all.push_back(csv(table_of(run.figures()[index])));
        }
        return all;
    };
    CHECK(pictures("") == pictures(", title_card: 3, end_card: Who is fast now!"));
}

TEST_CASE("a figure of one collision shows the whole of it and no present") {
    const Scene scene = test::scene_from(
        "title: Two disks\nbox: {size: [24, 18]}\n"
        "gas:\n  - {name: a, position: [3.5, 9], radius: 2, velocity: [1, 0]}\n"
        "  - {name: b, position: [13, 7], radius: 2}\nrun: {until: 12}\nfilm: {seconds: 2}\n"
        "figures:\n  - {name: a, kind: single-collision, at: 1}\n"
        "  - {name: b, kind: single-collision, at: 6.05}\n"
        "  - {name: c, kind: single-collision}\n  - {name: d, kind: contact-time, at: 1}\n"
        "  - {name: e, kind: contact-time, at: 11}\n");
    const FigureRun run = run_of(scene);
    const auto picture = [&](std::size_t index) { return drawn(run, index).file(); };
    CHECK(picture(0) == picture(1));
    CHECK(picture(0) == picture(2));
    CHECK(picture(3) == picture(4));
    for (const auto& row : table_of(run.figures()[3]).rows)
        CHECK(std::get<std::string>(row[1]) != "present");
}

TEST_CASE("in a figure the name of a disk keeps clear of the disks around it") {
    const auto left_of_name = [](const std::string& place) {
        const Scene scene = test::scene_from(
            "title: T\nbox: {size: [40, 30]}\n"
            "gas:\n  - {name: hot, count: 1, radius: 1, position: [20, 15]}\n"
            "  - {name: far, count: 20, radius: 0.5, position: {within: [0, 0, 10, 10]}}\n"
            "  - {count: 1, name: near, radius: 1, position: " +
            place +
            "}\nrun: {until: 1}\nfilm: {seconds: 2, trails: {of: hot}}\n"
            "figures: [{name: a, kind: gas, at: 0}]\n");
        const FigureRun run = run_of(scene);
        const TextLog log;
        drawn(run, 0);
        for (const DrawnLine& line : log.lines)
            if (line.markup == "hot") return line.ink.x;
        return 0.0;
    };
    CHECK(std::abs(left_of_name("[20, 17.5]") - left_of_name("[35, 17.5]")) > 20.0);
}

TEST_CASE("the figures of a scene have alternative texts of their own") {
    const FigureRun run = run_of(
        scene_of("  - {name: a, kind: gas, at: 0}\n  - {name: b, kind: gas, at: 10}\n"
                 "  - {name: c, kind: speed-histogram}\n  - {name: d, kind: temperature}\n"));
    const std::string description = run.scene().description;
    int described = 0;
    std::vector<std::string> all;
    for (const Figure& figure : run.figures()) {
        const std::string alt = words_of(run, figure).alt;
        CHECK(std::ranges::find(all, alt) == all.end());
        described += alt.find(description) != std::string::npos ? 1 : 0;
        all.push_back(alt);
    }
    CHECK(described == 1);
    CHECK(all.front().find(description) != std::string::npos);
}

TEST_CASE("captions may have formulae, alternative texts have them in words") {
    const FigureRun run =
        run_of(scene_of("  - {name: a, kind: gas, caption: 'At $kT$, for \\$2', alt: 'The mean is "
                        "$\\frac12 kT$'}\n"));
    const FigureWords words = words_of(run, run.figures()[0]);
    CHECK(words.caption == "At $kT$, for \\$2");
    CHECK(words.alt == "The mean is 1 over 2, times k times T");
}

TEST_CASE("a figure of words that has no room for them is refused") {
    const std::string words(500, 'w');
    CHECK_THROWS_WITH_AS(
        run_of(scene_of("  - {name: a, kind: text, size: [2, 2], words: " + words + "}\n")),
        doctest::Contains("do not fit into the panel's place"), SceneError);
    CHECK_NOTHROW(
        run_of(scene_of("  - {name: a, kind: text, words: some words with $x^2$ in them}\n")));
}

TEST_CASE("a strip of low boxes is as high as its key") {
    const auto height = [](const std::string& more) {
        const Scene scene = test::scene_from(
            "title: T\nbox: {size: [60, 20]}\ngas: [{count: 10, radius: 1, speed: 2}]\n"
            "run: {until: 10}\nfilm: {seconds: 2" +
            more + "}\nfigures:\n  - {name: a, kind: gas, strip: [0, 5, 10]}\n");
        // Units of 6.9 points; between two margins.
        return figure_size(scene, scene.figures[0])[1] / (6.9 / 72.0 * 2.54) - 1.6;
    };
    constexpr double rounding = 0.05;                       // to a tenth of a millimetre
    CHECK(height("") > 8.6 - rounding);                     // the bar of colours
    CHECK(height(", velocities: true") > 12.2 - rounding);  // and an arrow
}
