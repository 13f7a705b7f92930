#include "scene/sweep_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace carom {
namespace {

// The first of the mistakes, at the figure.
Diagnostic at_figure(const FigureSpec& figure, const std::vector<std::string>& changes,
                     const SceneError& error) {
    const Diagnostic& first = error.diagnostics().front();
    Diagnostic diagnostic = figure.panel.place;
    diagnostic.message =
        fmt::format("with {} the scene is not valid: {}", fmt::join(changes, ", "), first.message);
    diagnostic.hint = first.hint;
    return diagnostic;
}

void check_points(const FigureSpec& figure, std::vector<Diagnostic>& errors) {
    const SweepShown& shown = figure.panel.sweep;
    for (std::int64_t point = 0; !shown.from && point < shown.sweep.points(); ++point) {
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
    for (FigureSpec& figure : scene.figures) {
        if (figure.panel.kind != "sweep") continue;
        figure.panel.sweep.scene_with = [source = scene.source,
                                         resources](const std::vector<std::string>& changes) {
            Overrides overrides = source.overrides;
            overrides.insert(overrides.end(), changes.begin(), changes.end());
            return std::make_shared<const Scene>(
                load_run_text(source.text, source.path, resources, overrides));
        };
        check_points(figure, errors);
    }
    if (!errors.empty()) throw SceneError(std::move(errors));
}

}  // namespace carom
