#include "scene/other_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "physics/surfaces/surface_problem.h"
#include "scene/limits.h"
#include "scene/panel_kind.h"
#include "scene/reading/panel_reading.h"
#include "scene/scene.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

// Returns the scene of a compared run, loaded by `reload` with the run's overrides and with that
// figure alone.
Scene compared_scene(const FigureSpec& figure, const ComparedRun& run, Overrides overrides,
                     const ReloadCompared& reload) {
    overrides.insert(overrides.end(), run.values.begin(), run.values.end());
    Diagnostic error = run.place;
    try {
        Scene scene = reload(figure.name, overrides);
        for (FigureSpec& one : scene.figures) one.compare.clear();
        if (!scene.figures.empty() && scene.figures.front().panel.kind == figure.panel.kind)
            return scene;
        error.message = fmt::format("with this change the scene has no figure `{}` of kind `{}`",
                                    figure.name, figure.panel.kind);
        error.hint = "change the gas or the run, not the figures";
    } catch (const SceneError& refused) {
        error.message =
            "with this change the scene is not valid: " + refused.diagnostics().front().message;
        error.hint = refused.diagnostics().front().hint;
    }
    throw SceneError({std::move(error)});
}

// Returns the number of scenes that a figure loads; for a sweep at least those of the first and the
// last point.
std::size_t scenes_of(const FigureSpec& figure) {
    if (sweep_of(figure) == nullptr) return figure.compare.size();
    return runs_sweep(figure) ? 2 : 0;
}

// Keeps only the figure of this name: the others need not be valid for this run.
void keep_figure(Node& root, const std::string& name) {
    Node* list = find(root, "figures");
    if (list == nullptr || !list->is_list()) return;
    std::erase_if(list->items, [&](const Node& figure) {
        const Node* its = find(figure, "name");
        return its == nullptr || its->text != name;
    });
}

Node without(Node mapping, const std::string& key) {
    erase_key(mapping, key);
    return mapping;
}

// Replaces the film, and the end of the run, by those of the scene itself, without its callouts,
// which refer to the scene's own run.
void take_film(Node& root, const ScenePart& part) {
    const auto put = [](Node& mapping, const char* key, const Node& value) {
        if (Node* own = find(mapping, key)) {
            *own = value;
            return;
        }
        mapping.keys.push_back({.kind = Node::Kind::scalar,
                                .source = value.source,
                                .offset = value.offset,
                                .text = key});
        mapping.items.push_back(value);
    };
    put(root, "film", without(*part.film, "callouts"));
    Node* run = find(root, "run");
    if (run != nullptr && run->is_mapping() && part.until != nullptr)
        put(*run, "until", *part.until);
}

// Checks what the two runs of a film must have in common.
std::optional<ProblemText> problem_beside(const Scene& scene, const Scene& other) {
    const Box &box = scene.gas.box, &its = other.gas.box;
    if (box.dimension != its.dimension || box.size != its.size)
        return ProblemText{"the box of the other run has another size",
                           "boxes side by side must have the same size"};
    const auto kinds = [](const Film& film) {
        std::vector<std::string> names;
        for (const PanelSpec& panel : film.panels) names.push_back(panel.kind);
        return names;
    };
    if (kinds(scene.film) != kinds(other.film))
        return ProblemText{"for the gas of the other run the film would have other panels",
                           "name the film's `panels`"};
    const std::vector<double> turns = reversal_times(scene.run);
    for (const double time : reversal_times(other.run))
        if (std::ranges::find(turns, time) == turns.end())
            return ProblemText{
                fmt::format("the other run is reversed at {}, and the scene's own is not", time),
                "reverse the scene's own run then too, or exchange the two runs"};
    return std::nullopt;
}

// Gives the second run the film of the scene itself, with its times, except for what refers to
// particles, which is the second run's own. It has no captions and callouts: those of the film are
// the scene's.
void take_shared(Scene& other, const Film& film) {
    Film its = film;
    its.panels = std::move(other.film.panels);
    its.spotlights = std::move(other.film.spotlights);
    its.camera = std::move(other.film.camera);
    its.trails = std::move(other.film.trails);
    its.callouts.clear();
    its.runs = {};
    other.film = std::move(its);
    other.captions.clear();
}

}  // namespace

void keep_part(Node& root, const ScenePart& part) {
    if (part.figure) keep_figure(root, *part.figure);
    if (part.film != nullptr) take_film(root, part);
}

void keep_run(Node& root) {
    for (const char* key : {"film", "figures"}) erase_key(root, key);
}

void refuse_many_scenes(const Scene& scene) {
    const FigureSpec* last = nullptr;
    std::size_t runs = 0;
    for (const FigureSpec& figure : scene.figures) {
        runs += scenes_of(figure);
        if (scenes_of(figure) > 0) last = &figure;
    }
    const std::size_t bytes = runs * read_bytes(scene.source);
    if (bytes <= most_read_again.count()) return;
    Diagnostic error = last->panel.place;
    error.message = fmt::format(
        "for {} runs that the figures compare or vary, the scene and its template of {} bytes are "
        "read as often: {} bytes",
        runs, read_bytes(scene.source), bytes);
    error.hint = to_text(most_read_again);
    throw SceneError({std::move(error)});
}

std::optional<Diagnostic> of_another_dimension(const ComparedRun& run, const Scene& first,
                                               const std::string& kind, PanelKinds kinds) {
    if (first.gas.box.dimension == run.scene->gas.box.dimension ||
        kind_of(kinds, kind)->can(Ability::any_space))
        return {};
    Diagnostic error = run.place;
    error.message = "this run has another number of dimensions than the first";
    error.hint = "make a figure for each: of different dimensions, " +
                 listed(kinds_that_can(kinds, Ability::any_space), "and", "`") + " can be compared";
    return error;
}

void load_compared(Scene& scene, PanelKinds kinds, const Overrides& overrides,
                   const ReloadCompared& reload) {
    std::vector<Diagnostic> errors;
    for (FigureSpec& figure : scene.figures)
        for (ComparedRun& run : figure.compare) try {
                run.scene = std::make_shared<Scene>(compared_scene(figure, run, overrides, reload));
                const Scene* first = figure.compare.front().scene.get();
                if (first == nullptr) continue;
                if (auto error = of_another_dimension(run, *first, figure.panel.kind, kinds))
                    errors.push_back(std::move(*error));
            } catch (const SceneError& error) {
                errors.insert(errors.end(), error.diagnostics().begin(), error.diagnostics().end());
            }
    if (!errors.empty()) throw SceneError(std::move(errors));
}

void load_beside(Scene& scene, const Node& root, const Overrides& overrides,
                 const ReloadBeside& reload) {
    if (scene.film.runs.others.empty()) return;
    ComparedRun& beside = scene.film.runs.others.front();
    const Node &film = *find(root, "film"), &run = *find(root, "run");
    const Node* file = find(*find(film, "beside"), "scene");
    Overrides changes = file == nullptr ? overrides : Overrides{};
    changes.insert(changes.end(), beside.values.begin(), beside.values.end());
    std::optional<Scene> other;
    Diagnostic error = beside.place;
    try {
        other =
            reload(file != nullptr ? file->text : "",
                   ScenePart{.figure = "", .film = &film, .until = find(run, "until")}, changes);
    } catch (const SceneError& refused) {
        if (file != nullptr) throw;
        const Diagnostic& first = refused.diagnostics().front();
        error.message = "with this change the scene is not valid: " + first.message;
        error.hint = first.hint;
        throw SceneError({std::move(error)});
    }
    if (const auto problem = problem_beside(scene, *other)) {
        error.message = problem->message;
        error.hint = problem->hint;
        throw SceneError({std::move(error)});
    }
    if (file != nullptr) scene.source.files[other->source.path] = other->source.text;
    scene.source.files.insert(other->source.files.begin(), other->source.files.end());
    take_shared(*other, scene.film);
    beside.scene = std::make_shared<Scene>(std::move(*other));
}

}  // namespace carom
