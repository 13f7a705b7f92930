// What the runs of a sweep give together, as it is written once they are all there, and read by
// figures: JSON with all digits, the same for any number of chunks that the runs were done in.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runs/sweep_runs.h"

namespace carom {

/// One combination of values.
struct PointSummary {
    std::int64_t runs = 0;
    std::vector<NumberStatistics> numbers = {};  ///< in the summary's order
};

struct SweepSummary {
    std::string carom = {};  ///< version of the program that made the runs
    std::vector<std::pair<std::string, std::string>> build = {};  ///< what else they depend on
    std::string scene = {};                                       ///< its file, as it was given
    std::string title = {};
    std::vector<std::string> overrides = {};  ///< laid over it at all points
    std::string physics = {};  ///< SceneSource::physics, without the values of a point
    Sweep sweep = {};
    std::vector<RunNumber> numbers = {};
    std::vector<PointSummary> points = {};  ///< of each point of the sweep
};

/// One JSON object, indented, ends with a line break; null where a number is missing.
std::string text_of(const SweepSummary& summary);

/// Reads it back; `name` stands for it in messages. Throws SystemError where it is no such summary,
/// or of another version of the format.
SweepSummary sweep_summary(std::string_view text, const std::string& name);

}  // namespace carom
