// Finds which of several disks or spheres one of them touches first, and when. Four at a time are
// tested for whether they can be touched at all, and before a contact already predicted for either;
// the exact contact times (pair_collision.h) of the few candidates are solved two at a time. The
// only branches depend on the number of candidates: the processor could not predict any others, and
// a misprediction costs more than the arithmetic it saves. Independent of cells: the caller selects
// the bodies to test (pair_search.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/box.h"
#include "physics/cells/body_state.h"
#include "physics/cells/falling_body.h"
#include "physics/collision/lanes.h"
#include "physics/collision/pair_collision.h"

namespace carom {

/// Parameters common to all pairs of a search. `shift`: the images of the other bodies that are
/// tested. If `several_images` is set, an image farther away than `half` along an axis is replaced
/// by the nearer one, at the distance `size` from it.
template <int Dimension>
struct Pairing {
    using Vector = std::array<double, static_cast<std::size_t>(Dimension)>;
    Vector shift{};
    Vector half{};
    Vector size{};
    bool several_images = true;
    double sigma = 0.0;   ///< sum of radii if all bodies are alike; otherwise 0
    Vector gravity{};     ///< common acceleration of the bodies, if they may fall
    double margin = 0.0;  ///< contacts closer in time may coincide (coincidences.h)

    /// Selects the nearest images, for a box so wide that no others are relevant.
    static Pairing nearest(const Box& box);
    /// Selects the images at one shift.
    static Pairing shifted(const Vector& shift);
};

template <typename Body>
using PairingOf = Pairing<static_cast<int>(Body::axes)>;

/// A predicted contact, in a form that a search can replace by an earlier one without branches.
struct FirstContact {
    double time = never<double>;
    std::uint64_t who = 0;  ///< the partner and, in the upper half, its count of collisions

    FirstContact() = default;
    FirstContact(double at, std::int32_t partner, std::uint32_t collisions)
        : time(at), who(std::uint64_t{collisions} << 32 | static_cast<std::uint32_t>(partner)) {}
    std::int32_t partner() const { return static_cast<std::int32_t>(who); }
    std::uint32_t collisions() const { return static_cast<std::uint32_t>(who >> 32); }
};

/// Number of bodies tested at a time, and maximum number in one search.
inline constexpr std::size_t lanes = 4;
inline constexpr std::size_t most_searched = 64;

/// Replaces `first` by the earliest contact of body i with those listed in `near`, if that comes
/// before it; among equal times the lowest number counts. `count` <= most_searched is a whole
/// number of lanes; i itself may be listed and is never met. Contacts with a body that has an
/// earlier contact are left out, because that body will predict again after it. Returns whether
/// another contact that was found may coincide with the first. If the bodies may fall
/// (FallingBody), all of them do, with the acceleration of `pairing`. For BodyState and
/// FallingBody<double>.
template <typename Body>
bool search_contact(const LargeVector<Body>& bodies, const BodyProperties& properties,
                    std::int32_t i, double now, const std::int32_t* near, std::size_t count,
                    const PairingOf<Body>& pairing, FirstContact& first);

/// The same for two bodies, at the same time, that cannot be each other's next partner: the first
/// `split` entries of `near` belong to the first and the others to the second, each a whole number
/// of lanes. The processor overlaps the two searches, which would otherwise wait for each other.
/// Returns whether contacts of either may coincide.
template <typename Body>
bool search_two_contacts(const LargeVector<Body>& bodies, const BodyProperties& properties,
                         std::array<std::int32_t, 2> both, double now, const std::int32_t* near,
                         std::size_t split, std::size_t count, const PairingOf<Body>& pairing,
                         std::array<FirstContact, 2>& firsts);

}  // namespace carom
