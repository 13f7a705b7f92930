#include "panels/plot/plot.h"

#include <algorithm>
#include <cmath>

namespace carom::plot {

namespace {

// As many patterns as a panel has choices, and more than there are compared runs.
const std::vector<double>& dashes_of(std::size_t line) {
    static const std::array<std::vector<double>, 8> patterns{{{},
                                                              {0.8, 0.4},
                                                              {0.2, 0.25},
                                                              {0.9, 0.3, 0.2, 0.3},
                                                              {1.6, 0.4},
                                                              {0.9, 0.25, 0.2, 0.25, 0.2, 0.25},
                                                              {0.4, 0.4},
                                                              {1.6, 0.3, 0.4, 0.3}}};
    return patterns[line % patterns.size()];
}

}  // namespace

std::vector<double> dashes_in_print(std::size_t line, std::size_t lines) {
    return lines < 2 ? std::vector<double>{} : dashes_of(line);
}

Stroke stroke_of_run(std::size_t run, double width) {
    return {.role = {.of = Role::Of::run, .index = run}, .width = width, .dashes = dashes_of(run)};
}

Text& Text::operator+=(const Text& more) {
    pieces.insert(pieces.end(), more.pieces.begin(), more.pieces.end());
    return *this;
}

Text operator+(Text first, const Text& second) { return first += second; }

Text text_of(Language language, Phrase phrase, const std::vector<Text>& texts) {
    Text filled;
    std::string_view words = phrases::translated(language, phrase.english);
    for (std::size_t next = 0, open = words.find('{'); open != std::string_view::npos;
         open = words.find('{')) {
        const std::size_t close = words.find('}', open);
        const std::string_view place = words.substr(open + 1, close - open - 1);
        filled += std::string(words.substr(0, open));
        filled += texts.at(place.empty() ? next++ : static_cast<std::size_t>(place[0] - '0'));
        words.remove_prefix(close + 1);
    }
    return filled += std::string(words);
}

Text named(const std::string& name, const Role& role, Swatch swatch, std::size_t line) {
    Text text;
    text.pieces.push_back({escape_markup(name), role, swatch, line});
    return text;
}

Column column(Heading heading, std::vector<double> values) {
    return {std::move(heading), std::make_shared<const std::vector<double>>(std::move(values))};
}

Axis axis_of(Language language, const Quantity& quantity, double low, double high) {
    return {.title = say(language, quantity.word), .low = low, .high = high, .quantity = quantity};
}

ShownUnit unit_of(const Axis& axis, UnitSystem units) {
    if (units != UnitSystem::real || !axis.quantity || axis.quantity->is_logarithm ||
        axis.quantity->dimension.is_none())
        return {};
    const double low = axis.kind == Axis::Kind::linear ? std::abs(axis.low) : 0.0;
    const double high =
        axis.kind == Axis::Kind::linear ? std::abs(axis.high) : std::pow(10.0, axis.high);
    return shown_unit(*axis.quantity, units, std::max(low, high));
}

void name_units(Plot& plot) {
    for (Axis* axis : {&plot.x, &plot.y}) {
        const std::string unit = unit_of(*axis, plot.units).name;
        if (unit.empty()) continue;
        for (Text* title : {&axis->title, &axis->short_title})
            if (title == &axis->title || !title->empty())
                *title += Text((title->empty() ? "" : "\u00A0") + ("(" + unit + ")"));
        axis->is_titled_by_scene = true;
    }
}

const Layer& common(const AnyLayer& layer) {
    return std::visit([](const auto& one) -> const Layer& { return one; }, layer);
}

void name_level(Level& level, std::vector<Text> words, double deviation) {
    constexpr double over = -0.5, under = 1.25, step = 0.5, farthest = 1.5;  // units
    Label& label = level.label.emplace();
    label.still = level.still;
    label.role = level.stroke.role;
    label.words = std::move(words);
    label.level = level.value;
    label.swatch = level.stroke;
    for (double away = 0.0; away <= farthest; away += step)
        for (const bool is_over : {true, false})
            label.anchors.push_back({.at = {1.0, level.value + (is_over ? deviation : -deviation)},
                                     .x_is_share = true,
                                     .offset = {-0.4, is_over ? over - away : under + away},
                                     .align = Align::right,
                                     .step = {-0.5, 0.0}});
}

void name_last_line(Plot& plot, const Text& words) {
    constexpr int places = 16;
    constexpr double over = -0.5, under = 1.25;  // units, to the baseline
    const auto& line = std::get<Polyline>(plot.layers.back());
    Label label;
    label.still = label.is_name = true;
    label.role = line.stroke.role;
    label.words = {words};
    label.swatch = line.stroke;
    label.line = plot.layers.size() - 1;
    for (int k = 2; k < places && line.x.size() > 0; ++k) {
        const std::size_t i = (line.x.size() - 1) * static_cast<std::size_t>(k) / places;
        for (const double off : {over, under})
            for (const bool is_right : {true, false})  // which of them is free if the line slopes
                label.anchors.push_back({.at = {line.x[i], line.y[i]},
                                         .offset = {is_right ? 0.4 : -0.4, off},
                                         .align = is_right ? Align::left : Align::right,
                                         .is_inside = true});
    }
    plot.layers.emplace_back(std::move(label));
}

void name_runs(Plot& plot, std::vector<std::string> names) {
    Note key{.entries = {}, .wraps = true};
    for (std::size_t k = 0; k < names.size(); ++k) {
        const Stroke stroke = stroke_of_run(k);
        key.entries.push_back({stroke, {named(names[k], stroke.role)}});
    }
    plot.notes.push_back(std::move(key));
    plot.runs = std::move(names);
}

}  // namespace carom::plot
