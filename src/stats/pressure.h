// The pressure of a gas, measured in two ways that must agree: by the momentum that its walls
// receive, and by the virial of its collisions. In one dimension the pressure is a force.
#pragma once

#include <optional>
#include <span>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/simulation.h"

namespace carom {

/// Whether the gas has a single pressure that all its walls feel: false if gravity acts, a closed
/// partition divides the gas, or a side moves or has moved. `states` as given by
/// Simulation::surfaces().
bool has_one_pressure(const Box& box, std::span<const SurfaceState> states);

/// The time since when a gas has a single pressure, and the impulses received until then.
struct PressureStart {
    double time = 0.0;
    ImpulseTotals impulses;

    ImpulseTotals since(const ImpulseTotals& totals) const;
};

/// Follows a run to determine since when its gas has had a single pressure.
class PressureWatch {
  public:
    explicit PressureWatch(const Box& box) : box_(box) {}

    /// To be called in order of time, from the start of the run.
    void see(double time, const ImpulseTotals& impulses, std::span<const SurfaceState> states);

    /// The start of the run, or the first time seen after the last partition has opened; none while
    /// the gas has no single pressure.
    const std::optional<PressureStart>& start() const { return start_; }

  private:
    Box box_;
    std::optional<PressureStart> start_ = PressureStart{};
};

/// The momentum that the solid walls received during `time`, divided by the time and by their
/// area (in a plane their length, on a line their number). Nothing if no wall is solid, or after a
/// wall was hit by an infinite mass.
std::optional<double> wall_pressure(const Box& box, const ImpulseTotals& impulses, double time);

/// The pressure by the virial theorem, d P V = 2 K + (1 / t) sum r . dp in d dimensions, with the
/// sum as in ImpulseTotals::virial and the kinetic energy K = `thermal_energy`
/// (ThermalMotion::energy). V is the size of the box if it is periodic. Between walls the centres
/// reach only over L' = L - 2 R, and the theorem reads sum F_i L'_i = 2K + sum r . dp / t over the
/// axes i (exact for equal particles, except for the change of sum p . r; see
/// tests/physics/virial.cpp). There V is the mean over the axes of L'_i times the size of the sides
/// across it, (L_x L'_y + L_y L'_x) / 2 in a plane, so that the result agrees with wall_pressure().
/// R is the mean radius of the particles of finite mass. Returns nothing if there are no such
/// particles, or if their centres have no room. Meaningless where a moving infinite mass does work
/// on the gas.
std::optional<double> virial_pressure(const Box& box, const Particles& particles,
                                      double thermal_energy, const ImpulseTotals& impulses,
                                      double time);

}  // namespace carom
