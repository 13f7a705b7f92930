#include "physics/placement/line_room.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <queue>
#include <utility>

#include "physics/placement/placed_particles.h"

namespace carom {
namespace {

// Integer weights that change one at a time, and random draws in proportion to them, each in
// logarithmic time (Fenwick 1994).
class Weights {
  public:
    explicit Weights(std::size_t count) : weight_(count, 0), sum_(count + 1, 0) {}

    std::uint64_t total() const { return total_; }

    void set(std::size_t i, std::uint64_t weight) {
        const std::uint64_t change = weight - weight_[i];  // modulo 2^64, as all sums
        weight_[i] = weight;
        total_ += change;
        for (std::size_t k = i + 1; k < sum_.size(); k += k & (~k + 1)) sum_[k] += change;
    }

    // The first index at which the cumulative weight exceeds `below`, which is less than the total.
    std::size_t at(std::uint64_t below) const {
        std::size_t step = 1, found = 0;
        while (2 * step < sum_.size()) step *= 2;
        for (; step > 0; step /= 2)
            if (found + step < sum_.size() && sum_[found + step] <= below) {
                found += step;
                below -= sum_[found];
            }
        return found;
    }

  private:
    std::vector<std::uint64_t> weight_, sum_;
    std::uint64_t total_ = 0;
};

// The room left in each stretch. Beads that touch may lack a rounding error of their coordinates.
struct Rooms {
    explicit Rooms(const std::vector<Stretch>& stretches) {
        for (const Stretch& stretch : stretches) {
            left.push_back(stretch.room());
            lack = std::max(lack, touching_tolerance * std::abs(stretch.high));
        }
    }
    bool holds(std::size_t i, double length) const { return left[i] >= length - lack; }

    std::vector<double> left;
    double lack = 0.0;
};

// Puts each bead where it leaves the least room.
Shares share_tightly(const std::vector<Stretch>& stretches, const std::vector<double>& lengths) {
    const Rooms rooms(stretches);
    std::multimap<double, std::size_t> by_room;
    for (std::size_t i = 0; i < stretches.size(); ++i) by_room.emplace(rooms.left[i], i);
    std::vector<std::size_t> shares;
    for (const double length : lengths) {
        const auto best = by_room.lower_bound(length - rooms.lack);
        if (best == by_room.end()) return std::nullopt;
        const auto [room, i] = *best;
        shares.push_back(i);
        by_room.erase(best);
        by_room.emplace(room - length, i);
    }
    return shares;
}

// Each stretch that can hold the current bead is weighted by its room; the others wait for shorter
// beads.
class RandomSharing {
  public:
    explicit RandomSharing(const std::vector<Stretch>& stretches)
        : rooms_(stretches), weights_(stretches.size()) {
        for (std::size_t i = 0; i < stretches.size(); ++i) waiting_.emplace(rooms_.left[i], i);
        scale_ = 0x1p40 / std::max(waiting_.top().first, 1e-300);
    }

    std::optional<std::size_t> take(double length, Random& random) {
        while (!waiting_.empty() && rooms_.holds(waiting_.top().second, length)) {
            const std::size_t i = waiting_.top().second;
            waiting_.pop();
            weights_.set(i, weight(i));
        }
        if (weights_.total() == 0) return std::nullopt;
        const std::size_t i = weights_.at(random.below(weights_.total()));
        rooms_.left[i] -= length;
        const bool open = rooms_.holds(i, length);
        weights_.set(i, open ? weight(i) : 0);
        if (!open) waiting_.emplace(rooms_.left[i], i);
        return i;
    }

  private:
    std::uint64_t weight(std::size_t i) const {
        return 1 + static_cast<std::uint64_t>(scale_ * std::max(0.0, rooms_.left[i]));
    }

    Rooms rooms_;
    Weights weights_;
    std::priority_queue<std::pair<double, std::size_t>> waiting_;
    double scale_;
};

}  // namespace

LineRoom::LineRoom(const Box& box) : length_(box.size[0]), ring_(box.is_periodic(0)) {}

void LineRoom::take(std::vector<Stretch> beads) {
    const auto by_place = [](const Stretch& a, const Stretch& b) { return a.low < b.low; };
    std::sort(beads.begin(), beads.end(), by_place);
    const auto old = static_cast<std::ptrdiff_t>(taken_.size());
    taken_.insert(taken_.end(), beads.begin(), beads.end());
    std::inplace_merge(taken_.begin(), taken_.begin() + old, taken_.end(), by_place);
}

std::vector<Stretch> LineRoom::free() const {
    if (taken_.empty() || !ring_) return free_within({0.0, length_});
    return free_within({taken_.front().high, taken_.front().low + length_});
}

std::vector<Stretch> LineRoom::free_within(Stretch part) const {
    std::vector<Stretch> stretches;
    double low = part.low;
    const auto go_on_to = [&](const Stretch& next) {
        if (std::min(next.low, part.high) > low)
            stretches.push_back({low, std::min(next.low, part.high)});
        low = std::max(low, next.high);
    };
    for (const int turn : {-1, 0, 1}) {
        if (turn != 0 && !ring_) continue;
        for (const Stretch& bead : taken_) {
            const Stretch image{bead.low + turn * length_, bead.high + turn * length_};
            if (image.high > part.low && image.low < part.high) go_on_to(image);
        }
    }
    go_on_to({part.high, part.high});
    return stretches;
}

Shares share_at_random(const std::vector<Stretch>& stretches, const std::vector<double>& lengths,
                       Random& random) {
    if (stretches.empty()) return std::nullopt;
    RandomSharing sharing(stretches);
    std::vector<std::size_t> shares;
    for (const double length : lengths) {
        const auto share = sharing.take(length, random);
        if (!share) return share_tightly(stretches, lengths);
        shares.push_back(*share);
    }
    return shares;
}

// Gaps are calculated with the length of the bead last put into a stretch: exact if all beads have
// one length.
Shares share_evenly(const std::vector<Stretch>& stretches, const std::vector<double>& lengths) {
    if (stretches.empty()) return std::nullopt;
    Rooms rooms(stretches);
    std::vector<double> gaps(stretches.size(), 1.0);
    std::priority_queue<std::pair<double, std::size_t>> widest;
    const auto offer = [&](std::size_t i, double length) {
        widest.emplace((rooms.left[i] - length) / (gaps[i] + 1.0), i);
    };
    for (std::size_t i = 0; i < stretches.size() && !lengths.empty(); ++i) offer(i, lengths[0]);
    std::vector<std::size_t> shares;
    for (const double length : lengths) {
        const std::size_t i = widest.top().second;
        if (!rooms.holds(i, length)) return share_tightly(stretches, lengths);
        widest.pop();
        shares.push_back(i);
        rooms.left[i] -= length;
        gaps[i] += 1.0;
        offer(i, length);
    }
    return shares;
}

}  // namespace carom
