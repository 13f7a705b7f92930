// A simple simulator of spheres, of disks, or of beads on a line, with active surfaces, obstacles
// and gravity, as a reference for the fast one. From one state to the next it examines all pairs
// and all parts of surfaces (with all periodic images), including pistons and driven walls. Each
// distance is a polynomial of time; its roots are bracketed by those of its derivative. There are
// no cells, no event queue and no local times; its arithmetic is long double, which makes up for
// its larger round-off. It does not draw the random velocities after contacts with a heat bath or a
// diffuse wall.
//
// The caller names the next contact; the simulator checks that it is a contact and that no other
// one should have come before. It does not choose the contact itself because the order is undefined
// for simultaneous contacts and for those that round-off creates or misses.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/run.h"
#include "support/slow_numbers.h"
#include "support/slow_rounds.h"

namespace carom::test {

struct SlowContact {
    std::int32_t first, second;  ///< second < 0: surface -1 - second, as in surface.h
};

class SlowSurfaces {
  public:
    struct Body {
        SlowVector x, v, a;
        long double radius, inverse_mass;
        std::int32_t species;
        std::set<std::int32_t> passing = {};  ///< surfaces that have let the body through
    };
    /// A side of the box or a partition.
    struct Mover {
        int axis;
        long double place, velocity = 0.0L, acceleration = 0.0L;
        long double inverse_mass = 0.0L;  ///< 0: collisions do not change its motion
        Behaviour behaviour;
        bool is_open = false, is_held = false;
        bool is_mobile = false;  ///< is or was a piston or driven wall
        long double stops = std::numeric_limits<long double>::infinity();
    };

    SlowSurfaces(const Box& box, const Particles& particles, const Sample& start);

    /// How far two bodies may overlap, or be apart at a contact, because of round-off.
    long double slack() const { return slack_; }
    long double time() const { return time_; }
    const std::vector<Body>& bodies() const { return bodies_; }
    const std::vector<Mover>& movers() const { return movers_; }

    /// Advances all bodies to a time, including what surfaces do by themselves. If a contact should
    /// have happened earlier, stops at the first of them and returns it.
    std::optional<SlowContact> advance(long double time);

    /// Carries out a contact at the present time. `like` is the velocity of the first body after
    /// the contact according to another simulator: if several parts of a surface are in contact,
    /// the one that gives the velocity nearest to it is used. Returns the gap between the two and
    /// the normal velocity of approach (negative).
    struct Touch {
        long double gap, approach;
        bool is_random = false;  ///< the body leaves in a random direction, which is not drawn
        bool is_within = false;  ///< a membrane had let the body in and now reflects it
    };
    Touch collide(const SlowContact& contact, const SlowVector& like);

    /// The contacts that coincide at the present time with this one and are connected with it;
    /// those with baths come later (slow_rounds.h). If there are several, carries them out;
    /// otherwise nothing happens.
    struct Tie {
        int contacts = 0;
        bool is_doubtful = false;  ///< round-off decides which coincide
    };
    Tie settle_tie(const SlowContact& contact);

    /// Carries out an event of the run at the present time. Returns false if it is impossible;
    /// `in_the_way` then lists the particles on which a partition would close.
    bool apply(const RunEvent& event, std::vector<std::int32_t>& in_the_way);

    /// Takes over the state of another simulator.
    void adopt(const Sample& state, const std::vector<SurfaceState>& surfaces);

    /// The smallest distance between a mover and anything that it can hit. If it vanishes,
    /// round-off decides what happens to a particle in between.
    long double least_room() const;

    /// How often movers have bounced off something at rest or off each other since the last
    /// adopt(). A light piston may do so hundreds of times, which adds up the round-off of its
    /// motion.
    int bounces() const { return bounces_; }

    /// The smallest gap between any two bodies that must not overlap.
    long double least_gap() const;

  private:
    /// A range along a straight line, without an end where it is infinite.
    struct Span {
        SlowVector along;  ///< of length 1
        long double from, to;
        bool is_endless() const { return from == -infinite && to == infinite; }
    };
    /// All points that can be reached from `place` within some spans orthogonal to each other, and
    /// what lies less than `radius` away: a face or a line of a surface, an edge, a corner, a ball.
    /// It moves with `surface`.
    struct Part {
        std::int32_t surface = 0;
        SlowVector place = {};
        std::vector<Span> spans = {};
        long double radius = 0.0L;
        std::optional<SlowVector> normal = {};  ///< of a part that separates its two sides
        SlowVector low = {}, high = {};         ///< its extent, where its spans end
        std::vector<SlowVector> images = {};    ///< those that differ

        bool is_endless() const;  ///< separates the whole of space
        /// A vector without its components along the spans.
        SlowVector across(SlowVector a) const;
        /// Whether a point at this place relative to `place` lies within the spans, give or take
        /// some.
        bool has(const SlowVector& r, long double slack = 0.0L) const;
    };
    /// The motion of one body relative to another: r + v t + a t^2 / 2.
    struct Motion {
        SlowVector r, v, a;
    };
    struct Next {
        long double wait;
        std::int32_t first = -1, second = -1;  ///< first < 0: an event of movers, or none
        long double place = 0.0L;              ///< where a mover meets a part
    };

    void add(Part part);
    void add_partition(int axis, long double at, const std::vector<Gap>& gaps,
                       std::int32_t surface);
    void add_obstacle(const Obstacle& obstacle, std::int32_t surface);
    void set_motion(Mover& mover);
    void settle();
    void find_slack();
    long double side_of(const Part& part, long double distance) const;
    bool is_there(const Part& part) const;
    bool lets_pass(const Part& part, const Body& body) const;
    Motion motion_of(const Body& body, const Part& part, const SlowVector& image) const;
    Motion between(const Body& a, const Body& b, const SlowVector& image) const;
    std::vector<long double> times_at(const Motion& m, long double distance,
                                      long double before) const;
    bool is_out_of_reach(const Body& body, const Part& part, const SlowVector& image,
                         long double before) const;
    long double time_to_part(const Body& body, const Part& part, const Motion& m,
                             long double before) const;
    long double gap_of(const Motion& m, const Part& part, const Body& body) const;
    void look_at_pairs(Next& next) const;
    void look_at_parts(Next& next) const;
    std::optional<long double> end_towards(const Part& part, const Mover& mover) const;
    template <class Consider>
    void for_each_that_reaches(std::size_t k, const Consider& consider) const;
    void look_at_movers(Next& next) const;
    long double longest_step() const;
    void fly(long double wait);
    void bounce(const Next& next);
    bool admits(const Mover& mover, const Body& body) const;
    void append_touches_of_pairs(std::vector<SlowTouch>& all) const;
    void append_touches_of_parts(std::size_t i, std::vector<SlowTouch>& all) const;
    std::optional<SlowTouch> touch_of(std::size_t i, const Part& part, const Motion& m) const;
    std::vector<SlowParticipant> participants() const;
    Touch collide_with_surface(Body& body, std::int32_t surface, const SlowVector& like);

    Box box_;
    long double slack_;
    std::vector<Body> bodies_;
    std::vector<Mover> movers_;
    std::vector<SlowVector> images_;
    std::vector<Part> parts_;
    std::vector<std::size_t> order_;  ///< of beads on a line, from the left
    long double time_ = 0.0L;
    int bounces_ = 0;
};

}  // namespace carom::test
