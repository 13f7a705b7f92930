// The free stretches of a line between beads already placed, and how further beads are distributed
// among them. Independent of species and rules of placement (line_placement.h).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "util/random.h"

namespace carom {

/// A part of the line, length; on a ring it may reach beyond the end.
struct Stretch {
    double low, high;
    double room() const { return high - low; }
};

class LineRoom {
  public:
    explicit LineRoom(const Box& box);

    /// Marks the stretches covered by `beads` as taken.
    void take(std::vector<Stretch> beads);

    bool empty() const { return taken_.empty(); }

    /// The free stretches of the whole line, from left to right. On a ring the last goes on to the
    /// first bead; an empty ring is one stretch from 0 to its length.
    std::vector<Stretch> free() const;

    /// The free stretches of a part of the line.
    std::vector<Stretch> free_within(Stretch part) const;

  private:
    double length_;
    bool ring_;
    std::vector<Stretch> taken_;  ///< from left to right
};

/// The index of the stretch for each bead, in the order of the beads; nothing if they do not fit.
using Shares = std::optional<std::vector<std::size_t>>;

/// Distributes beads of `lengths` (in descending order) among stretches: each goes to one with a
/// probability proportional to the room left there. If a bead then does not fit, all beads go where
/// they fit most tightly.
Shares share_at_random(const std::vector<Stretch>& stretches, const std::vector<double>& lengths,
                       Random& random);

/// The same, but each bead goes to the stretch in which the gaps between beads remain widest.
Shares share_evenly(const std::vector<Stretch>& stretches, const std::vector<double>& lengths);

}  // namespace carom
