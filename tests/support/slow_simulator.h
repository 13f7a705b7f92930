// A simple simulator of disks in a plane or of spheres in space, as a reference for the fast one:
// at each event it examines all pairs (with all periodic images) and all walls, moves all particles
// to the earliest contact, and carries out the collision. It has no cell grid, no event queue and
// no local times, and uses the textbook quadratic formula; its arithmetic is long double, which
// makes up for its larger round-off.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "support/slow_rounds.h"

namespace carom::test {

struct SlowEvent {
    long double time;
    std::int32_t first, second;  ///< as in carom::Collision; first < second for a pair
    int contacts = 1;  ///< carried out, of all that coincide and are connected (slow_rounds.h)
    bool is_doubtful = false;  ///< round-off decides which coincide
};

class SlowSimulator {
  public:
    SlowSimulator(const Box& box, const Particles& particles, const Sample& start);

    /// Advances to the next collision and returns it; none if there is none before `end`.
    std::optional<SlowEvent> next(long double end);

    /// Takes over the state of another simulator.
    void adopt(const Sample& state);

    /// The state of a particle; its place lies in the box.
    const SlowVector& place(std::int32_t i) const { return its(i).x; }
    const SlowVector& velocity(std::int32_t i) const { return its(i).v; }

  private:
    struct Body {
        SlowVector x, v;
        long double radius, inverse_mass;
    };
    struct Candidate {
        long double wait;
        std::int32_t first, second;
        SlowVector image;
    };
    /// A particle and an image of another, relative to the first.
    struct Pair {
        SlowVector x, v;
        long double contact;  ///< distance at contact
    };
    const Body& its(std::int32_t i) const { return bodies_[static_cast<std::size_t>(i)]; }
    Pair pair(const Body& a, const Body& b, const SlowVector& image) const;
    void look_at_pairs(Candidate& best) const;
    void look_at_walls(Candidate& best) const;
    long double longest_step() const;
    void move(long double wait);
    void wrap();
    void collide(const Candidate& event);
    void append_touches_of_pair(std::size_t i, std::size_t j, std::vector<SlowTouch>& all) const;
    void append_touches_of_walls(std::size_t i, std::vector<SlowTouch>& all) const;
    bool grazes(const Candidate& event) const;
    void settle(const Candidate& first, SlowEvent& event);

    Box box_;
    std::vector<SlowVector> images_;
    std::vector<Body> bodies_;
    long double time_ = 0.0L;
};

}  // namespace carom::test
