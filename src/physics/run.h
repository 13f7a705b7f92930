// What happens to the gas in time, as plain values; reversal_times() may be called from any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "physics/gas.h"
#include "physics/surface.h"

namespace carom {

struct ReverseVelocities {};

/// Moves one particle by a little.
struct Perturbation {
    std::int64_t particle = 0;                ///< as the scene numbers them
    std::array<std::string, 2> by{"0", "0"};  ///< lengths in decimal, which a run of many bits
                                              ///< reads with all their digits; y is 0 in 1-D
};

/// Opens a partition, so that nothing is there, or closes it again.
struct SetOpen {
    std::int32_t surface = 0;  ///< its number among all surfaces (surface.h), here and below
    bool is_open = true;
};

/// A side or a partition moves at this velocity from now on, whatever hits it.
struct MoveSurface {
    std::int32_t surface = 0;
    double velocity = 0.0;  ///< along x or y
};

/// A piston stops and stays.
struct HoldPiston {
    std::int32_t surface = 0;
};

/// A piston that was held is free again, at rest.
struct ReleasePiston {
    std::int32_t surface = 0;
};

/// A side or a partition acts otherwise from now on.
struct ChangeSurface {
    std::int32_t surface = 0;
    Behaviour behaviour = Reflecting{};
};

/// Scales velocities: about their mean along axes where momentum is conserved
/// (conserves_momentum()), else about 0.
struct Heat {
    std::optional<std::int32_t> species;  ///< index into Gas::species; none: of all particles
    std::variant<double, Temperature> amount{};  ///< energy more or less, or what it comes to
};

struct RunEvent {
    double at = 0.0;  ///< simulated time
    std::variant<ReverseVelocities, Perturbation, SetOpen, MoveSurface, HoldPiston, ReleasePiston,
                 ChangeSurface, Heat>
        action;
    bool is_mirrored = true;  ///< at t, it is undone at 2 r - t after a reversal at r; of those
                              ///< that can be undone
};

/// Bits of the significands that a run calculates with: those of a double, or from the least to the
/// most.
inline constexpr int bits_of_double = 53, least_bits = 64, most_bits = 16384;

struct Run {
    double until = 0.0;            ///< end, in simulated time
    double equilibrate = 0.0;      ///< simulated time before t = 0, not counted
    double sample_every = 0.0;     ///< simulated time between two samples of the statistics, which
                                   ///< are no event: the simulation itself does not look at it
    std::vector<RunEvent> events;  ///< in order of time; equal times in the order listed
    std::optional<int> bits = bits_of_double;  ///< none: as many as it takes for the gas to return
                                               ///< after each reversal (bits_for_return())
    std::optional<double> time_step =
        {};  ///< advance by steps of this length, at whose ends particles
             ///< that overlap collide; none: from contact to contact
    std::optional<std::int64_t> most_collisions =
        {};  ///< of particles with anything, from the start of the equilibration on; none: as
             ///< collision_ceiling() says
    double tolerance = 1e-9;  ///< largest return distance, in units of the smallest radius, or on a
                              ///< line of points of the mean spacing
};

/// How many collisions a run may have, which ends one whose collisions follow ever faster.
inline std::int64_t collision_ceiling(const Run& run, std::int64_t particles) {
    constexpr std::int64_t least = 1'000'000'000, for_each_particle = 5'000;
    return run.most_collisions.value_or(std::max(least, for_each_particle * particles));
}

/// Whether an event does more than reverse velocities or nudge particles: it acts on surfaces or
/// heats the gas.
inline bool acts_on_box(const std::vector<RunEvent>& events) {
    return std::ranges::any_of(events, [](const RunEvent& event) {
        return !std::holds_alternative<ReverseVelocities>(event.action) &&
               !std::holds_alternative<Perturbation>(event.action);
    });
}

/// When velocities are reversed, in order.
inline std::vector<double> reversal_times(const Run& run) {
    std::vector<double> times;
    for (const RunEvent& event : run.events)
        if (std::holds_alternative<ReverseVelocities>(event.action)) times.push_back(event.at);
    return times;
}

}  // namespace carom
