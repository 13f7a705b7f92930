// The surfaces of a run at its samples as a table of comma-separated values, written as they come.
#pragma once

#include <string>
#include <vector>

#include "app/output.h"
#include "physics/gas.h"
#include "physics/surface.h"

namespace carom {

/// A header, then a row for each sample and surface:
/// time,surface,position,velocity,hits,impulse_x,impulse_y,work,heat, numbers as csv_number() has
/// them; position and velocity are empty of what has not moved. A line has no bottom and no top.
class SurfacesCsv {
  public:
    /// Writes the header to `output`, which must outlive the table.
    SurfacesCsv(const Box& box, Output& output);

    /// Adds the rows of a sample. Throws SystemError.
    void add(double time, const std::vector<SurfaceState>& surfaces);

  private:
    std::vector<std::string> names_;  ///< as fields, empty of what is not there
    Output& output_;
};

}  // namespace carom
