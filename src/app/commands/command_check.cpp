// carom check: whether scenes and figure sets are valid, what they are, and what they will cost.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/check/accessibility.h"
#include "app/check/check_facts.h"
#include "app/command.h"
#include "app/figures/figure_pages.h"
#include "app/figures/set_loading.h"
#include "app/figures/set_work.h"
#include "app/film/film_path.h"
#include "app/film/film_request.h"
#include "app/output.h"
#include "draw/text.h"
#include "figures/figure_drawing.h"
#include "figures/sweep_figure.h"
#include "films/cost/trial_run.h"
#include "films/film_checks.h"
#include "films/render.h"
#include "films/words/letters.h"
#include "panels/registry.h"
#include "panels/words/text_panel.h"
#include "panels/words/word_numbers.h"
#include "panels/words_left_out.h"
#include "physics/placement/draws.h"
#include "runs/own_files.h"
#include "scene/numbers/known_numbers.h"
#include "scene/sets/set_reading.h"
#include "util/diagnostics.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

struct CheckArguments : SceneOptions {
    std::vector<std::string> scenes;
    FilmOptions film;
    std::string format;  // empty: all
    bool json = false, measures = false, accessible = false, numbers = false;
};

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
    if (runs_sweep(figure)) check_swept_figure(scene, figure);
}

// Counts the run of a scene, which these panels see; tries those that its figures compare, too.
RunCounts tried(const Scene& scene, std::vector<PanelSpec> panels) {
    const std::vector<PanelSpec> of_figures = panels_to_try(scene.figures);
    panels.insert(panels.end(), of_figures.begin(), of_figures.end());
    for (const FigureSpec& figure : scene.figures)
        for (const ComparedRun& run : figure.compare)
            try_run(*run.scene, panels_to_try(run.scene->figures));
    return counts_of(scene, panels);
}

// The collisions that a film shows, at most as many as its runs may have.
std::optional<double> collisions_of_film(const Scene& scene, const SceneCounts& counts) {
    const auto limited = [](const Scene& one, const RunCounts& its) {
        const auto most = static_cast<double>(collision_ceiling(one.run, total_count(one.gas)));
        return std::min(most, its.collisions.value_or(0.0));
    };
    if (!counts.front().collisions) return std::nullopt;
    double all = 0.0;
    const std::vector<const Scene*> scenes = scenes_of_film(scene);
    for (std::size_t k = 0; k < scenes.size(); ++k) all += limited(*scenes[k], counts.at(k));
    return all;
}

// The words on the title cards of the set's joined film.
std::string words_on_cards(const FigureSet& set) {
    std::string words = set.title + set.description;
    for (const SetPart& part : set.parts) words += part.title;
    return words;
}

// Notes why a scene of a set, which was loaded for its figures, can have no film.
void find_missing_film(const Scene& scene, std::vector<CommandsRefused>& refused) {
    try {
        scene_from(scene.source);
    } catch (const SceneError& error) {
        refused.push_back({{"render", "figures --films"}, error.diagnostics()});
    }
}

// Checks a figure set with all its scenes, figures and pages; returns its facts.
Facts facts_of_set(const CheckArguments& arguments, const std::string& path,
                   const Overrides& overrides, CheckedFile& found) {
    const FigureSet set = load_set(path, resources_of(arguments), overrides);
    std::vector<CommandsRefused> refused;
    require_letters(words_on_cards(set), path);
    for (const SetPart& part : set.parts) {
        if (!part.compares) find_barriers(arguments, part.scene, found);
        refuse_long_words(part.scene);
        tried(part.scene, panels_to_try(part.scene.film.panels));
        if (!part.compares) find_missing_film(part.scene, refused);
        for (const std::string& name : part.figures)
            check_figure(part.scene, *figure_spec(part.scene, name));
    }
    for (const PageTemplate& page : set.pages) page_text(set, page, {}, {});
    refuse_same_names(set);
    const Work figures = work_of_set(set, {}, false);
    refuse_much_work(figures, set.parts.front().scene.source);
    return facts_of(set, {{"figures", figures}}, refused);
}

// Measures the cost of a film in the format asked for, or else as MP4.
FilmCost measured(const CheckArguments& arguments, const std::string& path, const Scene& scene,
                  FilmOptions options) {
    Progress progress(Progress::fitting_form(arguments.quiet), scene_stem(path));
    options.output =
        film_path({.output = {}, .format = arguments.format}, arguments.scenes.front());
    return measured_cost(scene, options, progress);
}

// Notes the formats that the film of a scene cannot have; returns the others.
std::vector<const OutputFormat*> formats_of(const Scene& scene,
                                            std::vector<CommandsRefused>& refused) {
    std::vector<const OutputFormat*> formats;
    for (const OutputFormat* format : formats_with_costs()) try {
            refuse_format(*format, scene);
            formats.push_back(format);
        } catch (const UsageError& error) {
            Diagnostic reason;
            reason.span.file = scene.source.path;
            reason.message = error.what();
            const std::string as = " as " + format->name;
            refused.push_back({{"render" + as, "plan" + as}, {reason}});
            if (format->name == "mp4") refused.back().commands.push_back("gallery" + as);
        }
    return formats;
}

// Finds the words for which the plots of a film have no room, or none at their lines, if its run
// takes a fraction of a second.
void find_words_without_room(const Scene& scene, const RunCounts& counts, CheckedFilm& film) {
    constexpr double most_events = 300'000.0;
    if (counts.bits > bits_of_double || counts.events > most_events) return;
    constexpr double few_events = 20'000.0;  // of which all frames can be seen
    const bool is_quick = counts.events > few_events;
    Progress silent(Progress::Form::silent, "");
    const TextLog log;
    draw_still_alone(with_usual_numbers(scene), scene.run.until, is_quick, {}, output_format("png"),
                     silent);
    film.cut = words_left_out(log);
    film.in_keys = words_in_keys(log);
}

CheckedFilm checked_film(const CheckArguments& arguments, const std::string& path,
                         const Scene& scene, const SceneCounts& counts,
                         std::vector<CommandsRefused>& refused) {
    CheckedFilm film{.options = arguments.film,
                     .counts = counts,
                     .collisions = collisions_of_film(scene, counts)};
    film.options.threads = threads_of(arguments);
    refuse_span(film.options, scene);
    if (arguments.format.empty()) {
        film.formats = formats_of(scene, refused);
    } else {
        film.formats = {&output_format(arguments.format)};
        refuse_format(*film.formats.front(), scene);
    }
    if (arguments.measures) film.measured = measured(arguments, path, scene, film.options);
    return film;
}

// The work of commands that draw no film.
NamedWork works_of(const Scene& scene, const RunCounts& counts) {
    NamedWork works{{"run", work_of_run(scene, counts)}};
    if (!scene.figures.empty())
        works.emplace_back("figures", work_of_figures(scene, {}, figure_formats(), counts));
    return works;
}

// Refuses the run if it takes too much, and notes that the figures do.
void hold_to_limits(const Scene& scene, const NamedWork& works,
                    std::vector<CommandsRefused>& refused) {
    for (const auto& [command, work] : works) {
        try {
            refuse_much_work(work, scene.source);
        } catch (const SceneError& error) {
            if (command == "run") throw;
            refused.push_back({{command}, error.diagnostics()});
        }
    }
}

// Of the formats of a film the first is refused, if it takes too much, and the others are noted.
void hold_to_limits(const CheckArguments& arguments, const Scene& scene, CheckedFilm& film,
                    std::vector<CommandsRefused>& refused) {
    const OutputFormat* const first = film.formats.front();
    std::erase_if(film.formats, [&](const OutputFormat* format) {
        try {
            refuse_much_work(work_of_film(scene, arguments.film, *format, film.counts),
                             scene.source);
            return false;
        } catch (const SceneError& error) {
            if (format == first) throw;
            const std::string as = " as " + format->name;
            refused.push_back({{"render" + as, "plan" + as}, error.diagnostics()});
            return true;
        }
    });
}

// The numbers for which words of the scene may ask.
Facts numbers_of(const CheckArguments& arguments, const Scene& scene) {
    if (!arguments.numbers) return {};
    std::vector<KnownNumber> all = known_numbers(scene, panel_kinds());
    for (const FigureSpec& figure : scene.figures)
        for (KnownNumber& number : known_numbers(figure, panel_kinds()))
            all.push_back(std::move(number));
    std::vector<ListItem> rows;
    for (const auto& [name, meaning] : all)
        rows.push_back(
            {fmt::format("{{{}}}: {}", name, meaning), Json{{"name", name}, {"meaning", meaning}}});
    return rows_of("numbers", "numbers", std::move(rows));
}

Facts facts_of_scene(const CheckArguments& arguments, const std::string& path,
                     const Overrides& overrides, CheckedFile& found) {
    const auto [scene, no_film] = load_for_all(path, resources_of(arguments), overrides);
    const bool has_film = no_film.empty();
    if (has_film) refuse_long_words(scene);
    require_letters(scene);
    const RunCounts own =
        tried(scene, has_film ? panels_to_try(scene.film.panels) : std::vector<PanelSpec>{});
    for (const FigureSpec& figure : scene.figures) check_figure(scene, figure);
    NamedWork works = works_of(scene, own);
    std::vector<CommandsRefused> refused;
    if (!has_film) {
        refused.push_back({{"render", "still", "plan", "gallery", "figures --films"}, no_film});
        hold_to_limits(scene, works, refused);
        return joined<Fact>(
            {facts_of(scene, std::nullopt, own, works, refused), numbers_of(arguments, scene)});
    }
    find_barriers(arguments, scene, found);
    SceneCounts counts{own};
    for (const ComparedRun& run : scene.film.runs.others) counts.push_back(counts_of(*run.scene));
    CheckedFilm film = checked_film(arguments, path, scene, counts, refused);
    hold_to_limits(scene, works, refused);
    hold_to_limits(arguments, scene, film, refused);
    find_words_without_room(scene, own, film);
    works.emplace_back("render",
                       work_of_film(scene, arguments.film, *film.formats.front(), counts));
    return joined<Fact>({facts_of(scene, film, own, works, refused), numbers_of(arguments, scene)});
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
              {"--numbers",
               "list the numbers for which words of the scene may ask, as {temperature}",
               &its.numbers},
              {"--format", "give the cost of this format only", &its.format, chunk_formats()}},
             scene_options(its),
             {limits_option(its.is_classroom)},
             picture_options(its),
             film_options(its, its.film),
             {threads_option(its)}}),
        [arguments] { check_scenes(*arguments); }, check_text()};
}

}  // namespace carom
