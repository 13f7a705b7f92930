#include "scene/figure_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/film_reading.h"
#include "scene/mixing.h"

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
    return figure;
}

}  // namespace

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
