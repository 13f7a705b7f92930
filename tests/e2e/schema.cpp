// carom schema against an independent validator, Debian's python3-jsonschema: it takes every good
// scene and refuses every bad one whose fault one place of a scene can show.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

// Debian's own: another one on PATH does not see Debian's packages.
const std::string python = "/usr/bin/python3";

// What the validator says of each file: null where it takes it.
json verdicts(const std::vector<fs::path>& files, const std::string& what = "scene",
              const std::vector<std::string>& options = {}) {
    const TemporaryFolder folder;
    const fs::path schema = folder.path() / "schema.json";
    const Outcome made = run({program, "schema", "--for", what});
    REQUIRE(made.exit_code == 0);
    CHECK(made.err.empty());
    std::ofstream(schema) << made.out;
    std::vector<std::string> command{python, (root / "tests/support/validate.py").string()};
    command.insert(command.end(), options.begin(), options.end());
    command.push_back(schema.string());
    for (const fs::path& file : files) command.push_back(file.string());
    const Outcome outcome = run(command);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out);
}

const char* const several_places = "the fault is between several places, or in what numbers mean";
const char* const other_file = "the fault is in the template, which is another file";
const char* const below_json = "YAML that no JSON can show";

// Bad scenes that the schema takes, and why it cannot do otherwise.
const std::map<std::string, const char*> beyond_the_schema{
    {"beside_box", several_places},        // a changed value against the scene
    {"beside_elsewhere", several_places},  // the ending and the folder of a name
    {"beside_film", several_places},
    {"beside_overlaid_field", several_places},
    {"beside_overlaid_wire", several_places},
    {"beside_panel", several_places},
    {"beside_reversal", several_places},
    {"beside_until", several_places},
    {"beside_value", several_places},
    {"captions_cut", several_places},         // times against the film's length
    {"collision_map_plane", several_places},  // a kind against the box
    {"count_missing", several_places},        // a count, or a list of positions
    {"event_at_the_end", several_places},     // `at` against `until`
    {"gas_reduced", several_places},          // `gas` against `units`
    {"film_fade_out", several_places},        // a region against the box
    {"film_trails_seeds", several_places},    // against the dimension
    {"profile_around", several_places},       // keys against one another, a point against the box
    {"profile_around_wire", several_places},
    {"run_distance_alone", several_places},  // a panel against `beside`
    {"events_in_two_frames", several_places},
    {"events_paced", several_places},
    {"events_too_dense", several_places},
    {"figure_sweep_elsewhere", several_places},  // the folder of a name
    {"figure_compare_run", several_places},      // `set` of a run against the scene
    {"figure_sweep_dashes", several_places},     // values of `vary` against the scene
    {"figure_sweep_point", several_places},      // values of `vary` against the scene
    {"figure_test_few", several_places},         // its particles against what it counts
    {"figure_test_over", several_places},
    {"film_callout_show", several_places},
    {"film_camera_ring", several_places},  // what is followed against the box
    {"film_field", several_places},        // a name against the gas
    {"film_field_share", several_places},  // `of` against `species`
    {"film_field_species", several_places},
    {"film_pauses", several_places},  // their sum against the film's length
    {"film_pauses_paced", several_places},
    {"film_slow_between", several_places},  // spans against one another and the film's length
    {"film_slow_in", several_places},
    {"film_slow_out", several_places},
    {"film_slow_paced", several_places},
    {"film_slow_too_short", several_places},
    {"film_streaks_line", several_places},  // the key against the box
    {"film_too_long", several_places},      // seconds, or until / pace, times fps
    {"film_too_many_frames", several_places},
    {"film_too_short", several_places},
    {"open_partition_leaves", several_places},  // a motion against the box
    {"open_piston", several_places},
    {"open_piston_start", several_places},
    {"beside_missing", "the fault is in what lies beside the scene"},
    {"range_narrow", several_places},
    {"drawn_smaller", several_places},          // a radius against another
    {"histogram_part_tested", several_places},  // keys against one another
    {"histogram_parts", several_places},        // names against the box
    {"dials_closed", several_places},           // what lets particles through
    {"dials_wire", several_places},             // a line against the box
    {"instruments", several_places},            // names against the box, and what moves
    {"formula", "a formula has a grammar of its own"},
    {"jam_around", several_places},
    {"jam_lattice", several_places},
    {"jam_row", several_places},
    {"jam_wide", several_places},
    {"lattice", several_places},
    {"list_lengths", several_places},     // against the count
    {"nudge_in_double", several_places},  // `by` against `precision`
    {"outside", several_places},
    {"overlap", several_places},
    {"overlap_around", several_places},
    {"packing", several_places},
    {"panels_correlations", several_places},  // distances and times against the box and `until`
    {"panels_correlations_obstacle", several_places},
    {"panels_displacement", several_places},  // times against `until`
    {"panels_order_wire", several_places},
    {"panels_range", several_places},
    {"space_compared", several_places},
    {"space_events", several_places},  // names and lengths against the box
    {"space_film", several_places},    // what is drawn against the box
    {"space_letters", several_places},
    {"space_overlaid", several_places},
    {"space_places", several_places},
    {"space_surfaces", several_places},  // places against the box
    {"space_walls", several_places},     // a side against the opposite one
    {"speed_alone", several_places},     // speeds against walls and counts
    {"speed_unbalanced", several_places},
    {"speed_wire", several_places},
    {"surface_diffuse_reversal", several_places},  // a wall against an event
    {"surface_diffuse_wire", several_places},      // a wall against the box
    {"time_step_precision", several_places},       // the step against `precision`
    {"time_step_wire", several_places},
    {"precision", "53 bits are a double, those between 53 and 64 are nothing"},
    {"reversal_no_way_home", several_places},  // `at` against `until`
    {"radius_too_large", several_places},
    {"sample_every", several_places},
    {"surface_crushes", several_places},     // velocity and times against the box and the gas
    {"surface_in_the_way", several_places},  // places against partitions and obstacles
    {"surface_reaches", several_places},
    {"surface_reversal", several_places},  // a reversal against walls
    {"surface_reversal_demon", several_places},
    {"template_caption", other_file},
    {"template_hidden", other_file},
    {"template_link", other_file},
    {"template_overlap", other_file},
    {"template_slots", other_file},
    {"theory_alone", several_places},  // `theory` against what is in the gas
    {"theory_at_rest", several_places},
    {"theory_drifts", several_places},
    {"theory_equal_masses", several_places},
    {"theory_growth_mixed", several_places},
    {"theory_piston", several_places},
    {"total_too_large", several_places},
    {"viewpoint_plane", several_places},  // against the box
    {"wire_filling", several_places},
    {"wire_full", several_places},
    {"wire_full_between", several_places},
    {"wire_outside", several_places},
    {"wire_outside_around", several_places},
    {"wire_overlap", several_places},
    {"wire_piston_presses", several_places},
    {"wire_pistons_meet", several_places},
    {"wire_too_long", several_places},
    {"within", several_places},
    {"words_overlap", several_places},
    {"numbers-in-words", several_places},  // names against the species, times against the run
    {"panels_beyond", other_file},         // the template's places
    {"panels_in_square", other_file},
    {"panels_too_many", other_file},
    {"template_broken", other_file},
    {"template_not_yaml", other_file},
    {"template_extension", other_file},
    {"template_nowhere", other_file},
    {"template_path", other_file},
    {"template_unknown", other_file},
    {"yaml_tag", below_json},
};

struct Case {
    std::string scene;
    bool good;
};

// Each by the validator and by carom check, from files in the folder.
void compare_verdicts(const TemporaryFolder& folder, const std::vector<Case>& all,
                      const std::string& what) {
    std::vector<fs::path> files;
    for (std::size_t i = 0; i < all.size(); ++i)
        files.push_back(folder.write(std::to_string(i) + ".yaml", all[i].scene));
    const json found = verdicts(files, what);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const json verdict = found.at(files[i].string());
        const Outcome outcome = run({program, "check", "--quiet", files[i].string()});
        CAPTURE(all[i].scene);
        CAPTURE(verdict);
        CAPTURE(outcome.err);
        CHECK(verdict.is_null() == all[i].good);
        CHECK(outcome.exit_code == (all[i].good ? 0 : 2));
    }
}

std::string with_comparison(const std::string& options) {
    return "title: T\nscenes: [scene.yaml]\ncomparisons: [{name: c, kind: entropy, " + options +
           "}]\n";
}

// Sets with one fault each, or none; beside them lies a good scene, scene.yaml, whose figures are a
// and b.
const std::vector<Case> sets{
    {"title: T\nscenes: [scene.yaml]\n", true},
    {"title: T\nscenes: [{scene: scene.yaml, title: Other, figures: [b, a]}]\n", true},
    {"title: T\nscenes: []\n", false},
    {"title: T\n", false},
    {"scenes: [scene.yaml]\n", false},
    {"title: T\nscenes: [scene.yaml]\nbox: {size: [1, 1]}\n", false},
    {"title: T\nscenes: [{title: Other}]\n", false},
    {"title: T\nscenes: [{scene: scene.yaml, figure: [a]}]\n", false},
    {"title: T\nscenes: [scene.yaml]\nformats: [svg, csv]\ntemplate: [html, latex]\n", true},
    {"title: T\nscenes: [scene.yaml]\nformats: svg\n", false},
    {"title: T\nscenes: [scene.yaml]\nformats: [jpg]\n", false},
    {with_comparison("scenes: [scene.yaml, {scene: scene.yaml, label: x, set: seed=2}]"), true},
    {with_comparison("at: 3, scenes: [scene.yaml, {scene: scene.yaml, label: x, set: [seed=2]}]"),
     true},
    {with_comparison("scenes: [scene.yaml]"), false},
    {with_comparison("scenes: [scene.yaml, {scene: scene.yaml}], seeds: 3"), false},
    {with_comparison("scenes: [scene.yaml, {label: x}]"), false},
    {with_comparison("bins: 9, scenes: [scene.yaml, {scene: scene.yaml, label: x}]"), false},
    {with_comparison("at: 3, over: [1, 3], scenes: [scene.yaml, {scene: scene.yaml, label: x}]"),
     false},
    {"title: T\nscenes: [scene.yaml]\ncomparisons: [{name: c, kind: gas, scenes: [scene.yaml, "
     "{scene: scene.yaml, label: x}]}]\n",
     false},
};

// A scene of a plane, one of a wire and one of space, and lines that replace the one with the same
// key.
std::string plane(const std::string& species, const std::string& more = "") {
    return "title: T\nbox: {size: [40, 30]}\ngas: [{name: a, count: 2" + species +
           "}]\nrun: {until: 10}\n" + more;
}

std::string wire(const std::string& species, const std::string& box = "length: 40") {
    return "title: T\nbox: {" + box + "}\ngas: [{name: a, count: 2" + species +
           "}]\nrun: {until: 10}\n";
}

std::string space(const std::string& species, const std::string& more = "",
                  const std::string& box = "size: [40, 30, 20]") {
    return "title: T\nbox: {" + box + "}\ngas: [{name: a, count: 2" + species +
           "}]\nrun: {until: 10}\n" + more;
}

// One fault each, or none.
const std::vector<Case> cases{
    {plane(""), true},
    {wire(""), true},
    {plane(", position: lattice, mass: infinite, color: teal"), true},
    {plane(", position: lattice, mass: infinite, color: biege"), false},
    {plane(", radius: {uniform: [0.1, 1e0]}, velocity: [1, -2]"), true},
    {plane(", radius: {uniform: [0.1, 1], normal: [1, 0.1]}"), false},
    {plane(", radius: {}"), false},
    {plane(", velocity: [1, 2, 3]"), false},
    {plane(", velocity: 3"), false},
    {wire(", velocity: 3"), true},
    {wire(", velocity: [1, 2]"), true},
    {wire(", velocity: [[1, 2], [1, 2]]"), false},
    {plane(", radius: 0"), false},
    {wire(", radius: 0"), true},
    {plane(", drawn_radius: 1"), true},
    {wire(", drawn_radius: 1"), true},
    {plane(", mass: 1, density: 1"), false},
    {plane(", speed: 1, temperature: 1"), false},
    {plane(", count: 2.0").replace(plane("").find(", count: 2"), 10, ""), true},
    {plane(", speed: yes"), false},
    {plane(", speed: \"1\""), false},
    {plane(", label: 7"), true},
    {plane(", position: {within: [1, 1, 9, 9]}"), true},
    {plane(", position: {within: [1, 9]}"), false},
    {wire(", position: {within: [1, 9]}"), true},
    {wire("", "length: 40, walls: {left: periodic, right: periodic}"), true},
    {wire("", "length: 40, walls: {left: solid, top: solid}"), false},
    {wire("", "length: 40, size: [40, 40]"), false},
    {space(""), true},
    {space(", velocity: [1, 2, 3], position: {within: [1, 1, 1, 9, 9, 9]}"), true},
    {space(", velocity: [1, 2]"), false},
    {space(", position: {within: [1, 1, 9, 9]}"), false},
    {space("", "gravity: [0, -1, 0]\npartitions: [{z: 5, gaps: [[1, 2, 3, 4]]}]\n"), true},
    {space("", "partitions: [{z: 5, gaps: [[1, 2]]}]\n"), false},
    {space("", "obstacles: [{sphere: [9, 9, 9], radius: 2}]\n"), true},
    {space("", "obstacles: [{disk: [9, 9], radius: 2}]\n"), false},
    {space("", "", "size: [40, 30, 20], walls: {back: periodic, front: periodic}"), true},
    {space("", "", "size: [40, 30, -20]"), false},
    {space("", "", "size: [40, 30, 20, 10]"), false},
    {plane("", "obstacles: [{sphere: [9, 9, 9], radius: 2}]\n"), false},
    {plane("", "partitions: [{z: 5}]\n"), false},
    {plane("", "carom: 2\n"), false},
    {plane("", "seed: -1\n"), false},
    {plane("", "seed: 9007199254740991\n"), true},
    {plane("", "seed: 9007199254740992\n"), false},
    {plane("", "subtitle: \"\"\n"), true},
    {plane("", "subtitle: \"a\\nb\"\n"), false},
    {plane("", "subtitle: >\n  a\n  b\n"), true},
    {plane("", "description: \"\"\n"), false},
    {plane("", "description: |\n  a\n  b\n"), true},
    {plane("", "film: {seconds: 5, size: [640, 360], panels: [speed-histogram]}\n"), true},
    {plane("", "film: {seconds: 5, pace: 1}\n"), false},
    {plane("", "film: {panels: [{kind: speed-histogram, bins: 10, theory: false}]}\n"), true},
    {plane("", "film: {panels: [{kind: energy-by-species, bins: 10}]}\n"), false},
    {plane("", "film: {panels: [{title: words}]}\n"), false},
    {plane("", "film:\n"), false},
    {plane("", "film: {spotlight: [{from: 1, of: a}]}\n"), true},
    {plane("", "film: {spotlight: [{from: 1, on: a}]}\n"), true},
    {plane("", "film: {spotlight: [{from: 1, of: a, on: a}]}\n"), false},
    {plane("", "film: {spotlight: [{from: 1}]}\n"), false},
    {plane("", "film: {callouts: [{at: 1, points_to: 0, text: t}]}\n"), true},
    {plane("", "film: {callouts: [{at: 1, on: 0, text: t}]}\n"), true},
    {plane("", "film: {callouts: [{at: 1, text: t}]}\n"), false},
};

}  // namespace

TEST_CASE("the schema in scenes/ is current") {
    const bool current =
        contents(root / "scenes/scene.schema.json") == run({program, "schema"}).out;
    INFO("make it anew with ./dev docs");
    CHECK(current);
}

TEST_CASE("the schema of styles is current, and the library's styles fit it and name it") {
    const fs::path styles = root / "templates/styles";
    const bool current =
        contents(styles / "style.schema.json") == run({program, "schema", "--for", "style"}).out;
    INFO("make it anew with ./dev docs");
    CHECK(current);
    const std::vector<fs::path> files = yaml_files(styles);
    CHECK(files.size() >= 2);
    const json found = verdicts(files, "style");
    for (const fs::path& file : files) {
        CAPTURE(file.string());
        CHECK(found.at(file.string()).is_null());
        CHECK(contents(file).starts_with("# yaml-language-server: $schema=style.schema.json\n"));
    }
}

TEST_CASE("the schema of sets is current, and the library's sets fit it and name it") {
    const bool current =
        contents(root / "scenes/set.schema.json") == run({program, "schema", "--for", "set"}).out;
    INFO("make it anew with ./dev docs");
    CHECK(current);
    const std::vector<fs::path> files = yaml_files(root / "scenes/sets");
    CHECK(files.size() >= 2);
    const json found = verdicts(files, "set");
    const std::string mark = "# yaml-language-server: $schema=";
    for (const fs::path& file : files) {
        CAPTURE(file.string());
        CHECK(found.at(file.string()).is_null());
        const std::string text = contents(file);
        REQUIRE(text.starts_with(mark));
        const std::string schema = text.substr(mark.size(), text.find('\n') - mark.size());
        CHECK(fs::equivalent(file.parent_path() / schema, root / "scenes/set.schema.json"));
    }
    CHECK(run({program, "schema", "--for", "film"}).exit_code == 2);
}

TEST_CASE("the schema of sets and carom check say the same of single faults") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 plane("",
                       "film: {seconds: 1}\nfigures: [{name: a, kind: entropy}, {name: b, "
                       "kind: gas}]\n"));
    compare_verdicts(folder, sets, "set");
}

TEST_CASE("every good scene fits the schema") {
    std::vector<fs::path> scenes = carom::test::library_files();
    for (const fs::path& scene : yaml_files(root / "tests/golden")) scenes.push_back(scene);
    CHECK(scenes.size() >= 5);
    const json found = verdicts(scenes);
    for (const auto& one : found.items()) {
        const auto& file = one.key();
        const auto& verdict = one.value();
        CAPTURE(file);
        CAPTURE(verdict);
        CHECK(verdict.is_null());
    }
}

// PyYAML, and what is built on it, reads YAML 1.1: `on` is true there, and `1e-20` a text.
TEST_CASE("every scene and set of the library fits the schema for readers of YAML 1.1, too") {
    const auto check = [](const std::vector<fs::path>& files, const std::string& what) {
        CHECK(files.size() >= 2);
        const json all = verdicts(files, what, {"--yaml-1.1"});
        for (const auto& [file, verdict] : all.items()) {
            CAPTURE(file);
            CAPTURE(verdict);
            CHECK(verdict.is_null());
        }
    };
    check(carom::test::library_files(), "scene");
    std::vector<fs::path> panels = yaml_files(root / "docs/panels");
    std::erase(panels, root / "docs/panels/panels.yaml");  // a set
    check(panels, "scene");
    check(yaml_files(root / "scenes/sets"), "set");
}

TEST_CASE("every bad scene is refused by the schema, where a schema can") {
    std::vector<fs::path> scenes = yaml_files(root / "tests/scenes_bad");
    std::erase_if(scenes, [](const fs::path& scene) {  // templates
        return scene.stem().string().starts_with("with_");
    });
    std::size_t taken = 0;
    const json found = verdicts(scenes);
    for (const auto& one : found.items()) {
        const auto& file = one.key();
        const auto& verdict = one.value();
        const auto reason = beyond_the_schema.find(fs::path(file).stem().string());
        CAPTURE(file);
        CAPTURE(verdict);
        const bool beyond = reason != beyond_the_schema.end();
        const std::string why = beyond ? reason->second : "a schema can show it";
        CAPTURE(why);
        CHECK(verdict.is_null() == beyond);
        taken += verdict.is_null() ? 1 : 0;
    }
    CHECK(taken == beyond_the_schema.size());
}

TEST_CASE("the schema and the loader say the same of single faults") {
    compare_verdicts(TemporaryFolder(), cases, "scene");
}
