#include "support/slow_line.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace carom::test {

SlowLine::SlowLine(const Box& box, const Particles& particles, const Sample& start)
    : length_(box.size[0]), ring_(box.is_periodic(0)) {
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        beads_.push_back({start.position(i, 0), start.velocity(i, 0), particles.radius[i],
                          particles.inverse_mass[i]});
    order_.resize(beads_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::int32_t a, std::int32_t b) { return bead(a).x < bead(b).x; });
}

long double SlowLine::x(std::int32_t i) const {
    return ring_ ? bead(i).x - length_ * std::floor(bead(i).x / length_) : bead(i).x;
}

void SlowLine::look_at_pair(std::int32_t left, std::int32_t right, long double turn,
                            std::vector<Contact>& found) const {
    const Bead &a = bead(left), &b = bead(right);
    const long double approach = a.v - b.v;
    if (approach <= 0.0L || a.inverse_mass + b.inverse_mass == 0.0L) return;
    const long double gap = b.x + turn - a.x - a.radius - b.radius;
    found.push_back({std::max(0.0L, gap / approach), std::min(left, right), std::max(left, right)});
}

void SlowLine::look_at_wall(std::int32_t i, int side, std::vector<Contact>& found) const {
    const Bead& b = bead(i);
    const long double approach = side == 0 ? -b.v : b.v;
    if (approach <= 0.0L) return;
    const long double gap = side == 0 ? b.x - b.radius : length_ - b.radius - b.x;
    found.push_back({std::max(0.0L, gap / approach), i, -1 - side});
}

std::vector<SlowLine::Contact> SlowLine::contacts() const {
    std::vector<Contact> found;
    if (order_.empty()) return found;
    for (std::size_t k = 0; k + 1 < order_.size(); ++k)
        look_at_pair(order_[k], order_[k + 1], 0.0L, found);
    if (ring_) {
        if (order_.size() > 1) look_at_pair(order_.back(), order_.front(), length_, found);
    } else {
        look_at_wall(order_.front(), 0, found);
        look_at_wall(order_.back(), 1, found);
    }
    return found;
}

void SlowLine::collide(const Contact& contact) {
    Bead& a = beads_[static_cast<std::size_t>(contact.first)];
    if (contact.second < 0) {
        a.v = -a.v;
        return;
    }
    Bead& b = beads_[static_cast<std::size_t>(contact.second)];
    const long double w1 = a.inverse_mass, w2 = b.inverse_mass, sum = w1 + w2;
    const long double v1 = a.v, v2 = b.v;
    a.v = ((w2 - w1) * v1 + 2.0L * w1 * v2) / sum;
    b.v = (2.0L * w2 * v1 + (w1 - w2) * v2) / sum;
}

std::optional<SlowEvent> SlowLine::next(long double end) {
    const std::vector<Contact> found = contacts();
    const auto earliest =
        std::min_element(found.begin(), found.end(), [](const Contact& a, const Contact& b) {
            return std::tuple(a.wait, a.second < 0, a.first, a.second) <
                   std::tuple(b.wait, b.second < 0, b.first, b.second);
        });
    if (earliest == found.end() || !(time_ + earliest->wait <= end)) return std::nullopt;
    for (Bead& b : beads_) b.x += b.v * earliest->wait;
    time_ += earliest->wait;
    collide(*earliest);
    return SlowEvent{time_, earliest->first, earliest->second};
}

}  // namespace carom::test
