#include "app/check/figure_facts.h"

#include <fmt/format.h>

#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "panels/registry.h"
#include "runs/number_json.h"
#include "scene/panel_kind.h"
#include "util/text.h"

namespace carom {
namespace {

// " at time 4", " over time 6 to 12".
std::string words_of_time(const FigureSpec& spec, UnitSystem units) {
    const PanelKind& kind = kind_of(spec.panel);
    if (kind.has_own_time && kind.has_own_time(spec.panel)) return "";
    const ShownTimes shown = times_of(spec);
    return fmt::format(" {} time {}", shown.over ? "over" : "at",
                       words_of({Language::english, units}, shown));
}

// "speeds: speed-histogram at time 4, 8.9 by 6.2 cm".
std::string figure_words(const Scene& scene, const FigureSpec& spec) {
    const auto [width, height] = figure_size(scene, spec);
    const std::string kind =
        spec.compare.empty() ? spec.panel.kind
                             : fmt::format("{} of {} runs", spec.panel.kind, spec.compare.size());
    return fmt::format("{}: {}{}, {:.3g} by {:.3g} cm", spec.name, kind,
                       words_of_time(spec, scene.units), width, height);
}

Json figure_value(const Scene& scene, const FigureSpec& spec) {
    const auto [width, height] = figure_size(scene, spec);
    Json times = Json::array();
    for (const double time : spec.times)
        times.push_back(Amount{time, quantities::time, scene.units});
    Json fields{{"name", spec.name},
                {"kind", spec.panel.kind},
                {"times", std::move(times)},
                {"size_cm", Json::array({width, height})}};
    Json runs = Json::array();
    for (const ComparedRun& run : spec.compare) runs.push_back(run.label);
    if (!runs.empty()) fields["runs"] = std::move(runs);
    return fields;
}

}  // namespace

Json section_value(const SetPart& part) {
    Json figures = Json::array();
    for (const std::string& name : part.figures)
        figures.push_back(figure_value(part.scene, *figure_spec(part.scene, name)));
    return Json{{"scene", part.compares ? Json() : Json(part.stem)},
                {"title", part.title},
                {"figures", std::move(figures)}};
}

// Comparisons behind the scenes.
Facts section_rows(const FigureSet& set) {
    Facts rows;
    for (const SetPart& part : set.parts) {
        if (part.compares) continue;
        rows.push_back(for_people("scene", part.stem));
        for (const std::string& name : part.figures)
            rows.push_back(
                for_people(" ", figure_words(part.scene, *figure_spec(part.scene, name))));
    }
    for (const SetPart& part : set.parts) {
        if (!part.compares) continue;
        const FigureSpec& spec = part.scene.figures.front();
        std::vector<std::string> labels;
        for (const ComparedRun& run : spec.compare) labels.push_back(run.label);
        rows.push_back(for_people("comparison", figure_words(part.scene, spec)));
        rows.push_back(for_people(" ", listed(labels)));
    }
    return rows;
}

}  // namespace carom
