// The collisions of a run as a CSV table, written while the run goes on.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/output.h"
#include "app/report/row_buffer.h"
#include "physics/advance_result.h"
#include "physics/box.h"
#include "physics/particles.h"
#include "physics/units/quantity.h"

namespace carom {

/// A header, then a row for each collision, in order: its time; the particle, and the particle or
/// the surface that it met (the other of these two fields is empty); the positions of both (for a
/// surface the point of contact, in a periodic box the partner's nearest image); the velocities of
/// both before and after; the momentum that the partner received. Vectors have as many fields as
/// the box has axes. Numbers are formatted by csv_number(); the impulse is empty if both masses are
/// infinite.
class CollisionsCsv {
  public:
    /// Writes the header to `output`, which must outlive the object.
    CollisionsCsv(const Box& box, Output& output, UnitSystem units = UnitSystem::reduced);

    /// Adds collisions; all are of the same particles. Throws SystemError.
    void add(const Particles& particles, std::span<const Collision> collisions);

    /// Passes the last rows to the output.
    void finish() { rows_.finish(); }

  private:
    void add(const Vec& value);

    int dimension_;
    std::vector<std::string> surfaces_;  ///< names as fields
    RowBuffer rows_;
};

}  // namespace carom
