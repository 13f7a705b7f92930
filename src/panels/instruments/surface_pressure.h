// Pressures on single surfaces, measured.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "panels/instruments/trailing.h"
#include "panels/panel.h"

namespace carom {

/// Measures the pressure on sides and partitions: the momentum along its normal that particles give
/// each, over the time and its length (on a line, over the time). Outward on sides; on a partition
/// what its two sides leave, toward larger x or y.
class SurfacePressures {
  public:
    SurfacePressures(const Box& box, std::vector<std::int32_t> surfaces, Over over);

    /// Of each surface, in order of time; NaN as long as no time has passed. A time before the last
    /// one begins anew.
    std::vector<double> operator()(double time, const AdvanceResult& advanced);

    /// Of all surfaces together, at the last time.
    double of_all() const;

  private:
    /// What has been received by a time, and the length that received it, integrated over time.
    struct Received {
        double time = 0.0;
        std::vector<double> push = {}, reach = {};
    };
    Box box_;
    std::vector<std::int32_t> surfaces_;
    Trailing<Received> received_;
    std::vector<double> last_length_;
};

/// For a table; on a line a pressure is a force.
std::string unit_of_pressure(const Box& box);

/// Of the surfaces that the panel names, against time.
std::unique_ptr<Panel> make_surface_pressure(const PanelContext& context, const PanelSpec& spec);

}  // namespace carom
