#include "panels/plot/plot.h"

namespace carom::plot {

std::vector<double> dashes_in_print(std::size_t line, std::size_t lines) {
    static const std::array<std::vector<double>, 4> patterns{
        {{}, {0.8, 0.4}, {0.2, 0.25}, {0.9, 0.3, 0.2, 0.3}}};
    return lines < 2 ? std::vector<double>{} : patterns[line % patterns.size()];
}

Stroke stroke_of_run(std::size_t run, double width) {
    static const std::array<std::vector<double>, 6> patterns{{{},
                                                              {0.8, 0.4},
                                                              {0.2, 0.25},
                                                              {0.9, 0.3, 0.2, 0.3},
                                                              {1.6, 0.4},
                                                              {0.9, 0.25, 0.2, 0.25, 0.2, 0.25}}};
    return {.role = {.of = Role::Of::run, .index = run},
            .width = width,
            .dashes = patterns[run % patterns.size()]};
}

Text& Text::operator+=(const Text& more) {
    pieces.insert(pieces.end(), more.pieces.begin(), more.pieces.end());
    return *this;
}

Text operator+(Text first, const Text& second) { return first += second; }

Text named(const std::string& name, const Role& role, Sample sample, std::size_t line) {
    Text text;
    text.pieces.push_back({escape_markup(name), role, sample, line});
    return text;
}

Column column(std::string name, std::vector<double> values) {
    return {std::move(name), std::make_shared<const std::vector<double>>(std::move(values))};
}

const Layer& common(const AnyLayer& layer) {
    return std::visit([](const auto& one) -> const Layer& { return one; }, layer);
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
