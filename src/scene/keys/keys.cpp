#include "scene/keys/keys.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "physics/run.h"
#include "scene/keys/key_table.h"
#include "scene/time/captions.h"

namespace carom::keys {
namespace {

using std::string;
using std::vector;

// What would make collisions lose energy, wherever it may be asked for.
Section all_elastic(Section section) {
    for (const char* name : {"restitution", "elasticity", "elastic", "inelastic", "dissipation",
                             "damping", "friction"})
        section.refused.push_back(
            {name,
             fmt::format("there is no `{}`: all collisions are elastic and without friction, with "
                         "walls too",
                         name),
             "energy is conserved, and every collision can be undone: leave it out"});
    return complete(std::move(section));
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
    return all_elastic(std::move(section));
}

Section box(int dimension) {
    const Form side = one_of({"solid", "periodic"});
    return all_elastic(
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
    return all_elastic(std::move(section));
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
                  {"reverse",
                   "Turns every velocity round; a run with one reversal must last until the gas is "
                   "home, at twice its time.",
                   {one_of({"velocities"})}},
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
    return all_elastic(
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

Section scene(int dimension) {
    return all_elastic(
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
}  // namespace carom::keys

namespace carom {

const Section& scene_section(int dimension) {
    static const std::array sections{keys::scene(1), keys::scene(2)};
    return sections.at(static_cast<std::size_t>(dimension - 1));
}

const Section& template_section() {
    static const Section section = keys::template_file();
    return section;
}

const Section& set_section() {
    static const Section section = keys::figure_set();
    return section;
}

}  // namespace carom
