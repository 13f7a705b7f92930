// carom join: puts together what the chunks of a plan have made.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/commands/film_plans.h"
#include "app/output.h"
#include "films/cost/work.h"
#include "util/csv.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/text.h"
#include "works/plan_folder.h"
#include "works/sweep_plan.h"

namespace carom {
namespace {

struct JoinArguments {
    std::string plan;
    std::string output;
    std::string csv;
    bool allow_mixed = false;
    bool quiet = false;
    bool text = false, poster = false;  // of a film
    bool is_classroom = false;
};

// A row for each run.
class RunsCsv {
  public:
    RunsCsv(const PlannedSweep& planned, Output& output)
        : sweep_(planned.sweep()), output_(output) {
        std::string header = "run,seed";
        for (const SweepAxis& axis : sweep_.axes) header += "," + csv_field(axis.key);
        for (const RunNumber& number : planned.numbers()) header += "," + csv_field(number.name);
        output_.write(header + "\n");
    }

    void add(std::int64_t run, const std::vector<double>& values) {
        std::string row = fmt::format("{},{}", run, sweep_.seed_of(run));
        for (const std::string& value : sweep_.values_at(sweep_.point_of(run)))
            row += "," + csv_field(value);
        for (const double value : values) row += "," + (std::isnan(value) ? "" : csv_number(value));
        output_.write(row + "\n");
    }

  private:
    const Sweep& sweep_;
    Output& output_;
};

void refuse_same_outputs(const JoinArguments& arguments) {
    const std::string &json = arguments.output, &csv = arguments.csv;
    if (json.empty() || csv.empty()) return;
    if (Output::are_same(json, csv))
        throw UsageError(fmt::format("-o and --csv would both be written to {}",
                                     Output::is_standard_output(csv) ? "standard output" : csv));
}

void join_sweep(const JoinArguments& arguments, const PlanFolder& plan) {
    refuse_same_outputs(arguments);
    const PlannedSweep sweep(plan, "join", arguments.is_classroom);
    refuse_much_sweep(sweep.sweep(), [&](std::int64_t point) { return sweep.scene_at(point); });
    std::optional<Output> json, csv;
    std::optional<RunsCsv> table;
    if (!arguments.output.empty()) json.emplace(arguments.output);
    if (!arguments.csv.empty()) table.emplace(sweep, csv.emplace(arguments.csv));
    const std::string text = text_of(sweep.summary(
        [&](std::int64_t run, const std::vector<double>& values) {
            if (table) table->add(run, values);
        },
        arguments.allow_mixed));
    AtomicFile summary(summary_in(plan.path()));
    summary.write(text);
    if (json) json->write(text);
    std::vector<PendingOutput*> outputs{&summary};
    for (std::optional<Output>* const output : {&csv, &json})
        if (*output) outputs.push_back(&**output);
    commit_together(outputs);
    if (arguments.quiet || Output::is_standard_output(arguments.output) ||
        Output::is_standard_output(arguments.csv))
        return;
    for (const std::string& path :
         {summary_in(plan.path()).path().string(), arguments.output, arguments.csv})
        if (!path.empty()) Output("-").write(printable(path) + "\n");
}

void join(const JoinArguments& arguments) {
    const PlanFolder plan(arguments.plan);
    plan.keep_files();
    const bool is_film = plan.kind() == PlanKind::film;
    if (is_film && !arguments.csv.empty())
        throw UsageError("--csv applies to the plan of a sweep; leave it out");
    if (!is_film && (arguments.text || arguments.poster))
        throw UsageError("--words and --poster apply to the plan of a film; leave them out");
    if (!is_film) return join_sweep(arguments, plan);
    if (arguments.is_classroom) refuse_much_plan(plan);
    join_film(plan, {arguments.output, arguments.text, arguments.poster, arguments.allow_mixed,
                     arguments.quiet});
}

CommandText join_text() {
    return {{"carom join PLAN/ [-o film.mp4] [--words] [--poster] [options]",
             "carom join SWEEP/ [-o summary.json] [--csv runs.csv] [options]"},
            "Puts together the results of the chunks of a plan. The film is the same, byte for "
            "byte, as from carom render; the summary of a sweep is the same for any number of "
            "chunks.",
            {{"carom join plan/ -o film.mp4 --words", "the film, with captions and a transcript"},
             {"carom join plan/ --poster", "also a picture of it"},
             {"carom join sweep/ -o summary.json --csv runs.csv",
              "the summary of a sweep, and a row for each run"}}};
}

}  // namespace

Command join_command() {
    const auto arguments = std::make_shared<JoinArguments>();
    JoinArguments& its = *arguments;
    return {
        "join",
        "put together what the chunks of a plan have made",
        {{"plan", "the folder of a plan whose chunks are all done", &its.plan},
         {"-o,--output FILE",
          "the film (default: out/SCENE.mp4), or the summary of a sweep as JSON, - for standard "
          "output",
          &its.output},
         {"--words",
          "for a film: also write captions, chapters and descriptions (.vtt) and a transcript "
          "(.txt)",
          &its.text},
         {"--poster", "for a film: also write a picture of it (.poster.png)", &its.poster},
         {"--csv FILE", "for a sweep: a row for each run; - for standard output", &its.csv},
         limits_option(its.is_classroom),
         {"--allow-mixed", "accept chunks made by other builds of carom", &its.allow_mixed},
         {"--quiet", "print no report", &its.quiet}},
        [arguments] { join(*arguments); },
        join_text()};
}

}  // namespace carom
