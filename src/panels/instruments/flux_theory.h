// The rate at which particles cross a line by kinetic theory, and the energy that they carry: n a
// sqrt(T / (2 pi m)) over a width a, with an energy of 1.5 T for each particle in the plane and T
// on a line.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "panels/means/trailing.h"
#include "panels/panel.h"
#include "stats/paths/line_crossings.h"

namespace carom {

/// The number of particles, and the energy, per unit time.
struct FluxRates {
    double particles = 0.0, energy = 0.0;
};

/// Predicts the rates at a line in a frame: toward larger x or y, and toward smaller.
class FluxTheory {
  public:
    virtual ~FluxTheory() = default;
    virtual std::array<FluxRates, 2> at(const FrameInput& input) = 0;
};

/// Returns the theory for some particles at a line; nullptr if there is none (LawOf::flux). At a
/// partition it is that of its gaps (LawOf::gap_flux), from the present number and temperature of
/// the gas on each side, while its mean free path is at most the width of the side and at least
/// twice the width that the widest gap leaves to a particle; otherwise rates are NaN.
std::unique_ptr<FluxTheory> flux_theory(const PanelContext& context, const CrossedLine& line,
                                        std::optional<std::int32_t> partition,
                                        const std::vector<Eigen::Index>& members);

}  // namespace carom
