// carom run: the physics alone, its statistics and its samples.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/command.h"
#include "app/depfile.h"
#include "app/output.h"
#include "app/report/collisions_csv.h"
#include "app/report/run_facts.h"
#include "app/report/samples_csv.h"
#include "app/report/samples_xyz.h"
#include "app/report/surfaces_csv.h"
#include "films/cost/work.h"
#include "runs/own_files.h"
#include "runs/run.h"
#include "runs/run_progress.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/text.h"
#include "works/build_facts.h"
#include "works/sweep_plan.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct RunArguments : SceneOptions {
    std::string scene;
    // Paths of outputs, or - for standard output; empty: not written.
    std::string json, csv, surfaces, xyz, events, depfile;
    int chunk = 0;  // number of a chunk of a sweep; 0: all missing ones
    bool force = false, allow_mixed = false;
    bool is_run_alone = false;  // whether film and figures are ignored

    // The outputs with their options.
    std::array<std::pair<const char*, std::string>, 6> outputs() const {
        return {{{"--json", json},
                 {"--csv", csv},
                 {"--surfaces", surfaces},
                 {"--xyz", xyz},
                 {"--events", events},
                 {"--depfile", depfile}}};
    }
};

void refuse_same_files(const RunArguments& arguments) {
    const auto outputs = arguments.outputs();
    for (const auto& [flag, path] : outputs)
        if (!path.empty() && is_same_file(path, arguments.scene))
            throw UsageError(fmt::format("{} {}: this would overwrite the scene", flag, path));
    for (std::size_t i = 0; i < outputs.size(); ++i)
        for (std::size_t j = i + 1; j < outputs.size(); ++j)
            if (!outputs[i].second.empty() && !outputs[j].second.empty() &&
                Output::are_same(outputs[i].second, outputs[j].second))
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

// Refuses a table of surfaces for a box with only reflecting walls: it would have no rows.
void refuse_no_surfaces(const RunArguments& arguments, const Scene& scene) {
    if (arguments.surfaces.empty() || !scene.gas.box.surfaces.are_plain() ||
        change_behaviours(scene.run.events))
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
    if (standard_output_is_taken(arguments)) return print_to_stderr(text);
    Output("-").write(text);
}

// A table and its output, if it was asked for.
template <typename Table>
struct TableOutput {
    std::optional<Output> output;
    std::optional<Table> table;

    // Opens the output before the work, in case it cannot be written.
    template <typename Subject>
    TableOutput(const std::string& path, const Subject& subject, UnitSystem units) {
        if (!path.empty()) table.emplace(subject, output.emplace(path), units);
    }
};

// The outputs of a run, which appear together or not at all.
class RunOutputs {
  public:
    RunOutputs(const RunArguments& arguments, const Gas& gas, UnitSystem units)
        : samples_(arguments.csv, gas, units),
          surfaces_(arguments.surfaces, gas.box, units),
          trajectory_(arguments.xyz, gas, units),
          collisions_(arguments.events, gas.box, units) {
        if (!arguments.json.empty()) json_.emplace(arguments.json);
        if (!arguments.depfile.empty()) depfile_.emplace(arguments.depfile);
    }

    RunTakers takers() {
        RunTakers take;
        if (samples_.table || surfaces_.table || trajectory_.table)
            take.sample = [this](const Particles& particles, const Sample& sample,
                                 const std::vector<SurfaceState>& states) {
                if (samples_.table) samples_.table->add(particles, sample);
                if (surfaces_.table) surfaces_.table->add(sample.time, states);
                if (trajectory_.table) trajectory_.table->add(particles, sample);
            };
        if (collisions_.table)
            take.collisions = [this](const Particles& particles,
                                     std::span<const Collision> collisions) {
                collisions_.table->add(particles, collisions);
            };
        return take;
    }

    // Passes the rows that the tables still hold to their outputs.
    void finish() {
        if (samples_.table) samples_.table->finish();
        if (trajectory_.table) trajectory_.table->finish();
        if (collisions_.table) collisions_.table->finish();
    }

    // After an interruption: a message about tables that were partly written to streams.
    std::string left_behind() {
        std::vector<std::string> left;
        for (const std::optional<Output>* output : tables())
            if (*output && !(*output)->left_behind().empty())
                left.push_back((*output)->left_behind());
        return fmt::format("{}", fmt::join(left, "; "));
    }

    void commit(const std::string& json, const std::string& depfile) {
        if (json_) json_->write(json);
        if (depfile_) depfile_->write(depfile);
        std::vector<PendingOutput*> all;
        std::vector<std::optional<Output>*> outputs = tables();
        outputs.insert(outputs.end(), {&json_, &depfile_});
        for (std::optional<Output>* const output : outputs)
            if (*output) all.push_back(&**output);
        commit_together(all);
    }

  private:
    std::vector<std::optional<Output>*> tables() {
        return {&samples_.output, &surfaces_.output, &trajectory_.output, &collisions_.output};
    }

    TableOutput<SamplesCsv> samples_;
    TableOutput<SurfacesCsv> surfaces_;
    TableOutput<SamplesXyz> trajectory_;
    TableOutput<CollisionsCsv> collisions_;
    std::optional<Output> json_, depfile_;
};

// The depfile: what the files that a run writes are made from; empty if it is not asked for.
std::string depfile_of(const RunArguments& arguments, const Scene& scene) {
    if (arguments.depfile.empty()) return "";
    std::vector<std::string> made;
    for (const auto& [flag, path] : arguments.outputs())
        if (!path.empty() && path != arguments.depfile && !Output::is_standard_output(path))
            made.push_back(path);
    if (made.empty())
        throw UsageError(
            "--depfile: this run writes no other file, and the rule would be about none; add "
            "--csv FILE or another output");
    return depfile_rule(made, files_of(scene));
}

// Refuses options that define a run or the destination of its results: a plan has fixed them.
void refuse_options_of_scene(const RunArguments& arguments) {
    for (const auto& [flag, path] : arguments.outputs())
        if (!path.empty())
            throw UsageError(fmt::format(
                "{} is for one scene; carom join {} --csv has a row for each run of a sweep", flag,
                arguments.scene));
    if (arguments.is_run_alone)
        throw UsageError(
            fmt::format("{} is planned: give --set run.until=T to carom plan", arguments.scene));
    if (!overrides_of(arguments).empty())
        throw UsageError(
            fmt::format("{} is planned: give --seed and --set to carom plan", arguments.scene));
}

// Does the chunks of a sweep. Chunks that are done already are left as they are.
void run_sweep(const RunArguments& arguments) {
    refuse_options_of_scene(arguments);
    const PlanFolder plan(arguments.scene);
    const PlannedSweep sweep(plan, "run", arguments.is_classroom);
    refuse_much_sweep(sweep.sweep(), [&](std::int64_t point) { return sweep.scene_at(point); });
    if (!arguments.allow_mixed) plan.require_same_build(carom::to_json(physics_build_facts()));
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

RunTables tables_of(const RunArguments& arguments) {
    return {.samples = !arguments.csv.empty(),
            .trajectory = !arguments.xyz.empty(),
            .collisions = !arguments.events.empty()};
}

// Runs a scene. The outputs are opened before the work, in case they cannot be written.
void run_scene(const RunArguments& arguments) {
    refuse_same_files(arguments);
    const Scene scene =
        load_scene(arguments.scene, resources_of(arguments), overrides_of(arguments),
                   arguments.is_run_alone ? Wanted::run : Wanted::physics);
    say_notes(arguments, scene);
    refuse_no_surfaces(arguments, scene);
    if (arguments.is_classroom)
        refuse_much_work(work_of_run(scene, counts_of(scene), tables_of(arguments)), scene.source);
    const std::string depfile = depfile_of(arguments, scene);
    RunOutputs outputs(arguments, scene.gas, scene.units);
    Progress progress(Progress::fitting_form(arguments.quiet), scene_stem(arguments.scene));
    RunReport report;
    try {
        RunTakers take = outputs.takers();
        take.aside = threads_of(arguments) > 1;
        report = run_physics(scene, take, shown_run(scene, progress));
        progress.finish();
        outputs.finish();
    } catch (const Interrupted&) {
        const std::string left = outputs.left_behind();
        if (left.empty()) throw;
        throw Interrupted(left);
    }
    outputs.commit(arguments.json.empty() ? "" : run_json(scene, report), depfile);
    print(arguments, report_text(arguments, scene, report));
}

Option end_option(RunArguments& its) {
    return {.name = "--to T",
            .meaning = "simulate to this time instead of `run.until`, and ignore film and figures",
            .value =
                [&its](const std::string& time) {
                    its.is_run_alone = true;
                    its.shortcuts.push_back(change_of("run.until", time));
                },
            .key = "run.until"};
}

CommandText run_text() {
    return {{"carom run SCENE [--to T] [--json FILE] [--csv FILE] [--xyz FILE] [--events FILE] "
             "[options]",
             "carom run SWEEP/ [--chunk K] [options]"},
            "Simulates without drawing, and prints a summary: collisions, energy, momentum, "
            "temperature, pressure, and how accurate the run was. Samples are taken at time 0, at "
            "every multiple of `run.sample_every`, and at the end.\n\nFor a sweep made by carom "
            "plan, it does the runs of the missing chunks.",
            {{"carom run scenes/time-reversal.yaml", "prints the summary"},
             {"carom run scenes/mixed-masses.yaml --csv samples.csv --json summary.json",
              "every sample as CSV, the summary as JSON"},
             {"carom run scenes/mixed-masses.yaml --seed 7 --to 20",
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
              end_option(its),
              {"--json FILE", "the statistics as JSON; - for standard output", &its.json},
              {"--csv FILE", "all samples, a row for each particle; - for standard output",
               &its.csv},
              {"--surfaces FILE",
               "position, hits, impulse, work and heat of walls, partitions and obstacles, a row "
               "for each sample and surface; - for standard output",
               &its.surfaces},
              {"--xyz FILE",
               "all samples as a trajectory in the extended XYZ format, for OVITO and ASE; - for "
               "standard output",
               &its.xyz},
              {"--events FILE", "every collision as CSV, a row for each; - for standard output",
               &its.events},
              depfile_option(its.depfile)},
             chunk_options(its.chunk, its.force, its.allow_mixed),
             scene_options(its),
             {limits_option(its.is_classroom)},
             work_options(its)}),
        [arguments] {
            if (is_plan(arguments->scene)) return run_sweep(*arguments);
            refuse_options_of_sweep(*arguments);
            run_scene(*arguments);
        },
        run_text()};
}

}  // namespace carom
