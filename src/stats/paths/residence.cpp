#include "stats/paths/residence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "util/bin_number.h"

namespace carom {

void Residence::add(const MotionStretch& stretch) {
    const double turn =
        stretch.acceleration != 0.0 ? -stretch.velocity / stretch.acceleration : 0.0;
    if (!(turn > 0.0 && turn < stretch.duration)) return add_monotone(stretch);
    MotionStretch before = stretch, after = stretch;
    before.duration = turn;
    after.place = stretch.place_after(turn);
    after.velocity = 0.0;
    after.duration = stretch.duration - turn;
    add_monotone(before);
    add_monotone(after);
}

// Splits the stretch at the bin edges that it passes. The time to an edge at distance s is
// 2 s / (v0 + v), where both velocities have the same sign.
void Residence::add_monotone(const MotionStretch& stretch) {
    const double end = stretch.place_after(stretch.duration);
    make_room(stretch.place);
    make_room(end);
    const double direction = end >= stretch.place ? 1.0 : -1.0;
    double last = stretch.place, reached = 0.0;
    double edge = direction > 0.0 ? std::floor(stretch.place / width_) + 1.0
                                  : std::ceil(stretch.place / width_) - 1.0;
    for (; (end - edge * width_) * direction > 0.0; edge += direction) {
        const double way = edge * width_ - stretch.place;
        const double square =
            stretch.velocity * stretch.velocity + 2.0 * stretch.acceleration * way;
        const double sum = std::abs(stretch.velocity) + std::sqrt(std::max(0.0, square));
        const double time =
            sum > 0.0 ? std::clamp(2.0 * std::abs(way) / sum, reached, stretch.duration) : reached;
        add(0.5 * (last + edge * width_), time - reached);
        last = edge * width_;
        reached = time;
    }
    add(0.5 * (last + end), stretch.duration - reached);
}

// Merges pairs of bins (-2 and -1 become -1) until the position is in one of the bins.
void Residence::make_room(double place) {
    while (std::abs(place) >= most_bins * width_) {
        width_ *= 2.0;
        if (first_ % 2 != 0) {
            times_.insert(times_.begin(), 0.0);
            --first_;
        }
        if (times_.size() % 2 != 0) times_.push_back(0.0);
        first_ /= 2;
        for (std::size_t k = 0; 2 * k < times_.size(); ++k)
            times_[k] = times_[2 * k] + times_[2 * k + 1];
        times_.resize(times_.size() / 2);
    }
}

void Residence::add(double place, double time) {
    const auto number = static_cast<int>(bin_number(place / width_));
    if (number < first_) {
        times_.insert(times_.begin(), static_cast<std::size_t>(first_ - number), 0.0);
        first_ = number;
    }
    const auto bin = static_cast<std::size_t>(number - first_);
    if (bin >= times_.size()) times_.resize(bin + 1, 0.0);
    times_[bin] += time;
}

}  // namespace carom
