// Pressures on single surfaces, measured.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "panels/means/trailing.h"
#include "panels/plots/series_panel.h"
#include "scene/instruments/places.h"

namespace carom {

struct PressureOptions {
    SurfaceNumbers surfaces = {};  ///< none: all walls together
    bool gauge = false;            ///< on dials instead of a plot
};

/// "hard disks": what an equation of state is of.
Phrase name_of_hard(int dimension);

/// Measures the pressure on sides and partitions: the normal momentum that particles give to a
/// surface, divided by time and length (in space by time and area, on a line by time). It counts
/// outward on sides; on a partition it is the difference of its two faces, toward larger
/// coordinates.
class SurfacePressures {
  public:
    SurfacePressures(const Box& box, std::vector<std::int32_t> surfaces, Over over);

    /// Returns the pressure on each surface; NaN while no time has passed. To be called in order of
    /// time; a time before the last one restarts the measurement.
    std::vector<double> operator()(const FrameInput& input);

    /// The pressure on all surfaces together, at the last time.
    double of_all() const;

  private:
    /// The momentum received up to a time, and the time integral of the size that received it.
    struct Received {
        double time = 0.0;
        std::vector<double> push = {}, reach = {};
    };
    Box box_;
    std::vector<std::int32_t> surfaces_;
    Trailing<Received> received_;
    std::vector<double> last_size_;
};

/// The pressures on the surfaces in `spec`, against time.
SeriesSubject surface_pressure(const PanelContext& context, const PanelSpec& spec);

}  // namespace carom
