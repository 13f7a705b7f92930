// From the rules of a gas to particles: positions without overlap, radii, masses, velocities, all
// from the gas's seed. place() may be called from any thread.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

/// A species cannot be placed; the message names the numbers (how many of how many, packing
/// fraction) and a way out.
class PlacementError : public std::runtime_error {
  public:
    PlacementError(std::size_t species, const std::string& message)
        : std::runtime_error(message), species_(species) {}
    std::size_t species() const { return species_; }  ///< index into Gas::species

  private:
    std::size_t species_;
};

/// The particles of `gas` and their state at time 0. Throws PlacementError.
std::pair<Particles, Sample> place(const Gas& gas);

}  // namespace carom
