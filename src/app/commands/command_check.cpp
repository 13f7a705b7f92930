// carom check: whether scenes and figure sets are valid, what they are, and what they will cost.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/command.h"
#include "app/figures/figure_pages.h"
#include "app/figures/set_loading.h"
#include "app/film/film_path.h"
#include "app/film/film_request.h"
#include "app/film/words/letters.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/report/accessibility.h"
#include "app/report/check_facts.h"
#include "app/report/trial_run.h"
#include "app/resources.h"
#include "figures/figure_drawing.h"
#include "figures/sweep_figure.h"
#include "panels/words/text_panel.h"
#include "scene/reading/set_reading.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

struct CheckArguments : SceneOptions {
    std::vector<std::string> scenes;
    FilmOptions film;
    std::string format;  // empty: all
    bool json = false, measures = false, accessible = false;
};

// Loads a scene. One that says nothing about a film, and from which none can be made, is still
// valid for its physics.
std::pair<Scene, bool> loaded(const std::string& path, const SceneResources& resources,
                              const Overrides& overrides) {
    try {
        return {load_scene(path, resources, overrides, Wanted::film), true};
    } catch (const SceneError& error) {
        try {
            return {load_scene(path, resources, overrides, Wanted::physics), false};
        } catch (const SceneError&) {
            throw error;
        }
    }
}

// Finds barriers if they are asked for, in films of the format asked for.
void find_barriers(const CheckArguments& arguments, const Scene& scene, CheckedFile& found) {
    if (!arguments.accessible) return;
    const bool has_format = !arguments.format.empty();
    std::vector<Diagnostic> its =
        barriers_in(scene, has_format ? &output_format(arguments.format) : nullptr);
    if (!found.barriers) found.barriers.emplace();
    found.barriers->insert(found.barriers->end(), its.begin(), its.end());
}

// Checks a figure. The joined sweep that it shows need not exist yet.
void check_figure(const Scene& scene, const FigureSpec& figure) {
    refuse_long_words(scene, figure);
    if (figure.panel.kind == "sweep" && !figure.panel.sweep.from) check_swept_figure(scene, figure);
}

// The words on the title cards of the set's joined film.
std::string words_on_cards(const FigureSet& set) {
    std::string words = set.title + set.description;
    for (const SetPart& part : set.parts) words += part.title;
    return words;
}

// Checks a figure set with all its scenes, figures and pages; returns its facts.
Facts facts_of_set(const CheckArguments& arguments, const std::string& path,
                   const Overrides& overrides, CheckedFile& found) {
    const FigureSet set = load_set(path, resources_of(arguments), overrides);
    require_letters(words_on_cards(set), path);
    for (const SetPart& part : set.parts) {
        if (!part.compares) find_barriers(arguments, part.scene, found);
        refuse_long_words(part.scene);
        try_run(part.scene, true);
        for (const std::string& name : part.figures)
            check_figure(part.scene, *figure_spec(part.scene, name));
    }
    for (const PageTemplate& page : set.pages) page_text(set, page, {}, {});
    refuse_same_names(set);
    return facts_of(set);
}

// Measures the cost of a film in the format asked for, or else as MP4.
FilmCost measured(const CheckArguments& arguments, const std::string& path, const Scene& scene,
                  FilmOptions options) {
    Progress progress(Progress::fitting_form(arguments.quiet), scene_stem(path));
    options.output =
        film_path({.output = {}, .format = arguments.format}, arguments.scenes.front());
    return measured_cost(scene, options, progress);
}

CheckedFilm checked_film(const CheckArguments& arguments, const std::string& path,
                         const Scene& scene, std::optional<double> collisions) {
    CheckedFilm film{.options = arguments.film, .collisions = collisions};
    film.options.threads = threads_of(arguments);
    if (!arguments.format.empty()) film.format = &output_format(arguments.format);
    refuse_span(film.options, scene);
    if (film.format != nullptr) refuse_format(*film.format, scene);
    if (arguments.measures) film.measured = measured(arguments, path, scene, film.options);
    return film;
}

Facts facts_of_scene(const CheckArguments& arguments, const std::string& path,
                     const Overrides& overrides, CheckedFile& found) {
    const auto [scene, has_film] = loaded(path, resources_of(arguments), overrides);
    if (has_film) refuse_long_words(scene);
    require_letters(scene);
    const std::optional<double> collisions = try_run(scene, has_film);
    for (const FigureSpec& figure : scene.figures) check_figure(scene, figure);
    if (has_film) find_barriers(arguments, scene, found);
    return facts_of(scene, has_film
                               ? std::optional(checked_film(arguments, path, scene, collisions))
                               : std::nullopt);
}

CheckedFile checked(const CheckArguments& arguments, const std::string& path,
                    const Overrides& overrides) {
    CheckedFile found{.path = path == standard_input ? "<stdin>" : path,
                      .is_set = path != standard_input && is_figure_set(path)};
    try {
        found.facts = found.is_set ? facts_of_set(arguments, path, overrides, found)
                                   : facts_of_scene(arguments, path, overrides, found);
    } catch (const SceneError& error) {
        found.errors = error.diagnostics();
    } catch (const MissingLetters& error) {
        Diagnostic& one = found.errors.emplace_back();
        one.span.file = error.path;
        one.message = error.what_is_missing;
        one.hint = MissingLetters::hint;
    } catch (const UsageError& error) {
        Diagnostic& one = found.errors.emplace_back();
        one.span.file = path;
        one.message = error.what();
    }
    return found;
}

// Throws if files are invalid: with the errors themselves for standard error, unless the JSON
// contains them.
void refuse_invalid(const std::vector<CheckedFile>& files, bool json) {
    std::vector<Diagnostic> errors;
    std::size_t invalid = 0;
    for (const CheckedFile& file : files) {
        errors.insert(errors.end(), file.errors.begin(), file.errors.end());
        invalid += file.facts ? 0 : 1;
    }
    if (invalid == 0) return;
    if (!json) throw SceneError(std::move(errors));
    const bool any_set = std::ranges::any_of(files, &CheckedFile::is_set);
    throw UsageError(fmt::format("{} of {} {}{} {} not valid", invalid, files.size(),
                                 any_set ? "file" : "scene", files.size() == 1 ? "" : "s",
                                 invalid == 1 ? "is" : "are"));
}

void refuse_barriers(const std::vector<CheckedFile>& files, bool json) {
    std::vector<Diagnostic> barriers;
    for (const CheckedFile& file : files)
        if (file.barriers)
            barriers.insert(barriers.end(), file.barriers->begin(), file.barriers->end());
    if (barriers.empty()) return;
    if (!json) throw SceneError(std::move(barriers));
    throw UsageError(
        fmt::format("--accessible: {}", counted(static_cast<int>(barriers.size()), "barrier")));
}

void check_scenes(const CheckArguments& arguments) {
    refuse_second_standard_input(arguments.scenes);
    const Overrides overrides = overrides_of(arguments);
    std::vector<CheckedFile> files;
    for (const std::string& path : arguments.scenes)
        files.push_back(checked(arguments, path, overrides));
    if (arguments.json)
        Output("-").write(check_json(files));
    else if (!arguments.quiet)
        Output("-").write(check_table(files));
    refuse_invalid(files, arguments.json);
    refuse_barriers(files, arguments.json);
}

CommandText check_text() {
    return {
        {"carom check SCENE|SET... [--measure] [--json] [options]"},
        "Checks all scenes and figure sets, reports every mistake of each with its line, and says "
        "what a valid scene contains and what its film will cost.",
        {{"carom check scenes/mixed-masses.yaml", "is it valid, and how long will its film take?"},
         {"carom check scenes/mixed-masses.yaml --format gif --size 640x360 --fps 15 --measure",
          "what a small GIF will take, measured on a few of its frames"},
         {"carom check scenes/mixed-masses.yaml scenes/sets/collisions.yaml --json",
          "as JSON, for other programs"}}};
}

}  // namespace

Command check_command() {
    const auto arguments = std::make_shared<CheckArguments>();
    CheckArguments& its = *arguments;
    return {
        "check", "check scenes and figure sets, and estimate their cost",
        joined<Option>(
            {{{"scenes", "scene files and figure sets; - for a scene from standard input",
               &its.scenes},
              {"--json", "print JSON: a list with an object for each file", &its.json},
              {"--measure",
               "simulate each film and encode a few frames, which gives its size to within a third",
               &its.measures},
              {"--accessible",
               "refuse what keeps some viewers from following the film (WCAG 2.1, level AA)",
               &its.accessible},
              {"--format", "give the cost of this format only", &its.format, chunk_formats()}},
             scene_options(its),
             {limits_option(its)},
             picture_options(its),
             film_options(its, its.film),
             {threads_option(its)}}),
        [arguments] { check_scenes(*arguments); }, check_text()};
}

}  // namespace carom
