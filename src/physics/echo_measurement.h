// How far a reversed run is from where it was: keeps the positions at the mirror times of chosen
// times, and compares when these come. Owns no simulation: simulation.h calls it on the way.
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

/// When a run with these ways back, in order, was last where it should be at `time`: as long before
/// the last reversal as `time` is after it. At the reversal itself that is the same time. None
/// before the first reversal, where the way back has been left, and where that lies before the
/// branch that the reversal ended. With `ends_branch`, a time that is a reversal's own belongs to
/// the branch that it ends.
std::optional<double> mirror_time(const std::vector<WayBack>& ways, double time,
                                  bool ends_branch = false);

class EchoMeasurement {
  public:
    using Positions = std::function<ExactPositions()>;

    EchoMeasurement() = default;

    /// Of `times`, those that have a mirror time not before `present`; `ends_branch` as above.
    EchoMeasurement(const std::vector<WayBack>& ways, std::vector<double> times, double present,
                    bool ends_branch);

    /// The next mirror time at which keep() is to be called, after all events of that time;
    /// infinity after the last.
    double next_time() const {
        return mirrors_.empty() ? std::numeric_limits<double>::infinity() : mirrors_.begin()->first;
    }
    void keep(const Positions& positions);

    /// To be called at each reversal: between its time and that time itself there are only the
    /// perturbations that follow at the same instant.
    void keep_at_reversal(double time, const Positions& positions);

    /// The distance at `time`, if it is one of those chosen.
    std::optional<ReturnDistance> compare(double time, const Positions& positions);

    template <class Archive>
    void archive(Archive& archive) {
        archive(mirrors_, reversals_, kept_, compared_, distance_);
    }

  private:
    std::multimap<double, double> mirrors_;  ///< when to keep positions, and when to compare them
    std::set<double> reversals_;             ///< chosen times that mirror themselves
    std::map<double, ExactPositions> kept_;  ///< by the time when they are compared
    double compared_ = std::numeric_limits<double>::quiet_NaN();  ///< the time of
    std::optional<ReturnDistance> distance_;                      ///< the last comparison
};

}  // namespace carom
