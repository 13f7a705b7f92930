#include "support/gas_states.h"

#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "physics/placement/draws.h"
#include "physics/placement/placement.h"
#include "support/space.h"
#include "util/random.h"

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

Condition in_space(const std::string& name, const std::function<void(GasState&)>& change) {
    Condition condition{name, [=](GasState& s) {
                            s.gas.box = space_of({20.0, 15.0, 12.0});
                            change(s);
                        }};
    condition.is_space = true;
    return condition;
}

void make_periodic_in_space(GasState& s) {
    s.gas.box.walls = {Wall::periodic, Wall::periodic, Wall::periodic};
}

// Spheres on a grid of points, whether or not they overlap, with normally distributed velocities
// whose momenta are 0 where they are conserved: laws only ask for the energy and for the places
// along gravity.
std::pair<Particles, Sample> on_a_grid(const Gas& gas) {
    Random random(gas.seed, "spheres on a grid");
    std::vector<double> radius, inverse_mass;
    std::vector<int> species;
    std::vector<Vec> velocity;
    for (std::size_t k = 0; k < gas.species.size(); ++k)
        for (std::int64_t i = 0; i < gas.species[k].count; ++i) {
            const auto* mass = std::get_if<ValueRule>(&gas.species[k].mass);
            radius.push_back(std::get<double>(gas.species[k].radius));
            inverse_mass.push_back(mass == nullptr ? 0.0 : 1.0 / std::get<double>(*mass));
            species.push_back(static_cast<int>(k));
            const auto* temperature = std::get_if<Temperature>(&gas.species[k].velocity);
            const double scale =
                temperature == nullptr ? 0.0 : std::sqrt(temperature->value * inverse_mass.back());
            velocity.push_back(scale * Vec{random.normal(), random.normal(), random.normal()});
        }
    const auto count = static_cast<Eigen::Index>(radius.size());
    Particles particles{Eigen::Map<Eigen::ArrayXd>(radius.data(), count),
                        Eigen::Map<Eigen::ArrayXd>(inverse_mass.data(), count),
                        Eigen::Map<Eigen::ArrayXi>(species.data(), count)};
    Sample sample{0.0, Eigen::ArrayXXd(count, 3), Eigen::ArrayXXd(count, 3)};
    const auto along = static_cast<Eigen::Index>(std::ceil(std::cbrt(double(count))));
    for (Eigen::Index i = 0; i < count; ++i) {
        put(velocity[static_cast<std::size_t>(i)], sample.velocity, i);
        Eigen::Index rest = i;
        for (int axis = 0; axis < 3; ++axis, rest /= along) {
            const double r = particles.radius[i], room = gas.box.size[axis] - 2.0 * r;
            sample.position(i, axis) = r + room * (double(rest % along) + 0.5) / double(along);
        }
    }
    const Eigen::ArrayXd mass =
        (particles.inverse_mass > 0.0).select(particles.inverse_mass.inverse(), 0.0);
    for (int axis = 0; axis < 3; ++axis)
        if (conserves_momentum(gas.box, particles, axis)) {
            const double drift = (mass * sample.velocity.col(axis)).sum() / mass.sum();
            sample.velocity.col(axis) -= drift;
        }
    return {particles, sample};
}

Condition unplaced(Condition condition) {
    condition.is_placed = false;
    return condition;
}

std::vector<Condition> conditions_in_space() {
    const auto nothing = [](GasState&) {};
    const auto with = [](const Partition& partition) {
        return [=](GasState& s) {
            s.gas.box.surfaces.partitions = {partition};
            s.asked.surface = s.gas.box.surfaces.first_partition();
        };
    };
    const auto side = [](std::size_t number, const Behaviour& behaviour) {
        return [=](GasState& s) {
            s.gas.box.surfaces.sides.at(number) = behaviour;
            s.asked.surface = static_cast<std::int32_t>(number);
        };
    };
    const auto in_periodic_cube = [](std::int64_t count) {
        return [=](GasState& s) {
            s.gas.box = cube_of(10.0, Wall::periodic);
            s.gas.species = {disks(count)};
        };
    };
    const Partition middle{.name = "wall", .axis = 2, .at = 6.0};
    Partition gap = middle;
    gap.gaps = {Gap({5.0, 5.0}, {8.0, 9.0})};
    return {
        in_space("space", nothing),
        in_space("space-periodic", make_periodic_in_space),
        in_space("space-half", [](GasState& s) { s.gas.box.walls[0] = Wall::periodic; }),
        in_space("space-pipe",
                 [](GasState& s) {
                     s.gas.box.walls = {Wall::periodic, Wall::solid, Wall::periodic};
                 }),
        in_space("space-mixture",
                 [](GasState& s) {
                     make_periodic_in_space(s);
                     s.gas.species.push_back(disks(5, 4.0));
                     s.gas.species.back().radius = 0.5;
                 }),
        in_space("space-mixed-walls",
                 [](GasState& s) {
                     s.gas.species.push_back(disks(5, 4.0));
                     s.gas.species.back().radius = 0.5;
                 }),
        in_space("space-gravity",
                 [](GasState& s) {
                     s.gas.box.surfaces.gravity = {0.0, -0.2, 0.0};
                 }),
        in_space("space-aslant",
                 [](GasState& s) {
                     s.gas.box.surfaces.gravity = {0.0, -0.2, 0.1};
                 }),
        in_space("space-bath", side(4, Bath{2.0})),
        in_space("space-piston", side(5, Piston{.mass = 50.0, .force = -2.0})),
        in_space("space-piston-half",
                 [=](GasState& s) {
                     s.gas.box.walls[0] = Wall::periodic;
                     side(5, Piston{.mass = 50.0, .force = -2.0})(s);
                 }),
        in_space("space-divided", with(middle)),
        in_space("space-gap", with(gap)),
        in_space("space-one", [](GasState& s) { s.gas.species = {disks(1)}; }),
        in_space(
            "space-billiard",
            [](GasState& s) {
                s.gas.species = {disks(1)};
                s.gas.box.surfaces.obstacles = {{"ball", Obstacle::Ball{{10.0, 7.0, 6.0}, 1.5}}};
            }),
        in_space("space-block",
                 [](GasState& s) {
                     s.gas.species = {disks(1)};
                     s.gas.box.surfaces.obstacles = {
                         {"block", Obstacle::Cuboid{{9.0, 6.0, 5.0}, {11.0, 8.0, 7.0}}}};
                 }),
        in_space("space-two-free",
                 [](GasState& s) {
                     make_periodic_in_space(s);
                     s.gas.species = {disks(2)};
                 }),
        in_space("space-points", [](GasState& s) { s.gas.species[0].radius = 0.0; }),
        in_space("space-fluid", in_periodic_cube(2653)),    // packing 0.3
        in_space("space-dense", in_periodic_cube(4244)),    // 0.48
        in_space("space-frozen", in_periodic_cube(4598))};  // 0.52
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
    for (const Condition& one : conditions_in_space()) all.push_back(one);
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
    if (condition.is_space) s.asked.cells_deep = 2;
    if (condition.name == "not-yet") s.asked.collisions = 0.0;
    if (condition.name == "hardly") s.asked.collisions = 2.0;
    if (condition.is_space)
        std::tie(s.particles, s.start) = on_a_grid(s.gas);
    else
        std::tie(s.particles, s.start) = condition.is_placed ? place(s.gas) : draw_gas(s.gas);
    return s;
}

GasState state_named(const std::string& name) {
    for (const Condition& one : conditions())
        if (one.name == name) return state_of(one);
    throw std::out_of_range("there is no condition " + name);
}

}  // namespace carom::test
