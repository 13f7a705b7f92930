// The pressure on a moving wall against the area, and the curves of theory beside it.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "support/relative.h"
#include "support/seen_panel.h"

using namespace carom;

namespace {

// The first panel of a scene's film, after its first pass over the whole run.
struct SeenPressure : test::SeenPanel {
    explicit SeenPressure(const std::string& text)
        : SeenPanel(test::scene_from("title: T\n" + text), 80) {}
};

// The longest name of an entry of the first note.
std::string name_in_note(const plot::Plot& plot, std::size_t entry) {
    std::string all;
    for (const auto& piece : plot.notes.at(0).entries.at(entry).words.front().pieces)
        all += piece.markup;
    return all;
}

}  // namespace

TEST_CASE("pressure against area begins at the box, with the ideal gas of disks that differ") {
    const SeenPressure seen(
        "box: {size: [10, 14], walls: {top: {velocity: -0.5}}}\n"
        "gas: [{name: a, count: 10, radius: 0.01, temperature: {exact: 2}}, "
        "{name: b, count: 10, radius: 0.02, temperature: {exact: 2}}]\n"
        "run: {until: 8}\nfilm: {seconds: 8, panels: [pressure-volume]}\n");
    const plot::Plot plot = seen.plot();
    CHECK(name_in_note(plot, 0) == "ideal gas");
    std::size_t found = 0;
    for (const auto& layer : plot.layers) {
        const auto* line = std::get_if<plot::Polyline>(&layer);
        if (line == nullptr || line->part != "theory") continue;
        const double start = 20 * 2.0 / 140.0, power = line->of == "adiabat" ? 2.0 : 1.0;
        for (std::size_t i = 0; i < line->x.size(); ++i)
            CHECK(line->y[i] == test::relative(start * std::pow(140.0 / line->x[i], power), 1e-12));
        ++found;
    }
    CHECK(found == 2);
    CHECK(plot.y.low == 0.0);
    CHECK(plot.x.low < 100.0);
    CHECK(plot.x.high > 140.0);

    // The gas does not fill the area that the walls enclose.
    for (const std::string more :
         {"partitions: [{name: d, x: 5}]\n", "obstacles: [{disk: [5, 4], radius: 3}]\n",
          "gravity: [0, -1]\n"}) {
        CAPTURE(more);
        const plot::Plot without =
            SeenPressure("box: {size: [10, 14], walls: {top: {velocity: -0.5}}}\n" + more +
                         "gas: [{name: a, count: 20, radius: 0.01, temperature: 2}]\n"
                         "run: {until: 8}\nfilm: {seconds: 8, panels: [pressure-volume]}\n")
                .plot();
        for (const auto& layer : without.layers)
            if (const auto* line = std::get_if<plot::Polyline>(&layer))
                CHECK(line->part != "theory");
    }
}

TEST_CASE("equal disks have their own isotherm and adiabat, and lines at multiples of the start") {
    const SeenPressure seen(
        "box: {size: [60, 44], walls: {top: {velocity: -2}}}\n"
        "gas: [{name: a, count: 200, radius: 0.34, temperature: {exact: 50}}]\n"
        "run: {until: 14}\n"
        "film: {seconds: 8, panels: [{kind: pressure-volume, levels: [1, 2.5]}]}\n");
    const plot::Plot plot = seen.plot();
    CHECK(name_in_note(plot, 0) == "hard disks");
    // Of points at the start 200 * 50 / (60 * 44), and more for the room that disks take up: the
    // pressure times the area, and the density with Z = 1.0594 of Kolafa and Rottner at 0.0285.
    const double ideal = 200 * 50.0 / (60 * 44);
    std::vector<double> levels;
    for (const auto& layer : plot.layers) {
        if (const auto* level = std::get_if<plot::Level>(&layer)) levels.push_back(level->value);
        const auto* line = std::get_if<plot::Polyline>(&layer);
        if (line == nullptr || line->of != "adiabat") continue;
        // By the same equation, integrated elsewhere: 157.6 at a height of 16, where the pressure
        // is 40.2; of points it would be 137.5 and 28.65.
        std::size_t at = 0;
        while (line->x[at] < 960.0) ++at;
        CHECK(line->y[at] == test::relative(40.2, 0.04));
    }
    REQUIRE(levels.size() == 2);
    CHECK(levels[0] == test::relative(ideal * 1.075, 0.015));
    CHECK(levels[1] == test::relative(2.5 * levels[0], 1e-12));
    CHECK(plot.y.high > levels[1]);
}

TEST_CASE("baths that become hotter together give a gas one isotherm after the other") {
    const auto curves = [](const std::string& right, const std::string& later) {
        const SeenPressure seen(
            "box: {size: [60, 44], walls: {top: {velocity: 0}, left: {temperature: 3}, right: "
            "{temperature: " +
            right +
            "}}}\ngas: [{name: a, count: 200, radius: 0.34, temperature: {exact: 2}}]\n"
            "run: {until: 9, events: [{at: 3, wall: left, temperature: " +
            later + "}, {at: 3, wall: right, temperature: " + later +
            "}, {at: 5, move: top, velocity: -2}, {at: 7, move: top, velocity: 0}]}\n"
            "film: {seconds: 8, panels: [{kind: pressure-volume}]}\n");
        std::map<std::string, double> at_start;  // pressure times area over the number
        const plot::Plot plot = seen.plot();
        for (const auto& layer : plot.layers) {
            const auto* line = std::get_if<plot::Polyline>(&layer);
            if (line == nullptr || line->part != "theory") continue;
            std::size_t i = 0;
            while (i + 1 < line->x.size() && line->x[i] < 60 * 44 - 1e-9) ++i;
            at_start[line->of] = line->y[i] * line->x[i] / 200;
        }
        return at_start;
    };
    const double most = 1.1;  // for the room that disks take up: 1.075 at the start
    const auto two = curves("3", "6");
    REQUIRE(two.size() == 2);
    CHECK(two.at("isotherm 3") > 3.0);
    CHECK(two.at("isotherm 3") < 3.0 * most);
    CHECK(two.at("isotherm 6") == test::relative(2.0 * two.at("isotherm 3"), 1e-12));
    // One temperature is that of the isotherm, whatever the gas begins with; the adiabat is through
    // the start.
    const auto one = curves("3", "3");
    REQUIRE(one.size() == 2);
    CHECK(one.at("isotherm") == test::relative(two.at("isotherm 3"), 1e-12));
    CHECK(one.at("adiabat") == test::relative(2.0 / 3.0 * one.at("isotherm"), 1e-9));
    CHECK(curves("4", "6").empty());  // between walls of different temperatures
}

TEST_CASE("the path of pressure and area begins when its window is full") {
    const SeenPressure seen(
        "box: {size: [10, 14], walls: {top: {velocity: -0.5}}}\n"
        "gas: [{name: a, count: 20, radius: 0.01, temperature: {exact: 2}}]\n"
        "run: {until: 8}\nfilm: {seconds: 8, panels: [{kind: pressure-volume, over: {window: "
        "4}}]}\n");
    const auto state = seen.last_state();
    const plot::Plot plot = seen.plot(state.get());
    const plot::Polyline* path = nullptr;
    for (const auto& layer : plot.layers)
        if (const auto* line = std::get_if<plot::Polyline>(&layer); line && line->part == "path")
            path = line;
    REQUIRE(path != nullptr);
    int before = 0;
    for (std::size_t i = 0; i < path->y.size(); ++i) {
        const bool is_full = path->x[i] < 120.0 + 1e-6;  // the wall has gone 2 of 14 by then
        CHECK(std::isfinite(path->y[i]) == is_full);
        before += !is_full;
    }
    CHECK(before > 30);
    CHECK(before < 50);
}
