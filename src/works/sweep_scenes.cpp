#include "works/sweep_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <vector>

#include "runs/own_files.h"
#include "runs/sweep_runs.h"
#include "util/stopwatch.h"

namespace carom {
namespace {

// A mistake in what an axis says stands in its text, not in that of a --set.
void place_at_axis(Diagnostic& diagnostic, const Sweep& sweep, const std::string& change) {
    if (diagnostic.span.file != text_of_change(change)) return;
    const std::string key = change.substr(0, change.find('='));
    for (const SweepAxis& axis : sweep.axes)
        if (axis.key == key) diagnostic.span = {.file = "--vary " + key};
    diagnostic.source_line.clear();
}

SceneError at_point(const SceneError& error, const Sweep& sweep, std::int64_t point) {
    const std::vector<std::string> changes = sweep.changes_at(point);
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    for (Diagnostic& one : diagnostics) {
        for (const std::string& change : changes) place_at_axis(one, sweep, change);
        if (!changes.empty())
            one.message = fmt::format("with {}: {}", fmt::join(changes, ", "), one.message);
    }
    return SceneError(std::move(diagnostics));
}

std::int64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::int64_t{usage.ru_maxrss} * 1024;
}

constexpr double longest_measurement = 3.0;  // seconds

struct Enough {};

// Seconds of a run, of one that is broken off by the part of it that was done.
double seconds_of_run(const Scene& scene) {
    const Stopwatch watch;
    const double all = scene.run.equilibrate + scene.run.until;
    double done = 0.0;
    const auto reach = [&](double time) {
        done = scene.run.equilibrate + time;
        if (watch.wall() > longest_measurement && done > 0.0) throw Enough();
    };
    try {
        run_physics(scene, {}, {.start = [&](int, double time) { reach(time); }, .reached = reach});
        done = all;
    } catch (const Enough&) {
    }
    return watch.wall() * all / done;
}

}  // namespace

std::shared_ptr<const Scene> scene_at_point(const SweptScene& swept, const Sweep& sweep,
                                            std::int64_t point) {
    Overrides overrides = swept.overrides;
    const std::vector<std::string> changes = sweep.changes_at(point);
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    try {
        SceneResources resources = scene_resources();
        resources.files = swept.files;
        resources.is_classroom = swept.is_classroom;
        return std::make_shared<const Scene>(
            load_run_text(swept.text, swept.path, resources, overrides));
    } catch (const SceneError& error) {
        throw at_point(error, sweep, point);
    }
}

RunCost cost_of_runs(const SweptScene& swept, const Sweep& sweep, Progress& progress) {
    const std::int64_t before = peak_memory();
    std::vector<std::int64_t> points{0};
    if (sweep.points() > 1) points.push_back(sweep.points() - 1);
    progress.begin("measuring", static_cast<double>(points.size()), "runs");
    RunCost cost;
    for (const std::int64_t point : points) {
        const auto scene = scene_at_point(swept, sweep, point);
        cost.seconds = std::max(cost.seconds, seconds_of_run(with_seed(*scene, sweep.seeds.first)));
        progress.advance();
    }
    constexpr std::int64_t least = 4 << 20;
    cost.memory_bytes = peak_memory();
    cost.memory_bytes_per_thread = std::max(least, cost.memory_bytes - before);
    return cost;
}

}  // namespace carom
