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

// The walls are the participant after the beads.
std::vector<SlowTouch> SlowLine::touches() const {
    std::vector<SlowTouch> all;
    const auto add_pair = [&](std::int32_t left, std::int32_t right, long double turn) {
        const Bead &a = bead(left), &b = bead(right);
        const long double sigma = a.radius + b.radius, y = b.x + turn;
        if (a.inverse_mass + b.inverse_mass == 0.0L) return;
        all.push_back(
            {static_cast<std::size_t>(left),
             static_cast<std::size_t>(right),
             {1.0L, 0.0L},
             y - a.x - sigma,
             distance_of_round_off(time_, b.v - a.v,
                                   std::max({std::abs(a.x), std::abs(y), sigma}) + sigma)});
    };
    const auto add_wall = [&](std::int32_t i, int side) {
        const Bead& b = bead(i);
        if (b.inverse_mass == 0.0L) return;
        all.push_back({static_cast<std::size_t>(i),
                       beads_.size(),
                       {side == 0 ? -1.0L : 1.0L, 0.0L},
                       (side == 0 ? b.x : length_ - b.x) - b.radius,
                       distance_of_round_off(time_, b.v, length_)});
    };
    for (std::size_t k = 0; k + 1 < order_.size(); ++k) add_pair(order_[k], order_[k + 1], 0.0L);
    if (ring_ && order_.size() > 1) add_pair(order_.back(), order_.front(), length_);
    if (!ring_) {
        add_wall(order_.front(), 0);
        add_wall(order_.back(), 1);
    }
    return all;
}

// Carries out all contacts that coincide with the first one found and are connected with it.
void SlowLine::settle(const Contact& first, SlowEvent& event) {
    const std::vector<SlowTouch> all = touches();
    std::vector<SlowParticipant> participants;
    for (const Bead& b : beads_) participants.push_back({{b.v, 0.0L}, {b.inverse_mass, 0.0L}});
    participants.push_back({});
    for (const SlowTouch& touch : all) event.is_doubtful = event.is_doubtful || touch.is_doubtful();
    const std::int32_t pushed = bead(first.first).inverse_mass > 0.0L ? first.first : first.second;
    if (pushed < 0) return collide(first);
    const auto connected = connected_with(static_cast<std::size_t>(pushed), all, participants);
    if (connected.size() < 2) return collide(first);
    event.contacts = carry_out_rounds(participants, connected);
    if (event.contacts == 0) {
        event.contacts = 1;
        return collide(first);
    }
    for (std::size_t i = 0; i < beads_.size(); ++i) beads_[i].v = participants[i].v.x;
}

void SlowLine::adopt(const Sample& state) {
    time_ = state.time;
    for (std::size_t i = 0; i < beads_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const long double place = state.position(row, 0);
        beads_[i].x = ring_ ? beads_[i].x + std::remainder(place - beads_[i].x, length_) : place;
        beads_[i].v = state.velocity(row, 0);
    }
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
    SlowEvent event{time_, earliest->first, earliest->second};
    settle(*earliest, event);
    return event;
}

}  // namespace carom::test
