// The runs of a sweep: a part of them, on several threads, and what they give together.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runs/run_numbers.h"
#include "scene/scene.h"
#include "scene/sweep.h"

namespace carom {

/// The values of numbers_of_runs() of each run, in order.
using RunRows = std::vector<std::vector<double>>;

/// The scene at a point of a sweep, as it is with any seed. Called from one thread.
using SceneAtPoint = std::function<std::shared_ptr<const Scene>(std::int64_t point)>;

/// A copy of a scene with another seed.
Scene with_seed(const Scene& scene, std::uint64_t seed);

/// Those of the runs from `first` to before `end`, each on one thread, of which there are `threads`
/// at most; the result is the same for any number. `on_run` is called after each, from any thread.
/// Throws SceneError, naming the run (a gas cannot be placed, or does not return); Interrupted.
RunRows run_part(const Sweep& sweep, std::int64_t first, std::int64_t end, int threads,
                 const SceneAtPoint& scene_at, const std::function<void()>& on_run = {});

/// A run in words: "run 12 (gas.0.radius=0.2, seed 5)", counted from 0.
std::string words_of_run(const Sweep& sweep, std::int64_t run);

/// The probabilities whose quantiles a summary gives.
inline constexpr std::array quantile_shares{0.05, 0.25, 0.5, 0.75, 0.95};

/// One number over independent runs, of those that have it; NaN where they are too few.
struct NumberStatistics {
    std::int64_t count = 0;
    double mean = 0.0;
    double error = 0.0;      ///< standard error of the mean
    double deviation = 0.0;  ///< of one run, from the variance with n - 1
    double least = 0.0, most = 0.0;
    std::array<double, quantile_shares.size()> quantiles =
        {};  ///< by linear interpolation between order statistics: of sorted values
             ///< x[0] to x[n-1], x at the place p (n - 1)
};

/// Of values in the order of runs, NaN where a run has none.
NumberStatistics statistics_of(const std::vector<double>& values);

/// Of each number, over some runs.
std::vector<NumberStatistics> statistics_of(const RunRows& rows);

}  // namespace carom
