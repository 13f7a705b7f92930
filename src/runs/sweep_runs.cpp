#include "runs/sweep_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scene/scene.h"
#include "stats/histogram.h"
#include "stats/means/mean_error.h"
#include "util/threads/on_threads.h"

namespace carom {
namespace {

// Throws the error of a run with the run named in each message.
[[noreturn]] void refuse_run(const Sweep& sweep, std::int64_t run, const SceneError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    for (Diagnostic& one : diagnostics)
        one.message = fmt::format("{}: {}", words_of_run(sweep, run), one.message);
    throw SceneError(std::move(diagnostics));
}

}  // namespace

Scene with_seed(const Scene& scene, std::uint64_t seed) {
    Scene its = scene;
    its.seed = its.gas.seed = seed;
    return its;
}

std::string words_of_run(const Sweep& sweep, std::int64_t run) {
    std::string values;
    for (const std::string& change : sweep.changes_at(sweep.point_of(run))) values += change + ", ";
    return fmt::format("run {} ({}seed {})", run, values, sweep.seed_of(run));
}

RunRows run_part(const Sweep& sweep, std::int64_t first, std::int64_t end, int threads,
                 const SceneAtPoint& scene_at, const std::function<void()>& on_run) {
    std::vector<std::shared_ptr<const Scene>> scenes;
    const std::int64_t first_point = sweep.point_of(first);
    for (std::int64_t point = first_point; point <= sweep.point_of(end - 1); ++point)
        scenes.push_back(scene_at(point));
    RunRows rows(static_cast<std::size_t>(end - first));
    on_threads(threads, rows.size(), [&](std::size_t k) {
        const std::int64_t run = first + static_cast<std::int64_t>(k);
        const auto point = static_cast<std::size_t>(sweep.point_of(run) - first_point);
        const Scene scene = with_seed(*scenes[point], sweep.seed_of(run));
        try {
            rows[k] = values_of(scene, run_physics(scene));
        } catch (const SceneError& error) {
            refuse_run(sweep, run, error);
        }
        if (on_run) on_run();
    });
    return rows;
}

NumberStatistics statistics_of(const std::vector<double>& values) {
    std::vector<double> its = values;
    std::erase_if(its, [](double value) { return std::isnan(value); });
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const MeanError mean = mean_error(its);
    NumberStatistics statistics{
        .count = static_cast<std::int64_t>(its.size()),
        .mean = mean.mean,
        .error = mean.error,
        .deviation = mean.error * std::sqrt(static_cast<double>(its.size())),
        .least = nan,
        .most = nan};
    statistics.quantiles.fill(nan);
    if (its.empty()) return statistics;
    std::ranges::sort(its);
    statistics.least = its.front();
    statistics.most = its.back();
    for (std::size_t k = 0; k < quantile_shares.size(); ++k)
        statistics.quantiles[k] = quantile(its, quantile_shares[k]);
    return statistics;
}

std::vector<NumberStatistics> statistics_of(const RunRows& rows) {
    std::vector<NumberStatistics> statistics;
    for (std::size_t k = 0; !rows.empty() && k < rows.front().size(); ++k) {
        std::vector<double> values;
        for (const std::vector<double>& row : rows) values.push_back(row[k]);
        statistics.push_back(statistics_of(values));
    }
    return statistics;
}

}  // namespace carom
