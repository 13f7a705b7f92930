// The run: what happens to the gas in the course of time, as plain values, and what several parts
// of the program ask about its events. Every question is answered for each alternative by a visit
// without a generic function, so that a new alternative does not compile until all of them are;
// questions of one place are visited there. Which alternative an event is, is asked only here. All
// functions may be called from any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/surface.h"
#include "physics/temperature.h"
#include "util/overloaded.h"

namespace carom {

struct ReverseVelocities {};

/// Lengths along each axis in decimal, of which a multiprecision run uses all digits; an empty text
/// is 0.
using Displacement = std::array<std::string, 3>;

/// Displaces one particle by a small distance.
struct Perturbation {
    std::int64_t particle = 0;  ///< as the scene numbers them
    Displacement by;            ///< 0 along axes that the box does not have
};

/// Opens a partition, which is then absent, or closes it again.
struct SetOpen {
    std::int32_t surface = 0;  ///< its number among all surfaces (surface.h), here and below
    bool is_open = true;
};

/// From now on a side or a partition moves at a prescribed velocity, unaffected by collisions.
struct MoveSurface {
    std::int32_t surface = 0;
    double velocity = 0.0;  ///< along its normal
};

/// Stops a piston and holds it in place.
struct HoldPiston {
    std::int32_t surface = 0;
};

/// Releases a held piston, which starts from rest.
struct ReleasePiston {
    std::int32_t surface = 0;
};

/// Changes the behaviour of a side or a partition.
struct ChangeSurface {
    std::int32_t surface = 0;
    Behaviour behaviour = Reflecting{};
};

/// Scales velocities: relative to their mean along axes where momentum is conserved
/// (conserves_momentum()), otherwise relative to 0.
struct Heat {
    std::optional<std::int32_t> species;         ///< index into Gas::species; unset: all particles
    std::variant<double, Temperature> amount{};  ///< energy added (negative: removed), or the
                                                 ///< resulting temperature
};

/// What happens at an event.
using RunAction = std::variant<ReverseVelocities, Perturbation, SetOpen, MoveSurface, HoldPiston,
                               ReleasePiston, ChangeSurface, Heat>;

struct RunEvent {
    double at = 0.0;  ///< simulated time
    RunAction action;
    bool is_mirrored = true;  ///< if the event happens at t and velocities are reversed at r, it is
                              ///< undone at 2 r - t; only for events that can be undone
};

/// Whether it reverses all velocities.
inline bool reverses(const RunEvent& event) {
    return std::visit(
        Overloaded{[](const ReverseVelocities&) { return true; },
                   [](const Perturbation&) { return false; }, [](const SetOpen&) { return false; },
                   [](const MoveSurface&) { return false; },
                   [](const HoldPiston&) { return false; },
                   [](const ReleasePiston&) { return false; },
                   [](const ChangeSurface&) { return false; }, [](const Heat&) { return false; }},
        event.action);
}

/// Whether it changes energies directly, not by surfaces.
inline bool heats(const RunEvent& event) {
    return std::visit(
        Overloaded{[](const ReverseVelocities&) { return false; },
                   [](const Perturbation&) { return false; }, [](const SetOpen&) { return false; },
                   [](const MoveSurface&) { return false; },
                   [](const HoldPiston&) { return false; },
                   [](const ReleasePiston&) { return false; },
                   [](const ChangeSurface&) { return false; }, [](const Heat&) { return true; }},
        event.action);
}

/// The surface on which it acts; none for other events.
inline std::optional<std::int32_t> surface_of(const RunEvent& event) {
    using Surface = std::optional<std::int32_t>;
    return std::visit(
        Overloaded{[](const ReverseVelocities&) { return Surface(); },
                   [](const Perturbation&) { return Surface(); },
                   [](const SetOpen& action) { return Surface(action.surface); },
                   [](const MoveSurface& action) { return Surface(action.surface); },
                   [](const HoldPiston& action) { return Surface(action.surface); },
                   [](const ReleasePiston& action) { return Surface(action.surface); },
                   [](const ChangeSurface& action) { return Surface(action.surface); },
                   [](const Heat&) { return Surface(); }},
        event.action);
}

/// The surface to which it gives another behaviour, and that; none for other events.
inline std::optional<std::pair<std::int32_t, Behaviour>> given_behaviour(const RunEvent& event) {
    using Given = std::optional<std::pair<std::int32_t, Behaviour>>;
    return std::visit(Overloaded{[](const ReverseVelocities&) { return Given(); },
                                 [](const Perturbation&) { return Given(); },
                                 [](const SetOpen&) { return Given(); },
                                 [](const MoveSurface& action) {
                                     return Given({action.surface, Driven{action.velocity}});
                                 },
                                 [](const HoldPiston&) { return Given(); },
                                 [](const ReleasePiston&) { return Given(); },
                                 [](const ChangeSurface& action) {
                                     return Given({action.surface, action.behaviour});
                                 },
                                 [](const Heat&) { return Given(); }},
                      event.action);
}

// The values of one alternative, for what only this one has; null for all others.
inline const Perturbation* perturbation_of(const RunEvent& event) {
    return std::get_if<Perturbation>(&event.action);
}
inline const SetOpen* opening_of(const RunEvent& event) {
    return std::get_if<SetOpen>(&event.action);
}

/// Whether it does more than reverse velocities or displace particles: acts on a surface or heats.
inline bool acts_on_box(const RunEvent& event) {
    return std::visit(
        Overloaded{[](const ReverseVelocities&) { return false; },
                   [](const Perturbation&) { return false; }, [](const SetOpen&) { return true; },
                   [](const MoveSurface&) { return true; }, [](const HoldPiston&) { return true; },
                   [](const ReleasePiston&) { return true; },
                   [](const ChangeSurface&) { return true; }, [](const Heat&) { return true; }},
        event.action);
}
inline bool act_on_box(const std::vector<RunEvent>& events) {
    return std::ranges::any_of(events, acts_on_box);
}

/// Whether any event gives a surface another behaviour.
inline bool change_behaviours(const std::vector<RunEvent>& events) {
    return std::ranges::any_of(
        events, [](const RunEvent& event) { return given_behaviour(event).has_value(); });
}

/// Significand bits that a run may calculate with: those of a double, or from the least to the most
/// of multiprecision.
inline constexpr int bits_of_double = 53, least_bits = 64, most_bits = 16384;

struct Run {
    double until = 0.0;         ///< end, in simulated time
    double equilibrate = 0.0;   ///< simulated time before t = 0, not counted
    double sample_every = 0.0;  ///< simulated time between two samples of the statistics; samples
                                ///< are not events and do not affect the simulation
    std::vector<RunEvent> events;  ///< in order of time; events at equal times are carried out in
                                   ///< the order listed
    std::optional<int> bits = bits_of_double;  ///< unset: as many as needed for the gas to return
                                               ///< after each reversal (bits_for_return())
    std::optional<double> time_step =
        {};  ///< fixed step length; particles that overlap at the end of a step collide there;
             ///< unset: event-driven, from contact to contact
    std::optional<std::int64_t> most_collisions =
        {};  ///< limit on all collisions of particles, counted from the start of the equilibration;
             ///< unset: collision_ceiling() sets it
    double tolerance = 1e-9;  ///< largest acceptable return distance, in units of the smallest
                              ///< radius or, on a line of points, of the mean spacing
};

/// The largest number of collisions of a run. The limit ends runs whose collisions follow each
/// other ever faster.
inline std::int64_t collision_ceiling(const Run& run, std::int64_t particles) {
    constexpr std::int64_t least = 1'000'000'000, for_each_particle = 5'000;
    return run.most_collisions.value_or(std::max(least, for_each_particle * particles));
}

/// The times at which velocities are reversed, in ascending order.
inline std::vector<double> reversal_times(const Run& run) {
    std::vector<double> times;
    for (const RunEvent& event : run.events)
        if (reverses(event)) times.push_back(event.at);
    return times;
}

/// All behaviours that each side and partition has in the course of the run: at the start and after
/// its events.
inline std::vector<std::vector<Behaviour>> behaviours_in_time(const Surfaces& surfaces,
                                                              const Run& run) {
    std::vector<std::vector<Behaviour>> all;
    for (const Behaviour& side : surfaces.numbered_sides()) all.push_back({side});
    for (const Partition& partition : surfaces.partitions) all.push_back({partition.behaviour});
    for (const RunEvent& event : run.events) {
        const auto given = given_behaviour(event);
        const auto k = given ? static_cast<std::size_t>(given->first) : all.size();
        if (k < all.size()) all[k].push_back(given->second);
    }
    return all;
}

}  // namespace carom
