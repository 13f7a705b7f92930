// The parameters that a sweep varies, as a plain value: seeds, and keys of the scene with the
// values that each takes. Runs are numbered from 0, all seeds of one point consecutively. This file
// runs nothing (runs/ does).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace carom {

/// Consecutive seeds, both ends included.
struct SeedRange {
    std::uint64_t first = 1, last = 1;
    std::int64_t count() const { return static_cast<std::int64_t>(last - first) + 1; }
    bool operator==(const SeedRange&) const = default;
};

/// A key of the scene, KEY.PATH as for --set, and the values that it takes, as texts.
struct SweepAxis {
    std::string key;
    std::vector<std::string> values;
    bool operator==(const SweepAxis&) const = default;
};

/// Each combination of values of the axes is a point, at which there is one run with each seed.
/// Points are numbered with the last axis varying fastest. Without axes there is one point.
struct Sweep {
    std::vector<SweepAxis> axes = {};
    SeedRange seeds = {};

    std::int64_t points() const;
    std::int64_t runs() const { return points() * seeds.count(); }
    std::int64_t point_of(std::int64_t run) const { return run / seeds.count(); }
    std::uint64_t seed_of(std::int64_t run) const {
        return seeds.first + static_cast<std::uint64_t>(run % seeds.count());
    }

    /// Returns the values at a point, one for each axis.
    std::vector<std::string> values_at(std::int64_t point) const;

    /// Returns the values at a point as overrides of the scene, KEY.PATH=VALUE.
    std::vector<std::string> changes_at(std::int64_t point) const;

    bool operator==(const Sweep&) const = default;
};

struct Scene;

/// What a figure shows of a sweep: a result of its runs, plotted against a key that is varied.
struct SweepShown {
    std::string number;   ///< the name of a result of each run
    std::string against;  ///< the key of one axis; each combination of the others is a line
    std::string across;   ///< label of the horizontal axis; empty: made from the key
    Sweep sweep = {};     ///< the sweep that the figure runs, unless it shows one that is joined
    std::function<std::shared_ptr<const Scene>(const std::vector<std::string>& changes)>
        scene_with = {};  ///< loads the scene's run with changes, KEY.PATH=VALUE; throws SceneError
};

/// The text of a sweep has a wrong form or a value that is not allowed.
class SweepError : public std::runtime_error {
  public:
    explicit SweepError(const std::string& what, std::string hint = "")
        : std::runtime_error(what), hint_(std::move(hint)) {}
    const std::string& hint() const { return hint_; }  ///< how to correct it; may be empty

  private:
    std::string hint_;
};

/// Parses FIRST:LAST, or N for 1:N. Throws SweepError.
SeedRange seed_range(const std::string& text);

/// Parses KEY=FIRST:LAST:N, N equally spaced values including both ends, rounded to 15 digits; or
/// KEY=VALUE,VALUE,... Throws SweepError.
SweepAxis sweep_axis(const std::string& text);

/// Throws SweepError if an axis is given twice or is the seed, or if there are more points or runs
/// than a sweep may have.
void check_sweep(const Sweep& sweep);

}  // namespace carom
