// Measures how far a reversed run is from its earlier state: stores the positions at the mirror
// times of selected times and compares them when those times are reached. Does not own a
// simulation; Simulation (simulation.h) calls it during an advance.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "physics/exact_positions.h"
#include "physics/ways_back.h"

namespace carom {

/// The earlier time at which a run with these ways back, in order of time, should have had the
/// positions of `time`: as long before the last reversal as `time` lies after it. At the reversal
/// itself that is `time`. Nothing before the first reversal, after the run has left the way back,
/// or if the mirror time lies before the branch that the reversal ended. With `ends_branch`, the
/// time of a reversal belongs to the branch that it ends.
std::optional<double> mirror_time(const std::vector<WayBack>& ways, double time,
                                  bool ends_branch = false);

class EchoMeasurement {
  public:
    using Positions = std::function<ExactPositions()>;

    EchoMeasurement() = default;

    /// Selects those of `times` whose mirror time exists and does not lie before `present`;
    /// `ends_branch` as for mirror_time().
    EchoMeasurement(const std::vector<WayBack>& ways, std::vector<double> times, double present,
                    bool ends_branch);

    /// The next mirror time at which keep() is to be called, after all events of that time;
    /// infinity after the last.
    double next_time() const {
        return mirrors_.empty() ? std::numeric_limits<double>::infinity() : mirrors_.begin()->first;
    }
    void keep(const Positions& positions);

    /// To be called at each reversal. If the reversal's own time is one of those selected, only
    /// perturbations at the same instant lie between keeping the positions and comparing them.
    void keep_at_reversal(double time, const Positions& positions);

    /// The return distance at `time`, if that is one of the selected times.
    std::optional<ReturnDistance> compare(double time, const Positions& positions);

    template <class Archive>
    void archive(Archive& archive) {
        archive(mirrors_, reversals_, kept_, compared_, distance_);
    }

  private:
    std::multimap<double, double> mirrors_;  ///< mirror time and the time of the comparison
    std::set<double> reversals_;             ///< selected times that are their own mirror time
    std::map<double, ExactPositions> kept_;  ///< by the time of the comparison
    double compared_ = std::numeric_limits<double>::quiet_NaN();  ///< time of the last comparison
    std::optional<ReturnDistance> distance_;  ///< result of the comparison at that time
};

}  // namespace carom
