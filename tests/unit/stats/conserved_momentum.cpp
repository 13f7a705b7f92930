// Along which axes a gas keeps its momentum, and what counts on it: temperatures, and the
// barometric law.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/simulation.h"
#include "physics/theory/law.h"
#include "stats/paths/thermal_times.h"
#include "stats/run_statistics.h"
#include "support/relative.h"

using namespace carom;
using test::relative;

namespace {

// A wind along x and a calm gas.
Gas gas_of(Wall across, Wall up) {
    Gas gas;
    gas.box.size = {20.0, 15.0};
    gas.box.walls = {across, up};
    gas.species = {{.name = "wind", .count = 12, .radius = 0.3, .velocity = Velocity{{{2.0, 0.5}}}},
                   {.name = "calm",
                    .count = 12,
                    .radius = 0.4,
                    .mass = ValueRule{2.0},
                    .velocity = Temperature{1.0}}};
    return gas;
}

std::vector<Eigen::Index> all_of(const Particles& particles) {
    std::vector<Eigen::Index> all(static_cast<std::size_t>(particles.count()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

struct Case {
    std::string name;
    std::function<void(Gas&)> change;
};

// What a box may have besides periodic sides.
std::vector<Case> cases() {
    const auto partition = [](int axis, Partition with = {}) {
        return [axis, with](Gas& gas) {
            Partition line = with;
            line.name = "p";
            line.axis = axis;
            line.at = 7.0;
            gas.box.surfaces.partitions = {line};
        };
    };
    const auto pull = [](double x, double y) {
        return [x, y](Gas& gas) { gas.box.surfaces.gravity = {x, y}; };
    };
    const auto side = [](std::size_t number, const Behaviour& behaviour) {
        return [number, behaviour](Gas& gas) { gas.box.surfaces.sides[number] = behaviour; };
    };
    return {
        {"plain", [](Gas&) {}},
        {"gravity along x", pull(-0.3, 0.0)},
        {"gravity along y", pull(0.0, -0.3)},
        {"partition across x", partition(0)},
        {"partition across y", partition(1)},
        {"membrane across y", partition(1, {.name = "", .behaviour = Membrane{.species = {0}}})},
        {"gap in one across y", partition(1, {.name = "", .gaps = {{3.0, 9.0}}})},
        {"bath across y", partition(1, {.name = "", .behaviour = Bath{1.0}})},
        {"obstacle",
         [](Gas& gas) {
             gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{5.0, 5.0}, 2.0}}};
         }},
        {"top is a bath", side(3, Bath{1.0})},
        {"top is a piston", side(3, Piston{.mass = 20.0, .force = -3.0})},
        {"top moves", side(3, Driven{.velocity = -0.05})},
        {"one particle is fixed", [](Gas& gas) {
             gas.species.push_back({.name = "peg", .count = 1, .radius = 1.0, .mass = Infinite{}});
         }}};
}

}  // namespace

TEST_CASE("momentum is conserved where a run keeps it, and only there") {
    for (const auto& [across, up] : {std::pair{Wall::solid, Wall::solid},
                                     {Wall::periodic, Wall::solid},
                                     {Wall::solid, Wall::periodic},
                                     {Wall::periodic, Wall::periodic}})
        for (const Case& one : cases()) {
            CAPTURE(one.name);
            Gas gas = gas_of(across, up);
            one.change(gas);
            const auto& top = gas.box.surfaces.sides[3];
            if (up == Wall::periodic && !std::holds_alternative<Reflecting>(top)) continue;
            Simulation simulation(gas, Run{});
            const Eigen::ArrayXd before = momentum(simulation.particles(), simulation.sample());
            simulation.advance_to(20.0);
            const Eigen::ArrayXd change =
                momentum(simulation.particles(), simulation.sample()) - before;
            for (int axis = 0; axis < 2; ++axis) {
                CAPTURE(axis);
                // Of some 40, kept to the last digits at each of some hundred collisions.
                const bool is_kept = std::abs(change[axis]) < 1e-10;
                CHECK(conserves_momentum(gas.box, simulation.particles(), axis) == is_kept);
            }
        }
}

TEST_CASE("a run, a moment and a mean over exact times have one temperature") {
    for (const Case& one : cases()) {
        CAPTURE(one.name);
        Gas gas = gas_of(Wall::periodic, Wall::solid);
        one.change(gas);
        Simulation simulation(gas, Run{});
        simulation.advance_to(3.0);
        const Sample& sample = simulation.sample();
        const Particles& particles = simulation.particles();
        const double moment = thermal_motion(gas.box, particles, sample).temperature();
        RunStatistics statistics(gas.box, particles, static_cast<int>(gas.species.size()), 1);
        statistics.see(sample);
        CHECK(*statistics.summary({}).temperature == relative(moment, 1e-13));
        const ThermalIntegrals now =
            ThermalTimes(gas.box, particles, {{all_of(particles), {}}}, {}).moment(sample).at(0);
        CHECK(now.energy / now.half_freedom == relative(moment, 1e-13));
    }
}

TEST_CASE("a single disk that obstacles stop has a temperature, one that nothing stops has none") {
    Gas gas = gas_of(Wall::periodic, Wall::periodic);
    gas.species = {{.name = "ball", .count = 1, .radius = 0.5, .velocity = Velocity{{{1.0, 0.0}}}}};
    const auto temperature = [&] {
        Simulation simulation(gas, Run{});
        return thermal_motion(gas.box, simulation.particles(), simulation.sample()).temperature();
    };
    CHECK(std::isnan(temperature()));
    gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{5.0, 5.0}, 2.0}}};
    CHECK(temperature() == 0.5);
}

TEST_CASE("the barometric law of a gas that drifts is that of the same gas at rest") {
    Gas gas = gas_of(Wall::periodic, Wall::solid);
    gas.box.surfaces.gravity = {0.0, -0.3};
    Simulation simulation(gas, Run{});
    const Particles particles = simulation.particles();
    const auto law = [&](const Sample& start) {
        return carom::law(BoxedGas(gas.box, {}, particles, start), LawOf::heights,
                          {.axis = 1, .cells = 10})
            .curve;
    };
    Sample drifting = simulation.sample();
    const std::vector<double> at_rest = law(drifting);
    drifting.velocity.col(0) += 7.0;
    const std::vector<double> moved = law(drifting);
    // The sums of squares lose two of sixteen digits.
    for (std::size_t k = 0; k < at_rest.size(); ++k) CHECK(moved[k] == relative(at_rest[k], 1e-11));
    // Between walls along x the drift is energy that all share.
    gas.box.walls[0] = Wall::solid;
    CHECK(law(drifting).back() > 1.5 * at_rest.back());
}
