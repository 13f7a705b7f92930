// Writes a checkpoint of a simulation, restores it, and compares how both simulations continue.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "physics/simulation.h"
#include "util/archive.h"

namespace carom::test {

struct CheckpointCase {
    Gas gas;
    Run run;
    std::vector<double> returns = {};  ///< times passed to measure_return()
};

inline std::string written(Simulation& simulation) {
    Archive archive;
    simulation.archive(archive);
    return archive.finished();
}

inline Simulation restored(const Simulation& of, const Run& run, const std::string& bytes) {
    Archive archive(bytes, "checkpoint");
    Simulation simulation(of.box(), of.particles(), run, archive);
    archive.expect_end();
    return simulation;
}

/// Records, bit for bit, everything that a simulation reports while it advances.
class Trace {
  public:
    void go_on(Simulation& simulation, const std::vector<double>& stops) {
        try {
            for (const double time : stops) {
                add(simulation.advance_to(time));
                add(simulation.sample());
                const EnergyAccount energy = simulation.energy_account();
                numbers({energy.kinetic, energy.potential, energy.pistons, energy.work, energy.heat,
                         energy.relative_error.value_or(-1.0)});
            }
        } catch (const std::exception& error) {
            thrown = error.what();
        }
    }

    std::vector<std::uint64_t> bits;
    std::size_t collisions = 0, returns = 0;
    std::string thrown;

  private:
    void numbers(std::initializer_list<double> all) {
        for (const double number : all) bits.push_back(std::bit_cast<std::uint64_t>(number));
    }
    void add(const Eigen::ArrayXXd& array) {
        for (Eigen::Index k = 0; k < array.size(); ++k) numbers({array.data()[k]});
    }
    void count(std::int64_t number) { bits.push_back(static_cast<std::uint64_t>(number)); }

    void add(const Sample& sample) {
        numbers({sample.time});
        add(sample.position);
        add(sample.velocity);
    }
    void add(const Collision& its) {
        count(its.first);
        count(its.second.is_particle() ? its.second.particle() : -1 - its.second.surface());
        numbers({its.time});
        for (const Vec& vector : {its.first_position, its.second_position, its.first_before,
                                  its.second_before, its.first_after, its.second_after})
            numbers({vector[0], vector[1]});
    }
    void add(const AdvanceResult& its) {
        for (const Collision& collision : its.collisions) add(collision);
        collisions += its.collisions.size();
        for (const std::int64_t number : {its.counts.particle, its.counts.wall,
                                          its.counts.ties.contacts, std::int64_t{its.reversals}})
            count(number);
        numbers({its.impulses.virial, its.impulses.largest_overlap});
        for (const double wall : its.impulses.wall) numbers({wall});
        if (its.return_distance) {
            ++returns;
            numbers({its.return_distance->log10_largest, its.return_distance->root_mean_square});
        }
        for (const SurfaceState& surface : its.surfaces) {
            for (const std::int64_t number :
                 {surface.hits, std::int64_t{surface.is_open}, std::int64_t{surface.is_held},
                  static_cast<std::int64_t>(surface.behaviour.index())})
                count(number);
            numbers({surface.impulse[0], surface.impulse[1], surface.work, surface.heat});
            if (surface.motion) numbers({surface.motion->place, surface.motion->velocity});
        }
    }
};

inline Simulation start_of(const CheckpointCase& its) {
    Simulation simulation(its.gas, its.run);
    simulation.record_collisions(true);
    if (!its.returns.empty()) simulation.measure_return(its.returns);
    return simulation;
}

/// The times at which the simulation stops after a checkpoint at `time`: up to the end of the run,
/// and including those at which returns are measured.
inline std::vector<double> stops_after(const CheckpointCase& its, double time) {
    std::vector<double> stops{5.0, 6.0};
    for (const double at : its.returns)
        if (at > time) stops.push_back(at);
    stops.push_back(time + 0.1);
    std::ranges::sort(stops);
    return stops;
}

inline void require_same(const Trace& one, const Trace& other) {
    REQUIRE(one.thrown == other.thrown);
    REQUIRE(one.collisions == other.collisions);
    REQUIRE(one.bits == other.bits);
}

struct Found {
    std::size_t collisions = 0, returns = 0, thrown = 0;
};

inline Found require_exact_checkpoint(const CheckpointCase& its, Simulation original, double time) {
    const Simulation start = original;
    Trace before;
    before.go_on(original, {time});
    const std::string bytes = written(original);
    Simulation copy = restored(original, its.run, bytes);
    REQUIRE(written(copy) == bytes);

    Trace trace, of_copy, of_other;
    const std::vector<double> stops = stops_after(its, time);
    if (before.thrown.empty()) {
        trace.go_on(original, stops);
        of_copy.go_on(copy, stops);
        require_same(trace, of_copy);
        REQUIRE(written(copy) == written(original));
    }

    // Restores the checkpoint into a simulation that was in another state; it must then equal the
    // copy.
    Simulation other = start;
    Archive archive(bytes, "checkpoint");
    other.archive(archive);
    REQUIRE(written(other) == bytes);
    if (before.thrown.empty()) {
        of_other.go_on(other, stops);
        require_same(trace, of_other);
    }
    return {trace.collisions, trace.returns, trace.thrown.empty() ? 0U : 1U};
}

inline CheckpointCase a_gas(std::int64_t count, int bits = 53) {
    CheckpointCase its;
    its.gas.box.size = {8.0, 6.0};
    its.gas.species = {
        {.name = "one", .count = count, .radius = 0.2, .velocity = Temperature{1.0}}};
    its.run.bits = bits;
    return its;
}

}  // namespace carom::test
