// Types shared by the event loop (event_loop.h), whose source is the same in every dimension, and
// its geometries: disks or spheres in a box (plain_space.h, open_space.h, mp_space.h) and beads on
// a line (line.h, open_line.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "physics/collision/flight.h"
#include "physics/collision/pair_collision.h"
#include "physics/particles.h"
#include "util/memory/large_pages.h"

namespace carom {

/// The arithmetic of a run: doubles, or numbers with more bits (multiprecision.h).
struct Arithmetic {
    int bits = 53;
    bool screened = true;  ///< multiprecision only: estimates in doubles rule out events that
                           ///< certainly do not happen; the events that do happen are the same
                           ///< without this screening
};

/// Geometry of a contact of two particles.
template <int Dimension>
struct Contact {
    std::array<double, Dimension> separation;  ///< from the first to the second (in a periodic box
                                               ///< to its image that touches the first)
    double virial = 0.0;   ///< scalar product of the separation and the momentum received by the
                           ///< second
    double overlap = 0.0;  ///< overlap depth, in units of the contact distance
};

/// The contact of two bodies of which the impulse factor is given (ContactRule::impulse());
/// `sigma`: sum of radii.
template <typename Scalar, std::size_t Dimension>
[[gnu::always_inline]] inline Contact<static_cast<int>(Dimension)> contact_of(
    const RelativeMotion<Scalar, Dimension>& m, const Scalar& factor, double sigma) {
    const auto square = static_cast<double>(scalar_product(m.r, m.r));
    Contact<static_cast<int>(Dimension)> contact;
    for (std::size_t k = 0; k < Dimension; ++k) contact.separation[k] = static_cast<double>(m.r[k]);
    contact.virial = -static_cast<double>(factor) * square;
    contact.overlap = 0.5 * (1.0 - square / (sigma * sigma));
    return contact;
}

/// Values of Prediction::border: first the sides of the box, of which there are at most six, in the
/// order of Side; then those of a cell or of a periodic box.
inline constexpr unsigned first_cell_side = 6;
inline constexpr int bits_of_border = 4;
inline constexpr std::uint32_t most_border = (1U << bits_of_border) - 1U;

/// Collision counts are compared modulo a power of 2, because a prediction stores only so many of
/// their bits.
inline constexpr int bits_of_collisions = 32 - bits_of_border;
inline constexpr std::uint32_t most_collisions = (1U << bits_of_collisions) - 1U;

/// The predicted next event of a particle; its time is stored in the event queue. It is a contact
/// with another particle if `contact_time` is not later than that time, otherwise the particle
/// reaches a border.
struct Prediction {
    double contact_time = never<double>;  ///< local; not later than the contact; for disks and
                                          ///< spheres in doubles it may be the time of a contact
                                          ///< after the border is reached
    std::int32_t partner = 0;             ///< the other particle of that contact
    std::uint32_t partner_collisions : bits_of_collisions = 0;
    std::uint32_t border : bits_of_border = 0;

    template <class Archive>
    void archive(Archive& archive) {
        std::uint32_t collisions = partner_collisions, side = border;
        archive(contact_time, partner, collisions, side);
        set(collisions, side);
    }

  private:
    // Outside the template, because GCC 14 would warn there that the masked values are too large.
    void set(std::uint32_t collisions, std::uint32_t side) {
        partner_collisions = collisions & most_collisions;
        border = side & most_border;
    }
};

/// A prediction together with its time.
template <typename Scalar>
struct Event : Prediction {
    Scalar time = never<double>;    ///< local
    double second = never<double>;  ///< the time of the second event that was found

    /// To be called for each event that is found, before it may replace the first one.
    [[gnu::always_inline]] void notice(const Scalar& another) {
        second =
            std::min(second, std::max(static_cast<double>(time), static_cast<double>(another)));
    }
};

/// The constant properties of a particle.
struct Properties {
    double radius;
    double inverse_mass;  ///< 0 for an infinite mass

    template <class Archive>
    void archive(Archive& archive) {
        archive(radius, inverse_mass);
    }
};

/// Common base of geometries whose bodies store their own properties and keep a fixed order.
template <typename BodyType>
struct PlainBodies {
    using Body = BodyType;
    using Bodies = LargeVector<Body>;

    /// Creates the bodies of these particles; properties() returns those of one body.
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

    /// The order in which bodies are stored in memory (here unchanged), and whether they are
    /// re-sorted from time to time.
    static std::vector<std::int32_t> order(const Bodies& bodies) {
        std::vector<std::int32_t> numbers(bodies.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        return numbers;
    }
    static bool is_resorted(std::size_t) { return false; }
};

/// To be called after a body has been moved or its velocity has changed, so that bodies can update
/// quantities derived from these.
template <typename Body>
void body_has_changed(Body&) {}

}  // namespace carom
