// carom plan: divides work into chunks that other processes do, and says which are left.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/commands/film_plans.h"
#include "app/film/film_request.h"
#include "app/output.h"
#include "films/cost/work.h"
#include "util/diagnostics.h"
#include "util/joined.h"
#include "util/text.h"
#include "works/plan_folder.h"
#include "works/sweep_plan.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct PlanArguments : SceneOptions {
    std::vector<std::string> scenes;
    std::string output;
    bool list = false, missing = false;
    FilmPlanArguments film;  // also what sweeps have in common with films
    std::string seeds;
    std::vector<std::string> vary;

    bool is_of_sweep() const { return !seeds.empty() || !vary.empty(); }
};

fs::path folder_of_plan(const PlanArguments& arguments) {
    if (!arguments.output.empty()) return arguments.output;
    return fs::path("out") / (scene_stem(arguments.scenes.front()) + ".plan");
}

bool has_film_options(const FilmPlanArguments& its) {
    return its.chunk_seconds || !its.format.empty() || changes_film(its.film);
}

// For an existing plan, options that make a new plan are refused.
void refuse_options_of_scenes(const PlanArguments& arguments) {
    const FilmPlanArguments& film = arguments.film;
    if (arguments.is_of_sweep() || !arguments.output.empty() || film.force || film.chunks > 0 ||
        has_film_options(film) || !overrides_of(arguments).empty() || arguments.scenes.size() > 1)
        throw UsageError(
            fmt::format("{} holds a plan already, to which only --list and --missing apply; to "
                        "plan again, name "
                        "the scene, with --force",
                        arguments.scenes.front()));
}

// The numbers of chunks, one a line.
void list_chunks(const PlanArguments& arguments) {
    refuse_options_of_scenes(arguments);
    if (arguments.list && arguments.missing)
        throw UsageError("--list and --missing cannot be combined");
    const PlanFolder plan(arguments.scenes.front());
    std::string text;
    if (arguments.missing)
        for (const int number : plan.missing()) text += fmt::format("{}\n", number);
    else
        for (const PlannedChunk& chunk : plan.chunks()) text += fmt::format("{}\n", chunk.number);
    Output("-").write(text);
}

// Returns read(text), the value of an option; errors name the option.
template <class Read>
auto value_of_option(const char* option, const std::string& text, const Read& read) {
    try {
        return read(text);
    } catch (const SweepError& error) {
        throw UsageError(fmt::format("{} {}: {}{}", option, text, error.what(),
                                     error.hint().empty() ? "" : "; " + error.hint()));
    }
}

Sweep sweep_of(const PlanArguments& arguments) {
    Sweep sweep;
    if (!arguments.seeds.empty())
        sweep.seeds = value_of_option("--seeds", arguments.seeds, seed_range);
    for (const std::string& text : arguments.vary)
        sweep.axes.push_back(value_of_option("--vary", text, sweep_axis));
    const std::string all = arguments.vary.empty() ? arguments.seeds : arguments.vary.back();
    return value_of_option(arguments.vary.empty() ? "--seeds" : "--vary", all,
                           [&](const std::string&) {
                               check_sweep(sweep);
                               return sweep;
                           });
}

std::string words_of_plan(const PlanFolder& plan, bool is_new) {
    double seconds = 0.0;
    for (const PlannedChunk& chunk : plan.chunks()) seconds += chunk.seconds;
    const auto chunks = static_cast<long long>(plan.chunks().size());
    const std::string folder = printable(plan.path().string());
    const std::string work = fmt::format("{}: {}, about {} on one core", folder,
                                         counted(chunks, "chunk"), clock_text(seconds));
    if (is_new) return work + "\n";
    const auto missing = static_cast<long long>(plan.missing().size());
    return fmt::format("{}; planned before, {} of them to do (--force plans again)\n", work,
                       missing);
}

void refuse_film_options(const PlanArguments& arguments) {
    if (arguments.scenes.size() > 1)
        throw UsageError("a sweep is of one scene; plan those of several one by one");
    if (has_film_options(arguments.film))
        throw UsageError(
            "--chunk-seconds, --format, --from, --to and --quality apply to films, and --seeds and "
            "--vary to runs; leave out one or the other");
}

void plan_seeds(const PlanArguments& arguments) {
    refuse_film_options(arguments);
    SweepRequest request{.scene = arguments.scenes.front(),
                         .overrides = overrides_of(arguments),
                         .sweep = sweep_of(arguments),
                         .is_seed_of_scene = arguments.seeds.empty(),
                         .is_classroom = arguments.is_classroom,
                         .is_strict = arguments.is_strict};
    const auto is_seed = [](const std::string& change) { return change.starts_with("seed="); };
    if (!arguments.seeds.empty() && std::ranges::any_of(request.overrides, is_seed))
        throw UsageError("--seeds and a value for `seed` cannot be combined");
    if (arguments.film.chunks > 0) request.chunks = arguments.film.chunks;
    const fs::path folder = folder_of_plan(arguments);
    Progress progress(Progress::fitting_form(arguments.quiet),
                      scene_stem(arguments.scenes.front()));
    const bool is_new =
        plan_sweep(request, folder, arguments.film.force, progress, refuse_much_sweep);
    if (!arguments.quiet) Output("-").write(words_of_plan(PlanFolder(folder), is_new));
}

void plan(const PlanArguments& arguments) {
    if (is_plan(arguments.scenes.front())) return list_chunks(arguments);
    if (arguments.list || arguments.missing)
        throw UsageError(fmt::format("{} holds no plan (plan.json)", arguments.scenes.front()));
    if (!arguments.output.empty()) refuse_file_for_folder(arguments.output, "a plan");
    if (!arguments.is_of_sweep())
        return plan_films(arguments.scenes, arguments.output, arguments.film, arguments);
    plan_seeds(arguments);
}

CommandText plan_text() {
    return {
        {"carom plan SCENE... [--chunks N | --chunk-seconds S] [-o PLAN/] [options]",
         "carom plan SCENE --seeds FIRST:LAST [--vary KEY=FIRST:LAST:N]... [-o SWEEP/] [options]",
         "carom plan PLAN/ --list", "carom plan PLAN/ --missing"},
        "Divides work into chunks, which any process on any machine can do in any order, and "
        "writes what they need into a folder. The work is the film of each scene or, with --seeds "
        "or --vary, a sweep: the run of one scene with many seeds and values. carom render and "
        "carom run do the chunks, and carom join puts the results together.",
        {{"carom plan scenes/one-hot-particle.yaml --chunks 8 -o plan/", "a film in 8 chunks"},
         {"carom plan scenes/mixed-masses.yaml --seeds 1:100 --vary gas.0.radius=0.1:0.4:7 -o "
          "sweep/",
          "7 radii with 100 seeds each"},
         {"carom plan plan/ --missing", "the numbers of the chunks that are still to do"}}};
}

}  // namespace

Command plan_command() {
    const auto arguments = std::make_shared<PlanArguments>();
    PlanArguments& its = *arguments;
    return {
        "plan", "divide work into chunks for several processes",
        joined<Option>(
            {{{"scenes", "scene files, - for standard input; or the folder of a plan", &its.scenes},
              {"-o,--output FOLDER",
               "the folder of the plan, with a subfolder for each of several scenes; default: "
               "out/SCENE.plan",
               &its.output},
              {"--seeds FIRST:LAST", "do a run with each seed from FIRST to LAST; N means 1:N",
               &its.seeds},
              {"--vary KEY=VALUES",
               "runs with several values of a key: KEY=FIRST:LAST:N or KEY=V,V,...", &its.vary},
              {.name = "--chunks N",
               .meaning = "the number of chunks of each plan",
               .value = &its.film.chunks,
               .most = most_chunks()},
              {"--list", "print the numbers of the chunks of a plan", &its.list},
              {"--missing", "print the numbers of the chunks that are still to do", &its.missing},
              {"--force", "plan again, and remove the existing chunks", &its.film.force}},
             film_plan_options(its, its.film),
             scene_options(its),
             {limits_option(its.is_classroom)}}),
        [arguments] { plan(*arguments); }, plan_text()};
}

}  // namespace carom
