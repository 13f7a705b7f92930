#include "physics/placement/line_squeeze.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "physics/placement/members.h"

namespace carom {
namespace {

constexpr int most_steps = 100'000;  // of a bead that bounces to and fro, perhaps forever

struct Squeeze {
    double time;  ///< simulated
    Eigen::Index left, right;
};

struct Boundary {
    Eigen::Index bead;  ///< a bead of infinite mass, or an end of the line
    double velocity;
};

// The part of the line between two boundaries.
struct Chamber {
    std::size_t left, right;  ///< boundaries
    double room;              ///< length not covered by beads
    int beads;                ///< number of beads of finite mass inside
};

class Chambers {
  public:
    Chambers(const Box& box, const Particles& particles, const Sample& start)
        : ring_(box.is_periodic(0)) {
        const Beads from_left = beads_along(start, 0);
        double from = 0.0, covered = 0.0;
        int beads = 0;
        const auto close = [&](Boundary boundary, double low, double high) {
            if (!boundaries_.empty())
                chambers_.push_back(
                    {boundaries_.size() - 1, boundaries_.size(), low - from - covered, beads});
            boundaries_.push_back(boundary);
            from = high;
            covered = 0.0;
            beads = 0;
        };
        if (!ring_) close({left_end, 0.0}, 0.0, 0.0);
        for (const auto& [x, i] : from_left) {
            const double r = particles.radius[i];
            if (particles.inverse_mass[i] > 0.0) {
                covered += 2.0 * r;
                ++beads;
            } else {
                close({i, start.velocity(i, 0)}, x - r, x + r);
            }
        }
        if (!ring_) close({right_end, 0.0}, box.size[0], box.size[0]);
        if (ring_ && boundaries_.size() > 1) close_ring(box, particles, from_left, from);
    }

    // Advances by `time`; stops early at a squeeze and returns it.
    std::optional<Squeeze> advance(double now, double time) {
        for (int step = 0; step < most_steps; ++step) {
            double wait = time;
            Chamber* closing = nullptr;
            for (Chamber& chamber : chambers_) {
                const double approach = speed_of_closing(chamber);
                const double its = std::max(0.0, chamber.room) / approach;
                if (!(approach > 0.0) || its > wait) continue;
                wait = its;
                closing = &chamber;
            }
            for (Chamber& chamber : chambers_) chamber.room -= wait * speed_of_closing(chamber);
            now += wait;
            time -= wait;
            if (closing == nullptr) return std::nullopt;
            Boundary &left = boundaries_[closing->left], &right = boundaries_[closing->right];
            const bool bounces = closing->beads == 0 && (left.bead < 0 || right.bead < 0);
            if (!bounces) return Squeeze{now, left.bead, right.bead};
            closing->room = 0.0;
            (left.bead < 0 ? right : left).velocity *= -1.0;
        }
        return std::nullopt;
    }

    void reverse() {
        for (Boundary& boundary : boundaries_) boundary.velocity = -boundary.velocity;
    }

  private:
    double speed_of_closing(const Chamber& chamber) const {
        return boundaries_[chamber.left].velocity - boundaries_[chamber.right].velocity;
    }

    // The chamber across the end of the ring, from the last boundary to the first.
    void close_ring(const Box& box, const Particles& particles, const Beads& from_left,
                    double last_high) {
        const auto is_fixed = [&](const auto& bead) {
            return !(particles.inverse_mass[bead.second] > 0.0);
        };
        const auto [x, first] = *std::ranges::find_if(from_left, is_fixed);
        Chamber across{boundaries_.size() - 1, 0, 0.0, 0};
        across.room = x - particles.radius[first] + box.size[0] - last_high;
        const auto add = [&](auto bead, auto to) {
            for (; bead != to && !is_fixed(*bead); ++bead)
                across.room -= 2.0 * particles.radius[bead->second];
        };
        add(from_left.begin(), from_left.end());
        add(from_left.rbegin(), from_left.rend());
        chambers_.push_back(across);
    }

    bool ring_;
    std::vector<Boundary> boundaries_;
    std::vector<Chamber> chambers_;
};

}  // namespace

std::optional<Problem> first_squeeze(const Box& box, const Particles& particles,
                                     const Sample& start, const Run& run) {
    Chambers chambers(box, particles, start);
    double now = -run.equilibrate;
    std::vector<double> times = reversal_times(run);
    times.push_back(run.until);
    for (const double time : times) {
        if (const auto squeeze = chambers.advance(now, time - now)) {
            const Eigen::Index last = std::max(squeeze->left, squeeze->right);
            return Problem{.kind = Problem::Kind::squeeze,
                           .species = static_cast<std::size_t>(particles.species[last]),
                           .particle = squeeze->left,
                           .other = squeeze->right,
                           .value = squeeze->time};
        }
        chambers.reverse();
        now = time;
    }
    return std::nullopt;
}

}  // namespace carom
