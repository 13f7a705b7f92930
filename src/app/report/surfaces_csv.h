// The surfaces of a run at the times of its samples, as a CSV table written while the run goes on.
#pragma once

#include <string>
#include <vector>

#include "app/output.h"
#include "physics/box.h"
#include "physics/surface.h"
#include "physics/units/quantity.h"

namespace carom {

/// A header, then a row for each sample and surface:
/// time,surface,position,velocity,hits,impulse_x,impulse_y,work,heat, in space with impulse_z.
/// Numbers are formatted by csv_number(); position and velocity are empty for surfaces that have
/// not moved. A line has no bottom and no top.
class SurfacesCsv {
  public:
    /// Writes the header to `output`, which must outlive the object.
    SurfacesCsv(const Box& box, Output& output, UnitSystem units = UnitSystem::reduced);

    /// Adds the rows of a sample. Throws SystemError.
    void add(double time, const std::vector<SurfaceState>& surfaces);

  private:
    int components_;                  ///< of an impulse
    std::vector<std::string> names_;  ///< as CSV fields; empty for surfaces that do not exist
    Output& output_;
};

}  // namespace carom
