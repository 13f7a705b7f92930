#include "scene/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "physics/run.h"
#include "scene/captions.h"
#include "scene/forms.h"

namespace carom {
namespace {

using std::string;
using std::vector;

constexpr Range any_number{};
constexpr Range not_negative{0.0, largest_quantity.value, largest_quantity.meaning};
constexpr Range positive{smallest_quantity.value, largest_quantity.value, largest_quantity.meaning};

const vector<string>& histograms() {
    static const vector<string> kinds{"speed-histogram", "energy-histogram", "velocity-histogram",
                                      "position-histogram"};
    return kinds;
}

// Those whose equilibrium is known.
const vector<string>& predicted() {
    static const vector<string> kinds{"speed-histogram", "energy-histogram", "velocity-histogram"};
    return kinds;
}

// Those that can show means of several runs.
const vector<string>& averaged() {
    static const vector<string> kinds{
        "speed-histogram",    "energy-histogram",  "velocity-histogram",
        "position-histogram", "energy-by-species", "speed-classes",
        "temperature",        "entropy",           "pressure"};
    return kinds;
}

// Those that can show several runs in one panel: one line of each.
const vector<string>& compared() {
    static const vector<string> kinds{"speed-histogram",
                                      "energy-histogram",
                                      "velocity-histogram",
                                      "position-histogram",
                                      "temperature",
                                      "entropy",
                                      "pressure"};
    return kinds;
}

// Those that take numbers over a time.
const vector<string>& timed() {
    static const vector<string> kinds{"speed-histogram", "energy-histogram", "velocity-histogram",
                                      "position-histogram", "pressure"};
    return kinds;
}

// Those that show particles which a scene may choose.
const vector<string>& choosing() {
    static const vector<string> kinds{"speed-histogram",    "energy-histogram",
                                      "velocity-histogram", "position-histogram",
                                      "temperature",        "phase",
                                      "positions",          "single-collision",
                                      "contact-time",       "collision-map"};
    return kinds;
}

const vector<string>& directed() {
    static const vector<string> kinds{"velocity-histogram", "position-histogram", "phase",
                                      "positions"};
    return kinds;
}

// A text, since a species may be called anything.
vector<Form> chosen() {
    Form one = text(1, most_name_letters);
    one.phrase = "`all`, a species or the number of a particle";
    return {one, list_of({one}, 1, most_chosen, "a list of species and particles")};
}

Form window() {
    return mapping(complete({.name = "`over`",
                             .keys = {required({"window",
                                                "How far back from the present, in simulated time.",
                                                {number(positive)}})}}),
                   "{window: time}");
}

Section walls(int dimension) {
    const Form side = one_of({"solid", "periodic"});
    Section section{.name = "`walls`", .keys = {}};
    section.keys = {
        otherwise("solid", {"left", "The wall at x = 0.", {side}}),
        otherwise(
            "solid",
            {"right", "The wall at the largest x; periodic together with the left one.", {side}})};
    const std::array upright{
        otherwise("solid", {"bottom", "The wall at y = 0.", {side}}),
        otherwise(
            "solid",
            {"top", "The wall at y = height; periodic together with the bottom one.", {side}})};
    for (const Key& key : upright) {
        if (dimension == 2) section.keys.push_back(key);
        if (dimension == 1)
            section.refused.push_back(
                {key.name, "a wire has no `" + key.name + "`", "its ends are `left` and `right`"});
    }
    return complete(std::move(section));
}

Section box(int dimension) {
    const Form side = one_of({"solid", "periodic"});
    return complete(
        {.name = "`box`",
         .keys = {{"size",
                   "Width and height of the box, x from 0 to the width, y from 0 to the height.",
                   {list_of({number(positive)}, 2, 2, "[width, height]")}},
                  {"length",
                   "Instead of a size: the length of a wire, x from 0 to the length.",
                   {number(positive)}},
                  otherwise(
                      "solid",
                      {"walls",
                       "What a particle meets at the edge of the box: a wall, or the opposite "
                       "side.",
                       {side, mapping(walls(dimension))}})},
         .choices = {{{"size", "length"}, true}}});
}

vector<Key> look_keys() {
    return {
        left_to("chosen by the film",
                {"color",
                 "The colour of this species where species are told apart: a name or \"#rrggbb\".",
                 {color()}}),
        otherwise("true", {"fill", "Whether disks and beads are filled; rings if not.", {flag()}}),
        left_to("none",
                {"label", "A word drawn beside the particles.", {text(0, most_name_letters)}}),
        left_to("by the film",
                {"trail",
                 "How long a trail the particles leave, in seconds of film.",
                 {number({0.0, most_trail_seconds.value, most_trail_seconds.meaning})}})};
}

// One place or velocity, or one for each particle: [x, y] in a plane, a number on a wire.
vector<Form> points(int dimension) {
    if (dimension == 1)
        return {number(any_number),
                list_of({number(any_number)}, 1, most_particles, "a list of numbers")};
    const Form point = list_of({number(any_number)}, 2, 2, "[x, y]");
    return {point, list_of({point}, 1, most_particles, "a list of [x, y]")};
}

vector<Form> places(int dimension) {
    const string corners = dimension == 1 ? "[x0, x1]" : "[x0, y0, x1, y1]";
    const std::size_t numbers = 2 * static_cast<std::size_t>(dimension);
    Section part{.name = "`position`",
                 .keys = {required({"within",
                                    "A part of the box, particles wholly inside.",
                                    {list_of({number(any_number)}, numbers, numbers, corners)}})}};
    string phrase = "{within: " + corners + "}";
    if (dimension == 2) {
        part.keys.push_back(
            left_to("random places",
                    {"text",
                     "A word as a pattern of disks, as large as fits into `within`: capitals, "
                     "digits, . ! ? - + = ♥ ☺. Without `count` there are as many disks as stand "
                     "well apart.",
                     {text(1, most_name_letters)}}));
        phrase = "{within: " + corners + "} (and a `text`)";
    }
    vector<Form> forms{one_of({"random", "lattice"}), mapping(complete(part), phrase)};
    for (Form& form : points(dimension)) forms.push_back(std::move(form));
    return forms;
}

vector<Key> matter_keys(int dimension) {
    const bool wire = dimension == 1;
    vector<Form> mass = quantity(positive);
    mass.push_back(one_of({"infinite"}));
    const Key radius =
        wire ? otherwise("0", {"radius", "Half the length of each bead: 0 is a point.",
                               quantity(not_negative)})
             : otherwise("0.5", {"radius", "The radius of each disk.", quantity(positive)});
    const string density = wire ? "Instead of a mass: mass = density * 2 radius."
                                : "Instead of a mass: mass = density * pi * radius^2.";
    const string direction = wire ? "to the left or to the right" : "in a random direction";
    return {
        left_to(
            "required when there are several species",
            {"name", "The name of the species, shown in legends.", {text(1, most_name_letters)}}),
        left_to("the number of positions listed, or of disks in a `text`",
                {"count", "How many particles.", {integer(1, most_particles)}}),
        radius,
        otherwise(
            "1",
            {"mass", "The mass of each particle; `infinite` is never moved by a collision.", mass}),
        {"density", density, quantity(positive)},
        {"speed", "The speed of each particle, " + direction + ".", quantity(not_negative)},
        {"velocity", "One velocity for all, or a list of one for each particle.",
         points(dimension)},
        left_to("at rest", {"temperature",
                            "Maxwell-Boltzmann velocities at this temperature.",
                            {number(not_negative)}}),
        otherwise("random", {"position",
                             "Where the particles begin: anywhere, evenly spaced, in a part of the "
                             "box, or in listed places.",
                             places(dimension)})};
}

Key drawn_radius() {
    return left_to("the radius, or 0.4 of the mean spacing for points",
                   {"drawn_radius",
                    "How large the beads are drawn, pushed apart so that they seem to touch when "
                    "they meet.",
                    {number(positive)}});
}

Section gas_item(int dimension) {
    Section section{.name = "an item of `gas`", .keys = matter_keys(dimension)};
    for (Key& key : look_keys()) section.keys.push_back(std::move(key));
    section.choices = {{{"mass", "density"}}, {{"speed", "velocity", "temperature"}}};
    if (dimension == 1) section.keys.push_back(drawn_radius());
    if (dimension == 2)
        section.refused = {{"drawn_radius", "`drawn_radius` is for beads on a wire (`length`)",
                            "disks are drawn as large as they are: give `radius`"}};
    return complete(std::move(section));
}

Section nudge(int dimension) {
    const Form by =
        dimension == 1 ? number(any_number) : list_of({number(any_number)}, 2, 2, "[dx, dy]");
    return complete(
        {.name = "`nudge`",
         .keys = {
             required({"particle",
                       "The number of the particle, counted from 0 in the order in which `gas` "
                       "lists them.",
                       {integer(0.0, most_particles)}}),
             required({"by",
                       "How far it is moved, read with all its digits: as little as 1e-300.",
                       {by}})}});
}

Section run(int dimension) {
    Form bits = integer(bits_of_double, most_precise);
    bits.phrase = fmt::format("a whole number from {} to {}", least_bits, most_bits);
    const Section event = complete(
        {.name = "an item of `events`",
         .keys = {required(
                      {"at", "When, in simulated time, before `until`.", {number(not_negative)}}),
                  {"reverse", "Turns every velocity round.", {one_of({"velocities"})}},
                  {"nudge",
                   "Moves one particle by a little, which shows how soon a reversed film goes "
                   "another way.",
                   {mapping(nudge(dimension), dimension == 1 ? "{particle: i, by: dx}"
                                                             : "{particle: i, by: [dx, dy]}")}},
                  {"mark",
                   "Keeps the places that the particles have then in sight, as outlines with these "
                   "words, until the next mark.",
                   {text(1, most_name_letters)}},
                  {"caption",
                   "Words under the gas, one line that is shown until the next; \"\" takes them "
                   "away.",
                   {text(0, most_caption_letters)}},
                  left_to("until the next caption",
                          {"for",
                           "How long the caption is shown at most, in seconds of film.",
                           {number({least_caption_seconds, most_seconds.value,
                                    most_seconds.meaning})}})},
         .choices = {{{"reverse", "nudge", "mark", "caption"}, true}}});
    return complete(
        {.name = "`run`",
         .keys = {
             required({"until", "The end of the run, in simulated time.", {number(positive)}}),
             otherwise("0", {"equilibrate",
                             "Simulated time before time 0, neither shown nor counted.",
                             {number(not_negative)}}),
             left_to(
                 "until / (frames - 1) with a film, until / 1000 without",
                 {"sample_every",
                  "Simulated time between two samples of the statistics: at 0, at its multiples, "
                  "and at the end.",
                  {number(positive)}}),
             otherwise(
                 "double",
                 {"precision",
                  "What the run calculates with: doubles, which have 53 bits; numbers of so "
                  "many bits; or as many as it takes to come home after every reversal, which "
                  "is tried out.",
                  {one_of({"double", "auto"}), bits}}),
             otherwise("1e-9",
                       {"tolerance",
                        "How near its place `precision: auto` must bring every particle home, in "
                        "units of the smallest radius; on a wire of points, of the length for each "
                        "of them.",
                        {number({1e-300, 1.0, "radius away from home"})}}),
             left_to("none", {"events",
                              "What happens on the way, a list of {at: time, action}.",
                              {list_of({mapping(event)}, 0, most_events, "a list of events")}})}});
}

Form monitors() {
    return list_of({one_of({"time", "collisions", "mean-speed", "mean-energy", "slow", "medium",
                            "fast", "all-collisions", "return-distance"})},
                   1, most_monitors, "a list of numbers to show");
}

Form panel_kind() {
    Form kind = one_of({panel_kinds().begin(), panel_kinds().end()});
    kind.elsewhere = {{"gas", "the box is in every film; the template says where"},
                      {"wire", "the wire with its beads is in every film; the template says where"},
                      {"world-lines", "they stand under the wire in every film of one dimension"}};
    return kind;
}

// Of collision maps: which pair, if it is none of the scene's, and how it is shown.
vector<Key> collision_map_keys() {
    const vector<string> map{"collision-map"};
    return {
        only_with(
            map,
            left_to("those of the pair in the scene",
                    {"masses",
                     "Two masses of a pair that need not be in the scene, with their "
                     "`velocities`; one of them may be `infinite`.",
                     {list_of({number(positive), one_of({"infinite"})}, 2, 2, "[mass, mass]")}})),
        only_with(map, left_to("those of the pair in the scene",
                               {"velocities",
                                "The velocities before the collision of the given `masses`.",
                                {list_of({number(any_number)}, 2, 2, "[velocity, velocity]")}})),
        only_with(map, otherwise("false", {"walk",
                                           "All collisions of the pair so far, with each other and "
                                           "with walls, as a walk on the ellipse of their energy; "
                                           "otherwise their first.",
                                           {flag()}})),
        only_with(map, left_to("that of `walk`",
                               {"scaled",
                                "Axes of the velocity times the root of the mass: the ellipse is a "
                                "circle, a collision mirrors it.",
                                {flag()}}))};
}

// The keys of panels and figures alike; `kind` and `over` are each one's own.
vector<Key> panel_keys(Form kind, Key over) {
    vector<Key> keys{
        required({"kind", "What the panel shows.", {std::move(kind)}}),
        left_to("by kind", {"title", "The words above the panel.", {text(1, most_title_letters)}}),
        only_with(histograms(), left_to("by rule, from the whole run",
                                        {"bins", "The number of bars.", {integer(1, most_bins)}})),
        only_with(histograms(), left_to("by rule, from the whole run",
                                        {"range",
                                         "The first and the last edge of the bars.",
                                         {list_of({number(any_number)}, 2, 2, "[low, high]")}})),
        only_with(choosing(),
                  otherwise("all", {"of",
                                    "Whose numbers: of all particles, a species, a particle "
                                    "by its number, or several of these drawn together. Of a "
                                    "pair, its two numbers; none for the first that collides.",
                                    chosen()})),
        std::move(over),
        only_with(directed(),
                  left_to("both for velocities, x for positions",
                          {"component",
                           "Along which axis; `both` counts either component of a particle.",
                           {one_of({"x", "y", "both"})}})),
        only_with(
            predicted(),
            otherwise(
                "true",
                {"theory",
                 "Whether to draw the curve that theory predicts for this finite mixture, if "
                 "it comes to an equilibrium; an error where `true` is written and it cannot.",
                 {flag()}})),
        only_with(histograms(),
                  otherwise("false", {"fit",
                                      "Whether to draw the normal curve of the same mean and "
                                      "deviation, which are written out.",
                                      {flag()}})),
        only_with(histograms(), left_to("true for speeds and energies",
                                        {"mean_now", "Whether to mark the mean.", {flag()}})),
        only_with(histograms(),
                  left_to("true for speeds and energies",
                          {"mean_start", "Whether to mark the mean at the start.", {flag()}})),
        only_with({"speed-classes"},
                  otherwise("now", {"reference",
                                    "The mean speed that slow and fast are measured by: the "
                                    "present one, or that at the start.",
                                    {one_of({"now", "initial"})}})),
        only_with({"monitors"}, left_to("all but all-collisions and return-distance",
                                        {"numbers",
                                         "Which numbers it shows; all-collisions counts those "
                                         "with walls too, return-distance is the largest of a "
                                         "particle from where it was on the way out.",
                                         {monitors()}})),
        only_with({"text"}, left_to("required for a text",
                                    {"words",
                                     "What the panel says, in lines as its place allows; an "
                                     "empty line parts paragraphs.",
                                     {lines(1, most_words_letters)}}))};
    for (Key& key : collision_map_keys()) keys.push_back(std::move(key));
    return keys;
}

Key panel_over() {
    return only_with(timed(), left_to("now; since the start for the pressure",
                                      {"over",
                                       "Numbers of the present, their mean since time 0, or "
                                       "their mean over a while before the present.",
                                       {one_of({"now", "start"}), window()}}));
}

Section panel() {
    return complete({.name = "a panel", .keys = panel_keys(panel_kind(), panel_over())});
}

// What is laid over the scene of a compared run.
Key changes() {
    Form change = text(3, most_title_letters);
    change.phrase = "KEY.PATH=VALUE";
    return left_to(
        "nothing",
        {"set",
         "What its scene has otherwise: KEY.PATH=VALUE as for `--set`, or a list of these.",
         {change, list_of({change}, 1, most_changes, "a list of KEY.PATH=VALUE")}});
}

vector<Form> compared_runs() {
    const Section seeds =
        complete({.name = "`compare`",
                  .keys = {required({"seeds",
                                     "How many runs: of the scene's seed and those that follow it.",
                                     {integer(2, most_compared)}})}});
    const Section run = complete(
        {.name = "an item of `compare`",
         .keys = {required({"label", "Its name in the figure.", {text(1, most_name_letters)}}),
                  changes()}});
    return {mapping(seeds, "{seeds: number}"),
            list_of({mapping(run)}, 2, most_compared, "a list of {label, set}")};
}

Section figure() {
    vector<string> kinds{panel_kinds().begin(), panel_kinds().end()};
    kinds.emplace_back("gas");
    const Form time = number(not_negative);
    const Form side = number({smallest_figure.value, largest_figure.value, largest_figure.meaning});
    vector<Key> keys{required({"name",
                               "The name of its files: small letters, digits and hyphens.",
                               {text(1, most_name_letters)}})};
    Key over = only_with(timed(), {"over",
                                   "Instead of `at`: the time that its numbers are taken over.",
                                   {list_of({time}, 2, 2, "[from, to]")}});
    for (Key& key : panel_keys(one_of(std::move(kinds)), std::move(over)))
        keys.push_back(std::move(key));
    keys.push_back(only_with(
        predicted(),
        otherwise("false", {"test",
                            "Whether the caption tells how well the bars fit the theory, by "
                            "Pearson's chi-squared test: for one time `at`, where the values are "
                            "independent but for what is conserved, and particles of one mass.",
                            {flag()}})));
    keys.push_back(only_with(
        averaged(),
        otherwise("1", {"seeds",
                        "Of how many independent runs it shows the mean, with its standard error: "
                        "of the scene's seed and those that follow it.",
                        {integer(1, most_seeds)}})));
    keys.push_back(only_with(
        compared(),
        left_to("the scene's run alone",
                {"compare",
                 "Several runs in one panel with shared axes and a key: of several seeds, or of "
                 "the scene with other values, each with its label.",
                 compared_runs()})));
    keys.push_back(
        left_to("the end of the run", {"at", "The simulated time that it shows.", {time}}));
    keys.push_back(only_with({"gas"}, {"strip",
                                       "Instead of `at`: several times, shown side by side.",
                                       {list_of({time}, 2, most_strip, "a list of times")}}));
    keys.push_back(otherwise(
        "column",
        {"size",
         "Of a text's column (8.9 cm wide), of its page (18.3 cm), of a slide "
         "(33.9 cm by 19.1 cm, with large type), or width and height in centimetres.",
         {one_of({"column", "page", "slide"}), list_of({side}, 2, 2, "[width, height]")}}));
    keys.push_back(
        otherwise("print", {"theme",
                            "The colours of the ground and of the text; `print` is "
                            "black, white and greys, but for what the scene colours itself.",
                            {one_of({"light", "dark", "print"})}}));
    keys.push_back(left_to("made from what the figure shows",
                           {"caption", "The words under the figure.", {lines(1, most_letters)}}));
    keys.push_back(
        left_to("made from what the figure shows",
                {"alt", "What is seen, for those who cannot see it.", {lines(1, most_letters)}}));
    return complete(
        {.name = "a figure",
         .keys = std::move(keys),
         .choices = {{{"at", "over", "strip"}}, {{"seeds", "compare"}}, {{"test", "compare"}}}});
}

Section trails() {
    return complete(
        {.name = "`trails`",
         .keys = {
             otherwise("all", {"of",
                               "Whose: of all particles, a species, a particle by its number, or "
                               "several of these.",
                               chosen()}),
             otherwise("1",
                       {"seconds",
                        "How long they are, in seconds of film.",
                        {number({0.0, most_trail_seconds.value, most_trail_seconds.meaning})}})}});
}

Section slow_span() {
    return complete(
        {.name = "an item of `slow`",
         .keys = {otherwise("0", {"from", "Its first time.", {number(not_negative)}}),
                  left_to("until", {"to", "Its last time, at most `until`.", {number(positive)}}),
                  required({"factor",
                            "The film's speed there, as a part of what it is elsewhere.",
                            {number({0.001, 1.0, {}})}})}});
}

vector<Key> film_keys() {
    const Form side = integer(smallest_side.value, largest_side);
    return {
        {"seconds",
         "The length of the whole film, holds and pauses included.",
         {number({0.01, most_seconds.value, most_seconds.meaning})}},
        otherwise("1", {"pace",
                        "Instead of seconds: simulated time in a second of film.",
                        {number(positive)}}),
        otherwise("30", {"fps", "Frames in a second.", {integer(1, most_frames_per_second)}}),
        otherwise(
            "1080p",
            {"size",
             "The picture in pixels: a name, or width and height. H.264 and VP9 add a row or a "
             "column to odd ones.",
             {one_of({"2160p", "1080p", "720p"}), list_of({side}, 2, 2, "[width, height]")}}),
        otherwise("dark", {"theme",
                           "The colours of the ground and of the text; `print` is black, white and "
                           "greys, but for what the scene colours itself.",
                           {one_of({"light", "dark", "print"})}}),
        otherwise("theme",
                  {"ground",
                   "What lies behind the box, the panels and the words: the theme's page, or none, "
                   "so that a slide shows through. Choose the theme that suits the slide.",
                   {one_of({"theme", "none"})}}),
        otherwise("speed", {"color_by",
                            "What the colour of a disk says.",
                            {one_of({"speed", "speed-class", "energy", "species", "mass"})}}),
        left_to("the theme's",
                {"palette",
                 "The colours from slow to fast.",
                 {one_of({"viridis", "cividis", "plasma", "inferno", "magma", "netlogo"})}}),
        left_to("none", {"labels",
                         "What is written on the disks or beads where there is room: their mass, "
                         "or their number.",
                         {one_of({"mass", "index"})}}),
        otherwise("false",
                  {"velocities",
                   "Arrows of velocity on disks and beads: whether there are any, or how much "
                   "simulated time they look ahead, so that an arrow is velocity * time long.",
                   {flag(), number(positive)}}),
        otherwise("false", {"flashes",
                            "A short mark where two particles touch, three a second at most.",
                            {flag()}}),
        otherwise("false",
                  {"title_card",
                   "A picture before the film with title and subtitle: whether there is one, of 3 "
                   "seconds, or its seconds. It is part of the film's `seconds`; with `pace` it "
                   "comes on top.",
                   {flag(), number({0.5, most_seconds.value, most_seconds.meaning})}}),
        left_to("none", {"end_card",
                         "Words on a picture of 4 seconds after the film, which is part of its "
                         "`seconds` too. Both cards together are a third of the film at most.",
                         {text(1, most_title_letters)}}),
        left_to("of single disks among many",
                {"trails",
                 "Trails that some of the particles leave; the `trail` of a species wins.",
                 {mapping(trails(), "{of: whose, seconds: how long}")}}),
        left_to("none",
                {"slow",
                 "Slow motion over spans of simulated time; factor 0.1 is ten times slower. The "
                 "film eases in before the span and out after it, over half a second each (a tenth "
                 "of a film of less than five), and says "
                 "×0.1 beside the clock. With `seconds` the rest is faster, with `pace` the "
                 "film is longer.",
                 {list_of({mapping(slow_span())}, 0, most_slow_spans,
                          "a list of {from, to, factor}")}}),
        left_to(
            "all but all-collisions and return-distance",
            {"monitors",
             "Which numbers stand in the row of monitors; all-collisions counts those with walls "
             "too, return-distance is the largest of a particle from where it was on the way out.",
             {monitors()}}),
        left_to("the template's",
                {"panels",
                 "What the panels show, each a kind or a mapping with options.",
                 {list_of({panel_kind(), mapping(panel())}, 0, most_panels, "a list of panels")}})};
}

Section film() {
    vector<Key> keys = film_keys();
    keys.insert(
        keys.begin(),
        otherwise("lecture",
                  {"template",
                   "The layout: a file in the scene's folder or in templates/films, by name.",
                   {text(1, most_title_letters)}}));
    return complete(
        {.name = "`film`", .keys = std::move(keys), .choices = {{{"seconds", "pace"}}}});
}

Section layout() {
    const Range units{0.0, largest_grid.value, largest_grid.meaning};
    const Form slot = list_of({number(units)}, 4, 4, "[x, y, width, height]");
    const Range sides{1.0, largest_grid.value, largest_grid.meaning};
    return complete(
        {.name = "`layout`",
         .keys = {required({"grid",
                            "Width and height of the picture in units of the layout; one unit is "
                            "the smallest size of text.",
                            {list_of({number(sides)}, 2, 2, "[width, height]")}}),
                  required({"title", "Where title and subtitle stand.", {slot}}),
                  required({"gas", "Where the box stands.", {slot}}),
                  required({"color_bar", "Where the scale of the colours stands.", {slot}}),
                  left_to("the foot of the gas's place",
                          {"caption",
                           "Where captions stand in films that have any: what reaches into this "
                           "place makes room for them.",
                           {slot}}),
                  left_to("none", {"monitors", "Where the numbers stand.", {slot}}),
                  left_to("none", {"panels",
                                   "Where the panels stand, in their order.",
                                   {list_of({slot}, 0, most_panels,
                                            "a list of [x, y, width, height]")}})}});
}

Section template_file() {
    vector<Key> keys = film_keys();
    keys.push_back(required({"layout", "Where things stand in a frame.", {mapping(layout())}}));
    return complete(
        {.name = "a template", .keys = std::move(keys), .choices = {{{"seconds", "pace"}}}});
}

Section set_scene() {
    return complete(
        {.name = "an item of `scenes`",
         .keys = {
             required({"scene",
                       "The scene's file, relative to the set; it may lie in the folder above the "
                       "set's.",
                       {text(1, most_title_letters)}}),
             left_to("the scene's",
                     {"title", "Its title in the set.", {text(1, most_title_letters)}}),
             left_to("the scene's",
                     {"description", "The words under it.", {lines(1, most_letters)}}),
             left_to("all of the scene", {"figures",
                                          "The names of the figures that are shown, in this order.",
                                          {list_of({text(1, most_name_letters)}, 1, most_figures,
                                                   "a list of names")}})}});
}

// A figure whose runs are those of several scenes.
Section comparison() {
    const Section run = complete(
        {.name = "an item of a comparison's `scenes`",
         .keys = {required({"scene",
                            "The scene's file, relative to the set; it may lie in the folder above "
                            "the set's.",
                            {text(1, most_title_letters)}}),
                  left_to("the scene's title",
                          {"label", "Its name in the figure.", {text(1, most_name_letters)}}),
                  changes()}});
    Form file = text(1, most_title_letters);
    file.phrase = "the path of a scene";
    vector<Key> keys;
    for (const Key& key : figure().keys) {
        const bool left_out = key.name == "seeds" || key.name == "test" || key.name == "strip" ||
                              key.name == "compare" || key.name == "numbers" ||
                              key.name == "words" || key.name == "reference";
        if (left_out) continue;
        keys.push_back(key);
        std::erase_if(keys.back().with, [](const string& kind) {
            return std::ranges::find(compared(), kind) == compared().end();
        });
        if (key.name != "kind") continue;
        keys.back().forms = {one_of(compared())};
        keys.push_back(
            required({"scenes",
                      "The scenes whose runs it shows in one panel with shared axes and a key.",
                      {list_of({file, mapping(run)}, 2, most_compared, "a list of scenes")}}));
    }
    return complete(
        {.name = "a comparison", .keys = std::move(keys), .choices = {{{"at", "over"}}}});
}

Section figure_set() {
    const Form page = text(1, most_title_letters);
    const Form format = one_of({"svg", "pdf", "png", "csv"});
    Form file = text(1, most_title_letters);
    file.phrase = "the path of a scene";
    return complete(
        {.name = "a figure set",
         .keys = {
             required({"title", "The title of its pages.", {text(1, most_title_letters)}}),
             left_to("none",
                     {"description", "What the set shows, in words.", {lines(1, most_letters)}}),
             required(
                 {"scenes",
                  "The scenes whose figures it holds, in the order of the pages' sections.",
                  {list_of({file, mapping(set_scene())}, 1, most_set_scenes, "a list of scenes")}}),
             left_to(
                 "none",
                 {"comparisons",
                  "Figures of several scenes in one panel, in the last section of the pages.",
                  {list_of({mapping(comparison())}, 1, most_figures, "a list of comparisons")}}),
             otherwise("html",
                       {"template",
                        "The pages: `markdown`, `html`, `latex`, or a template beside the set, a "
                        "file that ends in .md, .html or .tex; or a list of these.",
                        {page, list_of({page}, 1, 3, "a list of templates")}}),
             left_to("all", {"formats",
                             "The kinds of files of its figures.",
                             {list_of({format}, 1, 4, "a list of formats")}})}});
}

Section scene(int dimension) {
    return complete(
        {.name = "a scene",
         .keys = {
             otherwise("1", {"carom",
                             "The version of the scene format.",
                             {integer(1, {scene_format, "is the format that this carom reads"})}}),
             required({"title",
                       "Shown in the film and in the file's metadata.",
                       {text(1, most_title_letters)}}),
             left_to("none", {"subtitle", "Shown under the title.", {text(0, most_title_letters)}}),
             left_to("made from the scene's content",
                     {"description",
                      "What is seen, in words, for those who cannot see it.",
                      {lines(1, most_letters)}}),
             otherwise("1", {"seed", "Fixes every random choice.", {integer(0, largest_seed)}}),
             required({"box", "The box that holds the gas.", {mapping(box(dimension))}}),
             required(
                 {"gas",
                  "What is in the box: a list of species.",
                  {list_of({mapping(gas_item(dimension))}, 1, most_species, "a list of species")}}),
             required({"run", "What happens to the gas.", {mapping(run(dimension))}}),
             left_to("the template's", {"film", "What the viewer sees.", {mapping(film())}}),
             left_to("none",
                     {"figures",
                      "Pictures of single moments for texts and slides.",
                      {list_of({mapping(figure())}, 0, most_figures, "a list of figures")}})}});
}

}  // namespace

const Section& scene_section(int dimension) {
    static const std::array sections{scene(1), scene(2)};
    return sections.at(static_cast<std::size_t>(dimension - 1));
}

const Section& template_section() {
    static const Section section = template_file();
    return section;
}

const Section& set_section() {
    static const Section section = figure_set();
    return section;
}

std::span<const string> panel_kinds() {
    static const vector<string> kinds{"speed-histogram",
                                      "energy-histogram",
                                      "velocity-histogram",
                                      "position-histogram",
                                      "energy-by-species",
                                      "speed-classes",
                                      "temperature",
                                      "entropy",
                                      "pressure",
                                      "return-distance",
                                      "phase",
                                      "positions",
                                      "monitors",
                                      "single-collision",
                                      "contact-time",
                                      "collision-map",
                                      "text"};
    return kinds;
}

}  // namespace carom
