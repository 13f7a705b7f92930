// The parts of a box in which panels measure: the two sides of a partition, or regions that the
// scene names.
#pragma once

#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "panels/surfaces/place_options.h"

namespace carom {

/// The colour in a plot of one of several surfaces, or of parts of the box; a single one has the
/// colour of bars.
plot::Role surface_role(std::size_t place, std::size_t count);

/// In the order of `regions`, or below and above the place of the first surface.
class BoxParts {
  public:
    BoxParts(const Box& box, const MeasuredAt& parts)
        : box_(box), surfaces_(parts.surfaces), regions_(parts.regions) {}

    std::size_t count() const { return regions_.empty() ? 2 : regions_.size(); }
    std::vector<std::string> names(Language language) const;

    /// Where the parts are; `states`: of the surfaces at present, or none if they never move. The
    /// outer sides of a part beside a partition are at infinity, so that it holds what a side that
    /// moves leaves to it.
    std::vector<Region> regions(std::span<const SurfaceState> states) const;

    /// The present particles in each part now, in ascending order.
    std::vector<std::vector<Eigen::Index>> members(const FrameInput& input) const;

  private:
    int axis() const { return box_.surfaces.axis_of(surfaces_.front()); }

    Box box_;
    SurfaceNumbers surfaces_;
    std::vector<NamedRegion> regions_;
};

}  // namespace carom
