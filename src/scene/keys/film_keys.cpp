// The keys of films and of templates, which are films with a layout.
#include <algorithm>
#include <utility>

#include "scene/keys/key_table.h"

namespace carom::keys {
namespace {

using std::string;
using std::vector;

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

}  // namespace

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

namespace {

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

}  // namespace

Section template_file() {
    vector<Key> keys = film_keys();
    keys.push_back(required({"layout", "Where things stand in a frame.", {mapping(layout())}}));
    return complete(
        {.name = "a template", .keys = std::move(keys), .choices = {{{"seconds", "pace"}}}});
}

}  // namespace carom::keys
