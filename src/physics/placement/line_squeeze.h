// Where beads of infinite mass leave no room on a wire: they can neither pass nor yield, so that
// two of them that meet, or beads that one presses against another or against the end of the wire,
// have no motion that goes on. They move by themselves alone, so that this is known beforehand.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/run.h"

namespace carom {

/// Two beads of infinite mass between which the room ends; -1 and -2 are the left and the right end
/// of the wire.
struct Squeeze {
    double time;  ///< simulated
    Eigen::Index left, right;
};

/// The first squeeze of a run from `start` on, if there is one up to its end.
std::optional<Squeeze> first_squeeze(const Box& box, const Particles& particles,
                                     const Sample& start, const Run& run);

/// One sentence about it, without the way out.
std::string to_text(const Squeeze& squeeze);

}  // namespace carom
