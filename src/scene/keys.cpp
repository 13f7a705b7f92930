#include "scene/keys.h"

#include <utility>

#include "scene/forms.h"

namespace carom {
namespace {

using std::string;
using std::vector;

constexpr Range any_number{};
constexpr Range not_negative{0.0, largest_quantity.value, largest_quantity.meaning};
constexpr Range positive{smallest_quantity.value, largest_quantity.value, largest_quantity.meaning};

const vector<string>& histograms() {
    static const vector<string> kinds{"speed-histogram", "energy-histogram"};
    return kinds;
}

Section box() {
    const Form side = one_of({"solid", "periodic"});
    const Section walls =
        complete({.name = "`walls`",
                  .keys = {{"left", "The wall at x = 0.", {side}, false, "solid"},
                           {"right",
                            "The wall at x = width; periodic together with the left one.",
                            {side},
                            false,
                            "solid"},
                           {"bottom", "The wall at y = 0.", {side}, false, "solid"},
                           {"top",
                            "The wall at y = height; periodic together with the bottom one.",
                            {side},
                            false,
                            "solid"}}});
    return complete(
        {.name = "`box`",
         .keys = {{"size",
                   "Width and height of the box, x from 0 to the width, y from 0 to the "
                   "height.",
                   {list_of({number(positive)}, 2, 2, "[width, height]")},
                   true},
                  {"walls",
                   "What a disk meets at the edge of the box: a wall, or the opposite "
                   "side.",
                   {side, mapping(walls)},
                   false,
                   "solid"}},
         .refused = {{"length",
                      "`length` asks for a one-dimensional box; this version draws "
                      "two-dimensional boxes",
                      "give `size: [width, height]`"}}});
}

vector<Key> look_keys() {
    return {{"color",
             "The colour of this species where species are told apart: a name or "
             "\"#rrggbb\".",
             {color()},
             false,
             "",
             "chosen by the film"},
            {"label", "A word drawn beside the disks.", {text(0, 40)}, false, "", "none"},
            {"trail",
             "How long a trail the disks leave, in seconds of film.",
             {number({0.0, 3600.0, "seconds of a trail"})},
             false,
             "",
             "by the film"}};
}

vector<Key> matter_keys() {
    const vector<Form> points{list_of({number(any_number)}, 2, 2, "[x, y]"),
                              list_of({list_of({number(any_number)}, 2, 2, "[x, y]")}, 1,
                                      most_particles, "a list of [x, y]")};
    const Section within =
        complete({.name = "`position`",
                  .keys = {{"within",
                            "Random places in a part of the box, disks wholly inside.",
                            {list_of({number(any_number)}, 4, 4, "[x0, y0, x1, y1]")},
                            true}}});
    vector<Form> mass = quantity(positive);
    mass.push_back(one_of({"infinite"}));
    vector<Form> places{one_of({"random", "lattice"}),
                        mapping(within, "{within: [x0, y0, x1, y1]}")};
    places.insert(places.end(), points.begin(), points.end());
    return {{"name",
             "The name of the species, shown in legends.",
             {text(1, 40)},
             false,
             "",
             "required when there are several species"},
            {"count",
             "How many particles.",
             {integer(1, most_particles)},
             false,
             "",
             "the number of positions listed"},
            {"radius", "The radius of each disk.", quantity(positive), false, "0.5"},
            {"mass", "The mass of each disk; `infinite` is never moved by a collision.", mass,
             false, "1"},
            {"density", "Instead of a mass: mass = density * pi * radius^2.", quantity(positive)},
            {"speed", "The speed of each disk, in a random direction.", quantity(not_negative)},
            {"velocity", "One velocity for all, or a list of one for each particle.", points},
            {"temperature",
             "Maxwell-Boltzmann velocities at this temperature.",
             {number(not_negative)},
             false,
             "",
             "at rest"},
            {"position",
             "Where the disks begin: anywhere, in rows, in a part of the box, or in "
             "listed places.",
             places, false, "random"}};
}

Section gas_item() {
    vector<Key> keys = matter_keys();
    for (Key& key : look_keys()) keys.push_back(std::move(key));
    return complete({.name = "an item of `gas`",
                     .keys = std::move(keys),
                     .choices = {{{"mass", "density"}}, {{"speed", "velocity", "temperature"}}}});
}

Section run() {
    const Section event =
        complete({.name = "an item of `events`",
                  .keys = {{"at", "When, in simulated time.", {number(positive)}, true},
                           {"reverse", "Turns every velocity round.", {one_of({"velocities"})}}},
                  .choices = {{{"reverse"}, true}}});
    return complete(
        {.name = "`run`",
         .keys = {{"until", "The end of the run, in simulated time.", {number(positive)}, true},
                  {"equilibrate",
                   "Simulated time before time 0, neither shown nor counted.",
                   {number(not_negative)},
                   false,
                   "0"},
                  {"events",
                   "What happens on the way, a list of {at: time, action}.",
                   {list_of({mapping(event)}, 0, most_events, "a list of events")},
                   false,
                   "",
                   "none"}}});
}

Section panel() {
    const vector<string> kinds{panel_kinds().begin(), panel_kinds().end()};
    return complete(
        {.name = "a panel",
         .keys = {{"kind", "What the panel shows.", {one_of(kinds)}, true},
                  {"title", "The words above the panel.", {text(1, 100)}, false, "", "by kind"},
                  {"bins",
                   "The number of bars.",
                   {integer(1, most_bins)},
                   false,
                   "",
                   "by rule, from the whole run",
                   histograms()},
                  {"range",
                   "The first and the last edge of the bars.",
                   {list_of({number(not_negative)}, 2, 2, "[low, high]")},
                   false,
                   "",
                   "by rule, from the whole run",
                   histograms()},
                  {"theory",
                   "Whether to draw the curve that theory predicts for this finite "
                   "mixture.",
                   {flag()},
                   false,
                   "true",
                   "",
                   histograms()},
                  {"mean_now",
                   "Whether to mark the present mean.",
                   {flag()},
                   false,
                   "true",
                   "",
                   histograms()},
                  {"mean_start",
                   "Whether to mark the mean at the start.",
                   {flag()},
                   false,
                   "true",
                   "",
                   histograms()}}});
}

vector<Key> film_keys() {
    const vector<string> kinds{panel_kinds().begin(), panel_kinds().end()};
    const Form side = integer(smallest_side.value, largest_side);
    return {{"seconds",
             "The length of the whole film, holds and pauses included.",
             {number({0.01, 86400.0, "seconds of a film"})}},
            {"pace",
             "Instead of seconds: simulated time in a second of film.",
             {number(positive)},
             false,
             "1"},
            {"fps", "Frames in a second.", {integer(1, most_frames_per_second)}, false, "30"},
            {"size",
             "The picture in pixels: a name, or width and height, both even.",
             {one_of({"2160p", "1080p", "720p"}), list_of({side}, 2, 2, "[width, height]")},
             false,
             "1080p"},
            {"theme",
             "The colours of the ground and of the text.",
             {one_of({"light", "dark", "print"})},
             false,
             "dark"},
            {"color_by",
             "What the colour of a disk says.",
             {one_of({"speed", "speed-class", "energy", "species", "mass"})},
             false,
             "speed"},
            {"palette",
             "The colours from slow to fast.",
             {one_of({"viridis", "cividis", "plasma", "inferno", "magma"})},
             false,
             "",
             "the theme's"},
            {"panels",
             "What the panels show, each a kind or a mapping with options.",
             {list_of({one_of(kinds), mapping(panel())}, 0, most_panels, "a list of panels")},
             false,
             "",
             "the template's"}};
}

Section film() {
    vector<Key> keys = film_keys();
    keys.insert(keys.begin(), {"template",
                               "The layout: a file in the scene's folder or in "
                               "templates/films, by name.",
                               {text(1, 100)},
                               false,
                               "lecture"});
    return complete(
        {.name = "`film`", .keys = std::move(keys), .choices = {{{"seconds", "pace"}}}});
}

Section layout() {
    const Range units{0.0, largest_grid.value, largest_grid.meaning};
    const Form slot = list_of({number(units)}, 4, 4, "[x, y, width, height]");
    const Range sides{1.0, largest_grid.value, largest_grid.meaning};
    return complete(
        {.name = "`layout`",
         .keys = {{"grid",
                   "Width and height of the picture in units of the layout; one unit is "
                   "the smallest size of text.",
                   {list_of({number(sides)}, 2, 2, "[width, height]")},
                   true},
                  {"title", "Where title and subtitle stand.", {slot}, true},
                  {"gas", "Where the box stands.", {slot}, true},
                  {"color_bar", "Where the scale of the colours stands.", {slot}, true},
                  {"monitors", "Where the numbers stand.", {slot}, false, "", "none"},
                  {"panels",
                   "Where the panels stand, in their order.",
                   {list_of({slot}, 0, most_panels, "a list of [x, y, width, height]")},
                   false,
                   "",
                   "none"}}});
}

Section template_file() {
    vector<Key> keys = film_keys();
    keys.push_back({"layout", "Where things stand in a frame.", {mapping(layout())}, true});
    return complete(
        {.name = "a template", .keys = std::move(keys), .choices = {{{"seconds", "pace"}}}});
}

Section scene() {
    return complete(
        {.name = "a scene",
         .keys = {
             {"carom",
              "The version of the scene format.",
              {integer(1, {scene_format, "is the format that this carom reads"})},
              false,
              "1"},
             {"title", "Shown in the film and in the file's metadata.", {text(1, 200)}, true},
             {"subtitle", "Shown under the title.", {text(0, 200)}, false, "", "none"},
             {"description",
              "What is seen, in words, for those who cannot see it.",
              {lines(1, most_letters)},
              false,
              "",
              "made from the scene's content"},
             {"seed", "Fixes every random choice.", {integer(0, largest_seed)}, false, "1"},
             {"box", "The box that holds the gas.", {mapping(box())}, true},
             {"gas",
              "What is in the box: a list of species.",
              {list_of({mapping(gas_item())}, 1, most_species, "a list of species")},
              true},
             {"run", "What happens to the gas.", {mapping(run())}, true},
             {"film", "What the viewer sees.", {mapping(film())}, false, "", "the template's"}}});
}

}  // namespace

const Section& scene_section() {
    static const Section section = scene();
    return section;
}

const Section& template_section() {
    static const Section section = template_file();
    return section;
}

std::span<const string> panel_kinds() {
    static const vector<string> kinds{"speed-histogram", "energy-histogram", "energy-by-species"};
    return kinds;
}

}  // namespace carom
