// The event-driven simulation of hard particles: owns the state and the time. Between events
// particles are in free flight; every contact is computed exactly, none is missed, nothing
// overlaps (but in a run with a time step, which is there to show that). Does not know films, files
// or statistics: it gives samples and the collisions on the way.
//
// Threads: any number of simulations may run at once, each on one thread at a time. A function that
// is const may be called from several threads while none calls another function of that simulation.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "physics/advance_result.h"
#include "physics/collision/velocity_changes.h"
#include "physics/exact_positions.h"
#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/run.h"

namespace carom {

class Archive;

/// An event of the run that cannot happen: a perturbation that would push a particle into another
/// or into a wall, a partition that would close on a particle.
class RunEventError : public std::runtime_error {
  public:
    RunEventError(std::size_t event, const std::string& what, std::string hint)
        : std::runtime_error(what), event_(event), hint_(std::move(hint)) {}
    std::size_t event() const { return event_; }       ///< index in Run::events
    const std::string& hint() const { return hint_; }  ///< what to change

  private:
    std::size_t event_;
    std::string hint_;
};

class Simulation {
  public:
    /// Places the particles and runs `run.equilibrate` in times before 0, with which `on_progress`
    /// is called now and then. Throws std::invalid_argument for what no gas or run can be, also if
    /// `run.bits` is unset (start_run() finds them); PlacementError; Interrupted.
    Simulation(const Gas& gas, const Run& run, const TimeCallback& on_progress = {});

    /// Starts from given particles, with the state `start` at time 0 or `run.equilibrate` before
    /// it. Throws std::invalid_argument for what no run can be, also if particles overlap.
    Simulation(const Box& box, Particles particles, const Sample& start, const Run& run);

    /// The state that archive() wrote, of a simulation of this box and these particles in this run.
    /// Throws as archive() and the other constructors do.
    Simulation(const Box& box, Particles particles, const Run& run, Archive& state);

    /// A copy is an independent simulation that goes on alike, bit for bit.
    Simulation(const Simulation&);
    Simulation& operator=(const Simulation&);
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;
    ~Simulation();

    /// Writes the state, or replaces it by one that was written for the same box, particles and
    /// run: the simulation then goes on as that one would have, bit for bit. Throws SystemError if
    /// the archive is damaged or of another kind of simulation, which leaves this one as it was.
    void archive(Archive& archive);

    /// Processes all events with time <= `time` (inclusive; `run.events` too) and advances to it;
    /// not limited by `run.until`. Tells `on_progress` now and then how far it is. Throws
    /// std::invalid_argument if `time` lies in the past or is not finite; RunEventError;
    /// Interrupted (util/interrupt.h); CollisionError when particles collide without end at one
    /// instant, more often than the run may, or two beads of infinite mass meet; SurfaceError when
    /// a wall or a piston crushes the gas or reaches another surface.
    AdvanceResult advance_to(double time, const TimeCallback& on_progress = {});

    /// Replaces the events of the run that are still to come, for instance in a copy; an error's
    /// index counts in the new list. Throws std::invalid_argument if one lies in the past or before
    /// the one listed before it.
    void replace_events(std::vector<RunEvent> events);

    /// From now on advance_to() measures how far a reversed run is from where it was: when it ends
    /// at one of `times`, AdvanceResult::return_distance compares all positions with those at the
    /// mirror time, as long before the last reversal as the present is after it. Without it where
    /// the run was not at that time, or was before the present. Keeps the positions of each of
    /// these times from its mirror time on. Replaces what was asked for before.
    /// A time that is a reversal's own is its start, at distance 0, or with `ends_branch` the end
    /// of the branch before it.
    void measure_return(std::vector<double> times, bool ends_branch = false);

    /// State of all particles at the present time.
    const Sample& sample();

    /// The same without velocities, or without positions: in half the memory, and not kept.
    Sample sample_of_positions() const;
    Sample sample_of_velocities() const;

    /// Gives back the memory of sample(), whose result it ends.
    void forget_sample();

    /// Positions of all particles at the present time, with all bits of the run's numbers.
    ExactPositions exact_positions() const;

    /// Whether advance_to() gives the collisions themselves; off at first.
    void record_collisions(bool on);

    /// Whether advance_to() gives the velocities that have changed; off at first. It knows them in
    /// boxes with plain walls, between the run's events, as long as they are few: at most half
    /// of them.
    void follow_velocities(bool on);

    /// Bits of the significands of its numbers.
    int bits() const;

    /// What each surface has done since t = 0, and where those are that move: the four sides, the
    /// partitions, the obstacles of the box, in this order. None where there are only walls that
    /// reflect.
    std::vector<SurfaceState> surfaces() const;

    /// Where the energy is at the present time. Infinite masses are not counted.
    EnergyAccount energy_account() const;

    const Box& box() const;
    const Particles& particles() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Samples of velocities alone, one after each advance of a simulation; where few velocities have
/// changed, only these are looked at.
class VelocitySamples {
  public:
    /// The sample after an advance to `time`, without positions; valid until the next call.
    const Sample& after(Simulation& simulation, double time, const AdvanceResult& advanced);

    /// To be called for an advance after which no sample is wanted.
    void skip() { is_known_ = false; }

  private:
    Sample sample_;
    bool is_known_ = false;  ///< whether sample_ is that of the advance before
    VelocityFollowing following_{true};
};

}  // namespace carom
