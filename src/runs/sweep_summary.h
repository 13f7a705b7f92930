// The summary of a sweep, written when all runs are done and read by figures: JSON with all digits,
// independent of the number of chunks in which the runs were done.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runs/sweep_runs.h"

namespace carom {

/// The results at one point of the sweep (one combination of values).
struct PointSummary {
    std::int64_t runs = 0;
    std::vector<NumberStatistics> numbers = {};  ///< in the order of SweepSummary::numbers
};

struct SweepSummary {
    std::string carom = {};  ///< version of the program that made the runs
    std::vector<std::pair<std::string, std::string>> build = {};  ///< what else results depend on
    std::string scene = {};  ///< path of its file, as the user gave it
    std::string title = {};
    std::vector<std::string> overrides = {};  ///< changes to the scene that apply at all points
    std::string physics = {};  ///< SceneSource::physics, without the values of a point
    Sweep sweep = {};
    std::vector<RunNumber> numbers = {};
    std::vector<PointSummary> points = {};  ///< of each point of the sweep
};

/// One JSON object, indented, ending with a line break; null if a number is missing.
std::string text_of(const SweepSummary& summary);

/// Reads back what text_of() gave; `name` denotes it in messages. Throws SystemError if it is not
/// such a summary, or has another format version.
SweepSummary sweep_summary(std::string_view text, const std::string& name);

}  // namespace carom
