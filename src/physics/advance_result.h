// What an advance of the simulation reports: collisions, their counts, and the momentum that they
// transferred. Plain values.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "physics/collision/velocity_changes.h"
#include "physics/exact_positions.h"
#include "physics/surface.h"

namespace carom {

/// The sides of the box; a line has the first two, a plane the first four.
enum class Side : std::int8_t { left, right, bottom, top, back, front };

/// What a particle has collided with: another particle, a side of the box or another surface.
class Partner {
  public:
    constexpr Partner(std::int32_t particle = 0) : code_(particle) {}  // implicit: Eigen's indices
    constexpr Partner(Side side) : code_(-1 - static_cast<std::int32_t>(side)) {}

    /// The surface of this number: a side of the box, a partition or an obstacle (surface.h).
    static constexpr Partner of_surface(std::int32_t surface) { return Partner(-1 - surface); }

    constexpr bool is_surface() const { return code_ < 0; }
    constexpr bool is_particle() const { return code_ >= 0; }

    /// Its number. Throws std::logic_error if it is a surface.
    constexpr std::int32_t particle() const {
        if (is_surface()) throw std::logic_error("the partner of this collision is a surface");
        return code_;
    }
    /// Its number among the surfaces. Throws std::logic_error if it is a particle.
    constexpr std::int32_t surface() const {
        if (is_particle()) throw std::logic_error("the partner of this collision is a particle");
        return -1 - code_;
    }
    friend constexpr bool operator==(Partner, Partner) = default;
    friend constexpr bool operator==(Partner a, std::int64_t particle) {
        return a.is_particle() && a.code_ == particle;
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(code_);
    }

  private:
    std::int32_t code_;
};

/// One collision, as it happened.
struct Collision {
    double time;
    std::int32_t first;  ///< particle
    Partner second;
    Vec first_position;               ///< centre of `first` at contact
    Vec second_position;              ///< centre of `second` (in a periodic box of its image that
                                      ///< touches `first`), or the point of contact on the wall
    Vec first_before, second_before;  ///< velocities; a wall's are 0
    Vec first_after, second_after;
};

/// Contacts of connected particles that coincided, and were carried out together
/// (events/contact_rounds.h).
struct Ties {
    std::int64_t instants = 0;  ///< at which two or more contacts coincided
    std::int64_t contacts = 0;  ///< carried out at these instants
    double first = 0.0;         ///< time of the first of them, if there is one
};

/// How many collisions have happened since t = 0.
struct CollisionCounts {
    std::int64_t particle = 0;  ///< between two particles
    std::int64_t wall = 0;      ///< between a particle and a wall
    Ties ties = {};             ///< among them
};

/// Momentum transferred by collisions since t = 0, and the largest overlap at contact.
struct ImpulseTotals {
    std::array<double, 6> wall{};  ///< outward momentum given to each side of the box, in the order
                                   ///< of Side; infinite after a hit by an infinite mass
    double virial = 0.0;  ///< sum over collisions of two particles of r . dp: r from the first
                          ///< to the second, dp what the second received
    double largest_overlap = 0.0;  ///< largest overlap depth at a collision of two particles, in
                                   ///< units of their contact distance; 0 if none was detected late
};

/// The result of an advance to a given time.
struct AdvanceResult {
    CollisionCounts counts;  ///< since t = 0, at the end of this advance
    ImpulseTotals impulses;  ///< since t = 0, at the end of this advance
    int reversals = 0;       ///< reversals since t = 0, including those at the end of this advance
    std::span<const Collision>
        collisions;  ///< of this advance only, if they are recorded; valid until the next advance
    std::optional<ReturnDistance>
        return_distance;  ///< of the present positions from those at the mirror time, if
                          ///< Simulation::measure_return() has requested it for the present time
    std::vector<SurfaceState> surfaces = {};  ///< at the end of the advance, in the order of their
                                              ///< numbers; empty if there are only reflecting walls
    std::optional<std::span<const VelocityChange>> velocities =
        {};  ///< velocities changed in this advance, if Simulation::follow_velocities() requested
             ///< them and they are known; valid until the next advance
};

/// Called every few thousand events with the simulated time.
using TimeCallback = std::function<void(double time)>;

}  // namespace carom
