#include "support/slow_rounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace carom::test {
namespace {

// The opening speed of a contact as a function of the scaled velocities: e . u + constant.
struct Opening {
    std::vector<long double> e;
    long double constant = 0.0L;
};

long double dot(const std::vector<long double>& a, const std::vector<long double>& b) {
    long double sum = 0.0L;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

class Rounds {
  public:
    Rounds(std::vector<SlowParticipant>& participants, const std::vector<SlowTouch>& touches)
        : participants_(participants), touches_(touches) {
        for (const SlowTouch& touch : touches) openings_.push_back(opening(touch));
        for (const SlowParticipant& its : participants)
            fastest_ = std::max(fastest_, largest(its.v));
    }

    int run() {
        int carried_out = 0;
        for (int round = 0; round < 1000; ++round) {
            std::vector<std::size_t> left;
            for (std::size_t k = 0; k < touches_.size(); ++k)
                if (approaches(k)) left.push_back(k);
            if (left.empty()) return carried_out;
            while (!left.empty()) carried_out += carry_out(take_connected(left));
            if (round == 0 && is_single_) return carried_out;
        }
        throw EndlessRounds();
    }

    // Whether one contact approaches and all others recede.
    void look_whether_single() {
        int approaching = 0, receding = 0;
        for (std::size_t k = 0; k < touches_.size(); ++k) {
            approaching += approaches(k) ? 1 : 0;
            receding += speed(k) > round_off(k) ? 1 : 0;
        }
        is_single_ = approaching == 1 && receding + 1 == static_cast<int>(touches_.size());
    }

  private:
    Opening opening(const SlowTouch& touch) const {
        Opening all{std::vector<long double>(3 * participants_.size())};
        const auto add = [&](std::size_t i, long double sign) {
            for (int axis = 0; axis < 3; ++axis) {
                const long double w = participants_[i].inverse_mass[axis];
                if (w > 0.0L)
                    all.e[3 * i + static_cast<std::size_t>(axis)] +=
                        sign * touch.normal[axis] * std::sqrt(w);
                else
                    all.constant += sign * touch.normal[axis] * participants_[i].v[axis];
            }
        };
        add(touch.first, -1.0L);
        add(touch.second, 1.0L);
        return all;
    }

    std::vector<long double> scaled_velocities() const {
        std::vector<long double> u;
        for (const SlowParticipant& its : participants_)
            for (int axis = 0; axis < 3; ++axis)
                u.push_back(its.inverse_mass[axis] > 0.0L
                                ? its.v[axis] / std::sqrt(its.inverse_mass[axis])
                                : 0.0L);
        return u;
    }

    void set_scaled_velocities(const std::vector<long double>& u) {
        for (std::size_t i = 0; i < participants_.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                if (const long double w = participants_[i].inverse_mass[axis]; w > 0.0L)
                    participants_[i].v[axis] =
                        u[3 * i + static_cast<std::size_t>(axis)] * std::sqrt(w);
    }

    long double speed(std::size_t k) const {
        return dot(openings_[k].e, scaled_velocities()) + openings_[k].constant;
    }
    long double round_off(std::size_t k) const {
        const SlowTouch& touch = touches_[k];
        long double sum = fastest_;
        for (const std::size_t i : {touch.first, touch.second})
            for (int axis = 0; axis < 3; ++axis)
                sum += std::abs(touch.normal[axis] * participants_[i].v[axis]);
        return 4.0L * std::numeric_limits<double>::epsilon() * sum;
    }
    bool approaches(std::size_t k) const { return speed(k) < -round_off(k); }

    bool share_a_body(std::size_t a, std::size_t b) const {
        for (const std::size_t i : {touches_[a].first, touches_[a].second})
            for (const std::size_t j : {touches_[b].first, touches_[b].second})
                if (i == j && participants_[i].can_be_pushed()) return true;
        return false;
    }

    // Takes one contact out of a list, and all that are connected with it.
    std::vector<std::size_t> take_connected(std::vector<std::size_t>& left) const {
        std::vector<std::size_t> set{left.front()};
        left.erase(left.begin());
        for (std::size_t next = 0; next < set.size(); ++next)
            for (std::size_t k = 0; k < left.size();) {
                if (!share_a_body(set[next], left[k])) {
                    ++k;
                    continue;
                }
                set.push_back(left[k]);
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
            }
        return set;
    }

    // Whether every two of the planes meet at an angle of pi / n, or are the same.
    bool is_order_free(const std::vector<std::size_t>& set) const {
        for (const std::size_t a : set)
            for (const std::size_t b : set) {
                if (a >= b) continue;
                const auto &p = openings_[a].e, &q = openings_[b].e;
                const long double cosine = -dot(p, q) / std::sqrt(dot(p, p) * dot(q, q));
                if (cosine < -1.0L + 1e-12L) continue;
                const long double angle = std::acos(std::min(1.0L, cosine));
                const long double n = std::round(std::numbers::pi_v<long double> / angle);
                const long double fitting = std::cos(std::numbers::pi_v<long double> / n);
                if (!(n >= 2.0L && n <= 1000.0L && std::abs(cosine - fitting) < 1e-12L))
                    return false;
            }
        return true;
    }

    int carry_out(const std::vector<std::size_t>& set) {
        if (!is_order_free(set)) {
            reflect(set);
            return static_cast<int>(set.size());
        }
        int carried_out = 0;
        for (const std::size_t k : set) {
            if (!approaches(k)) continue;
            reflect({k});
            ++carried_out;
        }
        return carried_out;
    }

    void reflect(const std::vector<std::size_t>& set) {
        std::vector<Opening> orthonormal;
        for (const std::size_t k : set) {
            Opening one = openings_[k];
            const long double size = std::sqrt(dot(one.e, one.e));
            for (int twice = 0; twice < 2; ++twice)  // for the sake of round-off
                for (const Opening& other : orthonormal) {
                    const long double share = dot(one.e, other.e);
                    for (std::size_t m = 0; m < one.e.size(); ++m) one.e[m] -= share * other.e[m];
                    one.constant -= share * other.constant;
                }
            const long double rest = std::sqrt(dot(one.e, one.e));
            if (rest < 1e-9L * size) continue;  // it depends on the others
            for (long double& part : one.e) part /= rest;
            one.constant /= rest;
            orthonormal.push_back(one);
        }
        std::vector<long double> u = scaled_velocities();
        const std::vector<long double> before = u;
        for (const Opening& one : orthonormal) {
            const long double speed = dot(one.e, before) + one.constant;
            for (std::size_t m = 0; m < u.size(); ++m) u[m] -= 2.0L * speed * one.e[m];
        }
        set_scaled_velocities(u);
    }

    std::vector<SlowParticipant>& participants_;
    const std::vector<SlowTouch>& touches_;
    std::vector<Opening> openings_;
    long double fastest_ = 0.0L;  // at the start
    bool is_single_ = false;
};

}  // namespace

std::vector<SlowTouch> connected_with(std::size_t participant,
                                      const std::vector<SlowTouch>& touches,
                                      const std::vector<SlowParticipant>& participants) {
    std::set<std::size_t> bodies{participant}, taken;
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t k = 0; k < touches.size(); ++k) {
            const SlowTouch& touch = touches[k];
            if (!touch.is_closed() || taken.contains(k)) continue;
            if (!bodies.contains(touch.first) && !bodies.contains(touch.second)) continue;
            taken.insert(k);
            grows = true;
            for (const std::size_t i : {touch.first, touch.second})
                if (participants[i].can_be_pushed()) bodies.insert(i);
        }
    }
    std::vector<SlowTouch> found;
    for (const std::size_t k : taken) found.push_back(touches[k]);
    return found;
}

int carry_out_rounds(std::vector<SlowParticipant>& participants,
                     const std::vector<SlowTouch>& touches) {
    Rounds rounds(participants, touches);
    rounds.look_whether_single();
    return rounds.run();
}

}  // namespace carom::test
