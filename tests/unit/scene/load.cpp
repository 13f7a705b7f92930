// Good scenes, their defaults, and what the command line lays over them.
#include "scene/load.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "panels/plots/histogram_panel.h"
#include "panels/words/monitors_panel.h"
#include "scene/scene.h"
#include "support/files.h"
#include "support/library.h"
#include "support/resources.h"
#include "support/scene_text.h"
#include "support/test_root.h"

using namespace carom;
using test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

const fs::path root = carom::test::checkout();

Scene load(const std::string& text, const Overrides& overrides = {}) {
    return load_scene_text(text, "test.yaml", test::resources(), overrides);
}

std::string scene_with(const std::string& gas, const std::string& rest = "run: {until: 10}\n") {
    return "title: A gas\nbox: {size: [64, 48]}\ngas:\n  - " + gas + "\n" + rest;
}

std::string message(const std::string& text, const Overrides& overrides) {
    try {
        load(text, overrides);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

const std::string small_layout =
    "layout: {grid: [40, 20], title: [0, 0, 40, 2], gas: [0, 2, 30, 18], "
    "color_bar: [31, 2, 4, 18], panels: [[36, 2, 4, 18]]}\n";

}  // namespace

TEST_CASE("the first scene of the book") {
    const Scene scene = load_scene(root / "scenes/one-hot-particle.yaml", test::resources());
    CHECK(scene.title == "One fast particle among slow ones");
    CHECK(scene.seed == 1);
    CHECK(scene.gas.seed == 1);
    CHECK(scene.gas.box.size == Vec(88, 40));
    CHECK(!scene.gas.box.is_periodic(0));
    REQUIRE(scene.gas.species.size() == 2);
    const Species& cold = scene.gas.species[0];
    CHECK(cold.name == "the 200 others");
    CHECK(cold.count == 200);
    CHECK(std::get<double>(cold.radius) == 0.7);
    CHECK(std::get<double>(std::get<ValueRule>(cold.mass)) == 1.0);
    CHECK(std::get<double>(std::get<Speed>(cold.velocity).value) == 0.05);
    CHECK(std::holds_alternative<RandomPlaces>(cold.position));
    const Species& hot = scene.gas.species[1];
    CHECK(std::get<double>(std::get<Speed>(hot.velocity).value) == 30.0);
    CHECK(std::get<Places>(hot.position).values.at(0) == Vec(20, 22));
    CHECK(scene.run.until > 0.0);
    CHECK(scene.film.template_name == "hero");
    CHECK(scene.film.seconds == 42.0);
    CHECK(scene.film.fps == 30);
    CHECK(scene.film.size == PictureSize{1920, 1080});
    CHECK(scene.film.theme == ThemeName::dark);
    REQUIRE(scene.film.panels.size() == 1);
    CHECK(scene.film.panels[0].kind == "speed-histogram");
    CHECK(scene.film.panels[0].theory);
    CHECK(scene.film.layout.panels.size() == 1);
    CHECK(is_within(scene.film.layout.panels[0], scene.film.layout.gas));
    CHECK(scene.film.layout.gas.width > 0.0);
    CHECK(scene.film.layout.monitors.has_value());
    CHECK(scene.species_spans.at(1).span.column == 5);
    CHECK(scene.species_spans.at(1).source_line.find("the fast disk") != std::string::npos);
    CHECK(scene.source.text.starts_with("# yaml-language-server"));
    CHECK(scene.looks.size() == 2);
}

TEST_CASE("every scene of the library loads") {
    for (const fs::path& file : test::library_files()) {
        CAPTURE(file.string());
        CHECK_NOTHROW(load_scene(file, test::resources()));
    }
}

TEST_CASE("what is left out is chosen") {
    const Scene scene = load(scene_with("{count: 20}"));
    CHECK(scene.gas.species[0].name == "gas");
    CHECK(std::get<double>(scene.gas.species[0].radius) == 0.5);
    CHECK(std::holds_alternative<AtRest>(scene.gas.species[0].velocity));
    CHECK(scene.seed == 1);
    CHECK(scene.film.seconds == 10.0);  // pace 1
    CHECK(scene.film.color_by == ColorBy::speed);
    CHECK(!scene.film.palette);
    CHECK(scene.run.equilibrate == 0.0);
    CHECK(scene.description ==
          "20 disks, at rest, start in a box of 64 by 48 with solid walls and "
          "collide elastically.");
}

TEST_CASE("the description made for a scene is a plain sentence, whatever the walls") {
    const auto described = [](const std::string& walls, const std::string& gas) {
        return load("title: A gas\nbox: {size: [64, 48], walls: " + walls + "}\ngas: " + gas +
                    "\nrun: {until: 10}\n")
            .description;
    };
    const std::string gas = "[{count: 20, speed: 1}]";
    CHECK(described("solid", gas) ==
          "20 disks, at speed 1, start in a box of 64 by 48 with solid walls and collide "
          "elastically.");
    CHECK(described("periodic", gas) ==
          "20 disks, at speed 1, start in a periodic box of 64 by 48 and collide elastically. What "
          "leaves on one side enters on the opposite side.");
    CHECK(described("{left: periodic, right: periodic}", gas) ==
          "20 disks, at speed 1, start in a box of 64 by 48 with solid walls at the bottom and at "
          "the top, and "
          "collide elastically. What leaves on the left enters on the right, and the other way "
          "round.");
    CHECK(
        described("{bottom: periodic, top: periodic}", gas) ==
        "20 disks, at speed 1, start in a box of 64 by 48 with solid walls on the left and right, "
        "and collide elastically. What leaves at the top enters at the bottom, and the other way "
        "round.");
    CHECK(described("periodic",
                    "[{name: a, count: 9, speed: 1}, {name: b, count: 1}, {name: c, count: 3, "
                    "temperature: 2}]") ==
          "9 disks (a, at speed 1), 1 disk (b, at rest) and 3 disks (c, with velocities sampled at "
          "temperature 2) start in "
          "a periodic box of 64 by 48 and collide elastically. What leaves on one side enters on "
          "the opposite side.");
    CHECK(described("solid", "[{count: 1, speed: 1}]") ==
          "1 disk, at speed 1, starts in a box of 64 by 48 with solid walls and collides "
          "elastically.");
}

TEST_CASE("numbers in all their forms") {
    const Scene scene = load(scene_with(
        "{name: a, count: 2, radius: [0.5, 1], mass: infinite, velocity: [[1, 0], [0, 1]]}\n"
        "  - {name: b, count: 9, radius: {uniform: [0.5, 1]}, density: {normal: [2, 0.1]},\n"
        "     temperature: 3, position: {within: [0, 0, 20, 20]}, color: navy, label: B, trail: "
        "2}\n"
        "  - {name: c, position: [[30, 30], [40, 40]], mass: [1, 2], velocity: [1, -2]}\n"
        "  - {name: d, count: 3, speed: {uniform: [0, 1]}, position: lattice}"));
    const auto& species = scene.gas.species;
    CHECK(std::get<std::vector<double>>(species[0].radius) == std::vector<double>{0.5, 1.0});
    CHECK(std::holds_alternative<Infinite>(species[0].mass));
    CHECK(std::get<Velocity>(species[0].velocity).values.at(1)[1] == 1.0);
    CHECK(std::get<UniformDistribution>(species[1].radius).high == 1.0);
    CHECK(std::get<NormalDistribution>(std::get<Density>(species[1].mass).value).deviation == 0.1);
    CHECK(std::get<Temperature>(species[1].velocity).value == 3.0);
    CHECK(std::get<WithinRegion>(species[1].position).region.high[0] == 20.0);
    CHECK(scene.looks[1].color == "#000080");
    CHECK(scene.looks[1].label == "B");
    CHECK(scene.looks[1].trail == 2.0);
    CHECK(species[2].count == 2);
    CHECK(std::get<Velocity>(species[2].velocity).values.size() == 1);
    CHECK(std::holds_alternative<LatticePlaces>(species[3].position));
}

TEST_CASE("walls, events and panels with options") {
    const Scene scene = load(
        "title: >\n  A gas in\n  two lines\nseed: 9007199254740991\n"
        "box: {size: [64, 48], walls: {left: periodic, right: periodic}}\n"
        "gas: [{count: 20, speed: 1}]\n"
        "run:\n  until: 40\n  equilibrate: 5\n"
        "  events: [{at: 30, reverse: velocities}, {at: 20, reverse: velocities}]\n"
        "film:\n  pace: 4\n  size: [640, 480]\n  palette: magma\n  theme: light\n"
        "  panels: [{kind: speed-histogram, bins: 20, range: [0, 3], theory: false, title: "
        "Speeds}]\n");
    CHECK(scene.title == "A gas in two lines");
    CHECK(scene.seed == 9007199254740991U);
    CHECK(scene.gas.box.walls == Walls{Wall::periodic, Wall::solid});
    REQUIRE(scene.run.events.size() == 2);
    CHECK(scene.run.events[0].at == 20.0);
    CHECK(scene.film.seconds == 10.0);
    CHECK(scene.film.size == PictureSize{640, 480});
    CHECK(scene.film.theme == ThemeName::light);
    CHECK(scene.film.palette == "magma");
    REQUIRE(scene.film.panels.size() == 1);
    const auto& bars = scene.film.panels[0].options.as<HistogramOptions>();
    CHECK(bars.bins == 20);
    CHECK(bars.range->second == 3.0);
    CHECK(!scene.film.panels[0].theory);
    CHECK(!bars.mean_now.has_value());
    CHECK(scene.film.panels[0].title == "Speeds");
    CHECK(scene.description.find("At time 20 and 30 all velocities are reversed") !=
          std::string::npos);
}

TEST_CASE("a panel's particles are chosen by all, species and number") {
    const Scene scene = load(
        "title: T\nbox: {size: [64, 48]}\n"
        "gas: [{name: light, count: 20, speed: 1}, {name: heavy, count: 5}]\n"
        "run: {until: 40}\n"
        "film:\n  panels:\n"
        "    - {kind: velocity-histogram, of: [all, heavy, 24], over: {window: 3}, fit: true}\n"
        "    - {kind: velocity-histogram, of: light, component: y, over: start, mean_now: true}\n"
        "    - velocity-histogram\n");
    REQUIRE(scene.film.panels.size() == 3);
    const PanelSpec& first = scene.film.panels[0];
    REQUIRE(first.of.size() == 3);
    CHECK(!first.of[0].species.has_value());
    CHECK(!first.of[0].particle.has_value());
    CHECK(first.of[1].species == 1U);
    CHECK(first.of[2].particle == 24);
    CHECK(first.over->since == Over::Since::window);
    CHECK(first.over->window == 3.0);
    CHECK(first.options.as<HistogramOptions>().fit);
    CHECK(scene.film.panels[1].of.size() == 1);
    CHECK(scene.film.panels[1].over->since == Over::Since::start);
    CHECK(scene.film.panels[1].component == Component::y);
    CHECK(scene.film.panels[1].options.as<HistogramOptions>().mean_now == true);
    CHECK(scene.film.panels[2].of.empty());
    CHECK(!scene.film.panels[2].over.has_value());
}

TEST_CASE("the statistics are sampled as often as asked, whatever the film") {
    const auto every = [](const std::string& rest, Wanted wanted) {
        return load_scene_text(scene_with("{count: 20}", rest), "test.yaml", test::resources(), {},
                               wanted)
            .run.sample_every;
    };
    for (const Wanted wanted : {Wanted::film, Wanted::physics}) {
        CHECK(every("run: {until: 10, sample_every: 0.3}\n", wanted) == 0.3);
        CHECK(every("run: {until: 10}\n", wanted) == 10.0 / 1000);
        CHECK(every("run: {until: 10}\nfilm: {seconds: 5, fps: 20}\n", wanted) == 10.0 / 1000);
    }
}

TEST_CASE("only where a film is wanted must a run without one fit into a film") {
    const std::string text = scene_with("{count: 20}", "run: {until: 1e9}\n");
    CHECK(message(text, {}).find("frames of a film") != std::string::npos);
    CHECK(load_scene_text(text, "test.yaml", test::resources(), {}, Wanted::physics)
              .run.sample_every == 1e6);
    CHECK_THROWS_AS(load_scene_text(text + "film: {pace: 1}\n", "test.yaml", test::resources(), {},
                                    Wanted::physics),
                    SceneError);
}

TEST_CASE("a film too short for its reversals is refused, the length it is told to have is not") {
    std::string events;
    for (int i = 1; i <= 100; ++i)
        events += "{at: " + std::to_string(i) + "e-1, reverse: velocities},";
    const std::string text =
        scene_with("{count: 20}", "run: {until: 24, events: [" + events + "]}\nfilm: {fps: 30}\n");
    CHECK(message(text, {"film.seconds=3"}).find("a film of 4.6 seconds") != std::string::npos);
    CHECK(load(text, {"film.seconds=4.6"}).run.events.size() == 100);
}

TEST_CASE("the command line lays its values over the scene") {
    const std::string text =
        scene_with("{count: 20, color: red}", "run: {until: 10}\nfilm: {seconds: 5}\n");
    const Scene scene =
        load(text, {"gas.0.count=50", "gas.0.color=#00ff00", "film.size=[640, 480]", "film.pace=2",
                    "seed=6", "seed=7", "box.walls.left=periodic", "box.walls.right=periodic"});
    CHECK(scene.gas.species[0].count == 50);
    CHECK(scene.looks[0].color == "#00ff00");
    CHECK(scene.film.size == PictureSize{640, 480});
    CHECK(scene.film.seconds == 5.0);  // of pace 2: the later origin wins over the file's seconds
    CHECK(scene.seed == 7);
    CHECK(scene.gas.box.is_periodic(0));
    CHECK(load(text, {"film.pace=1"}).film.seconds == 10.0);
}

TEST_CASE("an error of the command line points into what was typed") {
    const std::string text = scene_with("{count: 20}");
    CHECK(
        message(text, {"film.fps=abc"}) ==
        "--set film.fps=abc: error: expected a whole number from 1 to 120 for `fps`, found `abc`\n"
        "      | --set film.fps=abc\n"
        "      |                ^^^\n"
        "  hint: for instance `30`");
    CHECK(message(text, {"gas.0.cuont=3"}) ==
          "--set gas.0.cuont=3: error: `cuont` is not a key of an item of `gas`\n"
          "      | --set gas.0.cuont=3\n"
          "      |             ^^^^^\n"
          "  hint: did you mean `count`?");
    CHECK(message(text, {"gas.1.count=3"}) ==
          "--set gas.1.count=3: error: expected an item of a list of 1, found `1`\n"
          "      | --set gas.1.count=3\n"
          "      |           ^\n"
          "  hint: items are counted from 0");
    CHECK(message(text, {"title.words=3"}) ==
          "--set title.words=3: error: `words` is set inside `A gas`, which is no mapping\n"
          "      | --set title.words=3\n"
          "      |             ^^^^^\n"
          "  hint: the keys before it lead to a single value: leave out what follows that");
    CHECK(message(text, {"film.size=[1, 2"}).starts_with("--set film.size=[1, 2: error: "));
    CHECK(message(text, {"="}).starts_with("--set =: error: `` is not a key of a scene"));
    CHECK(message(text, {"seed="}).starts_with("--set seed=: error: expected a whole number"));
}

TEST_CASE("figures are of the scene itself, not of the run beside") {
    const std::string text =
        scene_with("{count: 20, speed: 1}",
                   "run: {until: 10}\n"
                   "film: {seconds: 3, beside: {label: few, own_label: many, set: gas.0.count=5}}\n"
                   "figures: [{name: a, kind: speed-histogram, test: true}]\n");
    const Scene scene = load_scene_text(text, "test.yaml", test::resources());
    CHECK(scene.figures.size() == 1);
    CHECK(scene.film.runs.others.front().scene->figures.empty());
}

TEST_CASE("callouts are about the scene's own run, not about that beside it") {
    const Scene scene = load_scene_text(
        scene_with("{count: 20, speed: 1}",
                   "run: {until: 10}\n"
                   "film: {seconds: 3, callouts: [{at: 2, points_to: 15, text: this}], "
                   "beside: {label: few, own_label: many, set: gas.0.count=5}}\n"),
        "test.yaml", test::resources());
    CHECK(scene.film.callouts.size() == 1);
    CHECK(scene.film.runs.others.front().scene->film.callouts.empty());
}

TEST_CASE("a template is looked for beside the scene, then in carom's own folder") {
    const TemporaryFolder folder;
    folder.write("small.yaml", "fps: 12\npace: 2\npanels: [energy-histogram]\n" + small_layout);
    const std::string text =
        scene_with("{count: 20}", "run: {until: 10}\nfilm: {template: small}\n");
    const Scene scene = load_scene(folder.write("scene.yaml", text), test::resources());
    CHECK(scene.film.template_name == "small");
    CHECK(scene.film.fps == 12);
    CHECK(scene.film.seconds == 5.0);
    CHECK(scene.film.layout.grid_width == 40.0);
    CHECK(!scene.film.layout.monitors);
    REQUIRE(scene.film.panels.size() == 1);
    CHECK(scene.film.panels[0].kind == "energy-histogram");

    const std::string longer =
        scene_with("{count: 20}",
                   "run: {until: 10}\nfilm: {template: small, seconds: 3, fps: 24, panels: []}\n");
    const Scene own = load_scene(folder.write("scene.yaml", longer), test::resources());
    CHECK(own.film.seconds == 3.0);
    CHECK(own.film.fps == 24);
    CHECK(own.film.panels.empty());

    const fs::path typed = folder.path() / "small.yaml";
    const Scene by_path = load(scene_with("{count: 20}"), {"film.template=" + typed.string()});
    CHECK(by_path.film.fps == 12);
}

TEST_CASE("a scene may be called like its template") {
    const TemporaryFolder folder;
    const fs::path path = folder.write("lecture.yaml", scene_with("{count: 20}"));
    CHECK(load_scene(path, test::resources()).film.layout.panels.size() == 3);
}

TEST_CASE("a template that links out of the scene's folder is refused") {
    const TemporaryFolder folder;
    const fs::path inner = folder.path() / "inner";
    fs::create_directories(inner);
    const fs::path outside = folder.write("outside.yaml", small_layout);
    fs::create_symlink(outside, inner / "linked.yaml");
    std::ofstream{inner / "scene.yaml"}
        << scene_with("{count: 20}", "run: {until: 10}\nfilm: {template: linked}\n");
    try {
        load_scene(inner / "scene.yaml", test::resources());
        FAIL("the scene was loaded");
    } catch (const SceneError& error) {
        CHECK(error.diagnostics().at(0).message ==
              "the template `linked` is a link that leads out of the scene's folder");
    }
}

TEST_CASE("a scene's pace wins over its template's seconds") {
    const TemporaryFolder folder;
    folder.write("slow.yaml", "seconds: 20\n" + small_layout);
    folder.write("scene.yaml",
                 scene_with("{count: 20}", "run: {until: 10}\nfilm: {template: slow, pace: 2}\n"));
    folder.write("other.yaml",
                 scene_with("{count: 20}", "run: {until: 10}\nfilm: {template: slow}\n"));
    CHECK(load_scene(folder.path() / "scene.yaml", test::resources()).film.seconds == 5.0);
    CHECK(load_scene(folder.path() / "other.yaml", test::resources()).film.seconds == 20.0);
}

TEST_CASE("a template may ask for curves that not every gas has") {
    const TemporaryFolder folder;
    folder.write("curves.yaml", "panels: [{kind: speed-histogram, theory: true}]\n" + small_layout);
    folder.write("scene.yaml",
                 scene_with("{count: 1}", "run: {until: 10}\nfilm: {template: curves}\n"));
    CHECK(load_scene(folder.path() / "scene.yaml", test::resources()).film.panels.size() == 1);
}

TEST_CASE("a template laid over a scene shows as many of its panels as it has places") {
    const auto loaded = [](const std::string& text, const Overrides& overrides) {
        return load_scene_text(text, "test", test::resources(), overrides);
    };
    const std::string three = scene_with(
        "{count: 20}",
        "run: {until: 10}\nfilm: {panels: [energy-by-species, speed-histogram, monitors]}\n");
    const Scene square = loaded(three, {"film.template=square"});
    REQUIRE(square.film.panels.size() == 2);
    CHECK(square.film.panels[0].kind == "energy-by-species");
    CHECK(loaded(three, {"film.template=minimal"}).film.panels.empty());
    CHECK_THROWS_AS(
        loaded(three, {"film.template=square", "film.panels=[monitors, monitors, monitors]"}),
        SceneError);
    const std::string own = scene_with(
        "{count: 20}", "run: {until: 10}\nfilm: {template: minimal, panels: [monitors]}\n");
    CHECK_THROWS_AS(loaded(own, {}), SceneError);
}

TEST_CASE("the precision of a run, and nudges with all their digits") {
    const auto run_of = [](const std::string& box, const std::string& run) {
        return load("title: T\n" + box + "gas: [{count: 3}]\nrun: {until: 10" + run + "}\n").run;
    };
    const std::string plane = "box: {size: [40, 30]}\n", wire = "box: {length: 40}\n";
    CHECK(run_of(plane, "").bits == 53);
    CHECK(run_of(plane, ", precision: double").bits == 53);
    CHECK(run_of(plane, ", precision: 53").bits == 53);
    CHECK(run_of(plane, ", precision: 64").bits == 64);
    CHECK(run_of(plane, ", precision: 16384").bits == 16384);
    CHECK_FALSE(run_of(plane, ", precision: auto").bits.has_value());
    CHECK(run_of(plane, "").tolerance == 1e-9);
    CHECK(run_of(plane, ", precision: auto, tolerance: 1e-300").tolerance == 1e-300);

    const std::string digits = "1.00000000000000000000000000000000000000001e-300";
    const Run nudged = run_of(plane,
                              ", precision: auto, events: [{at: 5, reverse: velocities}, "
                              "{at: 5, nudge: {particle: 2, by: [-" +
                                  digits + ", 0]}}]");
    REQUIRE(nudged.events.size() == 2);
    const auto* nudge = std::get_if<Perturbation>(&nudged.events[1].action);
    REQUIRE(nudge != nullptr);
    CHECK(nudge->particle == 2);
    CHECK(nudge->by[0] == "-" + digits);
    CHECK(nudge->by[1] == "0");
    const Run beads = run_of(wire, ", events: [{at: 5, nudge: {particle: 0, by: 1e-3}}]");
    CHECK(std::get<Perturbation>(beads.events.at(0).action).by[0] == "1e-3");
}

TEST_CASE("rings, labels and monitors are read") {
    const Scene scene = load_scene_text(
        scene_with("{count: 20, fill: false}",
                   "run: {until: 10}\nfilm: {labels: index, monitors: [all-collisions, time], "
                   "panels: [{kind: monitors, numbers: [fast]}]}\n"),
        "test", test::resources());
    CHECK_FALSE(scene.looks[0].fill);
    CHECK(scene.film.labels == Labels::index);
    CHECK(scene.film.monitors == std::vector{Monitor::all_collisions, Monitor::time});
    CHECK(scene.film.panels[0].options.as<MonitorOptions>().numbers == std::vector{Monitor::fast});
}

// Of a scene that names no panels, with the template lecture.
TEST_CASE("a film shows panels that have something to show of its gas") {
    const auto kinds = [](const std::string& rest) {
        std::vector<std::string> all;
        for (const PanelSpec& panel :
             carom::test::scene_from("title: T\n" + rest + "film: {seconds: 9}\n").film.panels)
            all.push_back(panel.kind);
        return all;
    };
    using Kinds = std::vector<std::string>;
    const std::string box = "box: {size: [40, 30]}\n", wire = "box: {length: 40}\n",
                      run = "run: {until: 9}\n",
                      back = "run: {until: 9, events: [{at: 4, reverse: velocities}]}\n";
    CHECK(kinds(box + "gas: [{name: a, count: 9}, {name: b, count: 9}]\n" + run) ==
          Kinds{"speed-histogram", "energy-by-species"});
    // A mean energy of one species is constant.
    CHECK(kinds(box + "gas: [{count: 9}]\n" + run) == Kinds{"speed-histogram", "energy-histogram"});
    CHECK(kinds(box + "gas: [{count: 9}]\n" + back).at(1) == "return-distance");
    CHECK(kinds("box: {size: [40, 30], walls: {left: {temperature: 2}}}\ngas: [{count: 9}]\n" + run)
              .at(1) == "temperature");
    // Equal beads only exchange their velocities.
    CHECK(kinds(wire + "gas: [{count: 9, speed: 1}]\n" + run) == Kinds{"phase"});
    CHECK(kinds(wire + "gas: [{count: 9, mass: [1, 2, 3, 4, 5, 6, 7, 8, 9]}]\n" + run).at(0) ==
          "speed-histogram");
}
