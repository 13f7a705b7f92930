#include "scene/sweep_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/limits.h"
#include "scene/scene.h"
#include "scene/yaml/scalar.h"

namespace carom {
namespace {

constexpr const char* values_hint =
    "values in equal steps are written KEY=FIRST:LAST:N, for instance gas.0.radius=0.1:0.4:7";

// Returns the first of the errors, at the place of the figure.
Diagnostic at_figure(const FigureSpec& figure, const std::vector<std::string>& changes,
                     const SceneError& error) {
    const Diagnostic& first = error.diagnostics().front();
    Diagnostic diagnostic = figure.panel.place;
    diagnostic.message =
        fmt::format("with {} the scene is not valid: {}", fmt::join(changes, ", "), first.message);
    // If all values are numbers, the error is not due to a mistyped range.
    const bool is_number = std::ranges::all_of(changes, [](const std::string& change) {
        return parse_number(change.substr(change.find('=') + 1)).has_value();
    });
    diagnostic.hint = first.hint.empty() && !is_number ? values_hint : first.hint;
    return diagnostic;
}

// Loads the scene at the points of a sweep; if there are more than `most`, at points spread evenly,
// including the first and the last.
void check_points(const FigureSpec& figure, std::int64_t most, std::vector<Diagnostic>& errors) {
    const SweepShown& shown = *sweep_of(figure);
    const std::int64_t points = runs_sweep(figure) ? shown.sweep.points() : 0;
    const std::int64_t looks = std::min(points, std::max<std::int64_t>(most, 2));
    for (std::int64_t look = 0; look < looks; ++look) {
        const std::int64_t point = looks > 1 ? look * (points - 1) / (looks - 1) : 0;
        const std::vector<std::string> changes = shown.sweep.changes_at(point);
        try {
            shown.scene_with(changes);
        } catch (const SceneError& error) {
            errors.push_back(at_figure(figure, changes, error));
            return;
        }
    }
}

}  // namespace

void load_sweep_figures(Scene& scene, const SceneResources& resources) {
    std::vector<Diagnostic> errors;
    const auto sweeps = std::ranges::count_if(scene.figures, sweep_of);
    const auto loads = most_read_again.count() / std::max<std::size_t>(read_bytes(scene.source), 1);
    for (FigureSpec& figure : scene.figures) {
        if (sweep_of(figure) == nullptr) continue;
        figure.panel.options.change<SweepShown>().scene_with =
            [source = scene.source, resources](const std::vector<std::string>& changes) {
                Overrides overrides = source.overrides;
                overrides.insert(overrides.end(), changes.begin(), changes.end());
                return std::make_shared<const Scene>(
                    load_run_text(source.text, source.path, resources, overrides));
            };
        check_points(figure, static_cast<std::int64_t>(loads) / sweeps, errors);
    }
    if (!errors.empty()) throw SceneError(std::move(errors));
}

}  // namespace carom
