// What kinetic theory says of collisions: how often, how far apart, what they hand over, and how
// they lead to equilibrium.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/simulation.h"
#include "support/bodies.h"
#include "support/csv.h"
#include "support/equation_of_state.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;

namespace {

double collisions_per_particle(const AdvanceResult& advanced, double count) {
    return 2.0 * static_cast<double>(advanced.counts.particle) / count;
}

// The way of all disks from contact to contact, summed as the record of collisions tells it:
// flights are straight and much shorter than half of the periodic box.
class Ways {
  public:
    Ways(const Box& box, const Eigen::ArrayXXd& places) : size_(box.size), last_(places) {}

    void add(std::int32_t disk, const Vec& place) {
        Vec step = place - vec_in(last_, disk);
        for (int a = 0; a < 2; ++a) step[a] = std::remainder(step[a], size_[a]);
        total_ += std::hypot(step[0], step[1]);
        put(place, last_, disk);
    }

    double total() const { return total_; }

  private:
    Vec size_;
    Eigen::ArrayXXd last_;
    double total_ = 0.0;
};

}  // namespace

TEST_CASE("the equation of state that the tests use has the known virial coefficients") {
    for (const double packing : {0.02, 0.05, 0.1}) {
        double sum = 0.0;
        for (const auto& row : test::reference_rows("virial_hard_disk.csv"))
            sum += std::stod(row[1]) * std::pow(2.0 * packing, std::stoi(row[0]) - 1);
        // The coefficients from the fifth on are uncertain by 8e-6 at most; B_11 would be near
        // 0.01.
        const double doubt = 8e-6 * std::pow(2.0 * packing, 4) + 0.02 * std::pow(2.0 * packing, 10);
        CHECK(std::abs(test::excess_compressibility(packing) - sum) < doubt);
    }
}

TEST_CASE("disks collide as often, and fly as far, as Enskog's theory says") {
    // T is that of the centre-of-mass frame with 2N - 2 degrees of freedom.
    constexpr int count = 2000;
    for (const double packing : {0.2, 0.5}) {
        CAPTURE(packing);
        Gas gas;
        const double side = std::sqrt(count * std::numbers::pi * 0.25 / packing);
        gas.box.size = {side, side};
        gas.box.walls = {Wall::periodic, Wall::periodic};
        gas.species = {{.name = "", .count = count, .velocity = Temperature{1.0}}};
        if (packing > 0.45) gas.species[0].position = LatticePlaces{};
        Run run;
        run.equilibrate = packing > 0.45 ? 20.0 : 10.0;
        Simulation simulation(gas, run);
        simulation.record_collisions(true);
        Ways ways(simulation.box(), simulation.sample().position);
        const double duration = packing > 0.45 ? 120.0 : 450.0;
        const AdvanceResult advanced = simulation.advance_to(duration);
        for (const Collision& c : advanced.collisions) {
            ways.add(c.first, c.first_position);
            ways.add(c.second.particle(), c.second_position);
        }
        const Eigen::ArrayXXd& end = simulation.sample().position;
        for (std::int32_t i = 0; i < count; ++i) ways.add(i, vec_in(end, i));

        const double collisions = 2.0 * static_cast<double>(advanced.counts.particle);
        const double temperature =
            kinetic_energies(simulation.particles(), simulation.sample()).sum() / (count - 1);
        // The number of some 1e6 collisions fluctuates by 0.11 %, as 30 seeds showed; corrections
        // of 1/N are 0.05 %.
        CHECK(collisions / (count * duration) ==
              test::relative(test::collision_rate(packing, temperature), 0.005));
        CHECK(ways.total() / collisions == test::relative(test::mean_free_path(packing), 0.005));
    }
}

TEST_CASE("a hot disk gives a cold one (2/3) 4 m1 m2 / (m1 + m2)^2 of its energy on average") {
    // Aimed with evenly spaced offsets, which a gas makes equally likely, from all directions.
    constexpr int shots = 2000;
    for (const double mass : {0.01, 1.0, 8.0, 1e4}) {
        CAPTURE(mass);
        double given = 0.0;
        for (int k = 0; k < shots; ++k) {
            const double offset = -1.0 + (2.0 * k + 1.0) / shots;
            const double angle = 2.4 * k, nx = std::cos(angle), ny = std::sin(angle);
            Simulation pair = test::simulation_of(
                Box{2, {20.0, 20.0}, {}},
                {{10.0 - 3.0 * nx - offset * ny, 10.0 - 3.0 * ny + offset * nx, nx, ny},
                 {10.0, 10.0, 0.0, 0.0, 0.5, 1.0 / mass}});
            REQUIRE(pair.advance_to(3.1).counts.particle == 1);
            const Eigen::ArrayXd energies = kinetic_energies(pair.particles(), pair.sample());
            given += energies[1] / energies.sum() / shots;
        }
        // Of 1 - offset^2 the midpoint rule makes 2/3 + 1/(3 shots^2).
        const double expected = 8.0 / 3.0 * mass / ((1.0 + mass) * (1.0 + mass));
        CHECK(given == test::relative(expected, 1e-6));
    }
}

TEST_CASE("a gas of points presses as much as it has energy, over the area") {
    // Each point comes to each wall every 2 L / |v|, once more or less: 2 m |v| of doubt.
    Random random(1, "points");
    std::vector<test::Disk> points;
    for (int i = 0; i < 300; ++i)
        points.push_back({random.uniform(0.0, 7.0), random.uniform(0.0, 3.0), random.normal(),
                          random.normal(), 0.0, random.uniform(0.1, 10.0)});
    Simulation gas = test::simulation_of(Box{2, {7.0, 3.0}, {}}, points);
    const double energy = kinetic_energies(gas.particles(), gas.sample()).sum();
    const Eigen::Array2d momenta =
        (gas.sample().velocity.abs().colwise() / gas.particles().inverse_mass).colwise().sum();
    const double duration = 2000.0;
    const AdvanceResult advanced = gas.advance_to(duration);
    CHECK(advanced.counts.particle == 0);
    const std::array<double, 6>& wall = advanced.impulses.wall;
    const Vec size = gas.box().size;
    const double doubt = (momenta[0] * size[0] + momenta[1] * size[1]) / (2.0 * duration);
    CHECK(doubt < 2e-3 * energy);
    const double force_times_length =
        ((wall[0] + wall[1]) * size[0] + (wall[2] + wall[3]) * size[1]) / (2.0 * duration);
    CHECK(std::abs(0.5 * force_times_length - energy) < doubt);  // pressure times area
}

TEST_CASE("equal speeds relax as the Boltzmann equation says") {
    // Packing 0.01: dilute. The energy is fixed, so a2 of n disks has the standard error of their
    // mean v^4, which in equilibrium is sqrt(5 / n).
    const auto expected = [rows = test::reference_rows("relaxation_equal_speeds.csv")](double c) {
        std::size_t k = 1;
        while (k + 1 < rows.size() && std::stod(rows[k][0]) < c) ++k;
        const double c0 = std::stod(rows[k - 1][0]), c1 = std::stod(rows[k][0]);
        const double a0 = std::stod(rows[k - 1][1]), a1 = std::stod(rows[k][1]);
        return a0 + (a1 - a0) * (c - c0) / (c1 - c0);
    };
    constexpr int gases = 300;
    const std::vector<double> times{8.0, 25.0, 60.0, 120.0};
    std::vector<double> a2(times.size(), 0.0), c(times.size(), 0.0);
    for (std::uint64_t seed = 1; seed <= gases; ++seed) {
        Gas gas;
        gas.seed = seed;
        gas.box.size = {280.0, 280.0};
        gas.box.walls = {Wall::periodic, Wall::periodic};
        gas.species = {{.name = "", .count = 1000, .velocity = Speed{1.0}}};
        Simulation simulation(gas, Run{});
        for (std::size_t k = 0; k < times.size(); ++k) {
            c[k] += collisions_per_particle(simulation.advance_to(times[k]), 1000.0) / gases;
            const Eigen::ArrayXd v2 = speeds(simulation.sample()).square();
            a2[k] += (v2.square().mean() / (2.0 * v2.mean() * v2.mean()) - 1.0) / gases;
        }
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        CAPTURE(c[k]);
        CHECK(std::abs(a2[k] - expected(c[k])) < 4.0 * std::sqrt(5.0 / (gases * 1000.0)));
    }
    CHECK(c.back() > 3.0);
}

TEST_CASE("light and heavy disks end with the same mean energy") {
    Gas gas;
    gas.box.size = {40.0, 30.0};
    gas.species = {{.name = "light",
                    .count = 150,
                    .radius = 0.4,
                    .mass = ValueRule{1.0},
                    .velocity = Speed{3.0}},
                   {.name = "heavy", .count = 50, .radius = 0.8, .mass = ValueRule{8.0}}};
    Run run;
    run.equilibrate = 100.0;
    Simulation simulation(gas, run);
    double light = 0.0, heavy = 0.0;
    constexpr int samples = 300;
    for (int k = 1; k <= samples; ++k) {
        simulation.advance_to(4.0 * k);
        const Eigen::ArrayXd energies =
            kinetic_energies(simulation.particles(), simulation.sample());
        light += energies.head(150).mean() / samples;
        heavy += energies.tail(50).mean() / samples;
    }
    const double mean = 150.0 * 4.5 / 200.0;
    // standard errors: mean / sqrt(n samples) if samples were independent; allow for twice that
    CHECK(light == test::relative(mean, 8.0 / std::sqrt(150.0 * samples)));
    CHECK(heavy == test::relative(mean, 8.0 / std::sqrt(50.0 * samples)));
}
