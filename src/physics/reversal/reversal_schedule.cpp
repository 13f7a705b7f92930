#include "physics/reversal/reversal_schedule.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr int path_bits = 256;  // no sum of times needs more

// Without rounding.
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
    };
    for (const double time : reversal_times(run)) {
        if (time >= run.until) break;
        end_at(time);
        next.direction = -next.direction;
    }
    end_at(run.until);
}

// The first time at which the gas was where it is on a later branch.
MirrorTimes ReversalSchedule::mirror_of(const Branch& later, double path) const {
    const double again = std::min(later.begin + std::abs(path - later.path), later.end);
    for (const Branch& branch : branches_) {
        const double end = branch.path_at(branch.end);
        if (path < std::min(branch.path, end) || path > std::max(branch.path, end)) continue;
        const double first = std::min(branch.begin + std::abs(path - branch.path), branch.end);
        const Real off = exact_path(later, again) - exact_path(branch, first);
        return {first, again, path, std::abs(static_cast<double>(off))};
    }
    return {0.0, again, path, 0.0};
}

void ReversalSchedule::add(const Branch& branch) {
    branches_.push_back(branch);
    const double end = branch.path_at(branch.end);
    if (branches_.size() > 1) {
        std::vector<double> paths{std::clamp(end, low_, high_)};
        if (low_ < 0.0 && (branch.path > 0.0) != (end > 0.0)) paths.push_back(0.0);
        std::ranges::sort(paths, {}, [&](double path) { return std::abs(path - branch.path); });
        for (const double path : paths)
            if (path != branch.path) mirror_times_.push_back(mirror_of(branch, path));
    }
    low_ = std::min(low_, end);
    high_ = std::max(high_, end);
}

}  // namespace carom
