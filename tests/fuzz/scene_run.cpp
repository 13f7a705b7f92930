// Fuzz target: takes a small scene of the library and sets other values for its keys, built from
// the input with the table of keys so that most are valid. Then, as the input says, runs it, draws
// a frame of its film, or draws a few figures. What takes too long is interrupted.
#include <fmt/format.h>
#include <sys/time.h>

#include <array>
#include <csignal>

#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "films/first_pass.h"
#include "films/render.h"
#include "fuzz/fuzz.h"
#include "panels/registry.h"
#include "physics/collision_error.h"
#include "runs/own_files.h"
#include "runs/run.h"
#include "scene/reading/scene_reading.h"
#include "scene/time/timeline.h"

using namespace carom;
using test::FuzzInput;

namespace {

struct Base {
    const char* name;
    Overrides smaller;  ///< overrides with which the scene takes milliseconds
};

const std::vector<Base>& bases() {
    static const std::vector<Base> all{
        {"cradle",
         {"film.panels=[entropy]", "film.beside={set: gas.0.mass=1, own_label: A, label: B}"}},
        {"tonks-gas", {}},
        {"pi-from-collisions", {}},
        {"gaslab/single-collision", {}},
        {"gaslab/second-law", {"gas.0.count=30"}},
        {"gaslab/adiabatic-piston", {"gas.0.count=20"}},
        {"gaslab/maxwells-demon", {"gas.0.count=30"}},
        {"gaslab/gravity-box", {"gas.0.count=10"}},
        {"heat-flow", {"gas.0.count=12"}},
        {"periodic-gas", {"gas.0.count=20"}},
        {"mixed-masses",
         {"gas.0.count=10", "gas.1.count=5",
          "run.events=[{at: 4, reverse: velocities}, {at: 5, caption: Back}]"}},
        {"classics/sinai-billiard", {}}};
    return all;
}

// Boxes with three lengths: walls that act, gaps, obstacles under gravity, a reversal, demons.
const std::vector<Base>& bases_in_space() {
    static const std::vector<Base> all{
        {"periodic-gas",
         {"box={size: [12, 10, 8], walls: {left: {temperature: 2}, right: {velocity: -0.5, until: "
          "2}, back: diffuse, top: {mass: 5, force: -3}}}",
          "gas=[{name: a, count: 12, radius: 0.5, temperature: 1}]",
          "run.events=[{at: 2, hold: top}, {at: 4, release: top}]",
          "film.panels=[temperature, {kind: piston, surfaces: top}, {kind: profile, component: z}]",
          "film.camera=[{at: 3, view: [0, 0, 0, 6, 5, 4]}]"}},
        {"periodic-gas",
         {"box={size: [12, 10, 8]}",
          "partitions=[{name: window, x: 6, gaps: [[2, 2, 5, 5], [6, 2, 8, 7]]}, {name: lid, y: 8, "
          "mass: 4}]",
          "gas=[{name: a, count: 8, radius: 0.4, speed: 1, position: {within: [0, 0, 0, 6, 8, "
          "8]}}, "
          "{name: b, count: 3, radius: 0.6, mass: 4, temperature: 1, position: {within: [6, 0, 0, "
          "12, 8, 8]}}]",
          "run.events=[{at: 3, open: window}]",
          "film.panels=[{kind: sides, surfaces: window}, flux, {kind: thermometer, regions: "
          "[{name: low, within: [0, 0, 0, "
          "6, "
          "8, 4]}, {name: high, within: [0, 0, 4, 6, 8, 8]}]}]"}},
        {"periodic-gas",
         {"box={size: [12, 10, 8], walls: {left: periodic, right: periodic}}", "gravity=[0, -1, 0]",
          "obstacles=[{name: ball, sphere: [5, 4, 4], radius: 1.5}, {name: block, cuboid: [8, 0, "
          "2, "
          "10, 3, 6]}]",
          "gas=[{name: a, count: 8, radius: 0.4, speed: 2}]",
          "film.panels=[energy-account, mean-free-path, {kind: flux, line: {z: 4, between: [1, 1, "
          "7, "
          "7]}}]"}},
        {"periodic-gas",
         {"box={size: [8, 8, 8]}",
          "gas=[{name: a, count: 8, radius: 0.8, speed: 1}, {name: b, count: 4, radius: 0.3, mass: "
          "0.2, temperature: 2}]",
          "run.precision=auto", "run.events=[{at: 2, reverse: velocities}]",
          "film.panels=[return-distance, entropy, speed-histogram]"}},
        {"periodic-gas",
         {"box={size: [14, 8, 8]}",
          "partitions=[{name: demon, x: 7, gaps: [[3, 3, 5, 5]], passes: {to_right: {faster_than: "
          "1}, to_left: {slower_than: 1}}}]",
          "gas=[{name: a, count: 12, radius: 0.3, temperature: 1}]",
          "run.events=[{at: 2, wall: front, temperature: 3}, {at: 3, nudge: {particle: 0, by: "
          "[1e-6, 0, 0]}}]",
          "film.panels=[temperature, mean-squared-displacement, orientational-order]"}}};
    return all;
}

// A word of the scene language that has one of the forms, or almost has it.
std::string value_of(const std::vector<Form>& forms, FuzzInput& input, int depth);

std::string number(const Form& form, FuzzInput& input) {
    static const std::vector<std::string> any{"1",    "2",     "0.5",    "3",    "10",    "0.1",
                                              "7.25", "0",     "-1",     "-0.5", "50",    "1e-3",
                                              "1000", "1e-9",  "1e-12",  "1e12", "1e9",   "1e300",
                                              "-0",   "4e-13", "123456", ".nan", "1e-300"};
    const std::size_t which = input.below(any.size() + 2);
    if (which < any.size()) return any[which];
    return fmt::format("{}", which == any.size() ? form.range.low : form.range.most.value);
}

std::string list(const Form& form, FuzzInput& input, int depth) {
    std::string items;
    const std::size_t count = input.below(4);
    for (std::size_t k = 0; k < count; ++k)
        items += (k == 0 ? "" : ", ") + value_of(form.items, input, depth + 1);
    return "[" + items + "]";
}

std::string mapping(const Section& section, FuzzInput& input, int depth) {
    std::string text;
    const auto add = [&](const Key& key) {
        text +=
            (text.empty() ? "" : ", ") + key.name + ": " + value_of(key.forms, input, depth + 1);
    };
    for (const Key& key : section.keys)
        if (key.required) add(key);
    const std::size_t more = section.keys.empty() ? 0 : input.below(4);
    for (std::size_t k = 0; k < more; ++k)
        if (const Key& key = input.one_of(section.keys); !key.required) add(key);
    return "{" + text + "}";
}

std::string value_of(const std::vector<Form>& forms, FuzzInput& input, int depth) {
    static const std::vector<std::string> texts{
        "a",   "gas", "wall", "left", "piston", "\"\"", "$x^2$", "'$'", "'{temperature}'",
        "ä→𝄞", "~",   "now",  "0"};
    static const std::vector<std::string> colors{"red", "'#12ab'", "'#0072b2'", "none"};
    constexpr int deepest = 6;
    if (forms.empty() || depth > deepest) return "1";
    const Form& form = input.one_of(forms);
    switch (form.shape) {
        case Shape::number:
        case Shape::integer:
            return number(form, input);
        case Shape::length:
            return number(form, input) +
                   input.one_of(std::vector<std::string>{"", " cm", "pt", " yd"});
        case Shape::flag:
            return input.below(2) == 0 ? "true" : "false";
        case Shape::word:
            return form.words.empty() ? "a" : input.one_of(form.words);
        case Shape::color:
            return input.one_of(colors);
        case Shape::list:
            return list(form, input, depth);
        case Shape::mapping:
            return form.section ? mapping(*form.section, input, depth) : "{}";
        case Shape::text:
            break;
    }
    return form.words.empty() || input.below(2) == 0 ? input.one_of(texts)
                                                     : input.one_of(form.words);
}

// One key of the scene, or one inside it, with a value.
std::string change_of(const Section& scene, FuzzInput& input) {
    const Key* key = &input.one_of(scene.keys);
    std::string path = key->name;
    for (const Section* inner = section_in(key->forms); inner != nullptr && input.below(4) != 0;
         inner = section_in(key->forms)) {
        const bool is_list = key->forms.front().shape == Shape::list;
        if (is_list) path += input.below(3) == 0 ? ".1" : ".0";
        key = &input.one_of(inner->keys);
        path += "." + key->name;
    }
    return path + "=" + value_of(key->forms, input, 0);
}

const Section& keys_of_scene(int dimension) {
    static const Section plane = scene_table(panel_kinds(), 2).section();
    static const Section space = scene_table(panel_kinds(), 3).section();
    return dimension == 2 ? plane : space;
}

constexpr std::size_t works = 3;  // a run, a frame, figures

// What the first bytes of an input choose.
struct FuzzCase {
    const Base* base;
    int dimension;
    std::size_t work, kind;  // 1 to `works`; of the figures
};

FuzzCase case_of(FuzzInput& input) {
    constexpr std::size_t first_in_space = 240;
    const std::size_t first = input.byte(), kind = input.byte();
    const std::size_t in_space = first - first_in_space;  // wraps around below
    if (in_space < works * bases_in_space().size())
        return {&bases_in_space()[in_space % bases_in_space().size()], 3,
                in_space / bases_in_space().size() + 1, kind};
    const std::size_t which = first % ((works + 1) * bases().size());
    const std::size_t asked = which / bases().size();
    return {&bases()[which % bases().size()], 2, asked == 0 ? kind % works + 1 : asked, kind};
}

// A list of up to three figures, of consecutive kinds from `first` on that show something of the
// scene.
std::string figures_of(const Scene& scene, std::size_t first) {
    std::string list;
    const PanelKinds kinds = panel_kinds();
    for (std::size_t k = 0, found = 0; k < kinds.size() && found < 3; ++k) {
        const PanelKind& kind = kinds[(first + k) % kinds.size()];
        const bool suits = !kind.suits || kind.suits(scene.gas, scene.run);
        if (!suits || kind.can(Ability::two) || kind.name == "text" || kind.name == "sweep")
            continue;
        list += fmt::format("{}{{name: f{}, kind: {}, size: 3}}", found++ == 0 ? "" : ", ", k,
                            kind.name);
    }
    return "figures=[" + list + "]";
}

bool is_small(const Scene& scene) {
    std::int64_t particles = 0;
    for (const Species& species : scene.gas.species) particles += species.count;
    const PictureSize size = scene.film.size;
    return particles <= 150 && size.width * size.height <= 500'000 &&
           frame_count(scene.film) <= 120 && scene.run.bits.value_or(0) <= 256;
}

// Interrupts the work after a limit of CPU time.
class TimeLimit {
  public:
    TimeLimit() {
        constexpr int most_microseconds = 15'000;
        std::signal(SIGVTALRM, [](int) { set_interrupted(true); });
        start(most_microseconds);
    }
    ~TimeLimit() {
        start(0);
        set_interrupted(false);
    }
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

  private:
    static void start(int microseconds) {
        const itimerval timer{.it_interval = {}, .it_value = {0, microseconds}};
        setitimer(ITIMER_VIRTUAL, &timer, nullptr);
    }
};

// CollisionError: how Simulation::advance_to() ends if collisions accumulate without end.
template <class Work>
void run_for_a_while(const Work& work) {
    test::succeeds([&] {
        const TimeLimit limit;
        try {
            work();
        } catch (const CollisionError&) {
        }
    });
}

void draw_frame(const Scene& scene, double at) {
    Progress progress(Progress::Form::silent, "");
    const FilmPlan plan = prepare(scene, {}, progress);
    for (const char* format : {"png", "svg"})
        draw_still(plan, at, output_format(format), progress).file();
}

void draw_figures(const Scene& scene) {
    const FigureRun run(scene);
    for (const Figure& figure : run.figures()) {
        const FigureWords words = words_of(run, figure);
        draw_figure(run, figure, VectorFormat::svg, {scene.title, words.alt}).file();
        csv(table_of(figure));
    }
}

}  // namespace

void test::fuzz(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t most = 12;
    FuzzInput input(data, size);
    const FuzzCase chosen = case_of(input);
    const double at = input.byte() / 255.0;
    Overrides changes{"run={until: 8}", "film={size: [160, 120], fps: 3, seconds: 4}",
                      "figures=[]"};
    changes.insert(changes.end(), chosen.base->smaller.begin(), chosen.base->smaller.end());
    static const SceneResources resources = scene_resources();
    const std::filesystem::path path =
        library_folder() / (std::string(chosen.base->name) + ".yaml");
    Scene scene;
    const bool is_whole = input.is_at_end();
    for (std::size_t k = 0; k < most && !input.is_at_end(); ++k)
        changes.push_back(change_of(keys_of_scene(chosen.dimension), input));
    if (!test::succeeds([&] { scene = load_scene(path, resources, changes); })) {
        if (is_whole) std::abort();
        return;
    }
    if (!is_small(scene)) return;
    if (chosen.work == 1) run_for_a_while([&] { run_physics(scene); });
    if (chosen.work == 2) run_for_a_while([&] { draw_frame(scene, at * scene.run.until); });
    if (chosen.work == 3)
        run_for_a_while([&] {
            changes.push_back(figures_of(scene, chosen.kind));
            draw_figures(load_scene(path, resources, changes));
        });
}
