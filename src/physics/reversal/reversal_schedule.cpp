#include "physics/reversal/reversal_schedule.h"

#include <algorithm>
#include <cmath>

#include "physics/ways_back.h"

namespace carom {
namespace {

constexpr int path_bits = 256;  // no sum of times needs more

// The path coordinate at a time, without rounding.
Real exact_path(const Branch& branch, double time) {
    const Real since = Real(time, path_bits) - branch.begin;
    return branch.direction > 0 ? branch.exact_path + since : branch.exact_path - since;
}

}  // namespace

ReversalSchedule::ReversalSchedule(const Run& run) {
    Branch next{0.0, 0.0, 0.0, Real(0.0, path_bits), 1};
    const auto end_at = [&](double end) {
        next.end = end;
        if (end > next.begin) add(next);
        next.exact_path = exact_path(next, end);
        next.path = static_cast<double>(next.exact_path);
        next.begin = end;
        next.leaves_way_back = false;
    };
    const std::vector<WayBack> ways = ways_back(run.events);
    for (std::size_t k = 0; k < ways.size() && ways[k].begin < run.until; ++k) {
        end_at(ways[k].begin);
        next.direction = -next.direction;
        if (!(ways[k].end < run.until)) continue;
        end_at(ways[k].end);
        next.leaves_way_back = true;
    }
    end_at(run.until);
}

// Finds the first time at which the gas was at a point of the path that a later branch reaches
// again.
MirrorTimes ReversalSchedule::mirror_of(const Branch& later, double path) const {
    const double again = std::min(later.begin + std::abs(path - later.path), later.end);
    for (const auto& [branch, low, high] : known_) {
        if (path < low || path > high) continue;
        const double first = std::min(branch.begin + std::abs(path - branch.path), branch.end);
        const Real off = exact_path(later, again) - exact_path(branch, first);
        return {first, again, path, std::abs(static_cast<double>(off))};
    }
    return {0.0, again, path, 0.0};
}

void ReversalSchedule::forget_beyond(double path, int direction) {
    for (Known& one : known_)
        if (direction > 0)
            one.high = std::min(one.high, path);
        else
            one.low = std::max(one.low, path);
    std::erase_if(known_, [](const Known& one) { return one.low > one.high; });
    (direction > 0 ? high_ : low_) = path;
}

void ReversalSchedule::add(const Branch& branch) {
    if (branch.leaves_way_back) forget_beyond(branch.path, branch.direction);
    branches_.push_back(branch);
    const double end = branch.path_at(branch.end);
    if (branches_.size() > 1) {
        std::vector<double> paths{std::clamp(end, low_, high_)};
        if (low_ < 0.0 && (branch.path > 0.0) != (end > 0.0)) paths.push_back(0.0);
        std::ranges::sort(paths, {}, [&](double path) { return std::abs(path - branch.path); });
        for (const double path : paths)
            if (path != branch.path) mirror_times_.push_back(mirror_of(branch, path));
    }
    known_.push_back({branch, std::min(branch.path, end), std::max(branch.path, end)});
    low_ = std::min(low_, end);
    high_ = std::max(high_, end);
}

}  // namespace carom
