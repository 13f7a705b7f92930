// carom run: the physics alone, its statistics and its samples.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/chunks/build_facts.h"
#include "app/command.h"
#include "app/output.h"
#include "app/report/run_facts.h"
#include "app/report/samples_csv.h"
#include "app/report/surfaces_csv.h"
#include "app/resources.h"
#include "app/simulate.h"
#include "app/sweep/sweep_plan.h"
#include "runs/run.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct RunArguments : SceneOptions {
    std::string scene;
    std::string json, csv, surfaces;  // paths, or - for standard output; empty: none
    int chunk = 0;                    // of a sweep; 0: all that are missing
    bool force = false, allow_mixed = false;

    // By their options.
    std::array<std::pair<const char*, std::string>, 3> outputs() const {
        return {{{"--json", json}, {"--csv", csv}, {"--surfaces", surfaces}}};
    }
};

bool is_same_output(const std::string& a, const std::string& b) {
    return !a.empty() && !b.empty() &&
           (a == b || is_same_file(a, b) ||
            (Output::is_standard_output(a) && Output::is_standard_output(b)) ||
            fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal());
}

void refuse_same_files(const RunArguments& arguments) {
    const auto outputs = arguments.outputs();
    for (const auto& [flag, path] : outputs)
        if (!path.empty() && is_same_file(path, arguments.scene))
            throw UsageError(fmt::format("{} {}: this would overwrite the scene", flag, path));
    for (std::size_t i = 0; i < outputs.size(); ++i)
        for (std::size_t j = i + 1; j < outputs.size(); ++j)
            if (is_same_output(outputs[i].second, outputs[j].second))
                throw UsageError(fmt::format(
                    "{} and {} would both be written to {}", outputs[i].first, outputs[j].first,
                    Output::is_standard_output(outputs[j].second) ? "standard output"
                                                                  : outputs[j].second));
}

bool standard_output_is_taken(const RunArguments& arguments) {
    return std::ranges::any_of(arguments.outputs(), [](const auto& output) {
        return Output::is_standard_output(output.second);
    });
}

// A table of surfaces would have no rows where there are only walls that reflect.
void refuse_no_surfaces(const RunArguments& arguments, const Scene& scene) {
    const auto is_of_surface = [](const RunEvent& event) {
        return std::holds_alternative<ChangeSurface>(event.action) ||
               std::holds_alternative<MoveSurface>(event.action);
    };
    if (arguments.surfaces.empty() || !scene.gas.box.surfaces.are_plain() ||
        std::ranges::any_of(scene.run.events, is_of_surface))
        return;
    throw UsageError(fmt::format(
        "--surfaces: {} has nothing but walls that reflect; leave the option out, or give the "
        "scene walls that act, partitions, obstacles or gravity",
        arguments.scene));
}

std::string report_text(const RunArguments& arguments, const Scene& scene,
                        const RunReport& report) {
    std::string text;
    const auto outputs = arguments.outputs();
    const bool has_outputs =
        std::ranges::any_of(outputs, [](const auto& output) { return !output.second.empty(); });
    if (!arguments.quiet && !has_outputs) text += run_table(scene, report);
    if (!arguments.quiet && !standard_output_is_taken(arguments))
        for (const auto& [flag, path] : outputs)
            if (!path.empty()) text += printable(path) + "\n";
    if (arguments.timings) text += (text.empty() ? "" : "\n") + run_timings(report);
    return text;
}

void print(const RunArguments& arguments, const std::string& text) {
    if (text.empty()) return;
    if (standard_output_is_taken(arguments)) return say(text);
    Output("-").write(text);
}

// When the work is interrupted, a table that went to a stream is there as far as it came.
template <typename Work>
auto reporting_incomplete(const std::optional<Output>& stream, const Work& work) {
    try {
        return work();
    } catch (const Interrupted&) {
        const std::string left = stream ? stream->left_behind() : "";
        if (left.empty()) throw;
        throw Interrupted(left);
    }
}

// What says what a run is and where its results go; a plan has them.
void refuse_options_of_scene(const RunArguments& arguments) {
    for (const auto& [flag, path] : arguments.outputs())
        if (!path.empty())
            throw UsageError(fmt::format(
                "{} is for one scene; carom join {} --csv has a row for each run of a sweep", flag,
                arguments.scene));
    if (!overrides_of(arguments).empty())
        throw UsageError(
            fmt::format("{} is planned: give --seed and --set to carom plan", arguments.scene));
    if (arguments.is_classroom)
        throw UsageError(fmt::format("--limits is for one scene; {} is planned", arguments.scene));
}

// Those that are done already are left as they are.
void run_sweep(const RunArguments& arguments) {
    refuse_options_of_scene(arguments);
    const PlanFolder plan(arguments.scene);
    const PlannedSweep sweep(plan, "run");
    if (!arguments.allow_mixed) plan.require_same_build(carom::to_json(physics_facts()));
    std::vector<PlannedChunk> chunks = plan.chunks();
    if (arguments.chunk > 0) chunks = {plan.chunk(arguments.chunk)};
    for (const PlannedChunk& chunk : chunks) {
        if (!arguments.force && plan.is_done(chunk)) continue;
        Progress progress(Progress::fitting_form(arguments.quiet),
                          fs::absolute(plan.path() / "").parent_path().filename().string());
        sweep.run_chunk(chunk, threads_of(arguments), progress);
    }
}

void refuse_options_of_sweep(const RunArguments& arguments) {
    for (const auto& [flag, is_given] : {std::pair{"--chunk", arguments.chunk > 0},
                                         {"--force", arguments.force},
                                         {"--allow-mixed", arguments.allow_mixed}})
        if (is_given)
            throw UsageError(fmt::format(
                "{} is for the folder of a sweep, which carom plan makes; {} holds none", flag,
                arguments.scene));
}

// The outputs before the work: it may not be allowed to write them.
void run_scene(const RunArguments& arguments) {
    refuse_same_files(arguments);
    const Scene scene = load_scene(arguments.scene, resources_of(arguments),
                                   overrides_of(arguments), Wanted::physics);
    refuse_no_surfaces(arguments, scene);
    std::optional<Output> json, csv, surfaces;
    std::optional<SamplesCsv> table;
    std::optional<SurfacesCsv> surface_table;
    if (!arguments.json.empty()) json.emplace(arguments.json);
    if (!arguments.csv.empty()) table.emplace(scene.gas, csv.emplace(arguments.csv));
    if (!arguments.surfaces.empty())
        surface_table.emplace(scene.gas.box, surfaces.emplace(arguments.surfaces));
    SampleTaker take;
    if (table || surface_table)
        take = [&](const Particles& particles, const Sample& sample,
                   const std::vector<SurfaceState>& states) {
            if (table) table->add(particles, sample);
            if (surface_table) surface_table->add(sample.time, states);
        };
    Progress progress(Progress::fitting_form(arguments.quiet), scene_stem(arguments.scene));
    const RunReport report = reporting_incomplete(csv, [&] {
        const RunReport whole = run_physics(scene, take, shown_run(scene, progress));
        progress.finish();
        if (table) table->finish();
        return whole;
    });
    if (json) json->write(run_json(scene, report));
    std::vector<PendingOutput*> outputs;
    for (std::optional<Output>* const output : {&csv, &surfaces, &json})
        if (*output) outputs.push_back(&**output);
    commit_together(outputs);
    print(arguments, report_text(arguments, scene, report));
}

CommandText run_text() {
    return {{"carom run SCENE [--json FILE] [--csv FILE] [--surfaces FILE] [options]",
             "carom run SWEEP/ [--chunk K] [options]"},
            "Simulates without drawing, and prints a summary: collisions, energy, momentum, "
            "temperature, pressure, and how exact the run was. Samples are taken at time 0, at "
            "every multiple of `run.sample_every`, and at the end.\n\nOf a sweep that carom plan "
            "has made, it does the runs of the chunks that are missing.",
            {{"carom run scenes/time-reversal.yaml", "prints the summary"},
             {"carom run scenes/mixed-masses.yaml --csv samples.csv --json summary.json",
              "every sample as CSV, the summary as JSON"},
             {"carom run scenes/mixed-masses.yaml --seed 7 --set run.until=20",
              "with other random choices, for a shorter time"}}};
}

}  // namespace

Command run_command() {
    const auto arguments = std::make_shared<RunArguments>();
    RunArguments& its = *arguments;
    return {
        "run", "simulate without drawing: statistics and samples",
        joined<Option>(
            {{{"scene", "a scene file, - for standard input; or the folder of a sweep", &its.scene},
              {"--json FILE", "the statistics as JSON; - for standard output", &its.json},
              {"--csv FILE", "all samples, a row for each particle; - for standard output",
               &its.csv},
              {"--surfaces FILE",
               "what walls, partitions and obstacles have done, a row for each sample and surface; "
               "- "
               "for standard output",
               &its.surfaces}},
             chunk_options(its.chunk, its.force, its.allow_mixed),
             scene_options(its),
             {limits_option(its)},
             work_options(its)}),
        [arguments] {
            if (is_plan(arguments->scene)) return run_sweep(*arguments);
            refuse_options_of_sweep(*arguments);
            run_scene(*arguments);
        },
        run_text()};
}

}  // namespace carom
