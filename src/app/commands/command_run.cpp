// carom run: the physics alone, its statistics and its samples.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/command.h"
#include "app/output.h"
#include "app/report/run.h"
#include "app/report/run_facts.h"
#include "app/report/samples_csv.h"
#include "app/resources.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct RunArguments : SceneOptions {
    std::string scene;
    std::string json, csv;  // paths, or - for standard output; empty: none
};

bool is_same_output(const std::string& a, const std::string& b) {
    return !a.empty() && !b.empty() &&
           (a == b || is_same_file(a, b) ||
            (Output::is_standard_output(a) && Output::is_standard_output(b)) ||
            fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal());
}

void refuse_same_files(const RunArguments& arguments) {
    for (const auto& [flag, path] : {std::pair("--json", arguments.json), {"--csv", arguments.csv}})
        if (!path.empty() && is_same_file(path, arguments.scene))
            throw UsageError(fmt::format("{} {}: this would overwrite the scene", flag, path));
    if (is_same_output(arguments.json, arguments.csv))
        throw UsageError(fmt::format(
            "--json and --csv would both be written to {}",
            Output::is_standard_output(arguments.csv) ? "standard output" : arguments.csv));
}

bool standard_output_is_taken(const RunArguments& arguments) {
    return Output::is_standard_output(arguments.json) || Output::is_standard_output(arguments.csv);
}

std::string report_text(const RunArguments& arguments, const Scene& scene,
                        const RunReport& report) {
    std::string text;
    if (!arguments.quiet && arguments.json.empty() && arguments.csv.empty())
        text += run_table(scene, report);
    if (!arguments.quiet && !standard_output_is_taken(arguments))
        for (const std::string& path : {arguments.json, arguments.csv})
            if (!path.empty()) text += path + "\n";
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

// The outputs before the work: it may not be allowed to write them.
void run_scene(const RunArguments& arguments) {
    refuse_same_files(arguments);
    const Scene scene =
        load_scene(arguments.scene, scene_resources(), overrides_of(arguments), Wanted::physics);
    std::optional<Output> json, csv;
    std::optional<SamplesCsv> table;
    if (!arguments.json.empty()) json.emplace(arguments.json);
    if (!arguments.csv.empty()) table.emplace(scene.gas, csv.emplace(arguments.csv));
    SampleTaker take;
    if (table)
        take = [&](const Particles& particles, const Sample& sample) {
            table->add(particles, sample);
        };
    Progress progress(Progress::fitting_form(arguments.quiet), scene_stem(arguments.scene));
    const RunReport report = reporting_incomplete(csv, [&] {
        const RunReport whole = run_physics(scene, take, progress);
        if (table) table->finish();
        return whole;
    });
    if (json) json->write(run_json(scene, report));
    if (csv) csv->commit();
    if (json) json->commit();
    print(arguments, report_text(arguments, scene, report));
}

}  // namespace

Command run_command() {
    const auto arguments = std::make_shared<RunArguments>();
    RunArguments& its = *arguments;
    return {
        "run", "simulate without drawing: statistics and samples",
        joined<Option>(
            {{{"scene", "a scene file; - for standard input", &its.scene},
              {"--json", "the statistics as JSON; - for standard output", &its.json},
              {"--csv", "all samples, a row for each particle; - for standard output", &its.csv}},
             scene_options(its),
             work_options(its)}),
        [arguments] { run_scene(*arguments); }};
}

}  // namespace carom
