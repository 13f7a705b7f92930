// Numbers with units in scenes: which keys take them, and what is read.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "panels/registry.h"
#include "scene/keys/unit_conversion.h"
#include "scene/reading/scene_reading.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

bool is_number(const Form& form) {
    return form.shape == Shape::number || form.shape == Shape::integer;
}

// The paths of all numbers among these forms that have no quantity: "gas.count".
void add_plain(const std::vector<Form>& forms, const std::string& path,
               std::set<std::string>& plain) {
    for (const Form& form : forms) {
        if (is_number(form) && !form.quantity && !form.takes_any_quantity) plain.insert(path);
        add_plain(form.items, path, plain);
        if (!form.section) continue;
        for (const Key& key : form.section->keys)
            add_plain(key.forms, path + "." + key.name, plain);
    }
}

std::string scene_with(const std::string& gas, const std::string& more = "") {
    return "title: T\nunits: real\nbox: {size: [4 nm, 4 nm, 4 nm]}\ngas: [{" + gas +
           "}]\nrun: {until: 10 ps" + more + "}\n";
}

const std::string argon = "count: 9, radius: 0.17 nm, mass: 39.948 u";

}  // namespace

TEST_CASE("every number that describes the gas and its run is a quantity or a plain number") {
    // Counts, precision, shares, ratios, and seconds of film.
    const std::set<std::string> expected{"box.shape",
                                         "gas.count",
                                         "gas.trail",
                                         "run.events.for",
                                         "run.events.nudge.particle",
                                         "run.events.pause",
                                         "run.most_collisions",
                                         "run.precision",
                                         "run.tolerance"};
    for (int dimension = 1; dimension <= 3; ++dimension) {
        CAPTURE(dimension);
        const Section& scene = scene_table(panel_kinds(), dimension).section();
        std::set<std::string> plain;
        for (const char* name : {"box", "gravity", "partitions", "obstacles", "gas", "run"})
            if (const std::size_t k = scene.index(name); k < scene.keys.size())
                add_plain(scene.keys[k].forms, name, plain);
        CHECK(plain == expected);
    }
}

TEST_CASE(
    "in films and figures only counts, ratios, angles and seconds of film are plain numbers") {
    const Section& scene = scene_table(panel_kinds(), 3).section();
    std::set<std::string> plain;
    for (const char* name : {"film", "figures", "measure"})
        add_plain(scene.keys.at(scene.index(name)).forms, name, plain);
    const std::set<std::string> expected{"figures.bins",
                                         "figures.cells",
                                         "figures.compare.seeds",
                                         "figures.levels",
                                         "figures.seeds",
                                         "figures.size",
                                         "figures.viewpoint.lens",
                                         "figures.viewpoint.tilt",
                                         "figures.viewpoint.turn",
                                         "figures.width",
                                         "film.callouts.for",
                                         "film.camera.over",
                                         "film.camera.viewpoint.lens",
                                         "film.camera.viewpoint.tilt",
                                         "film.camera.viewpoint.turn",
                                         "film.fade_out.seconds",
                                         "film.field.cells",
                                         "film.field.opacity",
                                         "film.fps",
                                         "film.panels.bins",
                                         "film.panels.cells",
                                         "film.panels.levels",
                                         "film.panels.viewpoint.lens",
                                         "film.panels.viewpoint.tilt",
                                         "film.panels.viewpoint.turn",
                                         "film.seconds",
                                         "film.size",
                                         "film.slow.factor",
                                         "film.sound.loudness",
                                         "film.title_card",
                                         "film.trails.seconds",
                                         "film.trails.seeds",
                                         "film.viewpoint.lens",
                                         "film.viewpoint.spin",
                                         "film.viewpoint.tilt",
                                         "film.viewpoint.turn",
                                         "measure.cells"};
    CHECK(plain == expected);
}

TEST_CASE("numbers with units are read in nanometres, atomic mass units and picoseconds") {
    const Scene scene = test::scene_from(
        scene_with(argon + ", velocity: [1 m/s, 0, -2 km/s], position: {within: [0, 0, 0, 40 "
                           "angstrom, 2 nm, 3000 pm]}",
                   ", events: [{at: 0.005 ns, nudge: {particle: 1, by: [1.00000000000000000001e-9 "
                   "nm, 0, 0]}}]"),
        {}, Wanted::physics);
    CHECK(scene.gas.box.size[0] == 4.0);
    CHECK(scene.run.until == 10.0);
    CHECK(scene.run.events.at(0).at == 5.0);
    const Species& species = scene.gas.species.at(0);
    CHECK(std::get<double>(species.radius) == 0.17);
    const Vec velocity = std::get<Velocity>(species.velocity).values.at(0);
    CHECK(velocity[0] == 0.001);
    CHECK(velocity[2] == -2.0);
    // Digits that no double holds are kept.
    CHECK(perturbation_of(scene.run.events.at(0))->by[0] == "1.00000000000000000001e-9");
}

TEST_CASE("a text is parted into a number and what may be its unit") {
    const auto parts = [](std::string_view text) {
        const auto found = number_with_unit(text);
        return found ? std::string(found->number) + "|" + std::string(found->unit) : "";
    };
    CHECK(parts("12 nm") == "12|nm");
    CHECK(parts("12nm") == "12|nm");
    CHECK(parts("-1.5e3 m/s") == "-1.5e3|m/s");
    CHECK(parts("5 eV") == "5|eV");
    CHECK(parts("5eV") == "5|eV");
    CHECK(parts("2.5e25 1/m3") == "2.5e25|1/m3");
    CHECK(parts("20 °C") == "20|°C");
    CHECK(parts("3 µm") == "3|µm");
    CHECK(parts("12").empty());
    CHECK(parts("nm").empty());
    CHECK(parts("2*pi").empty());
    CHECK(parts("1 2").empty());
    // In a time that grows with the length alone.
    const std::string long_number(1 << 20, '1');
    CHECK(parts(long_number + " " + long_number).empty());
    CHECK(parts("1" + std::string(1 << 20, 'e')) == "");
}
