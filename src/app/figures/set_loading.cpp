#include "app/figures/set_loading.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/command.h"
#include "app/figures/figure_pages.h"
#include "films/words/letters.h"
#include "media/formats.h"
#include "panels/registry.h"
#include "runs/own_files.h"
#include "scene/other_runs.h"
#include "scene/sets/set_reading.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

std::vector<std::string> figure_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const FigureSpec& figure : scene.figures) names.push_back(figure.name);
    return names;
}

[[noreturn]] void fail(Diagnostic place, std::string message, std::string hint) {
    place.message = std::move(message);
    place.hint = std::move(hint);
    throw SceneError({std::move(place)});
}

// Of a scene that no file lists, errors are those of the command line.
SetPart part_of(const SetScene& listed_scene, const SceneResources& resources,
                const Overrides& overrides, Wanted wanted) {
    SetPart part;
    const std::filesystem::path& path = listed_scene.path;
    part.scene = load_scene(path, resources, overrides, wanted);
    require_letters(part.scene);
    part.stem = scene_stem(path.string());
    part.title = listed_scene.title.value_or(part.scene.title);
    part.description = listed_scene.description.value_or(part.scene.description);
    const std::vector<std::string> names = figure_names(part.scene);
    if (names.empty() && listed_scene.place.span.file.empty()) {
        const std::vector<Diagnostic>& notes = part.scene.notes;
        throw UsageError(notes.empty()
                             ? fmt::format("{}: the scene lists no `figures`; carom figure {} "
                                           "--kind gas draws one that is not listed",
                                           part.scene.source.path, part.scene.source.path)
                             : fmt::format("{}: no figures: {}", part.scene.source.path,
                                           note_text(notes.front())));
    }
    if (names.empty())
        fail(listed_scene.place, fmt::format("the scene {} lists no figures", path.string()), "");
    for (const auto& [name, place] : listed_scene.figures) {
        if (std::ranges::find(names, name) == names.end())
            fail(place, fmt::format("{} has no figure `{}`", path.string(), name),
                 spelling_hint(name, names, "its figures: " + listed(names, "and", "`")));
        part.figures.push_back(name);
    }
    if (part.figures.empty()) part.figures = names;
    return part;
}

ComparedRun run_of(const SetRun& run, const SceneResources& resources, Overrides overrides) {
    overrides.insert(overrides.end(), run.values.begin(), run.values.end());
    Scene scene;
    try {
        scene = load_run(run.path, resources, overrides);
    } catch (const SceneError& error) {
        if (run.values.empty()) throw;
        const Diagnostic& first = error.diagnostics().front();
        fail(run.place, "with this change the scene is not valid: " + first.message, first.hint);
    }
    ComparedRun compared = run;
    if (compared.label.empty()) compared.label = scene.title;
    compared.scene = std::make_shared<Scene>(std::move(scene));
    return compared;
}

SetPart part_of(const std::string& path, const SetFile& set, const SetComparison& comparison,
                const SceneResources& resources, const Overrides& overrides) {
    std::vector<ComparedRun> runs = all_made(
        comparison.runs, [&](const SetRun& run) { return run_of(run, resources, overrides); });
    for (ComparedRun& run : runs) {  // its mistakes are mostly those of all: reported once
        Scene scene = *run.scene;
        scene.figures = {figure_of(comparison, scene, panel_kinds())};
        run.scene = std::make_shared<Scene>(std::move(scene));
    }
    const Scene& first = *runs.front().scene;
    for (const ComparedRun& run : runs)
        if (const auto error =
                of_another_dimension(run, first, first.figures.front().panel.kind, panel_kinds()))
            throw SceneError({*error});
    for (std::size_t k = 1; k < runs.size(); ++k)
        for (std::size_t i = 0; i < k; ++i)
            if (runs[i].label == runs[k].label)
                fail(runs[k].place, fmt::format("another run has the label `{}`", runs[k].label),
                     "each run needs a `label` of its own");
    SetPart part;
    part.compares = true;
    part.scene = *runs.front().scene;
    part.scene.title = set.title;
    part.scene.subtitle = "";
    part.scene.description = set.description.empty() ? set.title : set.description;
    part.scene.source.path = path;
    part.scene.source.text = set.text;
    FigureSpec& figure = part.scene.figures.front();
    figure.compare = std::move(runs);
    require_letters(part.scene);
    part.stem = figure.name;
    part.figures = {figure.name};
    return part;
}

std::vector<SetPart> parts_of_set(const std::string& path, const SetFile& set,
                                  const SceneResources& resources, const Overrides& overrides,
                                  Wanted wanted) {
    struct Piece {
        const SetScene* scene;
        const SetComparison* comparison;
    };
    std::vector<Piece> pieces;
    for (const SetScene& scene : set.scenes) pieces.push_back({&scene, nullptr});
    for (const SetComparison& one : set.comparisons) pieces.push_back({nullptr, &one});
    std::vector<SetPart> parts = all_made(pieces, [&](const Piece& piece) {
        return piece.scene != nullptr ? part_of(*piece.scene, resources, overrides, wanted)
                                      : part_of(path, set, *piece.comparison, resources, overrides);
    });
    const auto first = std::ranges::find(parts, true, &SetPart::compares);
    if (first != parts.end()) first->title = say(first->scene.film.language, "Comparison");
    return parts;
}

// The formats that all scenes of a set agree on; none if they do not.
std::vector<std::string> formats_of_all(const std::vector<SetPart>& parts) {
    const std::vector<std::string>& first = parts.front().scene.figure_formats;
    const bool is_common = std::ranges::all_of(
        parts, [&](const SetPart& part) { return part.scene.figure_formats == first; });
    return is_common ? first : std::vector<std::string>{};
}

std::vector<std::string> first_given(const std::vector<std::vector<std::string>>& all) {
    const auto found = std::ranges::find_if(all, [](const auto& one) { return !one.empty(); });
    return found != all.end() ? *found : std::vector<std::string>{};
}

// Those of figure_formats that are asked for, in their order; none: all.
std::vector<std::string> in_order(const std::vector<std::string>& formats) {
    std::vector<std::string> all;
    for (const std::string& format : figure_formats())
        if (formats.empty() || std::ranges::find(formats, format) != formats.end())
            all.push_back(format);
    return all;
}

std::vector<PageTemplate> pages_of(const std::vector<std::string>& asked) {
    std::vector<PageTemplate> pages;
    for (const std::string& page : asked) pages.push_back(page_template(page));
    return pages;
}

}  // namespace

FigureSet load_set(const std::string& path, const SceneResources& resources,
                   const Overrides& overrides, const std::vector<std::string>& formats,
                   const std::vector<std::string>& pages, Wanted wanted) {
    const EndsAtOnce whole;
    const bool is_stream = path == standard_input;
    FigureSet set{.of = is_stream ? "stdin" : std::filesystem::path(path).filename().string(),
                  .stem = scene_stem(path)};
    SetFile file;
    if (is_stream || !is_figure_set(path)) {
        SetPart& part = set.parts.emplace_back(
            part_of({.path = path, .place = {}}, resources, overrides, wanted));
        set.title = part.scene.title;
        set.description = part.scene.description;
    } else {
        file = load_figure_set(path, panel_kinds(), figure_formats());
        set.title = file.title;
        set.description = file.description;
    }
    set.pages = pages_of(pages.empty() ? file.templates : pages);
    if (set.parts.empty()) {
        SceneResources of_set = resources;
        of_set.set = file.defaults;
        set.parts = parts_of_set(path, file, of_set, overrides, wanted);
    }
    set.formats = in_order(first_given({formats, file.formats, formats_of_all(set.parts)}));
    return set;
}

}  // namespace carom
