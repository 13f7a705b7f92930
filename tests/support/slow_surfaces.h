// The obvious simulator of disks, or beads on a line, among surfaces that act, obstacles and
// gravity, to check the fast one against. From one state to the next it looks at all pairs and all
// parts of surfaces (all images), at pistons and driven walls too. Each distance is a polynomial of
// the time, whose roots are found between those of its derivative. No cells, no queue, no local
// times; long double makes up for its round-off. It does not draw what leaves a heat bath.
//
// It is told which contact comes next and says whether that is one, and whether another would have
// come before: contacts at one time, and those that round-off makes or misses, have no order.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/run.h"
#include "support/slow_numbers.h"

namespace carom::test {

struct SlowContact {
    std::int32_t first, second;  ///< second: -1 - the number of a surface, as in surface.h
};

class SlowSurfaces {
  public:
    struct Disk {
        SlowVector x, v, a;
        long double radius, inverse_mass;
        std::int32_t species;
        std::set<std::int32_t> passing = {};  ///< surfaces that have let it through
    };
    /// A side or a partition.
    struct Mover {
        int axis;
        long double place, velocity = 0.0L, acceleration = 0.0L;
        long double inverse_mass = 0.0L;  ///< 0: nothing that hits it changes its motion
        Behaviour behaviour;
        bool is_open = false, is_held = false;
        bool is_mobile = false;  ///< has ever moved
        long double stops = std::numeric_limits<long double>::infinity();
    };

    SlowSurfaces(const Box& box, const Particles& particles, const Sample& start);

    /// How far two may overlap, or be apart at a contact, by round-off.
    long double slack() const { return slack_; }
    long double time() const { return time_; }
    const std::vector<Disk>& disks() const { return disks_; }
    const std::vector<Mover>& movers() const { return movers_; }

    /// Moves all on to a time, through what surfaces do by themselves. Stops at a contact before it
    /// that should have happened, and returns it.
    std::optional<SlowContact> advance(long double time);

    /// The contact at the present: what it does. `like` is the velocity of the first that another
    /// simulator has found, of the parts of a surface in contact the one is taken that gives this.
    /// Returns the distance of the two, and the velocity at which they approach (negative).
    struct Touch {
        long double gap, approach;
        bool is_bath = false;
        bool is_within = false;  ///< of a disk that a membrane had let in, and reflects
    };
    Touch collide(const SlowContact& contact, const SlowVector& like);

    /// What an event of the run does, at the present. False if it cannot be: `in_the_way` are the
    /// disks on which a partition would close.
    bool apply(const RunEvent& event, std::vector<std::int32_t>& in_the_way);

    /// Takes over the state of another simulator.
    void adopt(const Sample& state, const std::vector<SurfaceState>& surfaces);

    /// The smallest distance of a mover from what it could reach: where it is none, round-off
    /// decides what a disk between them does.
    long double least_room() const;

    /// The smallest distance of any two that should not overlap.
    long double least_gap() const;

  private:
    /// A straight line from `place` on, or a circle; `surface` moves it.
    struct Part {
        bool is_line;
        SlowVector place, end;  ///< of a circle both its center
        SlowVector along;       ///< the direction of a line
        long double length;     ///< of a line; of one without ends infinite
        long double radius;     ///< of a circle
        std::int32_t surface;
    };
    /// As one thing sees another: r + v t + a t^2 / 2.
    struct Motion {
        SlowVector r, v, a;
    };
    struct Next {
        long double wait;
        std::int32_t first = -1, second = -1;  ///< first < 0: of movers, or none
        long double place = 0.0L;              ///< of a part that a mover reaches
    };

    void add_partition(int axis, long double at, const std::vector<std::pair<double, double>>& gaps,
                       std::int32_t surface);
    void add_obstacle(const Obstacle& obstacle, std::int32_t surface);
    void set_motion(Mover& mover);
    void settle();
    void find_slack();
    static long double side_of(const Part& part, long double distance);
    bool is_there(const Part& part) const;
    bool lets_pass(const Part& part, const Disk& disk) const;
    Motion motion_of(const Disk& disk, const Part& part, const SlowVector& image) const;
    Motion between(const Disk& a, const Disk& b, const SlowVector& image) const;
    std::vector<SlowVector> images() const;
    long double time_to_circle(const Motion& m, long double distance, long double before) const;
    long double time_to_part(const Disk& disk, const Part& part, const Motion& m,
                             long double before) const;
    long double gap_of(const Motion& m, const Part& part, const Disk& disk) const;
    void look_at_pairs(Next& next) const;
    void look_at_parts(Next& next) const;
    std::optional<long double> end_towards(const Part& part, const Mover& mover) const;
    template <class Consider>
    void for_each_that_reaches(std::size_t k, const Consider& consider) const;
    void look_at_movers(Next& next) const;
    long double longest_step() const;
    void fly(long double wait);
    void bounce(const Next& next);
    bool admits(const Mover& mover, const Disk& disk) const;
    Touch collide_with_surface(Disk& disk, std::int32_t surface, const SlowVector& like);

    Box box_;
    long double slack_;
    std::vector<Disk> disks_;
    std::vector<Mover> movers_;
    std::vector<Part> parts_;
    std::vector<std::size_t> order_;  ///< of beads on a line, from the left
    long double time_ = 0.0L;
};

}  // namespace carom::test
