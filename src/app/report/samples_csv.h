// The samples of a run as a CSV table, written while the run goes on.
#pragma once

#include <string>
#include <vector>

#include "app/output.h"
#include "app/report/row_buffer.h"
#include "physics/membership.h"
#include "physics/units/quantity.h"

namespace carom {

struct Gas;

/// A header, then a row for each sample and particle that is present:
/// time,particle,species,mass,radius,x,y,vx,vy (in 1-D x,vx). Numbers are formatted by
/// csv_number(); an infinite mass is `inf`.
class SamplesCsv {
  public:
    /// Writes the header to `output`, which must outlive the object.
    SamplesCsv(const Gas& gas, Output& output, UnitSystem units = UnitSystem::reduced);

    /// Adds the rows of a sample; all samples are of the same particles. Throws SystemError.
    void add(const Particles& particles, const Sample& sample);

    /// Passes the last rows to the output.
    void finish() { rows_.finish(); }

  private:
    void name_rows(const Particles& particles, const Sample& sample);

    std::vector<std::string> species_;  ///< names as fields
    std::vector<std::string> labels_;   ///< of each particle, what stays the same: ",0,cold,1,0.5"
    MembershipWatch membership_;
    RowBuffer rows_;
};

}  // namespace carom
