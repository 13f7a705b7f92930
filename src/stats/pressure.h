// The pressure of a gas, measured in two ways that must agree: by the momentum its walls receive,
// and by the virial of its collisions. In one dimension pressure is a force.
#pragma once

#include <optional>
#include <span>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/simulation.h"

namespace carom {

/// Whether a gas has one pressure, which its walls feel: not where gravity acts, a partition parts
/// it, or a side moves or has moved. `states` as Simulation::surfaces() gives them.
bool has_one_pressure(const Box& box, std::span<const SurfaceState> states);

/// Since when it has one, and what had been received by then.
struct PressureStart {
    double time = 0.0;
    ImpulseTotals impulses;

    ImpulseTotals since(const ImpulseTotals& totals) const;
};

/// Follows a run, to know since when its gas has had one pressure.
class PressureWatch {
  public:
    explicit PressureWatch(const Box& box) : box_(box) {}

    /// In order of time, from the start.
    void see(double time, const ImpulseTotals& impulses, std::span<const SurfaceState> states);

    /// The start, or the first time seen after the last partition has opened; none while the gas
    /// has no one pressure.
    const std::optional<PressureStart>& start() const { return start_; }

  private:
    Box box_;
    std::optional<PressureStart> start_ = PressureStart{};
};

/// Momentum that the solid walls received in `time`, divided by the time and by their length (in
/// 1-D by their number). Nothing where no wall is solid, and after a hit by an infinite mass.
std::optional<double> wall_pressure(const Box& box, const ImpulseTotals& impulses, double time);

/// Pressure by the virial theorem: d P V = 2 K + (1 / t) sum r . dp in d dimensions, the sum as in
/// ImpulseTotals::virial, K the kinetic energy `thermal_energy` (ThermalMotion::energy).
/// V is the box's size where it is periodic. Between walls centres reach only over
/// L' = L - 2 R, and the theorem reads F_x L'_x + F_y L'_y = 2K + sum r . dp / t (exact for equal
/// disks, but for the change of sum p . r; see tests/physics/virial.cpp): V is
/// (L_x L'_y + L_y L'_x) / 2, in 1-D L', so that it agrees with wall_pressure(). R is the mean
/// radius of those with a finite mass.
/// Nothing without such, or where centres have no room. Has no meaning where a moving infinite mass
/// does work on the gas.
std::optional<double> virial_pressure(const Box& box, const Particles& particles,
                                      double thermal_energy, const ImpulseTotals& impulses,
                                      double time);

/// Pressure of a gas of points with this energy in the same box: d P V = 2 K, as above.
double pressure_of_points(const Box& box, double thermal_energy);

}  // namespace carom
