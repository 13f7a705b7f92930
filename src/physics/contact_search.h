// Which of some disks a disk touches first, and when. Four are tested at a time for whether they
// may be touched at all; the exact times (pair_collision.h) of the few that may are solved two at a
// time. There are no branches but on how many may be touched: the processor foretells none of the
// others, and a wrong guess costs more than the arithmetic it saves. Knows no cells: who comes into
// question is its caller's matter (plane.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/event_queue.h"
#include "physics/flying_disk.h"
#include "physics/gas.h"
#include "physics/lanes.h"

namespace carom {

/// Which images of the other disks are meant: those shifted by `shift`, and, if one is then farther
/// than `half` along an axis, the one nearer by `size`.
struct Images {
    std::array<double, 2> shift{};
    std::array<double, 2> half{};
    std::array<double, 2> size{};

    /// The nearest, in a box wide enough that it alone comes into question.
    static Images nearest(const Box& box);
    /// Those at one shift.
    static Images shifted(double x, double y);
};

/// So many are tested at a time, and so many in one search.
inline constexpr std::size_t lanes = 4;
inline constexpr std::size_t most_searched = 64;

/// The contact of disk i with the first to be touched of `near`, `count` <= most_searched numbers
/// (a whole number of lanes; i itself may be among them and is never met), becomes that of `first`
/// if it comes before the one there; of equal times the lowest number counts. A contact with a disk
/// that has one before is left out: that disk will look again before.
void search_contact(const FlyingDisks& disks, std::int32_t i, double now, const std::int32_t* near,
                    std::size_t count, const Images& images, const EventQueue& queue, Event& first);

/// The same for two disks that do not come into question for each other, at one time: of the
/// numbers of `near` the first `split` are those of the first disk, the others those of the second,
/// whole numbers of lanes. The processor works on both at once, where two searches would wait for
/// one another.
void search_two_contacts(const FlyingDisks& disks, std::array<std::int32_t, 2> both, double now,
                         const std::int32_t* near, std::size_t split, std::size_t count,
                         const Images& images, const EventQueue& queue,
                         std::array<Event, 2>& firsts);

}  // namespace carom
