#include "works/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "runs/number_json.h"
#include "runs/own_files.h"
#include "util/archive.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"
#include "util/files/utf8_names.h"
#include "util/fingerprint.h"
#include "util/interrupt.h"
#include "util/stopwatch.h"
#include "util/text.h"
#include "works/build_facts.h"
#include "works/sweep_scenes.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_chunk_bytes = std::int64_t{4} << 30;

Json axes_to_json(const Sweep& sweep) {
    Json axes = Json::array();
    for (const SweepAxis& axis : sweep.axes)
        axes.push_back(Json{{"key", axis.key}, {"values", axis.values}});
    return axes;
}

Sweep sweep_from(const Json& json) {
    Sweep sweep;
    sweep.seeds = {whole_in<std::uint64_t>(json.at("seeds").at(0)),
                   whole_in<std::uint64_t>(json.at("seeds").at(1))};
    for (const Json& axis : json.at("axes"))
        sweep.axes.push_back({axis.at("key"), axis.at("values")});
    return sweep;
}

// What plan.json says of the summary.
SweepSummary outcome_in(const Json& contents) {
    const Json& request = contents.at("request");
    SweepSummary outcome{.carom = request.at("build").at("carom"),
                         .scene = request.at("scene"),
                         .title = request.at("title"),
                         .overrides = request.at("overrides"),
                         .physics = request.at("physics"),
                         .sweep = sweep_from(request)};
    for (const auto& [name, value] : request.at("build").items())
        if (name != "carom") outcome.build.emplace_back(name, value.get<std::string>());
    for (const Json& number : contents.at("sweep").at("numbers"))
        outcome.numbers.push_back(run_number_from(number));
    return outcome;
}

// With the scene as it is without the values of a point.
Json request_to_json(const SweepRequest& request, const Scene& scene) {
    return {{"scene", utf8_of_name(scene.source.path)},
            {"text", scene.source.text},
            {"files", texts_to_json(scene.source.files)},
            {"template", fingerprint(scene.source.template_text)},
            {"title", scene.title},
            {"physics", scene.source.physics},
            {"overrides", request.overrides},
            {"seeds", {request.sweep.seeds.first, request.sweep.seeds.last}},
            {"axes", axes_to_json(request.sweep)},
            {"chunks", request.chunks ? Json(*request.chunks) : Json()},
            {"build", carom::to_json(physics_build_facts())}};
}

SweptScene swept_scene(const Json& request) {
    return {request.at("text"), name_of_utf8(request.at("scene").get<std::string>()),
            texts_from(request.at("files")), request.at("overrides")};
}

// Two keys may name one place, and a key may have nothing to do with the run.
class DistinctRuns {
  public:
    void add(const Scene& scene, const Sweep& sweep, std::int64_t point) {
        const auto [same, is_new] =
            points_.emplace(fmt::format("{} {}", scene.source.physics, scene.run.until), point);
        if (!is_new)
            throw UsageError(fmt::format(
                "--vary: the run with {} is the same as with {}; each value has to change it",
                fmt::join(sweep.changes_at(point), ", "),
                fmt::join(sweep.changes_at(same->second), ", ")));
    }

  private:
    std::map<std::string, std::int64_t> points_;
};

// All points, so that a mistake at one is found before the first run. Which numbers a run has must
// not depend on the point.
std::vector<RunNumber> checked_points(const SweptScene& swept, const Sweep& sweep,
                                      Progress& progress) {
    progress.begin("checking", static_cast<double>(sweep.points()), "points");
    std::vector<RunNumber> numbers;
    DistinctRuns runs;
    for (std::int64_t point = 0; point < sweep.points(); ++point) {
        throw_if_interrupted();
        const auto scene = scene_at_point(swept, sweep, point);
        runs.add(*scene, sweep, point);
        std::vector<RunNumber> its = numbers_of_runs(*scene);
        if (point == 0)
            numbers = std::move(its);
        else if (its != numbers)
            throw UsageError(fmt::format(
                "--vary: with {} a run has other numbers than with {}; dimension, species, walls, "
                "partitions and reversals have to be the same at all points",
                fmt::join(sweep.changes_at(point), ", "), fmt::join(sweep.changes_at(0), ", ")));
        progress.advance();
    }
    return numbers;
}

// Neither so short that processes only start, nor so many that folders fill.
int usual_chunks(const Sweep& sweep, const RunCost& cost) {
    constexpr double least_seconds = 4.0, usual = 64.0;
    const auto runs = static_cast<double>(sweep.runs());
    const double by_time = std::floor(runs * cost.seconds / least_seconds);
    return static_cast<int>(std::clamp(by_time, 1.0, std::min(runs, usual)));
}

std::vector<PlannedChunk> chunks_of(const Sweep& sweep, int count, const RunCost& cost,
                                    std::size_t numbers) {
    std::vector<PlannedChunk> chunks;
    for (int k = 0; k < count; ++k) {
        PlannedChunk chunk{.number = k + 1,
                           .first = sweep.runs() * k / count,
                           .end = sweep.runs() * (k + 1) / count};
        const auto rows = static_cast<std::int64_t>(numbers * sizeof(double)) * chunk.count();
        chunk.seconds = cost.seconds * static_cast<double>(chunk.count());
        chunk.memory_bytes = cost.memory_bytes + 2 * rows;
        chunk.memory_bytes_per_thread = cost.memory_bytes_per_thread;
        chunks.push_back(std::move(chunk));
    }
    return chunks;
}

Json facts_of(const Sweep& sweep, const std::vector<RunNumber>& numbers) {
    Json names = Json::array();
    for (const RunNumber& number : numbers) names.push_back(to_json(number));
    return {{"sweep",
             {{"runs", sweep.runs()},
              {"points", sweep.points()},
              {"seeds", sweep.seeds.count()},
              {"numbers", std::move(names)}}}};
}

}  // namespace

bool plan_sweep(SweepRequest request, const fs::path& folder, bool again, Progress& progress,
                const SweepChecker& check) {
    SceneResources resources = scene_resources();
    resources.is_classroom = request.is_classroom;
    resources.is_strict = request.is_strict;
    const Scene scene = load_scene(request.scene, resources, request.overrides, Wanted::physics);
    if (scene.units == UnitSystem::real)
        throw UsageError(
            fmt::format("{}: sweeps of scenes with `units: real` are not planned; carom "
                        "check gives the numbers of the same scene in reduced units",
                        request.scene));
    if (request.is_seed_of_scene) request.sweep.seeds = {scene.seed, scene.seed};
    const Json its = request_to_json(request, scene);
    if (!again && is_planned(folder, its)) return false;
    SweptScene swept = swept_scene(its);
    swept.is_classroom = request.is_classroom;
    const Sweep& sweep = request.sweep;
    const std::vector<RunNumber> numbers = checked_points(swept, sweep, progress);
    if (check)
        check(sweep, [&](std::int64_t point) { return scene_at_point(swept, sweep, point); });
    PlanWriter writer(folder);  // before the work, as it may not be allowed to write
    const RunCost cost = cost_of_runs(swept, sweep, progress);
    const int count = static_cast<int>(
        std::min<std::int64_t>(request.chunks.value_or(usual_chunks(sweep, cost)), sweep.runs()));
    writer.commit({PlanKind::sweep, its, facts_of(sweep, numbers)},
                  chunks_of(sweep, count, cost, numbers.size()));
    progress.finish();
    return true;
}

PlannedSweep::PlannedSweep(const PlanFolder& folder, const std::string& command, bool is_classroom)
    : folder_(folder) {
    folder.require(PlanKind::sweep, command);
    folder.read_contents([&](const Json& contents) {
        const Json& request = contents.at("request");
        scene_ = swept_scene(request);
        template_ = request.at("template").get<std::string>();
        outcome_ = outcome_in(contents);
    });
    scene_.is_classroom = is_classroom;
    try {
        check_sweep(outcome_.sweep);
    } catch (const SweepError& error) {
        throw UsageError(fmt::format("{}: {}; plan again", folder.path().string(), error.what()));
    }
    for (const PlannedChunk& chunk : folder.chunks())
        if (chunk.end > sweep().runs())
            throw UsageError(fmt::format("{}: the sweep has no {} runs; plan again",
                                         folder.path().string(), chunk.end));
}

std::shared_ptr<const Scene> PlannedSweep::scene_at(std::int64_t point) const {
    auto scene = scene_at_point(scene_, sweep(), point);
    if (fingerprint(scene->source.template_text) != template_)
        throw SystemError(
            fmt::format("{}: the template of {} was changed after it was planned; "
                        "plan again",
                        folder_.path().string(), scene->source.path));
    return scene;
}

void PlannedSweep::run_chunk(const PlannedChunk& chunk, int threads, Progress& progress) const {
    const Stopwatch watch;
    progress.begin(fmt::format("chunk {} of {}", chunk.number, folder_.chunks().size()),
                   static_cast<double>(chunk.count()), "runs");
    RunRows rows = run_part(
        sweep(), chunk.first, chunk.end, threads,
        [&](std::int64_t point) { return scene_at(point); }, [&] { progress.advance(); });
    std::string plan = folder_.fingerprint();
    std::int64_t first = chunk.first;
    Archive archive;
    archive(plan, first, rows);
    write_file(folder_.output(chunk), archive.finished());
    folder_.finish(chunk, carom::to_json(physics_build_facts()), watch.wall());
    progress.finish();
}

RunRows PlannedSweep::rows_of(const PlannedChunk& chunk) const {
    const StoredFile file = folder_.output(chunk);
    Archive archive(read_file(file, most_chunk_bytes), file.path().string());
    std::string plan;
    std::int64_t first = 0;
    RunRows rows;
    archive(plan, first);
    if (plan != folder_.fingerprint()) archive.refuse("it is a chunk of another plan");
    archive(rows);
    archive.expect_end();
    const std::size_t numbers = outcome_.numbers.size();
    const auto is_short = [&](const std::vector<double>& row) { return row.size() != numbers; };
    if (first != chunk.first || std::ssize(rows) != chunk.count() ||
        std::ranges::any_of(rows, is_short))
        archive.refuse("it holds other runs than the plan says");
    return rows;
}

SweepSummary PlannedSweep::summary(const RunTaker& take, bool allow_mixed) const {
    folder_.require_all_done(allow_mixed);
    SweepSummary summary = outcome_;
    RunRows point;  // of its runs so far
    for (const PlannedChunk& chunk : folder_.chunks()) {
        throw_if_interrupted();
        std::int64_t run = chunk.first;
        for (std::vector<double>& row : rows_of(chunk)) {
            if (take) take(run, row);
            point.push_back(std::move(row));
            if (std::ssize(point) == sweep().seeds.count())
                summary.points.push_back(
                    {std::ssize(point), statistics_of(std::exchange(point, {}))});
            ++run;
        }
    }
    return summary;
}

StoredFile summary_in(const fs::path& folder) { return {folder, "summary.json"}; }

}  // namespace carom
