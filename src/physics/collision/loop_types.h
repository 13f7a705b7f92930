// The types shared by the event loop (event_loop.h), which is one source for both dimensions, and
// its geometries: the plane of disks (plane.h, mp_plane.h) and the line of beads (line.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "physics/collision/flight.h"
#include "physics/collision/pair_collision.h"
#include "physics/gas.h"
#include "physics/particles.h"
#include "util/memory/large_pages.h"

namespace carom {

/// How a run calculates: with doubles, or with numbers of more bits (multiprecision.h).
struct Arithmetic {
    int bits = 53;
    bool screened = true;  ///< multiprecision: doubles exclude what certainly does not happen; the
                           ///< events are the same without
};

/// How two particles met.
template <int Dimension>
struct Contact {
    std::array<double, Dimension> separation;  ///< from the first to the second (in a periodic box
                                               ///< to its image that touches the first)
    double virial = 0.0;                       ///< separation . momentum received by the second
    double overlap = 0.0;                      ///< depth, in units of the contact distance
};

/// What will happen to a particle, at a time that the queue of events knows: a contact with another
/// if `contact_time` is not after it, else reaching a border.
struct Prediction {
    double contact_time = never<double>;  ///< local; not after the contact, in the plane of doubles
                                          ///< the time of one that may come after the border
    std::int32_t partner = 0;             ///< in that contact
    std::uint32_t partner_collisions : 29 = 0;
    std::uint32_t border : 3 = 0;

    template <class Archive>
    void archive(Archive& archive) {
        std::uint32_t collisions = partner_collisions, side = border;
        archive(contact_time, partner, collisions, side);
        set(collisions, side);
    }

  private:
    // Not in the template, where GCC 14 takes the masked values for too large.
    void set(std::uint32_t collisions, std::uint32_t side) {
        partner_collisions = collisions & ((1U << 29) - 1U);
        border = side & 7U;
    }
};

/// The same, and when.
template <typename Scalar>
struct Event : Prediction {
    Scalar time = never<double>;  ///< local
};

/// Borders of an event: the sides of the box are 0 to 3 (left, right, bottom, top), those of a
/// cell, or of a periodic box, 4 to 7.
inline constexpr unsigned first_cell_side = 4;

/// Collision counts are compared modulo 2^29: an event has that many bits for them.
inline constexpr std::uint32_t most_collisions = (1U << 29) - 1U;

/// What a particle is, apart from where it is.
struct Properties {
    double radius;
    double inverse_mass;  ///< 0 for an infinite mass

    template <class Archive>
    void archive(Archive& archive) {
        archive(radius, inverse_mass);
    }
};

/// What geometries have in common whose bodies know what they are, and stay in one order.
template <typename BodyType>
struct PlainBodies {
    using Body = BodyType;
    using Bodies = LargeVector<Body>;

    /// The bodies of these particles, and what the one or the other is.
    static Bodies bodies_of(const Particles& particles) {
        Bodies bodies(static_cast<std::size_t>(particles.count()));
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            bodies[i].radius = particles.radius[static_cast<Eigen::Index>(i)];
            bodies[i].inverse_mass = particles.inverse_mass[static_cast<Eigen::Index>(i)];
        }
        return bodies;
    }
    static Properties properties(const Bodies& bodies, std::size_t i) {
        return {bodies[i].radius, bodies[i].inverse_mass};
    }

    /// The order in which bodies shall lie in memory, and whether it is looked for again now and
    /// then.
    static std::vector<std::int32_t> order(const Bodies& bodies) {
        std::vector<std::int32_t> numbers(bodies.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        return numbers;
    }
    static bool is_resorted(std::size_t) { return false; }
};

/// To be called when a body has been moved or its velocity changed, for those who keep something
/// that depends on it.
template <typename Body>
void body_has_changed(Body&) {}

}  // namespace carom
