// Whether a gas comes home after its reversals: an echo of the run, compared with itself in full;
// and how many bits that takes. Knows no film and no scene.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "physics/exact_positions.h"
#include "physics/gas.h"
#include "physics/run.h"

namespace carom {

/// No number of bits that is allowed brings the gas home.
class PrecisionError : public std::runtime_error {
  public:
    PrecisionError(const std::string& what, std::string hint)
        : std::runtime_error(what), hint_(std::move(hint)) {}
    const std::string& hint() const { return hint_; }  ///< what to change

  private:
    std::string hint_;
};

/// Told now and then how far a trial has come: the bits that are tried, those of a double where
/// collisions are only counted, and the simulated time, below 0 while it equilibrates.
using TrialCallback = std::function<void(int bits, double time)>;

/// Bits with which the gas comes home after every reversal of `run`, as far as the run goes on:
/// within `run.tolerance`, and each particle meets on the way back whom it met on the way out, in
/// reverse order. Tried out, without the perturbations; and enough for these too. Those of a double
/// where there is neither. Runs the gas several times; the same on any machine. Throws
/// PrecisionError, and what Simulation throws.
int bits_for_return(const Gas& gas, const Run& run, const TrialCallback& on_progress = {});

/// Bits by which positions up to `size` can be moved by a perturbation, and seen to have been.
int bits_for(const Perturbation& perturbation, double size);

/// How far a gas of so many particles is from itself, once these perturbations have moved it.
ReturnDistance moved_by(const std::vector<Perturbation>& perturbations, Eigen::Index particles);

}  // namespace carom
