#include "support/gas_states.h"

#include <stdexcept>
#include <tuple>
#include <utility>

#include "physics/placement/draws.h"
#include "physics/placement/placement.h"

namespace carom::test {

Species disks(std::int64_t count, double mass) {
    return {.name = "disks",
            .count = count,
            .radius = 0.3,
            .mass = ValueRule{mass},
            .velocity = Temperature{1.0}};
}

namespace {

void make_periodic(GasState& s) { s.gas.box.walls = {Wall::periodic, Wall::periodic}; }

Condition on_side(const std::string& name, const Behaviour& behaviour, std::size_t side = 3) {
    return {name, [=](GasState& s) {
                s.gas.box.surfaces.sides.at(side) = behaviour;
                s.asked.surface = static_cast<std::int32_t>(side);
            }};
}

Condition with_partition(const std::string& name, const Partition& partition) {
    return {name, [=](GasState& s) {
                s.gas.box.surfaces.partitions = {partition};
                s.asked.surface = Surfaces{}.first_partition();
            }};
}

Condition of_disks(const std::string& name, std::int64_t count, bool is_periodic) {
    return {name, [=](GasState& s) {
                s.gas.species = {disks(count)};
                if (is_periodic) make_periodic(s);
            }};
}

Condition on_line(const std::string& name, Wall ends, const std::vector<double>& masses) {
    return {name,
            [=](GasState& s) {
                s.gas.box = {1, {20.0, 0.0}, {ends, Wall::solid}};
                Species beads = disks(static_cast<std::int64_t>(masses.size()));
                beads.mass = ValueRule{masses};
                s.gas.species = {beads};
            },
            true};
}

Condition unplaced(Condition condition) {
    condition.is_placed = false;
    return condition;
}

}  // namespace

std::vector<Condition> conditions() {
    const Partition middle{.name = "wall", .axis = 0, .at = 10.0};
    Partition gap = middle, selects = middle;
    gap.gaps = {{5.0, 8.0}};
    selects.behaviour = Membrane{.species = {0}};
    std::vector<Condition> all{
        {"closed", [](GasState&) {}},
        {"periodic", make_periodic},
        {"half", [](GasState& s) { s.gas.box.walls[0] = Wall::periodic; }},
        {"mixture",
         [](GasState& s) {
             make_periodic(s);
             s.gas.species = {disks(10), disks(1, 20.0)};
             s.gas.species[1].velocity = AtRest{};  // no momentum
         }},
        {"gravity",
         [](GasState& s) {
             s.gas.box.surfaces.gravity = {0.0, -0.2};
         }},
        {"fixed",
         [](GasState& s) {
             s.gas.species.push_back(
                 {.name = "post", .count = 1, .radius = 1.0, .mass = Infinite{}});
         }},
        {"moved",
         [](GasState& s) {
             s.gas.species.push_back({.name = "post",
                                      .count = 1,
                                      .radius = 1.0,
                                      .mass = Infinite{},
                                      .velocity = Velocity{{{1.0, 0.0}}}});
         }},
        on_side("bath", Bath{2.0}),
        {"baths",
         [](GasState& s) {
             s.gas.box.surfaces.sides[2] = Bath{1.0};
             s.gas.box.surfaces.sides[3] = Bath{2.0};
         }},
        on_side("driven", Driven{0.1}),
        on_side("piston", Piston{.mass = 50.0, .force = -2.0}),
        with_partition("membrane", selects),
        with_partition("divided", middle),
        with_partition("gap", gap),
        {"obstacle",
         [](GasState& s) {
             s.gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{10.0, 7.0}, 1.5}}};
         }},
        {"heated",
         [](GasState& s) {
             s.events = {{1.0, Heat{{}, 5.0}}};
         }},
        {"opened",
         [middle](GasState& s) {
             s.gas.box.surfaces.partitions = {middle};
             s.asked.surface = Surfaces{}.first_partition();
             s.events = {{1.0, SetOpen{Surfaces{}.first_partition(), true}}};
         }},
        {"shut",
         [middle](GasState& s) {
             s.gas.box.surfaces.partitions = {middle};
             s.asked.surface = Surfaces{}.first_partition();
             s.events = {{1.0, SetOpen{Surfaces{}.first_partition(), false}}};
         }},
        {"reversed",
         [](GasState& s) {
             s.events = {{1.0, ReverseVelocities{}}};
         }},
        of_disks("one", 1, false),
        of_disks("one-free", 1, true),
        {"billiard",
         [](GasState& s) {
             s.gas.species = {disks(1)};
             s.gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{10.0, 7.0}, 1.5}}};
         }},
        {"billiard-falling",
         [](GasState& s) {
             s.gas.species = {disks(1)};
             s.gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{10.0, 7.0}, 1.5}}};
             s.gas.box.surfaces.gravity = {0.0, -0.2};
         }},
        {"billiard-on",
         [](GasState& s) {
             s.gas.species = {disks(1)};
             s.gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{10.0, 7.0}, 1.5}}};
             s.asked.ends_at_walls = false;
         }},
        of_disks("two", 2, false),
        of_disks("two-free", 2, true),
        of_disks("empty", 0, false),
        {"at-rest", [](GasState& s) { s.gas.species[0].velocity = AtRest{}; }},
        {"drifts",
         [](GasState& s) {
             make_periodic(s);
             s.gas.species.push_back(disks(1));
             s.gas.species.back().velocity = Velocity{{{3.0, 0.0}}};
         }},
        {"points", [](GasState& s) { s.gas.species[0].radius = 0.0; }},
        {"points-falling",
         [](GasState& s) {
             s.gas.species[0].radius = 0.0;
             s.gas.box.surfaces.gravity = {0.0, -0.2};
         }},
        on_line("line", Wall::solid, {1.0, 2.0, 3.0, 1.0, 2.5}),
        on_line("ring", Wall::periodic, {1.0, 2.0, 3.0, 1.0, 2.5}),
        on_line("equals", Wall::solid, {1.0, 1.0, 1.0, 1.0, 1.0}),
        {"not-yet", make_periodic},
        {"hardly", make_periodic},
        unplaced(on_line("line-unplaced", Wall::solid, {1.0, 2.0, 3.0, 1.0, 2.5})),
        unplaced(on_line("equals-unplaced", Wall::solid, {1.0, 1.0, 1.0, 1.0, 1.0})),
        {"half-moved",
         [](GasState& s) {
             s.gas.box.walls[0] = Wall::periodic;
             s.gas.box.surfaces.sides[3] = Driven{0.1};
         }},
        {"diffuse", [](GasState& s) { s.gas.box.surfaces.sides.fill(Diffuse{}); }},
        {"one-diffuse",
         [](GasState& s) {
             s.gas.species = {disks(1)};
             s.gas.box.surfaces.sides.fill(Diffuse{});
         }},
        {"half-diffuse", [](GasState& s) {
             s.gas.box.walls[0] = Wall::periodic;
             s.gas.box.surfaces.sides[3] = Diffuse{};
         }}};
    return all;
}

GasState state_of(const Condition& condition) {
    GasState s;
    s.gas.box.size = {20.0, 15.0};
    s.gas.species = {disks(20)};
    s.gas.seed = 3;
    s.asked = {.axis = 1, .cells = 4, .cells_up = 3, .at = 7.0, .ends_at_walls = true};
    condition.change(s);
    if (condition.is_line) s.asked.axis = 0;
    if (condition.name == "not-yet") s.asked.collisions = 0.0;
    if (condition.name == "hardly") s.asked.collisions = 2.0;
    std::tie(s.particles, s.start) = condition.is_placed ? place(s.gas) : draw_gas(s.gas);
    return s;
}

GasState state_named(const std::string& name) {
    for (const Condition& one : conditions())
        if (one.name == name) return state_of(one);
    throw std::out_of_range("there is no condition " + name);
}

}  // namespace carom::test
