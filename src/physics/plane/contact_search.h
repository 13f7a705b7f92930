// Which of some disks a disk touches first, and when. Four are tested at a time for whether they
// may be touched at all, and before a contact that either has already; the exact times
// (pair_collision.h) of the few that may are solved two at a time. The only branches depend on how
// many may be touched: the processor can predict none of the others, and a wrong prediction costs
// more than the arithmetic it saves. Knows no cells: the caller chooses the disks to test
// (plane.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/collision/lanes.h"
#include "physics/collision/pair_collision.h"
#include "physics/gas.h"
#include "physics/plane/disk_state.h"
#include "physics/plane/falling_disk.h"

namespace carom {

/// What all pairs of a search have in common. First, which images of the other disks are tested:
/// those shifted by `shift`, and, if there are several and one is then farther than `half` along an
/// axis, the one nearer by `size`.
struct Pairing {
    std::array<double, 2> shift{};
    std::array<double, 2> half{};
    std::array<double, 2> size{};
    bool several_images = true;
    double sigma = 0.0;               ///< the sum of radii, if the disks are all alike; else 0
    std::array<double, 2> gravity{};  ///< the acceleration of all disks, of those that may fall

    /// The nearest images, in a box wide enough that they alone come into question.
    static Pairing nearest(const Box& box);
    /// The images at one shift.
    static Pairing shifted(double x, double y);
};

/// A predicted contact, in the form in which a search replaces it by an earlier one.
struct FirstContact {
    double time = never<double>;
    std::uint64_t who = 0;  ///< the partner and, in the upper half, its count of collisions

    FirstContact() = default;
    FirstContact(double at, std::int32_t partner, std::uint32_t collisions)
        : time(at), who(std::uint64_t{collisions} << 32 | static_cast<std::uint32_t>(partner)) {}
    std::int32_t partner() const { return static_cast<std::int32_t>(who); }
    std::uint32_t collisions() const { return static_cast<std::uint32_t>(who >> 32); }
};

/// So many are tested at a time, and so many in one search.
inline constexpr std::size_t lanes = 4;
inline constexpr std::size_t most_searched = 64;

/// The contact of disk i with the first to be touched of `near`, `count` <= most_searched numbers
/// (a whole number of lanes; i itself may be among them and is never met), becomes `first` if it
/// comes before that; of equal times the lowest number counts. A contact with a disk
/// that has one before is left out: that disk will look again before. Disks that may fall all do,
/// with the acceleration of `pairing`.
void search_contact(const DiskStates& disks, const DiskProperties& properties, std::int32_t i,
                    double now, const std::int32_t* near, std::size_t count, const Pairing& pairing,
                    FirstContact& first);
void search_contact(const FallingDisks& disks, const DiskProperties& properties, std::int32_t i,
                    double now, const std::int32_t* near, std::size_t count, const Pairing& pairing,
                    FirstContact& first);

/// The same for two disks that do not come into question for each other, at one time: of the
/// numbers of `near` the first `split` are those of the first disk, the others those of the second,
/// whole numbers of lanes. The processor works on both at once, where two searches would wait for
/// one another.
void search_two_contacts(const DiskStates& disks, const DiskProperties& properties,
                         std::array<std::int32_t, 2> both, double now, const std::int32_t* near,
                         std::size_t split, std::size_t count, const Pairing& pairing,
                         std::array<FirstContact, 2>& firsts);
void search_two_contacts(const FallingDisks& disks, const DiskProperties& properties,
                         std::array<std::int32_t, 2> both, double now, const std::int32_t* near,
                         std::size_t split, std::size_t count, const Pairing& pairing,
                         std::array<FirstContact, 2>& firsts);

}  // namespace carom
