// What lecturers are likely to write wrongly in a scene: for each mistake its place, and the hint.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "panels/registry.h"
#include "scene/load.h"
#include "scene/scene.h"
#include "support/test_root.h"

using namespace carom;

namespace {

const std::string right = R"(title: A gas
box: {size: [40, 30]}
gas:
  - {name: a, count: 20, radius: 0.5, temperature: 1}
run: {until: 10}
film:
  seconds: 5
  panels: [speed-histogram]
figures:
  - {name: f, kind: speed-histogram, at: 5}
)";

/// A text of the right scene, what is written instead, the line and column of the first error, and
/// how its hint begins.
struct Slip {
    std::string text, instead, place, hint;
};

const std::vector<Slip>& slips() {
    static const std::vector<Slip> all{
        {"until: 10", "until: 10 s", "5:14",
         "write `10`: numbers have units only in a scene with `units: real`"},
        {"seconds: 5", "seconds: 5s", "7:12",
         "write `5`: numbers have units only in a scene with `units: real`"},
        {"size: [40, 30]", "size: [40cm, 30cm]", "2:14",
         "write `40`: numbers have units only in a scene with `units: real`"},
        {"radius: 0.5", "radius: 50%", "4:34", "write `0.5`"},
        {"run: {until: 10}", "run:\n  until: 10,5", "6:10", "write `10.5`, with a point"},
        {"radius: 0.5", "radius: 0,5", "4:34", "for instance `1`, or any other number above 0"},
        {"count: 20", "count: 1,000", "4:24",
         "a comma separates keys; write thousands without it: 1000"},
        {"count: 20", "count: twenty", "4:22", "for instance `1`"},
        {"count: 20", "count: 20.5", "4:22", "write `20` or `21`"},
        {"count: 20", "count: 0", "4:22", "the smallest is 1"},
        {"radius: 0.5", "radius: -0.5", "4:34", "write `0.5`, without the minus sign"},
        {"temperature: 1", "temperature: 1, mass: 0", "4:61",
         "for instance `1`, or any other number above 0"},
        {"temperature: 1", "temperature: 1, mass: inf", "4:61", "did you mean `infinite`?"},
        {"temperature: 1", "temperature: 300K", "4:52",
         "write `300`: numbers have units only in a scene with `units: real`"},
        {"temperature: 1", "temperature: 20°C", "4:52",
         "write `20`: numbers have units only in a scene with `units: real`"},
        {"temperature: 1", "temperature: hot", "4:52", "write a number, or give {exact: T}"},
        {"temperature: 1", "temperature: -1", "4:52", "write `1`, without the minus sign"},
        {"seconds: 5", "seconds: 5\n  fps: 0", "8:8", "the smallest is 1"},
        {"seconds: 5", "seconds: 5\n  fps: 29.97", "8:8", "write `29` or `30`"},
        {"seconds: 5", "seconds: 5\n  fps: 240", "8:8",
         "the limit is 120 frames in a second of film"},
        {"seconds: 5", "seconds: 5\n  size: HD", "8:9", "HD is `720p`, full HD is `1080p`"},
        {"seconds: 5", "seconds: 5\n  size: 1920x1080", "8:9", "write `[1920, 1080]`"},
        {"seconds: 5", "seconds: 5\n  size: Full HD", "8:9", "full HD is `1080p`"},
        {"seconds: 5", "seconds: 5\n  size: 1080", "8:9", "did you mean `1080p`?"},
        {"seconds: 5", "seconds: 5\n  size: {width: 1920, height: 1080}", "8:9",
         "write `[1920, 1080]`"},
        {"seconds: 5", "seconds: 5\n  size: 16:9", "8:9", "or give [width, height]"},
        {"  seconds: 5", "\tseconds: 5", "7:9", "indent with spaces, not with tabs"},
        {"seconds: 5", "seconds:\t5\n\tfps: 30", "8:1", "indent with spaces, not with tabs"},
        {"film:", "fillm:", "6:1", "did you mean `film`?"},
        {"film:", "Film:", "6:1", "did you mean `film`?"},
        {"seconds: 5", "Seconds: 5", "7:3", "did you mean `seconds`?"},
        {"seconds: 5", "seconds: 5\n  endCard: x", "8:3", "did you mean `end_card`?"},
        {"seconds: 5", "seconds: 5\n  color-by: speed", "8:3", "did you mean `color_by`?"},
        {"seconds: 5", "seconds: 5\n  colour_by: speed", "8:3", "did you mean `color_by`?"},
        {"radius: 0.5", "radius: 0.5, colour: red", "4:39", "did you mean `color`?"},
        {"radius: 0.5", "radius: 0.5, color: \"rgb(255,0,0)\"", "4:46", "write `\"#ff0000\"`"},
        {"radius: 0.5", "radius: 0.5, color: #ff0000", "10:3",
         "`#` begins a comment; put the colour in quotes"},
        {"radius: 0.5", "radius: 0.5, color: [255, 0, 0]", "4:46", "write `\"#ff0000\"`"},
        {"radius: 0.5", "radius: 0.5, color: dark blue", "4:46", "did you mean `darkblue`?"},
        {"radius: 0.5", "radius: 0.5, color: rot", "4:46",
         "names are `red`, `rosybrown`, `royalblue`, `rebeccapurple` and others; "
         "docs/scene-reference.md lists all"},
        {"radius: 0.5", "radius: 0.5, color: ff0000", "4:46",
         "write `#` before the digits, in quotes: \"#ff0000\""},
        {"radius: 0.5", "radius: 0.5, color: \"#f00\"", "4:46",
         "write it with six digits: \"#ff0000\""},
        {"panels: [speed-histogram]", "panels: [Speed-Histogram]", "8:12",
         "did you mean `speed-histogram`?"},
        {"panels: [speed-histogram]", "panels: [speed histogram]", "8:12",
         "did you mean `speed-histogram`?"},
        {"panels: [speed-histogram]", "panels: [speed_histogram]", "8:12",
         "did you mean `speed-histogram`?"},
        {"panels: [speed-histogram]", "panels: [speeds]", "8:12",
         "there are `speed-histogram`, `speed-classes`"},
        {"panels: [speed-histogram]", "panels: [histogram]", "8:12",
         "there are `speed-histogram`, `energy-histogram`, `velocity-histogram`, "},
        {"panels: [speed-histogram]", "panels: speed-histogram, entropy", "8:11",
         "write `[speed-histogram, entropy]`"},
        {"panels: [speed-histogram]", "panels: {kind: speed-histogram}", "8:11",
         "begin each item of the list with `- `, or put brackets around it: [{...}]"},
        {"panels: [speed-histogram]", "panels:\n    speed-histogram:\n      bins: 20", "9:5",
         "begin each item of the list with `- `, or put brackets around it: [{...}]"},
        {"panels: [speed-histogram]", "panels:\n    - speed-histogram:\n        bins: 20", "9:7",
         "write `kind: speed-histogram`"},
        {"panels: [speed-histogram]", "panels: none", "8:11", "write `[]`"},
        {"  - {name: a,", "  -{name: a,", "4:19", "put a space after the `-` of an item"},
        {"  - {name: a, count: 20, radius: 0.5, temperature: 1}",
         "  name: a\n  count: 20\n  radius: 0.5\n  temperature: 1", "4:3",
         "begin each item of the list with `- `, or put brackets around it: [{...}]"},
        {"  seconds: 5", "  seconds 5", "7:3", "put a colon and a space after a key: `seconds: 5`"},
        {"  seconds: 5", "  seconds = 5", "7:3",
         "put a colon and a space after a key: `seconds: 5`"},
        {"  seconds: 5", "  seconds:5", "7:3", "put a colon and a space after a key: `seconds: 5`"},
        {"  seconds: 5\n", "   seconds: 5\n", "8:3",
         "lines that belong together begin in the same column"},
        {"run: {until: 10}", "run: {until: 10", "5:6",
         "write `}` where it ends, and `,` between its items"},
        {"count: 20, radius", "count: 20; radius", "4:5", "a comma separates its items, not `;`"},
        {"count: 20, radius", "count: 20 radius", "4:5",
         "write `}` where it ends, and `,` between its items"},
        {"size: [40, 30]", "size: (40, 30)", "2:13", "lists are written in brackets: [1, 2]"},
        {"size: [40, 30]", "size: 40x30", "2:13", "write `[40, 30]`"},
        {"size: [40, 30]", "size: 40", "2:13", "two numbers: [width, height]"},
        {"size: [40, 30]", "size: [40, 30, 20, 10]", "2:13",
         "a box has a width and a height, and in space a depth"},
        {"size: [40, 30]", "width: 40, height: 30", "2:7",
         "did you mean `size`? Or, `width` is a key of a figure and `figure_defaults`"},
        {"run: {until: 10}", "run: {until: 10, fps: 30}", "5:18",
         "`fps` is a key of `film`; the keys of `run` are until, equilibrate, sample_every, "},
        {"run: {until: 10}", "until: 10", "1:1", "`run`: What happens to the gas."},
        {"film:\n  seconds: 5", "seconds: 5\nfilm:", "6:1", "`seconds` is a key of `film`"},
        {"title: A gas", "title: A gas\ntitle: B", "2:1", "remove one of them"},
        {"{name: f, kind: speed-histogram, at: 5}", "{kind: speed-histogram, at: 5}", "10:5",
         "`name`: The name of its files: lower-case letters, digits and hyphens."},
        {"at: 5}", "at: 50}", "10:42", "the run ends at 10"},
        {"name: f,", "name: a/b,", "10:12",
         "it names the figure's files, for instance one-hot-particle"},
        {"at: 5}", "at: [1, 5]}", "10:42",
         "a figure has one time; `strip` shows several side by side, in a figure of kind `gas`"},
        {"kind: speed-histogram, at", "kind: histogramm, at", "10:21",
         "there are `speed-histogram`, `energy-histogram`, `velocity-histogram`, "},
        {"at: 5}", "at: 5, format: png}", "10:45", "carom figures SCENE --formats svg,png"},
        {"at: 5}", "at: 5, width: 8em}", "10:52",
         "the units of lengths are cm, mm, in, pt and px: `8 cm`"},
        {"seconds: 5", "seconds: 5\n  template: lecture-hall", "8:13",
         "templates: data, hero, instrument, lecture, minimal, portrait, side-by-side, square, "
         "wide-gas"},
        {"seconds: 5", "seconds: 5\n  template: Lecture", "8:13", "did you mean `lecture`?"},
        {"seconds: 5", "seconds: 5\n  theme: black", "8:10", "did you mean `dark`?"},
        {"seconds: 5", "seconds: 5\n  font: Comic Sans", "8:3",
         "`style: house.yaml` at the top level of the file, and `font: NAME` in that file"},
        {"seconds: 5", "seconds: 5\n  language: deutsch", "8:13", "did you mean `de`?"},
        {"seconds: 5", "seconds: 5\n  language: it", "8:13", "for instance `en`"},
        {"seconds: 5", "seconds: 5\n  sound: yes", "8:10", "write `collisions`"},
        {"seconds: 5", "seconds: 5\n  sound: music.mp3", "8:10",
         "or give {of: collisions, loudness: 0.3}"},
        {"run: {until: 10}",
         "run:\n  until: 10\n  events:\n    - {at: 12, caption: late}\n    - {at: 3, caption: b}",
         "8:12", "the film ends at `until`: what happens at this time or later is never shown"},
        {"seconds: 5", "seconds: 5\n  captions: [{at: 1, text: a}]", "8:3",
         "`events: [{at: 1, caption: words}]` in `run`"},
        {"run: {until: 10}", "run:\n  until: 10\n  events:\n    - {at: 3, text: a}", "8:15",
         "did you mean `caption`? Or, `text` is a key of `position` and an item of `callouts`"},
        {"run: {until: 10}", "run:\n  until: 10\n  events:\n    - {time: 3, caption: a}", "8:8",
         "did you mean `at`?"},
        {"run: {until: 10}", "run:\n  until: 10\n  events: {at: 3, caption: a}", "7:11",
         "begin each item of the list with `- `, or put brackets around it: [{...}]"},
        {"run: {until: 10}", "run: {until: 10}\nevents: [{at: 3, caption: a}]", "6:1",
         "did you mean `run`? Or, `events` is a key of `run`"},
        {"run: {until: 10}", "run:\n  until: 10\n  events: [{at: 5, reverse: true}]", "7:29",
         "for instance `velocities`"},
        {"run: {until: 10}", "run:\n  until: 10\n  events: [reverse]", "7:12",
         "its keys are at, reverse, nudge, open, close, move, hold, release, wall, heat, mark, "},
        {"title: A gas", "title: Gas: the movie", "1:11", "a text with `: ` in it needs quotes"},
        {"title: A gas", "title: [1] A gas", "1:12",
         "nothing may follow a closing quote or bracket in the same line: leave out the rest, or "
         "put "},
        {"title: A gas", "title: *important* gas", "1:8",
         "write the value out, or quotes around a text that begins with `*`"},
        {"title: A gas", "title: @home", "1:8", "a text that begins with `@` needs quotes"},
        {"title: A gas", "title: %gas", "1:8", "a text that begins with `%` needs quotes"},
        {"title: A gas", "title: 'It's a gas'", "1:12",
         "nothing may follow a closing quote or bracket in the same line: leave out the rest, or "
         "put "},
        {"title: A gas", "title: \"A \"big\" gas\"", "1:12",
         "nothing may follow a closing quote or bracket in the same line: leave out the rest, or "
         "put "},
        {"title: A gas", "title:", "1:1", "for instance `words`"},
        {"title: A gas", "title: \"A gas\\ndescription: \"", "1:8", "leave out the `\\n`"},
        {"seconds: 5", "seconds: 5\n  end_card: $\\foo$", "8:14",
         "docs/films.md lists the commands of formulae"},
        {"seconds: 5", "seconds: 5\n  end_card: costs $5", "8:19", "write \\$ for a dollar sign"},
        {"radius: 0.5, temperature: 1", "radius: 0.5, temperature: 1, position: [[1,1],[1.2,1]]",
         "4:65", "give one for each particle"},
        {"count: 20, radius: 0.5, temperature: 1",
         "radius: 0.5, temperature: 1, position: [[50,5]]", "4:55",
         "its centre must have x from 0.5 to 39.5 and y from 0.5 to 29.5"},
        {"count: 20", "count: 2000", "4:22",
         "fewer or smaller disks, or a box of about 64.7 by 48.5"},
        {"radius: 0.5", "radius: 20", "4:34", "a smaller disk or a larger box"},
        {"temperature: 1", "temperature: 1, velocity: [1, 0]", "4:55", "keep one of them"},
        {"temperature: 1", "velocity: 3", "4:49", "two numbers: [x, y]"},
        {"size: [40, 30]", "size: [40, 30], walls: true", "2:30",
         "or give a mapping with left, right, bottom and top"},
        {"size: [40, 30]", "size: [40, 30], walls: [solid, periodic]", "2:30",
         "for instance `solid`"},
        {"size: [40, 30]", "size: [40, 30], walls: {left: hot}", "2:37",
         "or give {temperature: T}, {mass: m, force: F} or {velocity: u}"},
        {"size: [40, 30]", "size: [40, 30], walls: {left: 2}", "2:37",
         "or give {temperature: T}, {mass: m, force: F} or {velocity: u}"},
        {"size: [40, 30]", "size: [40, 30], walls: {north: periodic, south: periodic}", "2:31",
         "its keys are left, right, bottom and top"},
        {"size: [40, 30]", "size: [40, 30], walls: {left: periodic}", "2:30",
         "a periodic wall leads to the opposite one: make both periodic"},
        {"size: [40, 30]", "size: [40, 30], periodic: true", "2:23", "did you mean `walls`?"},
        {"run: {until: 10}", "run: {until: 10}\ngravity: 9.81", "6:10", "two numbers: [x, y]"},
        {"run: {until: 10}", "run: {until: 10}\ngravity: down", "6:10", "for instance `[1, 2]`"},
        {"run: {until: 10}", "run: {until: 10}\nseed: random", "6:7", "for instance `1`"},
        {"run: {until: 10}", "run: {until: 10}\nseed: -1", "6:7",
         "write `1`, without the minus sign"},
        {"until: 10", "until: 0", "5:14", "for instance `1`, or any other number above 0"},
        {"until: 10", "until: 1:30", "5:14", "write `90`"},
        {"until: 10", "until: forever", "5:14", "for instance `1`"},
        {"run: {until: 10}", "run: {}", "5:6", "`until`: The end of the run, in simulated time."},
        {"until: 10", "until: 2*5", "5:14",
         "expressions are not evaluated: write one number, in decimal"},
        {"radius: 0.5", "radius: sqrt(2)", "4:34",
         "write a number, or give a list of numbers or {uniform: [low, high]} or {normal: [mean, "
         "deviation]}"},
        {"radius: 0.5", "radius: pi", "4:34",
         "write a number, or give a list of numbers or {uniform: [low, high]} or {normal: [mean, "
         "deviation]}"},
        {"radius: 0.5", "radius: 5x10^-1", "4:34", "write `5e-1`"},
        {"radius: 0.5", "radius: 5*10^-1", "4:34", "write `5e-1`"},
        {"count: 20", "count: 0x20", "4:22", "write the number in decimal"},
        {"count: 20", "count: \"20\"", "4:22", "write the number without quotes"},
        {"radius: 0.5", "radius: 0.5 +- 0.1", "4:34", "write `{normal: [0.5, 0.1]}`"},
        {"radius: 0.5", "radius: 0.4-0.6", "4:34", "write `{uniform: [0.4, 0.6]}`"},
        {"radius: 0.5", "radius: {normal: 0.5}", "4:43", "two numbers: [mean, deviation]"},
        {"radius: 0.5", "radius: {gauss: [0.5, 0.1]}", "4:35", "did you mean `normal`?"},
        {"seconds: 5", "seconds: *len", "7:12",
         "write the value out, or quotes around a text that begins with `*`"},
        {"seconds: 5", "<<: *base\n  seconds: 5", "7:7",
         "write the value out, or quotes around a text that begins with `*`"},
        {"seconds: 5", "seconds: !!int 5", "7:12", "leave it out"},
        {"seconds: 5", "seconds: 5", "7:3",
         "a no-break space (U+00A0) stands after `seconds:`: write an ordinary space instead"},
        {"seconds: 5", "seconds：5", "7:3",
         "a full-width colon (U+FF1A) stands after `seconds`: write `: ` instead"},
        {"radius: 0.5", "radius: −0.5", "4:34",
         "write `-0.5`, with the minus sign of the keyboard"},
        {"seconds: 5", "seconds: 5\n  camera: follow", "8:11",
         "for instance `[{at: 1, view: box}]`"},
        {"seconds: 5", "seconds: 5\n  spotlight: [{from: 1, to: 3, of: b}]", "8:36",
         "the species is `a`; a particle has a number, 0 to 19"},
        {"seconds: 5", "seconds: 5\n  spotlight: {from: 1, to: 3, of: a}", "8:14",
         "begin each item of the list with `- `, or put brackets around it: [{...}]"},
        {"seconds: 5", "seconds: 5\n  slow: [{from: 1, to: 3, factor: 0}]", "8:35",
         "the smallest is 0.001"},
        {"seconds: 5",
         "seconds: 5\n  slow: [{from: 1, to: 5, factor: 0.5}, {from: 3, to: 7, factor: 0.5}]",
         "8:41", "end the first before the second begins"},
        {"seconds: 5", "seconds: 5\n  monitors: [time, collission]", "8:20",
         "did you mean `collisions`?"},
        {"seconds: 5", "seconds: 5\n  monitors: time", "8:13", "write `[time]`"},
        {"seconds: 5", "seconds: 5\n  pace: 2", "8:3", "keep one of them"},
        {"seconds: 5", "seconds: two minutes", "7:12", "for instance `1`"},
        {"seconds: 5", "seconds: 2min", "7:12",
         "write `2`: numbers have units only in a scene with `units: real`"},
        {"seconds: 5", "seconds: -5", "7:12", "write `5`, without the minus sign"},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, bins: many}]", "8:42",
         "for instance `1`"},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, bins: auto}]", "8:42",
         "for instance `1`"},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, range: [3, 0]}]", "8:43",
         "write the smaller one first"},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, of: [lightest, heaviest]}]",
         "8:41", "the species is `a`; a particle has a number, 0 to 19"},
        {"panels: [speed-histogram]", "panels: [{kind: temperature, of: 20}]", "8:36",
         "particles are numbered from 0 to 19, in the order in which `gas` lists them"},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, theory: maxwell}]", "8:44",
         "for instance `true`"},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, over: 5}]", "8:42",
         "or give {window: time}"},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, xlabel: v}]", "8:36",
         "did you mean `x_title`?"},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, colour_bar: v}]", "8:36",
         "its keys are kind, title, of, x_title, y_title, over, show, component, bins, range, "},
        {"panels: [speed-histogram]", "panels: [{kind: speed-histogram, scale: log}]", "8:36",
         "did you mean `scaled`?"},
        {"seconds: 5", "seconds: 5 // five", "7:12",
         "write `5`: a comment begins with a space and `#`"},
        {"seconds: 5", "seconds: 5#five", "7:12",
         "write `5`: a comment begins with a space and `#`"},
        {"count: 20", "count: [20]", "4:22", "write `20`"},
        {"- {name: a, count: 20, radius: 0.5, temperature: 1}",
         "- {name: a, count: 20, radius: 0.5, temperature: 1}\n  - {name: a, count: 2, radius: 1}",
         "5:12", "give each species a name of its own"},
        {"- {name: a, count: 20, radius: 0.5, temperature: 1}",
         "- {count: 20, radius: 0.5, temperature: 1}\n  - {count: 2, radius: 1}", "4:5",
         "for instance `name: light`"},
        {"run: {until: 10}", "run: {until: 10}\npartitions: [{x: 50}]", "6:18",
         "the box goes from 0 to 40"},
        {"run: {until: 10}", "run: {until: 10, events: [{at: 2, open: door}]}", "5:41",
         "there are `left`, `right`, `bottom` and `top`"},
        {"run: {until: 10}", "run: {until: 10, events: [{at: 2, heat: 3}]}", "5:41",
         "its keys are of, by and to"},
    };
    return all;
}

std::vector<Diagnostic> errors_in(const std::string& text) {
    std::filesystem::current_path(test::checkout());
    try {
        load_scene_text(text, "scene.yaml", {"templates", panel_kinds()});
    } catch (const SceneError& error) {
        return error.diagnostics();
    }
    return {};
}

}  // namespace

TEST_CASE("the scene from which the mistakes differ is right") { CHECK(errors_in(right).empty()); }

TEST_CASE("each mistake has its place, a reason, and a hint that mends it") {
    CHECK(slips().size() >= 160);
    for (const auto& [text, instead, place, hint] : slips()) {
        CAPTURE(instead);
        const std::size_t at = right.find(text);
        REQUIRE(at != std::string::npos);
        const std::vector<Diagnostic> errors =
            errors_in(std::string{right}.replace(at, text.size(), instead));
        REQUIRE_FALSE(errors.empty());
        for (const Diagnostic& error : errors) {
            CAPTURE(error.message);
            CHECK(error.span.line > 0);
            CHECK_FALSE(error.message.empty());
            CHECK_FALSE(error.hint.empty());
        }
        const SourceSpan& span = errors.front().span;
        CHECK(std::to_string(span.line) + ":" + std::to_string(span.column) == place);
        CHECK(errors.front().hint.substr(0, hint.size()) == hint);
    }
}
