// How many bits a run needs to return after its reversals, found by trials; and how far its
// perturbations move it. Knows no film and no scene. Any function may be called from any thread.
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
#include "physics/simulation.h"

namespace carom {

/// No number of bits that is allowed lets the gas return.
class PrecisionError : public std::runtime_error {
  public:
    PrecisionError(const std::string& what, std::string hint)
        : std::runtime_error(what), hint_(std::move(hint)) {}
    const std::string& hint() const { return hint_; }  ///< what to change

  private:
    std::string hint_;
};

/// Called now and then with the progress of a trial: the bits that are tried, those of a double
/// where collisions are only counted, and the simulated time, below 0 while it equilibrates.
using TrialCallback = std::function<void(int bits, double time)>;

/// The simulation of a run at time 0, in `run.bits` or, where these are unset, in as many as it
/// takes. With those the gas returns after every reversal, as far as the run goes on: to within
/// `run.tolerance`, and each particle meets its former partners in reverse order; and perturbations
/// are resolved. Where there are neither they are those of a double. Tried out without the
/// perturbations, which takes several runs; the same bits on any machine. Throws PrecisionError,
/// and what Simulation throws.
Simulation start_run(const Gas& gas, const Run& run, const TrialCallback& on_progress = {});

/// The bits of start_run().
int bits_for_return(const Gas& gas, const Run& run, const TrialCallback& on_progress = {});

/// Bits that resolve a perturbation of positions up to `size`.
int bits_for(const Perturbation& perturbation, double size);

/// How far these perturbations, all at one time, move a gas of so many particles.
ReturnDistance moved_by(const std::vector<Perturbation>& perturbations, Eigen::Index particles);

}  // namespace carom
