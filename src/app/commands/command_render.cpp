// carom render: the films of scenes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "app/command.h"
#include "app/commands/film_plans.h"
#include "app/commands/render_arguments.h"
#include "app/commands/render_words.h"
#include "app/depfile.h"
#include "app/film/film_path.h"
#include "app/film/film_request.h"
#include "app/output.h"
#include "app/pages/film_page.h"
#include "app/pages/slides.h"
#include "films/cost/film_shape.h"
#include "films/cost/fitted_scenes.h"
#include "films/cost/work.h"
#include "films/film_checks.h"
#include "films/join.h"
#include "films/render.h"
#include "films/words/letters.h"
#include "media/formats.h"
#include "panels/registry.h"
#include "runs/run.h"
#include "scene/limits.h"
#include "scene/sets/set_reading.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/text.h"
#include "works/plan_folder.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// A scene to be rendered, and the values that a list of scenes overrides in it.
struct ListedScene {
    std::string name;
    Overrides values = {};
};

std::string quoted(std::string words) {
    for (std::size_t at = words.find('\''); at != std::string::npos; at = words.find('\'', at + 2))
        words.insert(at, 1, '\'');
    return "'" + words + "'";
}

// The scenes of a figure set; those that it gives a title begin with a card.
std::vector<ListedScene> scenes_of(const SetFile& set) {
    std::vector<ListedScene> scenes;
    for (const SetScene& scene : set.scenes) {
        scenes.push_back({scene.path.string()});
        if (scene.title)
            scenes.back().values = {"title=" + quoted(*scene.title), "film.title_card=true"};
    }
    return scenes;
}

// Loads all scenes before any work, so that a mistake in the last one shows before hours are spent
// on the first.
std::vector<Scene> load_all(const RenderArguments& arguments,
                            const std::vector<ListedScene>& listed_scenes,
                            const std::shared_ptr<const SetDefaults>& set) {
    SceneResources resources = resources_of(arguments);
    resources.set = set;
    Overrides overrides = overrides_of(arguments);
    bool is_first = true;
    return all_made(listed_scenes, [&](const ListedScene& one) {
        Overrides values = one.values;
        values.insert(values.end(), overrides.begin(), overrides.end());
        Scene scene = load_scene(one.name, resources, values);
        if (arguments.join && std::exchange(is_first, false)) {
            const Film& film = scene.film;
            overrides.push_back(
                fmt::format("film.size=[{}, {}]", film.size.width, film.size.height));
            overrides.push_back(fmt::format("film.fps={}", film.fps));
        }
        return scene;
    });
}

// Refuses options and scenes that cannot be joined to one film.
void refuse_join(const RenderArguments& arguments, const std::vector<Scene>& scenes) {
    if (arguments.film.from || arguments.film.to)
        throw UsageError("--join: --from and --to apply to one scene; leave them out");
    if (scenes.size() < 2)
        throw UsageError(
            "--join makes one film of several scenes; give two, or a figure set that lists them");
    refuse_unjoinable(scenes,
                      format_of_film(film_path(arguments.destination, arguments.scenes.front())));
}

// The depfile rules: what each film was made from. A joined film is made from several scenes.
std::string depfile_of(const RenderArguments& arguments, const std::vector<fs::path>& outputs,
                       const std::vector<ListedScene>& listed_scenes,
                       const std::vector<Scene>& scenes) {
    if (arguments.depfile.empty()) return "";
    if (Output::is_stream(arguments.destination.output))
        throw UsageError(
            "--depfile: the film has no file that a rule could be about; name one "
            "with -o");
    std::string text;
    std::vector<std::string> files;
    const bool is_one = arguments.join || !arguments.destination.slides.empty();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::ranges::copy(files_of(scenes[i]), std::back_inserter(files));
        if (is_one && i + 1 < scenes.size()) continue;
        if (arguments.join && listed_scenes.front().name != arguments.scenes.front())
            files.push_back(arguments.scenes.front());  // the set
        std::string made = outputs[is_one ? 0 : i].string();
        if (!arguments.destination.slides.empty()) {
            made = (fs::path(arguments.destination.slides) / "index.html").string();
            files.push_back(document_template("slides.html").name);
        }
        if (made.ends_with('/')) made.pop_back();
        text += depfile_rule(std::vector{made}, files);
        files.clear();
    }
    return text;
}

// `later`: if given, takes what is to be printed once the film is there.
void print_report(const RenderArguments& arguments, const Scene& scene, const RenderReport& report,
                  std::string* later) {
    if (arguments.quiet && !arguments.timings) return;
    const std::string& output = arguments.destination.output;
    const bool streamed = Output::is_stream(output);
    const std::string name = Output::is_standard_output(output) ? "standard output"
                             : streamed                         ? output
                                                                : report.path.string();
    std::string text = words_of(report, scene.film, name, arguments.max_size);
    if (arguments.timings) text += timings_of(report);
    if (streamed) return print_to_stderr(text);
    if (later != nullptr) {
        *later += text;
        return;
    }
    fmt::print("{}", text);
}

RenderReport render_all(const std::vector<Scene>& scenes, const JoinedTitle& title,
                        const FilmOptions& options, Progress& progress) {
    if (scenes.size() > 1) return render_joined(scenes, title, options, progress);
    return render(scenes.front(), options, progress);
}

RenderReport render_to_stream(Output& stream, const std::vector<Scene>& scenes,
                              const JoinedTitle& title, FilmOptions options, Progress& progress) {
    options.take = [&](const FilmWriter& film) {
        film.copy([&](std::string_view piece) { stream.write(piece); });
    };
    return render_all(scenes, title, options, progress);
}

double seconds_of(const std::vector<Scene>& scenes, const JoinedTitle& title,
                  const FilmOptions& options) {
    double seconds = seconds_of_title(title);
    for (const Scene& scene : scenes)
        seconds += static_cast<double>(frames_of(scene, options)) / scene.film.fps;
    return seconds;
}

// The scenes of a film, in the largest shape that fits into `most` bytes.
std::vector<Scene> fitted(const RenderArguments& arguments, const std::vector<Scene>& scenes,
                          const JoinedTitle& title, double most, const FilmOptions& options,
                          Progress& progress) {
    auto found = fitted_scenes(scenes, title, most, options, progress);
    if (!found)
        throw UsageError(
            fmt::format("--max-size {}: a film of {:.6g} seconds takes more, even of small frames "
                        "and few of them; make it shorter (--seconds), or allow more",
                        arguments.max_size, seconds_of(scenes, title, options)));
    return *std::move(found);
}

// Slides whose films are rendered one by one, and what is printed when they are there.
struct SlideWork {
    Slides slides;
    std::string said = {};
};

// Renders the film of one scene, or the joined film of several; for slides, the next one.
void render_film(const RenderArguments& arguments, const std::string& name,
                 const std::vector<Scene>& asked, const fs::path& output,
                 const JoinedTitle& title = {}, SlideWork* slides = nullptr) {
    Progress progress(Progress::fitting_form(arguments.quiet), scene_stem(name));
    FilmOptions options = arguments.film;
    options.cache = arguments.cache;
    options.output = film_at(arguments.destination, output);
    options.threads = threads_of(arguments);
    options.most_bytes = most_bytes(arguments);
    std::vector<Scene> scenes = asked;
    RenderReport report;
    // A page or a stream is opened only once, because the reader of a pipe ends when it is closed.
    std::optional<Output> whole;
    const bool is_page = !arguments.destination.page.empty();
    const std::string target = is_page ? output.string() : arguments.destination.output;
    // The size measured on a few frames may be slightly less than that of the whole film: if the
    // film is too large, aim lower.
    for (double aim = options.most_bytes;; aim *= 0.9) {
        if (std::isfinite(aim)) scenes = fitted(arguments, asked, title, aim, options, progress);
        if (!whole && (is_page || Output::is_stream(target))) whole.emplace(target);
        if (slides != nullptr)
            report = slides->slides.add(scenes.front(), options, progress);
        else if (is_page)
            report = render_page(scenes.front(), options, *whole, progress);
        else if (whole)
            report = render_to_stream(*whole, scenes, title, options, progress);
        else
            report = render_all(scenes, title, options, progress);
        if (fits(report, options)) break;
    }
    print_report(arguments, scenes.front(), report, slides != nullptr ? &slides->said : nullptr);
    if (!arguments.quiet)
        print_to_stderr(warnings_of(report, format_of_film(options.output), is_page));
}

void render_plan(const RenderArguments& arguments) {
    refuse_film_options(arguments);
    if (arguments.scenes.size() != 1)
        throw UsageError("the chunks of one plan are rendered at a time; give one folder");
    render_chunks({.plan = arguments.scenes.front(),
                   .chunk = arguments.chunk,
                   .how = {threads_of(arguments), arguments.force, arguments.allow_mixed},
                   .is_classroom = arguments.is_classroom,
                   .quiet = arguments.quiet});
}

void render_slides(const RenderArguments& arguments, const std::vector<Scene>& scenes,
                   const std::vector<fs::path>& outputs) {
    std::vector<std::string> names;
    for (const fs::path& output : outputs) names.push_back(output.stem().string());
    SlideWork work{Slides({.folder = arguments.destination.slides,
                           .names = std::move(names),
                           .format = format_of_film(outputs.front()).name,
                           .words = arguments.film.text,
                           .force = arguments.force})};
    for (std::size_t i = 0; i < scenes.size(); ++i)
        render_film(arguments, arguments.scenes[i], {scenes[i]}, outputs[i], {}, &work);
    const SlidesReport report = work.slides.finish();
    print_to_stderr(warnings_of(report, arguments.destination.slides));
    if (!arguments.quiet) work.said += words_of(report, work.slides.page().string(), scenes.size());
    fmt::print("{}", work.said);
}

void render_loaded(const RenderArguments& arguments, const std::vector<Scene>& scenes,
                   const std::vector<fs::path>& outputs, const JoinedTitle& title) {
    if (arguments.join)
        return render_film(arguments, arguments.scenes.front(), scenes, outputs.front(), title);
    if (!arguments.destination.slides.empty()) return render_slides(arguments, scenes, outputs);
    std::size_t rendered = 0;
    try {
        for (; rendered < scenes.size(); ++rendered)
            render_film(arguments, arguments.scenes[rendered], {scenes[rendered]},
                        outputs[rendered]);
    } catch (const Interrupted&) {
        if (rendered == 0) throw;
        throw Interrupted(fmt::format("{} of {} films {} written", rendered, scenes.size(),
                                      rendered == 1 ? "is" : "are"));
    }
}

// Refuses outputs, films and their text files, that would replace files in use.
void refuse_used(const RenderArguments& arguments, const std::vector<Scene>& scenes,
                 const std::vector<fs::path>& outputs) {
    if (Output::is_stream(arguments.destination.output) || !arguments.destination.slides.empty())
        return;
    const auto has_words = [&](const std::string& what) {
        if (arguments.film.text) return true;
        const OutputFormat& format =
            format_of_film(film_at(arguments.destination, outputs.front()));
        return what == "captions" && arguments.destination.page.empty() &&
               std::ranges::any_of(scenes,
                                   [&](const Scene& scene) { return has_sound(scene, format); });
    };
    for (const fs::path& output : outputs) {
        Output::refuse_used(output);
        for (const auto& [what, ending] : text_endings)
            if (has_words(what)) Output::refuse_used(text_path(output, what));
    }
}

// Refuses what exceeds --limits. A joined film counts as a whole, other films one by one.
void refuse_much_work(const RenderArguments& arguments, const std::vector<Scene>& scenes,
                      const std::vector<fs::path>& outputs) {
    if (!arguments.is_classroom) return;
    const int measures = arguments.max_size.empty() ? 0 : most_shapes_measured;
    Work all;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const OutputFormat& format =
            format_of_film(film_at(arguments.destination, outputs[arguments.join ? 0 : i]));
        if (arguments.join)
            all = together(
                all, work_of_film(scenes[i], arguments.film, format, counts_of_film(scenes[i])));
        else
            refuse_much_film(scenes[i], arguments.film, format, measures);
    }
    if (arguments.join) refuse_much_work(all, scenes.front().source);
}

void render_scenes(RenderArguments& arguments) {
    if (std::ranges::any_of(arguments.scenes, is_plan)) return render_plan(arguments);
    const bool is_slides = !arguments.destination.slides.empty();
    if (arguments.chunk > 0 || (arguments.force && !is_slides) || arguments.allow_mixed)
        throw UsageError(
            "--chunk, --force and --allow-mixed apply to the folder of a plan; make one with carom "
            "plan SCENE -o PLAN/");
    if (is_slides) refuse_slide_options(arguments);
    refuse_second_standard_input(arguments.scenes);
    arguments.destination.several = arguments.scenes.size() > 1 && !arguments.join;
    const std::vector<fs::path> outputs =
        outputs_of(arguments.destination, arguments.scenes, arguments.join);
    most_bytes(arguments);  // refused before any work
    if (arguments.film.text && Output::is_stream(arguments.destination.output))
        throw UsageError(
            "--words: these files go beside the film, which has no file here; name one with -o");
    JoinedTitle title;
    std::shared_ptr<const SetDefaults> set_defaults;
    std::vector<ListedScene> listed_scenes;
    for (const std::string& name : arguments.scenes) listed_scenes.push_back({name});
    if (arguments.join && arguments.scenes.size() == 1 && is_figure_set(arguments.scenes.front())) {
        const SetFile set =
            load_figure_set(arguments.scenes.front(), panel_kinds(), figure_formats());
        title = {set.title, set.description};
        set_defaults = set.defaults;
        require_letters(title.title + title.words, arguments.scenes.front());
        listed_scenes = scenes_of(set);
    }
    refuse_page_options(arguments, format_of_film(film_at(arguments.destination, outputs.front())));
    const std::vector<Scene> scenes = load_all(arguments, listed_scenes, set_defaults);
    for (const Scene& scene : scenes) say_notes(arguments, scene);
    if (arguments.join) refuse_join(arguments, scenes);
    for (std::size_t i = 0; i < scenes.size(); ++i)
        refuse_unfit(
            scenes[i], arguments.film,
            format_of_film(film_at(arguments.destination, outputs[arguments.join ? 0 : i])));
    refuse_much_work(arguments, scenes, outputs);
    const std::string made_from = depfile_of(arguments, outputs, listed_scenes, scenes);
    std::optional<Output> depfile;  // before the work
    if (!arguments.depfile.empty()) depfile.emplace(arguments.depfile);
    refuse_used(arguments, scenes, outputs);
    render_loaded(arguments, scenes, outputs, title);
    if (!depfile) return;
    depfile->write(made_from);
    depfile->commit();
}

CommandText render_text() {
    return {{"carom render SCENE... [options]", "carom render PLAN/ [--chunk K] [options]"},
            "Simulates the gas of each scene and writes a film of it: MP4, WebM, GIF, a PDF "
            "with a page for each frame, or single frames as PNG. All scenes are read and checked "
            "before the first film begins. The same "
            "scene and seed give the same film, byte for byte, on any number of cores.\n\nFor a "
            "plan made by carom plan, it draws and encodes the missing chunks.",
            {{"carom render scenes/one-hot-particle.yaml", "writes out/one-hot-particle.mp4"},
             {"carom render scenes/mixed-masses.yaml -o film.webm --size 720p --theme light",
              "another format, size and colours"},
             {"carom render scenes/mixed-masses.yaml --set run.until=20 film.seconds=10 --quality "
              "draft",
              "a short film, made quickly"}}};
}

}  // namespace

Command render_command() {
    const auto arguments = std::make_shared<RenderArguments>();
    RenderArguments& its = *arguments;
    return {
        "render", "render the films of scenes",
        joined<Option>(
            {{{"scenes", "scene files, - for standard input; or the folder of a plan", &its.scenes},
              {"-o,--output FILM",
               "the film (.mp4, .webm, .gif, or .pdf with a page for each frame; - for standard "
               "output), an existing folder for it, or a new folder, written with a slash "
               "(frames/), for its frames as PNG; default: out/SCENE.mp4",
               &its.destination.output},
              {"--format", "mp4, webm, gif, pdf, or png for single frames", &its.destination.format,
               film_formats()},
              {"--words",
               "also write captions, chapters and descriptions (.vtt) and a transcript (.txt)",
               &its.film.text},
              {"--page",
               "html: write a page that contains the film, its chapters, transcript and scene",
               &its.destination.page,
               {"html"}},
              {.name = "--slides [FOLDER]",
               .meaning =
                   "write a folder with a page of slides (Reveal.js), one for each scene, and "
                   "the films and posters; default: out/slides",
               .value = &its.destination.slides,
               .absent = "out/slides"},
              {"--join",
               "make one film of all scenes, or those of a figure set, each fading into the next",
               &its.join}},
             chunk_options(its.chunk, its.force, its.allow_mixed,
                           "; for slides: replace files that carom did not write"),
             scene_options(its),
             {limits_option(its.is_classroom)},
             picture_options(its),
             film_options(its, its.film),
             {cache_option(its.cache)},
             {{"--max-size BYTES",
               "reduce the picture size or the frame rate until the film takes at most this much: "
               "5MB, 800kB",
               &its.max_size},
              depfile_option(its.depfile)},
             work_options(its)}),
        [arguments] { render_scenes(*arguments); }, render_text()};
}

}  // namespace carom
