#include "physics/events/echo_measurement.h"

#include <algorithm>

namespace carom {

std::optional<double> mirror_time(const std::vector<WayBack>& ways, double time, bool ends_branch) {
    const auto next = ends_branch ? std::ranges::lower_bound(ways, time, {}, &WayBack::begin)
                                  : std::ranges::upper_bound(ways, time, {}, &WayBack::begin);
    if (next == ways.begin()) return std::nullopt;
    const double last = (next - 1)->begin;
    const double begin = next - ways.begin() > 1 ? (next - 2)->begin : 0.0;
    const double mirror = last - (time - last);
    const double rounding = 1e-12 * last;
    if (mirror < begin - rounding || time > (next - 1)->end + rounding) return std::nullopt;
    return std::max(mirror, begin);
}

EchoMeasurement::EchoMeasurement(const std::vector<WayBack>& ways, std::vector<double> times,
                                 double present, bool ends_branch) {
    for (const double time : times) {
        const auto mirror = mirror_time(ways, time, ends_branch);
        if (!mirror || *mirror < present) continue;
        if (*mirror == time)
            reversals_.insert(time);
        else
            mirrors_.emplace(*mirror, time);
    }
}

void EchoMeasurement::keep(const Positions& positions) {
    const ExactPositions here = positions();
    const auto now = mirrors_.equal_range(next_time());
    for (auto mirror = now.first; mirror != now.second; ++mirror)
        kept_.emplace(mirror->second, here);
    mirrors_.erase(now.first, now.second);
}

void EchoMeasurement::keep_at_reversal(double time, const Positions& positions) {
    if (reversals_.erase(time) > 0) kept_.emplace(time, positions());
}

std::optional<ReturnDistance> EchoMeasurement::compare(double time, const Positions& positions) {
    if (time == compared_) return distance_;
    compared_ = time;
    distance_.reset();
    if (const auto before = kept_.extract(time))
        distance_ = return_distance(before.mapped(), positions());
    return distance_;
}

}  // namespace carom
