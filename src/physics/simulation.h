// The event-driven simulation of hard particles. A Simulation owns the state of all particles and
// the simulated time. Between events particles are in free flight; every contact time is computed
// exactly, no collision is missed and no particles overlap (except in a run with a fixed time step,
// which exists to show what goes wrong then). The class knows nothing about films, files or
// statistics: it provides samples of the state and the collisions of each advance.
//
// Thread safety: any number of simulations may run at once, each used by one thread at a time.
// Const functions may be called from several threads as long as no thread calls a non-const
// function of the same simulation.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "physics/advance_result.h"
#include "physics/box.h"
#include "physics/collision/velocity_changes.h"
#include "physics/exact_positions.h"
#include "physics/particles.h"
#include "physics/run.h"

namespace carom {

struct Gas;

class Archive;

/// Thrown when an event of the run cannot be carried out: a perturbation that would push a particle
/// into another one or into a wall, or a partition that would close on a particle.
class RunEventError : public std::runtime_error {
  public:
    RunEventError(std::size_t event, const std::string& what, std::string hint)
        : std::runtime_error(what), event_(event), hint_(std::move(hint)) {}
    std::size_t event() const { return event_; }       ///< index in Run::events
    const std::string& hint() const { return hint_; }  ///< suggested change

  private:
    std::size_t event_;
    std::string hint_;
};

class Simulation {
  public:
    /// Places the particles and simulates the equilibration, which takes the simulated time
    /// `run.equilibrate` and ends at t = 0. Calls `on_progress` now and then with the simulated
    /// time, which is below 0. Throws std::invalid_argument if the gas or the run is invalid, or if
    /// `run.bits` is unset (start_run() determines the bits); PlacementError; Interrupted.
    Simulation(const Gas& gas, const Run& run, const TimeCallback& on_progress = {});

    /// Starts from given particles, whose state is `start` at time 0 or, with an equilibration, at
    /// `-run.equilibrate`. Throws std::invalid_argument if the particles or the run are invalid,
    /// for instance if particles overlap.
    Simulation(const Box& box, Particles particles, const Sample& start, const Run& run);

    /// Restores a state written by archive() for a simulation of the same box, particles and run.
    /// Throws what archive() and the other constructors throw.
    Simulation(const Box& box, Particles particles, const Run& run, Archive& state);

    /// A copy is an independent simulation that continues identically, bit for bit.
    Simulation(const Simulation&);
    Simulation& operator=(const Simulation&);
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;
    ~Simulation();

    /// Writes the state to the archive, or reads it from there. A state that is read must have been
    /// written for the same box, particles and run; the simulation then continues as the original
    /// would have, bit for bit. Throws SystemError if the archive is damaged or belongs to another
    /// kind of simulation; this simulation is then left unchanged.
    void archive(Archive& archive);

    /// Processes all events with time <= `time`, those of `run.events` included, and advances to
    /// `time`, which may lie beyond `run.until`. Calls `on_progress` now and then with the
    /// simulated time reached. Throws std::invalid_argument if `time` lies in the past or is not
    /// finite; RunEventError; Interrupted (util/interrupt.h); CollisionError if particles collide
    /// without end at one instant, if there are more collisions than the run allows, or if two
    /// beads of infinite mass meet; SurfaceError if a wall or a piston crushes the gas or reaches
    /// another surface.
    AdvanceResult advance_to(double time, const TimeCallback& on_progress = {});

    /// Replaces the future events of the run, for instance in a copy; the index in a RunEventError
    /// then refers to the new list. Throws std::invalid_argument if an event lies in the past or
    /// before its predecessor in the list.
    void replace_events(std::vector<RunEvent> events);

    /// Makes advance_to() measure how well a reversed run returns. When an advance ends at one of
    /// `times`, AdvanceResult::return_distance compares all positions with those at the mirror
    /// time, which lies as long before the last reversal as the present lies after it. There is no
    /// return distance if the run was not at the mirror time, or if that lies before the present
    /// time of this call. The positions for each of `times` are kept in memory from their mirror
    /// time on. Replaces the times of any earlier call. A time that equals the time of a reversal
    /// counts as the start of the new branch, at distance 0, or, with `ends_branch`, as the end of
    /// the branch before it.
    void measure_return(std::vector<double> times, bool ends_branch = false);

    /// State of all particles at the present time.
    const Sample& sample();

    /// The membership at the present time, as in all samples of this time; it is not null.
    const std::shared_ptr<const Membership>& membership() const;

    /// The same without velocities, or without positions. Takes half the memory, and the result is
    /// not kept.
    Sample sample_of_positions() const;
    Sample sample_of_velocities() const;

    /// Frees the memory of sample(); references returned by sample() become invalid.
    void forget_sample();

    /// Positions of all particles at the present time, in the full precision of the run.
    ExactPositions exact_positions() const;

    /// Sets whether AdvanceResult contains the individual collisions; off by default.
    void record_collisions(bool on);

    /// Sets whether AdvanceResult lists the velocities that have changed; off by default. They are
    /// known only in boxes with plain walls, in advances without events of the run other than
    /// perturbations, and only while they are few: at most half of all particles.
    void follow_velocities(bool on);

    /// Significand bits of the numbers that the simulation calculates with.
    int bits() const;

    /// The totals of each surface since t = 0, and the position and velocity of those that move.
    /// Order: the four sides, the partitions, the obstacles of the box. Empty if there are only
    /// reflecting walls.
    std::vector<SurfaceState> surfaces() const;

    /// The energy balance at the present time. Particles of infinite mass are not counted.
    EnergyAccount energy_account() const;

    const Box& box() const;
    const Particles& particles() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Produces a sample of the velocities after each advance of a simulation. When only a few
/// velocities have changed, only those are updated.
class VelocitySamples {
  public:
    /// The sample after an advance to `time`, without positions; valid until the next call.
    const Sample& after(Simulation& simulation, double time, const AdvanceResult& advanced);

    /// To be called instead of after() when no sample is needed after an advance.
    void skip() { is_known_ = false; }

  private:
    Sample sample_;
    bool is_known_ = false;  ///< whether sample_ is that of the advance before
    VelocityFollowing following_{true};
};

}  // namespace carom
