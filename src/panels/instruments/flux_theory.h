// How many particles cross a line in a time by kinetic theory, and the energy that they carry: n a
// sqrt(T / (2 pi m)) over a width a, and 1.5 T each in the plane, T on a line.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "panels/instruments/trailing.h"
#include "panels/panel.h"
#include "stats/paths/line_crossings.h"

namespace carom {

/// Rates: of particles, and of energy.
struct FluxRates {
    double particles = 0.0, energy = 0.0;
};

/// What theory says of a line in a frame, toward larger x or y and toward smaller.
class FluxTheory {
  public:
    virtual ~FluxTheory() = default;
    virtual std::array<FluxRates, 2> at(const FrameInput& input) = 0;
};

/// Of some particles at a line, where a partition may stand; none where theory knows no such thing,
/// and beside particles of infinite mass. It does
/// - in a gas in equilibrium, at a line right across a periodic axis, exactly, or between solid
///   walls for points on a line and dilute disks: with the mean of |v| that so many particles have;
/// - at a partition with gaps that are small beside it, from a dilute gas whose mean free path is
///   less than its side and more than twice a gap: by the number and the temperature that it has.
/// NaN where it does not hold at the moment.
std::unique_ptr<FluxTheory> flux_theory(const PanelContext& context, const CrossedLine& line,
                                        std::optional<std::int32_t> partition,
                                        const std::vector<Eigen::Index>& members);

}  // namespace carom
