// The samples of a run as a trajectory in the extended XYZ format, which OVITO and ASE open.
#pragma once

#include <string>
#include <vector>

#include "app/output.h"
#include "app/report/row_buffer.h"
#include "physics/particles.h"
#include "physics/units/quantity.h"

namespace carom {

struct Gas;

/// Two lines for each sample, then one for each particle. The first is the number of particles, the
/// second describes what follows: Lattice (the box; missing dimensions have length 1), Properties,
/// Time, pbc, and the names of the species. The species of a particle is written as the symbol of a
/// chemical element, because ASE accepts no other names: H for the first, He for the second, and so
/// on; X after the last element. Positions and velocities have three components. Numbers are
/// formatted by csv_number(); an infinite mass is `inf`.
class SamplesXyz {
  public:
    /// `output` must outlive it.
    SamplesXyz(const Gas& gas, Output& output, UnitSystem units = UnitSystem::reduced);

    /// Adds a sample; all are of the same particles. Throws SystemError.
    void add(const Particles& particles, const Sample& sample);

    /// Passes the last lines to the output.
    void finish() { rows_.finish(); }

  private:
    void name_lines(const Particles& particles);

    std::string before_time_, after_time_;  ///< of the second line
    std::vector<std::string> ends_;    ///< of each particle, what stays the same: radius, mass, …
    std::vector<std::string> begins_;  ///< its species
    RowBuffer rows_;
};

}  // namespace carom
