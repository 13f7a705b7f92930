#include "scene/reading/figure_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <variant>

#include "physics/gas.h"
#include "physics/theory/law.h"
#include "scene/keys/made_once.h"
#include "scene/reading/gas_reading.h"
#include "scene/reading/panel_reading.h"
#include "scene/reading/template.h"
#include "util/text.h"

namespace carom {
namespace {

/// A figure with the intermediate values that the rules between its keys need.
struct FigureReading : FigureSpec, PanelSpec {
    std::optional<double> one_time;
    std::vector<double> interval;  ///< from and to, of `over`; empty: not given
    std::vector<double> strip;
    const Node* scenes = nullptr;  ///< of a comparison
};

/// Centimetres.
struct FigureSize {
    double width = 0.0;
    std::optional<double> height = {};
    bool slide = false;
};

const double width_of_column = FigureSpec{}.width;
constexpr double page_width = 18.3;
constexpr double slide_width = 33.867, slide_height = 19.05;  // 13 1/3 by 7 1/2 inches

Binding<FigureSpec> size_key() {
    const auto named = one_of<FigureSize>({{"column", {.width = width_of_column}},
                                           {"page", {.width = page_width}},
                                           {"slide", {slide_width, slide_height, true}}});
    const auto by_sides = mapped(list_of(width_notation(), 2, {2}, "[width, height]"),
                                 [](const std::vector<double>& sides) {
                                     return FigureSize{.width = sides.at(0), .height = sides.at(1)};
                                 });
    const auto by_width =
        mapped(width_notation(), [](double width) { return FigureSize{.width = width}; });
    const auto fill = [](FigureSpec& figure, const FigureSize& size) {
        figure.width = size.width;
        figure.height = size.height;
        figure.slide = size.slide;
    };
    return bind_with<FigureSpec>(
               "size", fill, either(named, either(by_width, by_sides)),
               fmt::format("The size of a text column ({} cm wide), a page ({} cm) or a slide "
                           "({:.1f} cm by {:.1f} cm, with large type), or a width, or width and "
                           "height, in centimetres or with their unit (cm, mm, in, pt, px). If no "
                           "height is given, it follows from the "
                           "width: a box keeps its shape, with no space above and below.",
                           width_of_column, page_width, slide_width, slide_height))
        .default_value("column");
}

Binding<FigureSpec> width_key() {
    return bind_with<FigureSpec>(
               "width",
               [](FigureSpec& figure, double width) {
                   figure.width = width;
                   figure.height.reset();
                   figure.slide = false;
               },
               width_notation(),
               "Instead of `size`: the width, in centimetres or with its unit (cm, mm, in, pt, "
               "px); the height follows from it.")
        .default_text("that of `size`");
}

std::vector<ComparedRun> runs_of_seeds(std::int64_t count, const Node& place,
                                       const Reading& reading) {
    std::vector<ComparedRun> runs;
    const std::uint64_t first = reading.gas.seed;
    for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed)
        runs.push_back(
            {fmt::format("seed {}", seed), {fmt::format("seed={}", seed)}, place_of(place)});
    return runs;
}

void check_labels(const std::vector<Placed<ComparedRun>>& runs, const Node&, Reading& reading) {
    std::set<std::string> labels;
    for (const auto& [run, node] : runs)
        if (!labels.insert(run.label).second)
            reading.errors.add(*node,
                               fmt::format("there is another run with the label `{}`", run.label),
                               "each run needs a label of its own");
}

Notation<std::vector<ComparedRun>> compared_runs() {
    struct Seeds {
        std::int64_t count = 0;
    };
    const KeyTable<Seeds> seeds{
        .name = "`compare`",
        .keys = {bind_key("seeds", &Seeds::count, whole(2, most_compared),
                          "The number of runs, with the scene's seed and those that follow it.")
                     .required()}};
    const KeyTable<ComparedRun> run{
        .name = "an item of `compare`",
        .keys = {label_key().required(), changes_key(), run_color_key()},
        .rule = place_run};
    const auto of_seeds = [](const Seeds& several, const Node& node, Reading& reading) {
        return std::optional(runs_of_seeds(several.count, node, reading));
    };
    const auto listed = checked(
        list_of(placed(mapping(run)), 2, most_compared, "a list of two or more {label, set}"),
        check_labels);
    return either(parsed(mapping(seeds, "{seeds: number}"), of_seeds),
                  mapped(listed, values_of<ComparedRun>));
}

void check_time(const Node& node, double time, Reading& reading) {
    const double until = reading.run.until;
    if (until > 0.0 && time > until)
        reading.errors.add(node, fmt::format("expected a time from 0 to {}", until),
                           fmt::format("the run ends at {}", until));
}

// Sets the times that a figure shows: one, the end of an interval, or several.
void complete_times(FigureReading& figure, const Node& node, Reading& reading) {
    figure.times = {figure.one_time.value_or(reading.run.until)};
    if (figure.one_time) check_time(*given(node, "at"), *figure.one_time, reading);
    if (!figure.interval.empty()) {
        const Node& over = *given(node, "over");
        for (const char* key : {"at", "strip"})
            if (const Node* written = given(node, key))
                reading.errors.add(
                    *written, fmt::format("`{}` and an interval in `over` cannot be combined", key),
                    "keep one of them: an interval ends at the time that the figure shows");
        const double from = figure.interval[0], to = figure.interval[1];
        check_time(over.items[1], to, reading);
        if (from >= to)
            reading.errors.add(over, "expected [from, to] with from < to for `over`",
                               "write the earlier time first");
        figure.times = {to};
        figure.over = Over{Over::Since::window, to - from};
    }
    for (std::size_t i = 0; i < figure.strip.size(); ++i) {
        const Node& moment = given(node, "strip")->items[i];
        check_time(moment, figure.strip[i], reading);
        if (i > 0 && figure.strip[i] <= figure.strip[i - 1])
            reading.errors.add(moment, "expected increasing times",
                               "write the times in order, each once");
    }
    if (!figure.strip.empty()) figure.times = figure.strip;
    figure.at = figure.times.back();
}

// Checks that a name is a valid file name on every system, and valid in a label of every kind of
// document.
void check_name(const std::string& name, const Node& node, Reading& reading) {
    const bool plain =
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
    if (!plain || name.starts_with('-'))
        reading.errors.add(node,
                           plain ? "`name` begins with a hyphen"
                                 : "expected lower-case letters, digits and hyphens for `name`",
                           "it names the figure's files, for instance one-hot-particle");
}

void check_names(const std::vector<Placed<FigureSpec>>& figures, const Node&, Reading& reading) {
    std::set<std::string> names;
    for (const auto& [figure, node] : figures)
        if (const Node* name = given(*node, "name"); !names.insert(figure.name).second && name)
            reading.errors.add(*name,
                               fmt::format("there is another figure named `{}`", figure.name),
                               "each figure writes its own files: give one of them another name");
}

// Why the bars have no equilibrium that they could be tested against. That they are of particles of
// one mass is known when these are drawn.
std::optional<NoLaw> why_no_test(const PanelSpec& panel, const Reading& reading) {
    for (const LawOf quantity : {LawOf::distribution, LawOf::goodness_of_fit}) {
        const auto reason = why_no_law(reading.gas, reading.run, quantity);
        const bool depends_on_choice = reason && !panel.of.empty() &&
                                       (reason->why == NoLaw::Why::unequal_masses ||
                                        reason->why == NoLaw::Why::fixed_particles);
        if (reason && !depends_on_choice) return reason;
    }
    return std::nullopt;
}

// Checks the assumptions of the test, as far as they are known before the run.
void check_test(const PanelSpec& panel, const Node& node, Reading& reading) {
    const Node* asked = given(node, "test");
    if (asked == nullptr || !panel.test) return;
    if (panel.over && panel.over->since != Over::Since::now)
        reading.errors.add(*asked,
                           "`test` applies to one time: over a longer time the same particles are "
                           "counted repeatedly, and values are not independent",
                           "give a time in `at` instead of `over`");
    if (!panel.theory)
        reading.errors.add(*asked,
                           "`test` compares the bars with the theory, which `theory: false` hides",
                           "leave out one of them");
    if (!particles_in(reading.gas)) return;
    const auto reason = why_no_test(panel, reading);
    if (reason)
        reading.errors.add(*asked,
                           "this gas has no equilibrium to be tested against: " +
                               to_text(Language::english, *reason, reading.gas.species),
                           "leave out `test`");
}

// Checks that a comparison draws one line for each run: its legend names the runs, not several
// things drawn for each.
void check_one_line(const PanelSpec& panel, const PanelKind* kind, const Node& node,
                    Reading& reading) {
    const auto refuse = [&](const SeveralShown& several) {
        if (const Node* its = given(node, several.key))
            reading.errors.add(
                *its,
                fmt::format("a comparison shows one line for each run: `{}` takes {}", several.key,
                            several.takes),
                several.hint);
    };
    if (panel.of.size() > 1) refuse({"of", "one species or particle"});
    if (kind == nullptr) return;
    const MeasuredAt at = kind->measured_at ? kind->measured_at(panel) : MeasuredAt{};
    if (at.surfaces.size() > 1) refuse({"surfaces", "one"});
    if (at.regions.size() > 1) refuse({"regions", "one"});
    if (kind->several)
        if (const auto several = kind->several(panel)) refuse(*several);
}

// Only the command line may give another path.
void check_is_inside(const std::string& written, const Node& node, Reading& reading) {
    const std::filesystem::path path = written;
    const bool leads_out = path.is_absolute() || std::ranges::find(path, "..") != path.end();
    if (leads_out && node.source->origin != Origin::command_line)
        reading.errors.add(node,
                           fmt::format("{} leads out of the scene's folder", in_quotes(written)),
                           "move the sweep there, or name it on the command line: --set "
                           "figures.NAME.seeds.from=FOLDER");
}

// The number of runs, or the folder of a sweep that has already run them.
Binding<PanelSpec> seeds_key() {
    struct Joined {
        std::string from;
    };
    using Runs = std::variant<std::int64_t, Joined>;
    const KeyTable<Joined> joined_sweep{
        .name = "`seeds`",
        .keys = {bind_key("from", &Joined::from,
                          checked(text(1, most_title_letters), check_is_inside),
                          "The folder of a sweep that `carom join` has joined, or its summary, "
                          "inside the scene's folder.")
                     .required()}};
    const auto fill = [](PanelSpec& panel, const Runs& runs) {
        if (const auto* sweep = std::get_if<Joined>(&runs))
            panel.joined = sweep->from;
        else
            panel.seeds = static_cast<int>(std::get<std::int64_t>(runs));
    };
    return bind_with<PanelSpec>(
               "seeds", fill,
               either(
                   as<Runs>(whole(1, most_seeds)),
                   as<Runs>(mapping(joined_sweep, "{from: FOLDER} of a figure of kind `sweep`"))),
               "The number of independent runs whose mean it shows, with its standard error. The "
               "runs have the scene's seed and those that follow it.")
        .default_text("1");
}

std::vector<Binding<PanelSpec>> keys_of_runs(PanelKinds kinds) {
    return {bind_key("test", &PanelSpec::test, flag(),
                     "Whether the caption says how well the bars fit the theory, by Pearson's "
                     "chi-squared test, which applies to one time `at` and particles of one mass.")
                .only_with(kinds_that_can(kinds, Ability::equilibrium)),
            seeds_key().only_with(kinds_that_can(kinds, Ability::means))};
}

// The values of `over` for panels, or an interval.
Binding<FigureReading> over_key() {
    using Interval = std::vector<double>;
    using Times = std::variant<Over, Interval>;
    const auto fill = [](FigureReading& figure, const Times& times) {
        if (const auto* interval = std::get_if<Interval>(&times))
            figure.interval = *interval;
        else
            figure.over = std::get<Over>(times);
    };
    return bind_with<FigureReading>(
        "over", fill,
        either(as<Times>(over_notation()),
               as<Times>(list_of(number(not_negative, quantities::time), 2, {2}, "[from, to]"))),
        "The time over which values are taken: only the time shown, all since time 0, a window "
        "before the time shown; or an interval, which replaces `at`.");
}

std::vector<Binding<FigureReading>> time_keys(PanelKinds kinds) {
    const auto one_time = number(not_negative, quantities::time)
                              .with_list_hint(
                                  "a figure has one time; `strip` shows several side by side, in a "
                                  "figure of kind `gas`");
    return {
        bind_key("at", &FigureReading::one_time, one_time, "The simulated time that it shows.")
            .tried_as({"time", "t", "when", "times"})
            .default_text("the end of the run"),
        over_key().only_with(kinds_that_can(kinds, Ability::over)),
        bind_key("strip", &FigureReading::strip,
                 list_of(number(not_negative, quantities::time), 2, most_strip, "a list of times"),
                 "Instead of `at`: several times, shown side by side.")
            .only_with(kinds_that_can(kinds, Ability::strip))};
}

// Those that the defaults of a scene's figures have, too.
std::vector<Binding<FigureSpec>> figure_look_keys() {
    return {size_key(), width_key(), theme_key(&FigureSpec::theme),
            bind_key("svg_text", &FigureSpec::svg_has_text,
                     one_of<bool>({{"paths", false}, {"text", true}}),
                     "What the words of an SVG are: `paths`, outlines of letters, which look the "
                     "same everywhere; or `text`, which can be searched, selected and styled by "
                     "the page, in fonts that the reader must have.")};
}

std::vector<Binding<FigureSpec>> word_keys() {
    return {
        bind_key("caption", &FigureSpec::caption, with_formulas(lines(1, most_letters)),
                 "The words under the figure, with formulae between `$` signs.")
            .default_text("made from what the figure shows"),
        bind_key("alt", &FigureSpec::alt, with_formulas(lines(1, most_letters)),
                 "A description for readers who cannot see the figure; its formulae become words.")
            .default_text("made from what the figure shows")};
}

void complete_figure(FigureReading& figure, const Node& node, PanelKinds kinds, Reading& reading) {
    complete_panel(figure, node, kinds, reading);
    check_units(figure, node, kinds, reading);
    const PanelKind* kind = kind_of(kinds, figure.kind);
    if (figure.joined && (kind == nullptr || !kind->can(Ability::sweep)))
        reading.errors.add(*given(node, "seeds"),
                           fmt::format("only a figure of kind {} reads the runs of a joined sweep",
                                       listed(kinds_that_can(kinds, Ability::sweep), "or", "`")),
                           "give the number of runs, which the figure then does itself");
    complete_times(figure, node, reading);
    check_test(figure, node, reading);
    if (find(node, "compare") != nullptr || find(node, "scenes") != nullptr)
        check_one_line(figure, kind, node, reading);
    constexpr std::size_t two = 2;
    if (kind != nullptr && kind->can(Ability::two_runs) && figure.compare.size() != two)
        reading.errors.add(node,
                           fmt::format("a figure of kind `{}` compares two runs", figure.kind),
                           "give it `compare` with two items");
    figure.panel = figure;
}

KeyTable<FigureReading> figure_table(PanelKinds kinds) {
    std::vector<std::string> names;
    for (const PanelKind& kind : kinds) names.push_back(kind.name);
    const std::vector name{
        bind_key("name", &FigureSpec::name, checked(text(1, most_name_letters), check_name),
                 "The name of its files: lower-case letters, digits and hyphens.")
            .required()};
    const std::vector compare{
        bind_key("compare", &FigureSpec::compare, compared_runs(),
                 "Several runs in one panel with shared axes and a legend: with different seeds, "
                 "or of the scene with other values, each with a label.")
            .default_text("the scene's run alone")
            .only_with(kinds_that_can(kinds, Ability::comparison))};
    return {.name = "a figure",
            .keys = joined<FigureReading>(name, panel_keys(kinds, kind_key(word(names)), {}),
                                          keys_of_runs(kinds), compare, time_keys(kinds),
                                          figure_look_keys(), word_keys()),
            .choices = {{{"at", "strip"}},
                        {{"seeds", "compare"}},
                        {{"test", "compare"}},
                        {{"size", "width"}}},
            .refused = {{"format", "formats are chosen where figures are drawn",
                         "carom figures SCENE --formats svg,png"},
                        {"formats", "formats are chosen where figures are drawn",
                         "carom figures SCENE --formats svg,png"}},
            .rule = [kinds](FigureReading& figure, const Node& node, Reading& reading) {
                complete_figure(figure, node, kinds, reading);
            }};
}

// Returns whether a key applies to comparisons: for a key of only some kinds, whether one of these
// can be compared. Removes the other kinds from the key.
bool is_for_comparison(Binding<FigureReading>& key, const std::vector<std::string>& compared) {
    if (key.key.name == "seeds" || key.key.name == "test" || key.key.name == "compare")
        return false;
    if (key.key.kinds.empty()) return true;
    std::erase_if(key.key.kinds, [&](const std::string& kind) {
        return std::ranges::find(compared, kind) == compared.end();
    });
    return !key.key.kinds.empty();
}

}  // namespace

Notation<double> width_notation() {
    const Range side{smallest_figure.value, largest_figure};
    return either(number(side), length(side, LengthUnit::cm));
}

Notation<std::vector<std::string>> figure_formats_notation() {
    const std::vector<std::string> names(figure_format_names.begin(), figure_format_names.end());
    return one_or_list(word(names), {double(names.size())}, "a list of formats");
}

const FixedTable<FigureDefaults>& figure_defaults_table() {
    static const auto& table = *new FixedTable<FigureDefaults>(KeyTable<FigureDefaults>{
        .name = "`figure_defaults`",
        .keys = joined<FigureDefaults>(
            figure_look_keys(),
            std::vector{bind_key("format", &FigureDefaults::formats, figure_formats_notation(),
                                 "The file formats of figures, unless --formats gives others.")
                            .tried_as({"formats"})
                            .default_text("all")}),
        .choices = {{{"size", "width"}}}});
    return table;
}

void add_defaults(Node& figure, const Node& defaults) {
    if (!figure.is_mapping()) return;
    Node keys = defaults;
    erase_key(keys, "format");
    figure = lay_over(figure, keys, figure_defaults_table().section().choices);
}

void add_defaults_to_all(Node& figures, const Node& defaults) {
    for (Node& figure : figures.items) add_defaults(figure, defaults);
}

Binding<ComparedRun> label_key() {
    return bind_key("label", &ComparedRun::label, text(1, most_name_letters),
                    "Its name in the figure.");
}

Binding<ComparedRun> run_color_key() {
    return bind_key("color", &ComparedRun::color, color(),
                    "Its colour in plots; made darker or lighter where the page needs it.")
        .tried_as({"colour"})
        .default_text("by its place");
}

Binding<ComparedRun> changes_key() {
    const auto check = [](const std::string& change, const Node& node, Reading& reading) {
        const std::size_t sign = change.find('=');
        if (sign == 0 || sign == std::string::npos)
            reading.errors.add(node,
                               fmt::format("expected KEY.PATH=VALUE, found {}", in_quotes(change)),
                               "for instance gas.0.temperature=4");
    };
    auto one = checked(text(3, most_title_letters).called("KEY.PATH=VALUE"), check);
    one.forms.front().words = {"gas.0.temperature=4"};
    return bind_key("set", &ComparedRun::values,
                    one_or_list(one, most_changes, "a list of KEY.PATH=VALUE"),
                    "The values to change in its scene: KEY.PATH=VALUE as for `--set`, or a list "
                    "of these.")
        .default_text("nothing");
}

void place_run(ComparedRun& run, const Node& node, Reading&) { run.place = place_of(node); }

Notation<FigureSpec> comparison_notation(PanelKinds kinds, const Notation<const Node*>& scenes) {
    const std::vector<std::string> compared = kinds_that_can(kinds, Ability::comparison);
    KeyTable<FigureReading> table = figure_table(kinds);
    table.name = "a comparison";
    for (Binding<FigureReading> key : std::exchange(table.keys, {})) {
        if (!is_for_comparison(key, compared)) continue;
        const bool is_kind = key.key.name == "kind";
        if (is_kind) key.key.forms = word(compared).forms;
        table.keys.push_back(std::move(key));
        if (is_kind)
            table.keys.push_back(
                bind_key("scenes", &FigureReading::scenes, scenes,
                         "The scenes that it compares, in one panel with shared axes and a legend.")
                    .required());
    }
    table.choices = {{{"size", "width"}}};
    return as<FigureSpec>(mapping(table));
}

const Notation<std::vector<FigureSpec>>& figures_notation(PanelKinds kinds) {
    static MadeOnce<Notation<std::vector<FigureSpec>>> notations;
    return notations.of(kinds, [&] {
        const auto figure = placed(as<FigureSpec>(mapping(figure_table(kinds))));
        return mapped(checked(list_of(figure, 0, most_figures, "a list of figures"), check_names),
                      values_of<FigureSpec>);
    });
}

}  // namespace carom
