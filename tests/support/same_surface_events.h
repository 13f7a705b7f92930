// Compares the event loop of boxes with active surfaces with the slow, simple reference simulator,
// event by event.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"
#include "support/goodness_of_fit.h"
#include "support/slow_surfaces.h"
#include "support/surface_scenes.h"
#include "util/random.h"

namespace carom::test {

/// Counts of what has been compared.
struct SurfaceTally {
    int scenes = 0, pairs = 0, hits = 0, events = 0, refused = 0, ended = 0;
    int instants = 0, tied = 0;       ///< at which contacts coincided, and these contacts
    std::vector<double> flux, along;  ///< velocities normal to and along baths, in sqrt(T/m)
    /// Of the directions behind diffuse walls, each uniform in [-1, 1] by the cosine law: in the
    /// plane the sine of the angle to the normal; in space 2 sin^2 - 1 of it, and the angle about
    /// the normal in units of pi.
    std::vector<double> sines, turns;
};

/// Four tests of a run, three where there are no turns: chance fails one in a million.
inline void check_random_walls(const SurfaceTally& tally) {
    const auto is_uniform = [](double x) { return 0.5 * (1.0 + x); };
    CHECK(tally.sines.size() > 1'000);
    CHECK(chance(tally.sines, is_uniform) > 1e-6);
    if (!tally.turns.empty()) CHECK(chance(tally.turns, is_uniform) > 1e-6);
    CHECK(chance(tally.flux, [](double v) { return 1.0 - std::exp(-0.5 * v * v); }) > 1e-6);
    CHECK(chance(tally.along, [](double v) { return 0.5 * std::erfc(-v / std::numbers::sqrt2); }) >
          1e-6);
}

/// Directions across a normal, of length 1 and orthogonal to each other: those of the other axes in
/// their order if the normal points along an axis.
inline std::vector<SlowVector> across(const SlowVector& normal, int dimension) {
    std::vector<SlowVector> all;
    for (int axis = 0; axis < dimension && std::ssize(all) < dimension - 1; ++axis) {
        SlowVector one = along_axis(axis) - normal[axis] * normal;
        for (const SlowVector& other : all) one = one - dot(one, other) * other;
        if (size(one) > 0.5L) all.push_back((1.0L / size(one)) * one);
    }
    return all;
}

/// Compares the two simulators from event to event: after each event the slow one takes over the
/// state of the fast one.
template <int dimension, class Scalar>
class SurfaceComparison {
  public:
    SurfaceComparison(const Box& box, const Particles& particles, const Sample& start,
                      SurfaceTally& tally, const Arithmetic& arithmetic)
        : box_(box),
          particles_(particles),
          fast_(box, particles, arithmetic),
          slow_(box, particles, start),
          tally_(tally) {
        fast_.start(start);
    }

    /// Advances to `time`, through at most `most` events. Returns false if these are used up, or if
    /// the comparison cannot go on.
    bool go_on(double time, int& most) {
        Collision found{};
        while (most > 0) {
            if (!fast_.advance_one(time, found)) {
                require_nothing_before(time);
                compare(time);
                return true;
            }
            --most;
            if (!check(found)) return false;
        }
        return false;
    }

    /// Carries out an event of the run in both simulators. Returns false if it is impossible, which
    /// ends a run.
    bool carry_out(const RunEvent& event) {
        std::vector<std::int32_t> in_the_way;
        const bool can_be = slow_.apply(event, in_the_way);
        if (const auto* heat = std::get_if<Heat>(&event.action)) {
            REQUIRE(fast_.heat(*heat, true, event.at) == can_be);
        } else {
            const auto one = fast_.change(action_of(event), true, event.at);
            REQUIRE(one.has_value() == !can_be);
            if (one) REQUIRE(std::ranges::find(in_the_way, *one) != in_the_way.end());
        }
        ++(can_be ? tally_.events : tally_.refused);
        if (can_be) compare(event.at);
        return can_be;
    }

  private:
    static SurfaceAction action_of(const RunEvent& event) {
        return std::visit(
            [](const auto& its) -> SurfaceAction {
                if constexpr (std::is_constructible_v<SurfaceAction, decltype(its)>)
                    return its;
                else
                    throw std::logic_error("no surface");
            },
            event.action);
    }

    void require_nothing_before(double time) {
        const auto missed = slow_.advance(time);
        if (!missed) return;
        CAPTURE(static_cast<double>(slow_.time()));
        CAPTURE(time);
        CAPTURE(missed->first);
        CAPTURE(missed->second);
        FAIL("a contact has been missed");
    }

    // Checks one collision. Returns false if round-off may decide how the run continues.
    bool check(const Collision& found) {
        const bool is_pair = found.second.is_particle();
        const std::int32_t second = is_pair ? found.second.particle() : -1 - found.second.surface();
        CAPTURE(found.time);
        CAPTURE(found.first);
        CAPTURE(second);
        require_nothing_before(found.time);
        if (slow_.least_room() < 1e-9L || slow_.bounces() > 20) return false;
        const std::int64_t tied = fast_.counts().ties.contacts - tied_;
        tied_ += tied;
        if (tied > 0) return check_tie(found, tied);
        const auto touch = slow_.collide({found.first, second}, slow(found.first_after));
        CAPTURE(static_cast<double>(touch.gap));
        CAPTURE(static_cast<double>(touch.approach));
        REQUIRE(std::abs(touch.gap) <= slow_.slack());
        REQUIRE(touch.approach < slow_.slack());
        ++(is_pair ? tally_.pairs : tally_.hits);
        if (touch.is_random && particles_.inverse_mass[found.first] > 0.0)
            check_random(found);
        else
            compare(found.time);
        fast_.sample(found.time, sample_);
        slow_.adopt(sample_, fast_.surfaces(found.time));
        // One that leaves a diffuse wall almost at rest may jump no higher than places are rounded.
        if (touch.is_random && square(found.first_after) < 1e-12) return false;
        // A particle reflected while it overlaps the surface may meet it again without having left
        // it. A piston that nothing holds is far away in the end, where round-off is large.
        return !touch.is_within && slow_.slack() < 1e-10L;
    }

    // Checks contacts that coincided, the first of which has been taken from the event loop.
    // Round-off may decide what else belongs to them.
    bool check_tie(const Collision& first, std::int64_t contacts) {
        const double time = first.time;
        const std::int32_t second =
            first.second.is_particle() ? first.second.particle() : -1 - first.second.surface();
        const auto tie = slow_.settle_tie({first.first, second});
        if (tie.is_doubtful || tie.contacts != contacts) return false;
        Collision next{};
        for (std::int64_t k = 1; k < contacts; ++k) REQUIRE(fast_.advance_one(time, next));
        ++tally_.instants;
        tally_.tied += static_cast<int>(contacts);
        compare(time);
        slow_.adopt(sample_, fast_.surfaces(time));
        return slow_.slack() < 1e-10L;
    }

    // The particle must leave the wall, a diffuse one at its own speed; its velocity is stored, and
    // compared with its distribution in the end.
    void check_random(const Collision& found) {
        const auto& mover = slow_.movers()[static_cast<std::size_t>(found.second.surface())];
        Vec normal = found.first_position - found.second_position;
        if (particles_.radius[found.first] == 0.0) {  // on the wall; it came from the other side
            normal = {};
            normal[mover.axis] = found.first_before[mover.axis] > 0.0 ? -1.0 : 1.0;
        }
        const SlowVector away = slow(normal / length(normal)), after = slow(found.first_after);
        const long double outward = dot(away, after);
        REQUIRE(outward > 0.0L);
        std::vector<double> along;
        for (const SlowVector& direction : across(away, dimension))
            along.push_back(static_cast<double>(dot(direction, after)));
        if (dimension == 3 && std::abs(away[mover.axis]) == 1.0L)
            require_drawn(found, mover.behaviour, static_cast<double>(outward), along);
        if (const auto* bath = bath_of(mover.behaviour)) {
            const double unit = std::sqrt(bath->temperature * particles_.inverse_mass[found.first]);
            tally_.flux.push_back(static_cast<double>(outward) / unit);
            for (const double each : along) tally_.along.push_back(each / unit);
            return;
        }
        const double before = length(found.first_before);
        REQUIRE(length(found.first_after) == doctest::Approx(before).epsilon(1e-14));
        if constexpr (dimension == 2) tally_.sines.push_back(along[0] / before);
        if constexpr (dimension == 3) {
            tally_.sines.push_back(2.0 * square(Vec(along[0], along[1]) / before) - 1.0);
            tally_.turns.push_back(std::atan2(along[1], along[0]) / std::numbers::pi);
        }
    }

    // The velocity with which a sphere leaves a face is made of the numbers that docs/physics.md
    // lists, in their order: that along the normal first, then those along the other axes.
    void require_drawn(const Collision& found, const Behaviour& behaviour, double outward,
                       const std::vector<double>& along) const {
        const auto k = static_cast<std::size_t>(found.second.surface());
        const std::int64_t hit = fast_.surfaces(found.time)[k].hits;
        Random random(box_.surfaces.seed,
                      "hit " + std::to_string(hit) + " of surface " + std::to_string(k));
        const auto near = [](double a, double b) { return std::abs(a - b) < 1e-14; };
        if (const auto* bath = bath_of(behaviour)) {
            const double unit = std::sqrt(bath->temperature * particles_.inverse_mass[found.first]);
            REQUIRE(near(outward / unit, std::sqrt(-2.0 * std::log1p(-random.uniform()))));
            for (const double each : along) REQUIRE(near(each / unit, random.normal()));
            return;
        }
        const double speed = length(found.first_before);
        double x = 1.0, y = 1.0;  // the projection onto the face, uniform in a circle of radius 1
        while (x * x + y * y >= 1.0) {
            x = 2.0 * random.uniform() - 1.0;
            y = 2.0 * random.uniform() - 1.0;
        }
        REQUIRE(near(along[0] / speed, -x));
        REQUIRE(near(along[1] / speed, -y));
    }

    void compare(double time) {
        fast_.sample(time, sample_);
        const auto surfaces = fast_.surfaces(time);
        // Round-off of the contact point rotates the velocities after the collision.
        const auto near = [&](double found, long double expected, long double scale) {
            return std::abs(found - expected) <= scale;
        };
        long double fastest = 1.0L;
        for (const auto& body : slow_.bodies()) fastest = std::max(fastest, size(body.v));
        for (const auto& mover : slow_.movers())
            fastest = std::max(fastest, std::abs(mover.velocity));
        for (std::size_t i = 0; i < slow_.bodies().size(); ++i) {
            const auto& body = slow_.bodies()[i];
            CAPTURE(i);
            for (int axis = 0; axis < dimension; ++axis) {
                const auto row = static_cast<Eigen::Index>(i);
                long double off = sample_.position(row, axis) - body.x[axis];
                if (box_.is_periodic(axis)) off = std::remainder(off, box_.length(axis));
                CAPTURE(axis);
                REQUIRE(near(static_cast<double>(off), 0.0L, slow_.slack()));
                CAPTURE(sample_.velocity(row, axis));
                CAPTURE(static_cast<double>(body.v[axis]));
                const long double turn =
                    body.radius > 0.0L ? slow_.slack() / body.radius : slow_.slack();
                REQUIRE(near(sample_.velocity(row, axis), body.v[axis], 10.0L * turn * fastest));
            }
        }
        for (std::size_t k = 0; k < slow_.movers().size(); ++k) {
            const auto& mover = slow_.movers()[k];
            CAPTURE(k);
            REQUIRE(surfaces[k].motion.has_value() == mover.is_mobile);
            if (!mover.is_mobile) continue;
            CAPTURE(surfaces[k].motion->place);
            CAPTURE(static_cast<double>(mover.place));
            CAPTURE(surfaces[k].motion->velocity);
            CAPTURE(static_cast<double>(mover.velocity));
            REQUIRE(near(surfaces[k].motion->place, mover.place, slow_.slack()));
            REQUIRE(near(surfaces[k].motion->velocity, mover.velocity,
                         100.0L * slow_.slack() * fastest));
        }
    }

    Box box_;
    const Particles& particles_;
    EventLoop<dimension, Scalar, true> fast_;
    SlowSurfaces slow_;
    Sample sample_;
    SurfaceTally& tally_;
    std::int64_t tied_ = 0;  ///< contacts that coincided so far
};

/// Moves some particles to special places, such as a corner, and sets some at rest, for instance on
/// the floor.
inline void move_some(const Box& box, const Particles& particles, Sample& start,
                      std::uint64_t seed) {
    Random random(seed, "special places");
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const double which = random.uniform();
        if (which > 0.3) continue;
        const Sample before = start;
        for (int axis = 0; axis < box.dimension; ++axis) {
            if (box.is_periodic(axis)) continue;
            const bool low = random.uniform() < 0.5;
            if (which < 0.2 || axis == 1)  // touches this wall
                start.position(i, axis) =
                    low ? particles.radius[i] : box.length(axis) - particles.radius[i];
            if (which < 0.1 || (which > 0.2 && axis == 1)) start.velocity(i, axis) = 0.0;
        }
        const SlowSurfaces slow(box, particles, start);
        if (slow.least_gap() < -1e-12L) start = before;
    }
}

/// Requires that both simulators find the same events, for at most `most` of them.
template <int dimension, class Scalar = double>
void require_same_surface_events(const SurfaceScene& scene, std::uint64_t seed, SurfaceTally& tally,
                                 int most, const Arithmetic& arithmetic = {}) {
    Particles particles;
    Sample start;
    try {
        std::tie(particles, start) = place(scene.gas);
    } catch (const std::exception&) {
        return;  // the particles do not fit
    }
    move_some(scene.gas.box, particles, start, seed);
    ++tally.scenes;
    SurfaceComparison<dimension, Scalar> comparison(scene.gas.box, particles, start, tally,
                                                    arithmetic);
    try {
        for (const RunEvent& event : scene.events) {
            if (!comparison.go_on(event.at, most)) return;
            if (!comparison.carry_out(event)) return;
        }
        comparison.go_on(20.0, most);
    } catch (const std::runtime_error& error) {
        ++tally.ended;  // a driven wall reaches another surface, or crushes a particle
    }
}

}  // namespace carom::test
