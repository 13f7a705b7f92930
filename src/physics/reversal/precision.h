// Determines by trial runs how many bits a run needs to return after its reversals, and calculates
// how far its perturbations displace it. Independent of films and scenes. All functions may be
// called from any thread.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "physics/exact_positions.h"
#include "physics/run.h"
#include "physics/simulation.h"

namespace carom {

struct Gas;

/// Thrown if no permitted number of bits makes the gas return.
class PrecisionError : public std::runtime_error {
  public:
    PrecisionError(const std::string& what, std::string hint)
        : std::runtime_error(what), hint_(std::move(hint)) {}
    const std::string& hint() const { return hint_; }  ///< suggested change

  private:
    std::string hint_;
};

/// Called now and then with the progress of a trial: the number of bits being tried (that of a
/// double while collisions are only counted) and the simulated time, which is below 0 during
/// equilibration.
using TrialCallback = std::function<void(int bits, double time)>;

/// Returns the simulation of a run at time 0, with `run.bits` or, if these are unset, with as many
/// bits as needed. That is, with them the gas returns after every reversal, as far as the run
/// continues, to within `run.tolerance`; each particle meets its former partners in reverse order;
/// and perturbations are resolved. Without reversals and perturbations the bits are those of a
/// double. The bits are found by several trial runs without the perturbations, and are the same on
/// any machine. Throws PrecisionError, and what Simulation throws.
Simulation start_run(const Gas& gas, const Run& run, const TrialCallback& on_progress = {});

/// The number of bits that start_run() uses.
int bits_for_return(const Gas& gas, const Run& run, const TrialCallback& on_progress = {});

/// The number of bits that resolves a perturbation of positions up to `size`.
int bits_for(const Perturbation& perturbation, double size);

/// The distance by which these perturbations, all at the same time, displace a gas with this number
/// of particles.
ReturnDistance moved_by(const std::vector<Perturbation>& perturbations, Eigen::Index particles);

}  // namespace carom
