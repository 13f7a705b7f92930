#include "scene/reading/figure_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/mixing.h"
#include "scene/reading/film_reading.h"

namespace carom {
namespace {

constexpr double column_width = 8.9, page_width = 18.3;       // cm
constexpr double slide_width = 33.867, slide_height = 19.05;  // cm: 13 1/3 by 7 1/2 inches

void check_time(const Node& node, double time, const Run& run, Errors& errors) {
    if (run.until > 0.0 && time > run.until)
        errors.add(node, fmt::format("the run ends at {}", run.until),
                   fmt::format("expected a time from 0 to {}", run.until));
}

std::vector<double> read_strip(const Node& list, const Run& run, Errors& errors) {
    std::vector<double> times = numbers(list);
    for (std::size_t i = 0; i < times.size(); ++i) {
        check_time(list.items[i], times[i], run, errors);
        if (i > 0 && times[i] <= times[i - 1])
            errors.add(list.items[i], "expected times that rise from picture to picture");
    }
    return times;
}

void read_over(const Node& list, FigureSpec& figure, const Run& run, Errors& errors) {
    const std::vector<double> ends = numbers(list);
    check_time(list.items[1], ends[1], run, errors);
    if (ends[0] >= ends[1]) errors.add(list, "expected [from, to] with from < to for `over`");
    figure.times = {ends[1]};
    figure.panel.over = Over{Over::Since::window, ends[1] - ends[0]};
}

void read_times(const Fields& fields, FigureSpec& figure, const Run& run, Errors& errors) {
    figure.times = {run.until};
    if (const Node* at = fields.given("at")) {
        figure.times = {fields.number("at").value_or(0.0)};
        check_time(*at, figure.times.front(), run, errors);
    }
    if (const Node* over = fields.given("over")) read_over(*over, figure, run, errors);
    if (const Node* strip = fields.given("strip")) figure.times = read_strip(*strip, run, errors);
}

void read_size(const Fields& fields, FigureSpec& figure) {
    const Node* size = fields.value("size");
    if (size->is_list()) {
        const Eigen::Array2d sides = pair(*size);
        figure.width = sides[0];
        figure.height = sides[1];
        return;
    }
    figure.slide = size->text == "slide";
    figure.width = size->text == "page" ? page_width : column_width;
    if (!figure.slide) return;
    figure.width = slide_width;
    figure.height = slide_height;
}

// A name that is a file's on every system, and part of a label in every kind of document.
void check_name(const Node& node, const std::vector<FigureSpec>& others, const std::string& name,
                Errors& errors) {
    const bool plain =
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
    if (!plain || name.starts_with('-'))
        errors.add(node, "expected small letters, digits and hyphens for `name`",
                   "it is the name of the figure's files: one-hot-particle-start");
    if (std::ranges::find(others, name, &FigureSpec::name) != others.end())
        errors.add(node, fmt::format("there is another figure of the name `{}`", name),
                   "each writes files of its own: give one of them another name");
}

// Of what the test supposes, as much as is known before the run.
void check_test(const Fields& fields, const Gas& gas, Errors& errors) {
    const Node* asked = fields.given("test");
    if (asked == nullptr || fields.flag("test") != true) return;
    if (fields.mentions("over"))
        errors.add(*asked,
                   "`test` is for one time: over a while the same particles are counted again and "
                   "again, and values are not independent",
                   "give a time in `at` instead of `over`");
    if (fields.flag("theory") == false)
        errors.add(*asked, "`test` compares the bars with the theory, which `theory: false` hides",
                   "leave out one of them");
    if (const auto reason = why_no_equilibrium(gas))
        errors.add(*asked,
                   "there is no equilibrium that this gas could be tested against: " + *reason,
                   "leave out `test`");
}

std::vector<ComparedRun> runs_of_seeds(const Fields& compare, const Gas& gas) {
    std::vector<ComparedRun> runs;
    const auto count = static_cast<std::uint64_t>(compare.integer("seeds").value_or(0));
    for (std::uint64_t seed = gas.seed; seed < gas.seed + count; ++seed)
        runs.push_back({fmt::format("seed {}", seed),
                        {fmt::format("seed={}", seed)},
                        place_of(compare.node())});
    return runs;
}

std::vector<ComparedRun> read_runs(const Node& list, const Section& section, Errors& errors) {
    std::vector<ComparedRun> runs;
    for (const Node& item : list.items) {
        if (!item.valid || !item.is_mapping()) continue;
        const Fields fields{item, section};
        ComparedRun run{fields.text("label").value_or(""), read_changes(fields, errors),
                        place_of(item)};
        if (std::ranges::find(runs, run.label, &ComparedRun::label) != runs.end())
            errors.add(item, fmt::format("there is another run with the label `{}`", run.label),
                       "they could not be told apart");
        runs.push_back(std::move(run));
    }
    return runs;
}

std::vector<ComparedRun> read_compare(const Fields& figure, const Gas& gas, Errors& errors) {
    const Node* compare = figure.given("compare");
    if (compare == nullptr) return {};
    const Key& key = figure.section().keys.at(figure.section().index("compare"));
    const std::vector<const Section*> sections = sections_in(key.forms);  // of seeds, of a run
    if (compare->is_mapping()) return runs_of_seeds({*compare, *sections.front()}, gas);
    return read_runs(*compare, *sections.back(), errors);
}

// The key names runs, not what is drawn of each.
void check_one_line(const Fields& fields, const FigureSpec& figure, Errors& errors) {
    if (const Node* of = fields.given("of"); of != nullptr && figure.panel.of.size() > 1)
        errors.add(*of,
                   "a comparison shows one line of each run: `of` takes one species or particle",
                   "make a figure for each");
}

FigureSpec read_figure(const Fields& fields, const Shown& shown, Errors& errors) {
    FigureSpec figure;
    figure.name = fields.text("name").value_or("");
    figure.panel = read_panel(fields, shown, errors);
    read_times(fields, figure, shown.run, errors);
    figure.panel.at = figure.times.back();
    read_size(fields, figure);
    figure.panel.seeds = static_cast<int>(fields.integer("seeds").value_or(1));
    figure.panel.test = fields.flag("test").value_or(false);
    check_test(fields, shown.gas, errors);
    figure.theme = read_theme(fields.text("theme").value());
    figure.caption = fields.text("caption");
    figure.alt = fields.text("alt");
    figure.compare = read_compare(fields, shown.gas, errors);
    if (fields.mentions("compare")) check_one_line(fields, figure, errors);
    return figure;
}

}  // namespace

std::vector<std::string> read_changes(const Fields& run, Errors& errors) {
    std::vector<std::string> changes;
    const Node* set = run.given("set");
    if (set == nullptr) return changes;
    const std::vector<Node> single{*set};
    for (const Node& one : set->is_list() ? set->items : single) {
        const std::size_t sign = one.text.find('=');
        if (sign == 0 || sign == std::string::npos)
            errors.add(one, fmt::format("expected KEY.PATH=VALUE, found {}", in_quotes(one.text)),
                       "for instance gas.0.temperature=4");
        changes.push_back(one.text);
    }
    return changes;
}

std::pair<std::string, std::string> parted_change(const std::string& change) {
    const std::size_t sign = std::min(change.find('='), change.size());
    return {change.substr(0, sign), sign < change.size() ? change.substr(sign + 1) : ""};
}

FigureSpec read_comparison(const Node& comparison, const Shown& shown, Errors& errors) {
    const Fields fields{comparison, section_of(scene_section(), "figures")};
    FigureSpec figure = read_figure(fields, shown, errors);
    if (const Node* name = fields.given("name")) check_name(*name, {}, figure.name, errors);
    check_one_line(fields, figure, errors);
    return figure;
}

std::vector<FigureSpec> read_figures(const Fields& scene, const Shown& shown, Errors& errors) {
    std::vector<FigureSpec> figures;
    const Node* list = scene.given("figures");
    if (list == nullptr) return figures;
    const Section& section = section_of(scene.section(), "figures");
    for (const Node& item : list->items) {
        if (!item.valid || !item.is_mapping()) continue;
        const Fields fields{item, section};
        FigureSpec figure = read_figure(fields, shown, errors);
        if (const Node* name = fields.given("name"))
            check_name(*name, figures, figure.name, errors);
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace carom
