// What is varied over the runs of a sweep, as a plain value: seeds, and keys of the scene with the
// values that each takes. Its runs are numbered from 0; all seeds of a point follow one another.
// Runs nothing (runs/).
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace carom {

/// Seeds from the first to the last.
struct SeedRange {
    std::uint64_t first = 1, last = 1;
    std::int64_t count() const { return static_cast<std::int64_t>(last - first) + 1; }
    bool operator==(const SeedRange&) const = default;
};

/// A key of the scene, KEY.PATH as for --set, and the values that it takes, as they are written.
struct SweepAxis {
    std::string key;
    std::vector<std::string> values;
    bool operator==(const SweepAxis&) const = default;
};

/// Each combination of values of the axes is a point, at which there is a run with each seed; of
/// points that follow one another the last axis changes first. Without axes there is one point.
struct Sweep {
    std::vector<SweepAxis> axes = {};
    SeedRange seeds = {};

    std::int64_t points() const;
    std::int64_t runs() const { return points() * seeds.count(); }
    std::int64_t point_of(std::int64_t run) const { return run / seeds.count(); }
    std::uint64_t seed_of(std::int64_t run) const {
        return seeds.first + static_cast<std::uint64_t>(run % seeds.count());
    }

    /// The values at a point, one of each axis.
    std::vector<std::string> values_at(std::int64_t point) const;

    /// What is laid over the scene at a point, as KEY.PATH=VALUE.
    std::vector<std::string> changes_at(std::int64_t point) const;

    bool operator==(const Sweep&) const = default;
};

/// A sweep is not written as it has to be.
class SweepError : public std::runtime_error {
  public:
    explicit SweepError(const std::string& what, std::string hint = "")
        : std::runtime_error(what), hint_(std::move(hint)) {}
    const std::string& hint() const { return hint_; }  ///< how to mend it; may be empty

  private:
    std::string hint_;
};

/// Reads FIRST:LAST, or N for 1:N. Throws SweepError.
SeedRange seed_range(const std::string& text);

/// Reads KEY=FIRST:LAST:N, N equally spaced values with both ends, to 15 digits; or
/// KEY=VALUE,VALUE,... Throws SweepError.
SweepAxis sweep_axis(const std::string& text);

/// Throws SweepError where an axis is given twice, is the seed, or there are more points or runs
/// than a sweep may have.
void check_sweep(const Sweep& sweep);

}  // namespace carom
