// Does a part of the runs of a sweep on several threads, and computes statistics over runs.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runs/run_numbers.h"
#include "scene/sweep.h"

namespace carom {

struct Scene;

/// For each run, in order, the values of numbers_of_runs().
using RunRows = std::vector<std::vector<double>>;

/// Gives the scene at a point of a sweep; its seed is replaced. Called from one thread only.
using SceneAtPoint = std::function<std::shared_ptr<const Scene>(std::int64_t point)>;

/// A copy of a scene with another seed.
Scene with_seed(const Scene& scene, std::uint64_t seed);

/// Does the runs [first, end), each on one of at most `threads` threads, and returns their rows;
/// the result does not depend on the number of threads. `on_run` is called after each run, from any
/// thread. Throws SceneError, naming the run (a gas cannot be placed, or does not return);
/// Interrupted.
RunRows run_part(const Sweep& sweep, std::int64_t first, std::int64_t end, int threads,
                 const SceneAtPoint& scene_at, const std::function<void()>& on_run = {});

/// Describes a run in words: "run 12 (gas.0.radius=0.2, seed 5)". Runs are counted from 0.
std::string words_of_run(const Sweep& sweep, std::int64_t run);

/// The probabilities whose quantiles a summary gives.
inline constexpr std::array quantile_shares{0.05, 0.25, 0.5, 0.75, 0.95};

/// Statistics of one number over independent runs, of which only those are counted that have it.
/// Values are NaN if there are too few runs.
struct NumberStatistics {
    std::int64_t count = 0;
    double mean = 0.0;
    double error = 0.0;      ///< standard error of the mean
    double deviation = 0.0;  ///< standard deviation of one run, with divisor n - 1
    double least = 0.0, most = 0.0;
    std::array<double, quantile_shares.size()> quantiles =
        {};  ///< by linear interpolation between order statistics: for sorted values x[0] to
             ///< x[n-1], x at position p (n - 1)
};

/// The statistics of values, one for each run in order; NaN if a run has no value.
NumberStatistics statistics_of(const std::vector<double>& values);

/// The statistics of each number over the runs in `rows`.
std::vector<NumberStatistics> statistics_of(const RunRows& rows);

}  // namespace carom
