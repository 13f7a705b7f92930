// The keys of panels and figures, and which kinds of panel take them.
#include <algorithm>
#include <utility>

#include "scene/keys/key_table.h"

namespace carom::keys {
namespace {

using std::string;
using std::vector;

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

}  // namespace

// Those that can show several runs in one panel: one line of each.
const vector<string>& compared() {
    static const vector<string> kinds{
        "speed-histogram", "energy-histogram", "velocity-histogram", "position-histogram",
        "temperature",     "entropy",          "pressure",           "return-distance"};
    return kinds;
}

namespace {

// Those with a curve of theory.
const vector<string>& with_theory() {
    static const vector<string> kinds{"speed-histogram", "energy-histogram", "velocity-histogram",
                                      "return-distance"};
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

}  // namespace

// A text, since a species may be called anything.
vector<Form> chosen() {
    Form one = text(1, most_name_letters);
    one.phrase = "`all`, a species or the number of a particle";
    return {one, list_of({one}, 1, most_chosen, "a list of species and particles")};
}

namespace {

Form window() {
    return mapping(complete({.name = "`over`",
                             .keys = {required({"window",
                                                "How far back from the present, in simulated time.",
                                                {number(positive)}})}}),
                   "{window: time}");
}

}  // namespace

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

namespace {

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
            with_theory(),
            otherwise(
                "true",
                {"theory",
                 "Whether to draw the curve that theory predicts for this finite mixture, if "
                 "it comes to an equilibrium; an error where `true` is written and it cannot. Of "
                 "return distances the law by which they grow, for equal disks.",
                 {flag()}})),
        only_with({"return-distance"},
                  otherwise("time", {"against",
                                     "What they are drawn against: the time since the reversal, or "
                                     "the collisions of each particle since then, on average.",
                                     {one_of({"time", "collisions"})}})),
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

}  // namespace

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

namespace {

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

}  // namespace

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
    Form one_time = time;
    one_time.instead_of_list =
        "a figure has one time; `strip` shows several side by side, in a figure of kind `gas`";
    keys.push_back(
        left_to("the end of the run", {"at", "The simulated time that it shows.", {one_time}}));
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

}  // namespace carom::keys

namespace carom {

std::span<const std::string> panel_kinds() {
    static const std::vector<std::string> kinds{"speed-histogram",
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
