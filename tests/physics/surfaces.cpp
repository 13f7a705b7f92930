// Known truths of boxes whose walls act, of obstacles and of gravity. Each bound on a mean is five
// standard errors, taken from blocks of the same run, so that chance fails one run of a test in
// about two million.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "physics/gas.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "physics/surface.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/law.h"
#include "physics/theory/theory.h"
#include "support/blocks.h"
#include "support/equilibrium.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

// One species of as many particles, each at its place with its velocity.
struct Start {
    Box box;
    double radius = 0.0;
    std::vector<Vec> places = {}, velocities = {};
    double mass = 1.0;

    Simulation simulation(const Run& run = {}) const {
        const auto count = static_cast<Eigen::Index>(places.size());
        Particles particles{Eigen::ArrayXd::Constant(count, radius),
                            Eigen::ArrayXd::Constant(count, 1.0 / mass),
                            Eigen::ArrayXi::Zero(count)};
        Sample start{0.0, Eigen::ArrayXXd(count, 2), Eigen::ArrayXXd(count, 2)};
        for (Eigen::Index i = 0; i < count; ++i) {
            put(places[static_cast<std::size_t>(i)], start.position, i);
            put(velocities[static_cast<std::size_t>(i)], start.velocity, i);
        }
        return {box, particles, start, run};
    }
};

constexpr double most_error = 0.02;  // of a mean, in units of it

std::int64_t all_hits(const Simulation& simulation) {
    std::int64_t hits = 0;
    for (const SurfaceState& surface : simulation.surfaces()) hits += surface.hits;
    return hits;
}

// The path of a point between two hits, in blocks.
std::vector<double> free_paths(Simulation simulation, double speed) {
    constexpr int blocks = 40;
    constexpr double time = 2000.0;
    std::vector<double> paths;
    std::int64_t before = 0;
    for (int k = 1; k <= blocks; ++k) {
        simulation.advance_to(k * time);
        const std::int64_t hits = all_hits(simulation);
        paths.push_back(speed * time / static_cast<double>(hits - before));
        before = hits;
    }
    return paths;
}

}  // namespace

TEST_CASE("a disk that falls on a floor bounces to its height for ever") {
    // From height h it needs sqrt(2h/g) to the floor: here 2.
    Start start{.box = {.size = {4.0, 20.0}}, .radius = 0.5};
    start.box.surfaces.gravity = {0.0, -1.0};
    start.places = {{2.0, 2.5}};
    start.velocities = {{0.0, 0.0}};
    Simulation simulation = start.simulation();
    simulation.advance_to(4.0 * 1000.0);
    CHECK(simulation.surfaces()[2].hits == 1000);
    // A rounding of each bounce, of its time 2 or of the speed 2.
    CHECK(simulation.sample().position(0, 1) == relative(2.5, 1000.0 * 4e-16));
    simulation.advance_to(4.0 * 1000.0 + 1.0);
    CHECK(simulation.sample().position(0, 1) == relative(2.0, 1000.0 * 4e-16));
    CHECK(simulation.surfaces()[2].impulse[1] == relative(-2.0 * 2.0 * 1000.0, 1e-12));
}

TEST_CASE("a disk at rest on the floor stays there, and slides without falling") {
    Start start{.box = {.size = {10.0, 10.0}}, .radius = 0.5};
    start.box.surfaces.gravity = {0.0, -1.0};
    start.places = {{2.0, 0.5}, {7.0, 0.5}};
    start.velocities = {{1.0, 0.0}, {0.0, 0.0}};
    Simulation simulation = start.simulation();
    simulation.advance_to(5.0);  // the first has met the second and lies where that was
    const Sample& sample = simulation.sample();
    CHECK((sample.position.col(1) == 0.5).all());
    CHECK(sample.position(0, 0) == relative(6.0, 1e-14));
    CHECK(sample.velocity(1, 0) == relative(1.0, 1e-14));
}

TEST_CASE("the mean free path of a Sinai billiard is (L^2 - pi R^2) / 2R") {
    constexpr double length = 3.0, radius = 0.8;
    Start start{.box = {.size = {length, length}, .walls = {Wall::periodic, Wall::periodic}}};
    start.box.surfaces.obstacles = {{"disk", Obstacle::Ball{{1.5, 1.5}, radius}}};
    start.places = {{0.1, 0.2}};
    start.velocities = {{std::cos(1.0), std::sin(1.0)}};
    test::check_mean(free_paths(start.simulation(), 1.0),
                     (length * length - std::numbers::pi * radius * radius) / (2.0 * radius),
                     most_error);
}

TEST_CASE("the mean free path of any billiard is pi area / perimeter") {
    Start start{.box = {.size = {4.0, 3.0}}};
    start.box.surfaces.obstacles = {
        {"wedge", Obstacle::Lines{{{1.0, 1.0}, {3.0, 1.0}, {2.0, 2.0}}, true}},
        {"peg", Obstacle::Ball{{0.8, 2.2}, 0.3}}};
    start.places = {{0.5, 0.5}};
    start.velocities = {{std::cos(0.7), std::sin(0.7)}};
    const double area = 12.0 - 1.0 - std::numbers::pi * 0.09;
    const double perimeter = 14.0 + 2.0 + 2.0 * std::numbers::sqrt2 + std::numbers::pi * 0.6;
    test::check_mean(free_paths(start.simulation(), 1.0), std::numbers::pi * area / perimeter,
                     most_error);
}

TEST_CASE("a driven wall reflects v to 2u - v, and does the work") {
    Start start{.box = {.size = {10.0, 4.0}}, .radius = 0.5, .mass = 2.0};
    start.box.surfaces.sides[1] = Driven{-1.0};
    start.places = {{5.0, 2.0}};
    start.velocities = {{3.0, 0.5}};
    Simulation simulation = start.simulation();
    simulation.advance_to(2.0);  // meets at (9.5 - 5) / 4 = 1.125
    CHECK(simulation.sample().velocity(0, 0) == -5.0);
    CHECK(simulation.sample().velocity(0, 1) == 0.5);
    const SurfaceState wall = simulation.surfaces()[1];
    CHECK(wall.hits == 1);
    CHECK(wall.work == 16.0);  // 2/2 (25 - 9)
    CHECK(wall.impulse[0] == 16.0);
    CHECK(simulation.advance_to(2.0).impulses.wall[1] == 16.0);
    CHECK(wall.motion->place == 8.0);
}

TEST_CASE("Jarzynski: the mean of exp(-W/T) over starts is the ratio of the volumes") {
    constexpr double temperature = 1.0, begin = 4.0, end = 2.0, speed = 1.0;
    Random random(11, "starts of Jarzynski");
    std::vector<double> blocks;
    for (int block = 0; block < 40; ++block) {
        double sum = 0.0;
        constexpr int starts = 200;
        for (int k = 0; k < starts; ++k) {
            Start start{.box = {.size = {begin, 1.0}}};
            start.box.surfaces.sides[1] = Driven{-speed, (begin - end) / speed};
            start.places = {{random.uniform(0.0, begin), 0.5}};
            start.velocities = {{std::sqrt(temperature) * random.normal(), 0.0}};
            Simulation simulation = start.simulation();
            simulation.advance_to((begin - end) / speed);
            sum += std::exp(-simulation.surfaces()[1].work / temperature);
        }
        blocks.push_back(sum / starts);
    }
    test::check_mean(blocks, end / begin, most_error);
}

TEST_CASE("a piston on points in a column stands at two thirds of E / F on average") {
    // Vertical motion alone exchanges energy: p(h) goes as h^N (E - F h)^((N - 1) / 2), of which
    // the mean is 2 E / 3 F, for any N.
    constexpr double force = 1.0;
    Start start{.box = {.size = {1.0, 4.0}}};
    start.box.surfaces.sides[3] = Piston{.mass = 3.0, .force = -force};
    double energy = force * 4.0;
    for (int i = 0; i < 8; ++i) {
        start.places.emplace_back(0.1 + 0.1 * i, 0.3 + 0.4 * i);
        start.velocities.emplace_back(0.0, 0.9 + 0.17 * i * (i % 2 == 0 ? 1.0 : -1.0));
        energy += 0.5 * start.velocities.back()[1] * start.velocities.back()[1];
    }
    Simulation simulation = start.simulation();
    std::vector<double> blocks;
    double time = 0.0;
    for (int block = 0; block < 40; ++block) {
        double sum = 0.0;
        for (int k = 0; k < 400; ++k) {
            simulation.advance_to(time += 0.77);
            sum += simulation.surfaces()[3].motion->place;
        }
        blocks.push_back(sum / 400.0);
    }
    test::check_mean(blocks, 2.0 * energy / (3.0 * force), most_error);
    // The account: kinetic energies, and the force times the height.
    const auto piston = *simulation.surfaces()[3].motion;
    const double now = 0.5 * simulation.sample().velocity.square().sum() +
                       1.5 * piston.velocity * piston.velocity + force * piston.place;
    CHECK(now == relative(energy, 1e-12));
}

TEST_CASE("particles leave a heat bath with the energies of its flux") {
    // One point between a bath and a wall: each hit gives a new velocity, of mean square 2 T/m
    // along the normal and T/m along the wall.
    constexpr double temperature = 2.5, mass = 2.0;
    Start start{.box = {.size = {1.0, 1.0}}, .mass = mass};
    start.box.surfaces.sides[0] = Bath{temperature};
    start.places = {{0.5, 0.5}};
    start.velocities = {{-1.0, 0.3}};
    Simulation simulation = start.simulation();
    simulation.record_collisions(true);
    std::vector<double> normal, along;
    double time = 0.0, normal_sum = 0.0, along_sum = 0.0;
    int hits = 0;
    while (normal.size() < 40) {
        const AdvanceResult result = simulation.advance_to(time += 10.0);
        for (const Collision& collision : result.collisions) {
            if (!(collision.second == Partner(Side::left))) continue;
            normal_sum += collision.first_after[0] * collision.first_after[0];
            along_sum += collision.first_after[1] * collision.first_after[1];
            if (++hits % 500 != 0) continue;
            normal.push_back(normal_sum / 500.0);
            along.push_back(along_sum / 500.0);
            normal_sum = along_sum = 0.0;
        }
    }
    const test::Estimate across = test::estimate(normal), parallel = test::estimate(along);
    CHECK(std::abs(across.mean - 2.0 * temperature / mass) < 5.0 * across.error);
    CHECK(std::abs(parallel.mean - temperature / mass) < 5.0 * parallel.error);
}

TEST_CASE("one point between two baths carries 1.5 (T1 - T2) G of heat") {
    constexpr double warm = 3.0, cold = 1.0, length = 2.0;
    Start start{.box = {.size = {length, 1.0}}};
    start.box.surfaces.sides[0] = Bath{warm};
    start.box.surfaces.sides[1] = Bath{cold};
    start.places = {{1.0, 0.5}};
    start.velocities = {{1.0, 0.0}};
    Simulation simulation = start.simulation();
    std::vector<double> flow;
    double before = 0.0;
    constexpr double time = 4000.0;
    for (int k = 1; k <= 40; ++k) {
        simulation.advance_to(k * time);
        const double heat = simulation.surfaces()[0].heat;
        flow.push_back((heat - before) / time);
        before = heat;
    }
    const double hits = 2.0 / (length * (1.0 / std::sqrt(warm) + 1.0 / std::sqrt(cold)) *
                               std::sqrt(2.0 * std::numbers::pi));
    const test::Estimate flux = test::estimate(flow);
    CHECK(std::abs(flux.mean - 1.5 * (warm - cold) * hits) < 5.0 * flux.error);
}

TEST_CASE("a gap lets through what fits, a membrane those it names") {
    Start start{.box = {.size = {10.0, 10.0}}, .radius = 0.5};
    start.box.surfaces.partitions = {
        {.name = "window", .axis = 0, .at = 5.0, .gaps = {{4.0, 6.0}}}};
    start.places = {{2.0, 5.0}, {2.0, 8.0}};
    start.velocities = {{1.0, 0.0}, {1.0, 0.0}};
    Simulation window = start.simulation();
    window.advance_to(6.0);
    CHECK(window.sample().position(0, 0) == 8.0);
    CHECK(window.sample().position(1, 0) == 1.0);

    start.box.surfaces.partitions = {
        {.name = "demon",
         .axis = 0,
         .at = 5.0,
         .behaviour = Membrane{.upward = {.faster_than = 1.5}, .downward = {}}}};
    start.velocities = {{2.0, 0.0}, {1.0, 0.0}};
    Simulation demon = start.simulation();
    demon.advance_to(6.0);  // the fast one passes, comes back from the wall and is kept
    CHECK(demon.sample().position(0, 0) == relative(6.0, 1e-14));
    CHECK(demon.sample().velocity(0, 0) == 2.0);
    CHECK(demon.sample().velocity(1, 0) == -1.0);
    start.box.surfaces.partitions[0].behaviour = Membrane{.species = {0}};
    Simulation membrane = start.simulation();
    membrane.advance_to(4.0);
    CHECK(membrane.surfaces()[4].hits == 0);
    CHECK(membrane.sample().position(1, 0) == 6.0);
}

TEST_CASE("reversed, disks come home past obstacles, pistons, driven walls and gravity") {
    Gas gas;
    gas.box.size = {12.0, 10.0};
    gas.box.surfaces.gravity = {0.0, -0.5};
    gas.box.surfaces.obstacles = {{"peg", Obstacle::Ball{{4.0, 4.0}, 1.0}}};
    gas.box.surfaces.sides[1] = Driven{-0.2, 2.0};
    gas.box.surfaces.sides[3] = Piston{.mass = 20.0, .force = -1.0};
    gas.species = {{.name = "disks", .count = 12, .radius = 0.4, .velocity = Temperature{1.0}}};
    Run run;
    run.events = {{3.0, ReverseVelocities{}}};
    Simulation simulation(gas, run);
    const Sample start = simulation.sample();
    CHECK(simulation.advance_to(2.9).counts.particle > 3);
    simulation.advance_to(6.0);
    // Differences grow by a factor of about ten with each of the few collisions of a disk.
    CHECK((simulation.sample().position - start.position).abs().maxCoeff() < 1e-8);
    CHECK(simulation.surfaces()[1].motion->place == relative(12.0, 1e-14));
    CHECK(simulation.surfaces()[3].motion->place == relative(10.0, 1e-9));
}

TEST_CASE("what has no memory is not reversed") {
    Start start{.box = {.size = {4.0, 4.0}}, .radius = 0.5};
    start.box.surfaces.sides[0] = Bath{1.0};
    start.places = {{2.0, 2.0}};
    start.velocities = {{1.0, 0.0}};
    Run run;
    run.events = {{1.0, ReverseVelocities{}}};
    CHECK_THROWS_AS(start.simulation(run), std::invalid_argument);
    start.box.surfaces.sides[0] = Reflecting{};
    run.events.insert(run.events.begin(), {0.5, ChangeSurface{0, Bath{1.0}}});
    CHECK_THROWS_AS(start.simulation(run), std::invalid_argument);
    run.events[0].action = ChangeSurface{0, Driven{0.1}};
    start.simulation(run);
}

TEST_CASE("surfaces that cannot be are refused") {
    const auto is_refused = [](const auto& change) {
        Start start{.box = {.size = {4.0, 4.0}}, .radius = 0.1};
        start.places = {{2.0, 1.0}};
        start.velocities = {{1.0, 0.0}};
        change(start.box);
        try {
            start.simulation();
        } catch (const std::invalid_argument&) {
            return true;
        }
        return false;
    };
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK_FALSE(is_refused([](Box& box) { box.surfaces.sides[0] = Bath{1.0}; }));
    CHECK(is_refused([](Box& box) { box.surfaces.sides[0] = Bath{0.0}; }));
    CHECK(is_refused([](Box& box) { box.surfaces.sides[0] = Bath{std::nan("")}; }));
    CHECK(is_refused([](Box& box) { box.surfaces.sides[3] = Piston{.mass = -1.0}; }));
    CHECK(is_refused([&](Box& box) { box.surfaces.sides[3] = Driven{infinity}; }));
    CHECK(is_refused([&](Box& box) { box.surfaces.gravity[1] = -infinity; }));
    CHECK(is_refused([](Box& box) {
        box.walls[0] = Wall::periodic;
        box.surfaces.sides[0] = Bath{1.0};
    }));
    const auto partition = [&](Partition line) {
        return is_refused([&](Box& box) { box.surfaces.partitions = {line}; });
    };
    CHECK_FALSE(partition({.name = "", .at = 3.0, .gaps = {{0.0, 1.0}, {2.0, 4.0}}}));
    CHECK(partition({.name = "", .at = 5.0}));
    CHECK(partition({.name = "", .axis = 2, .at = 3.0}));
    CHECK(partition({.name = "", .at = 3.0, .gaps = {{2.0, 3.0}, {1.0, 2.0}}}));
    CHECK(partition({.name = "", .at = 3.0, .gaps = {{1.0, 2.0}}, .behaviour = Piston{}}));
    CHECK(partition({.name = "", .at = 2.0}));  // through the disk
    CHECK(is_refused([](Box& box) {
        box.surfaces.obstacles = {{"", Obstacle::Lines{{{1.0, 3.0}, {1.0, 3.0}}}}};
    }));
    CHECK(is_refused([](Box& box) { box.surfaces.obstacles = {{"", Obstacle::Lines{}}}; }));
}

TEST_CASE("a wall that leaves no room for the disks ends the run with the reason") {
    Start start{.box = {.size = {6.0, 2.0}}, .radius = 0.45};
    start.box.surfaces.sides[1] = Driven{-1.0};
    for (int i = 0; i < 5; ++i) {
        start.places.emplace_back(0.6 + 1.1 * i, 1.0);
        start.velocities.emplace_back(0.3 - 0.1 * i, 0.05 * i);
    }
    Simulation simulation = start.simulation();
    CHECK_THROWS_AS(simulation.advance_to(10.0), std::runtime_error);
}

TEST_CASE("neither a weight on a gas at rest nor a slow wall in a fall crushes the gas") {
    Start start{.box = {.size = {4.0, 4.0}}, .radius = 0.5};
    start.places = {{2.0, 0.5}};
    start.velocities = {{0.0, 0.0}};
    start.box.surfaces.sides[3] = Piston{.mass = 1.0, .force = -1.0};
    Simulation weight = start.simulation();
    weight.advance_to(20.0);
    CHECK(weight.surfaces()[3].hits > 0);
    start.box.surfaces.gravity = {0.0, -1.0};
    start.box.surfaces.sides = {};
    start.box.surfaces.sides[2] = Driven{1e-6};
    start.places = {{2.0, 2.5}};
    Simulation slow = start.simulation();
    slow.advance_to(400.0);
    CHECK(slow.surfaces()[2].hits == 100);
}

TEST_CASE("a partition near the side of a periodic box stops disks on both sides") {
    Start start{.box = {.size = {6.0, 4.0}, .walls = {Wall::periodic, Wall::solid}}, .radius = 0.5};
    start.box.surfaces.partitions = {{.name = "line", .axis = 0, .at = 0.2}};
    start.places = {{3.0, 2.0}};
    start.velocities = {{1.0, 0.0}};
    Simulation simulation = start.simulation();
    simulation.advance_to(4.0);  // turns back at 6.2 - 0.5
    CHECK(simulation.sample().position(0, 0) == relative(4.4, 1e-14));
    CHECK(simulation.surfaces()[4].hits == 1);
}

TEST_CASE("theory that takes a plain box for granted does not answer for others") {
    Gas gas;
    gas.box.size = {10.0, 10.0};
    gas.species = {{.name = "disks", .count = 10, .radius = 0.4, .velocity = Temperature{1.0}}};
    CHECK_FALSE(why_no_law(gas, {}, LawOf::distribution));
    const auto [particles, start] = place(gas);
    CHECK(law(BoxedGas(gas.box, {}, particles, start), LawOf::collision_rate));
    gas.box.surfaces.gravity = {0.0, -1.0};
    REQUIRE(why_no_law(gas, {}, LawOf::distribution));
    CHECK(why_no_law(gas, {}, LawOf::distribution)->why == NoLaw::Why::gravity);
    CHECK_FALSE(law(BoxedGas(gas.box, {}, particles, start), LawOf::collision_rate));
    CHECK_FALSE(test::equilibrium(gas.box, particles, start));
}

TEST_CASE("disks are placed clear of every surface") {
    Gas gas;
    gas.box.size = {10.0, 10.0};
    gas.box.surfaces.obstacles = {
        {"block", Obstacle::Lines{{{3.0, 3.0}, {7.0, 3.0}, {7.0, 7.0}, {3.0, 7.0}}, true}}};
    gas.box.surfaces.partitions = {{.name = "divider", .axis = 1, .at = 8.5}};
    gas.species = {{.name = "disks", .count = 40, .radius = 0.4, .velocity = Temperature{1.0}}};
    Simulation simulation(gas, Run{});
    for (const double time : {0.0, 50.0}) {
        simulation.advance_to(time);
        for (Eigen::Index i = 0; i < 40; ++i) {
            const double x = simulation.sample().position(i, 0);
            const double y = simulation.sample().position(i, 1);
            const double from_block = std::hypot(std::max(0.0, std::abs(x - 5.0) - 2.0),
                                                 std::max(0.0, std::abs(y - 5.0) - 2.0));
            CHECK(from_block > 0.4 - 1e-12);
            CHECK(std::abs(y - 8.5) > 0.4 - 1e-12);
        }
    }
    Start start{.box = gas.box, .radius = 0.4};
    start.places = {{5.0, 5.0}};
    start.velocities = {{0.0, 0.0}};
    CHECK_THROWS_AS(start.simulation(), std::invalid_argument);
}

// Beyond the box that it was made for, and crowded in a corner of it, the grid of cells is made
// anew: with wrong neighbours disks would overlap.
TEST_CASE("disks meet one another wherever the walls have gone") {
    constexpr double out = 0.5, turn = 80.0, until = 150.0;
    Gas gas;
    gas.box.size = {20.0, 20.0};
    for (std::size_t side = 0; side < 4; ++side)
        gas.box.surfaces.sides[side] = Driven{.velocity = side % 2 == 0 ? -out : out};
    gas.species = {{.name = "disks", .count = 150, .radius = 0.5, .velocity = Temperature{4.0}}};
    Run run;
    for (std::int32_t side = 0; side < 4; ++side)
        run.events.push_back({turn, MoveSurface{side, side % 2 == 0 ? out : -out}});
    Simulation simulation(gas, run);
    double farthest = 0.0;
    for (double time = 1.0; time <= until; time += 1.0) {
        simulation.advance_to(time);
        const double moved = out * (time < turn ? time : 2.0 * turn - time);
        const Eigen::ArrayXXd& x = simulation.sample().position;
        double closest = 1.0;
        for (Eigen::Index i = 0; i < x.rows(); ++i)
            for (Eigen::Index j = 0; j < i; ++j)
                closest = std::min(closest, (x.row(i) - x.row(j)).matrix().norm());
        CHECK(closest > 1.0 - 1e-12);
        CHECK(x.minCoeff() > 0.5 - moved - 1e-12 * 100.0);
        CHECK(x.maxCoeff() < 19.5 + moved + 1e-12 * 100.0);
        farthest = std::max(farthest, x.maxCoeff());
    }
    CHECK(farthest > 40.0);
}

TEST_CASE("disks that a slow wall squeezes to half their room follow the adiabat of hard disks") {
    // Walls of two speeds, extrapolated to a wall without speed. An ideal gas would come to twice
    // its temperature.
    constexpr int count = 100, runs = 32;
    constexpr double size = 20.0;
    double expected = 0.0;
    const auto hotter = [&](double speed, std::uint64_t seed) {
        Gas gas;
        gas.seed = seed;
        gas.box.size = {size, size};
        gas.box.surfaces.sides[3] = Driven{-speed, 0.5 * size / speed};
        gas.species = {
            {.name = "", .count = count, .radius = 0.5, .velocity = Temperature{1.0, true}}};
        Simulation simulation(gas, {});
        const BoxedGas boxed(gas.box, {}, simulation.particles(), simulation.sample());
        const Law adiabat = law(boxed, LawOf::adiabat, {.surface = 3, .lengths = {0.5 * size}});
        expected = adiabat.temperatures[0] / boxed.thermal.temperature();
        const double before = simulation.energy_account().kinetic;
        simulation.advance_to(0.5 * size / speed);
        return simulation.energy_account().kinetic / before;
    };
    std::vector<double> found;
    for (std::uint64_t seed = 1; seed <= runs; ++seed)
        found.push_back(2.0 * hotter(0.02, seed) - hotter(0.04, seed + runs));
    const test::Estimate ratio = test::estimate(found);
    CAPTURE(ratio.mean);
    CAPTURE(ratio.error);
    CAPTURE(expected);
    CHECK(expected > 2.5);
    CHECK(std::abs(ratio.mean / expected - 1.0) < 0.005 + 5.0 * ratio.error / expected);
    CHECK(ratio.error < 0.004 * expected);
}
