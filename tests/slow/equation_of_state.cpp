// Pressure and collision rate of the fluid of hard disks against the best that is known of them.
#include "support/equation_of_state.h"

#include <doctest/doctest.h>

#include <cmath>

#include "physics/simulation.h"
#include "support/blocks.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

constexpr int blocks = 20;

struct Measured {
    test::Estimate z;     // P A / (N T), from the virial of the collisions
    test::Estimate rate;  // collisions of one disk per unit of time
    double temperature;   // of the centre-of-mass frame: 2N - 2 degrees of freedom
};

Measured measure(double packing, int count, double melt, double duration) {
    Run run;
    run.equilibrate = melt;
    Simulation simulation(test::equal_disks(packing, count), run);
    Measured m{};
    m.temperature =
        kinetic_energies(simulation.particles(), simulation.sample()).sum() / (count - 1);
    Eigen::ArrayXd z(blocks), rate(blocks);
    AdvanceResult before{};
    for (int k = 0; k < blocks; ++k) {
        const AdvanceResult now = simulation.advance_to((k + 1) * duration / blocks);
        const double per_disk = blocks / (duration * count);
        z[k] =
            1.0 + (now.impulses.virial - before.impulses.virial) * per_disk / (2.0 * m.temperature);
        rate[k] =
            2.0 * static_cast<double>(now.counts.particle - before.counts.particle) * per_disk;
        before = now;
    }
    m.z = test::estimate(z);
    m.rate = test::estimate(rate);
    return m;
}

}  // namespace

TEST_CASE("the pressure is that of Kolafa and Rottner from dilute to the edge of freezing") {
    struct Case {
        double packing, melt, duration;
    };
    // The denser, the longer a disturbance lasts: at 0.69 it takes tens of units of time.
    for (const auto& [packing, melt, duration] : {Case{0.2, 50.0, 1200.0},
                                                  {0.4, 50.0, 600.0},
                                                  {0.6, 100.0, 400.0},
                                                  {0.69, 400.0, 1500.0}}) {
        CAPTURE(packing);
        constexpr int count = 2500;
        const Measured m = measure(packing, count, melt, duration);
        const double expected = 1.0 + test::excess_compressibility(packing);
        CAPTURE(m.z.mean / expected);
        // Three standard errors; and corrections of some 1/N, with the blocks' memory of each
        // other: 0.5 % at most.
        CHECK(m.z.error < 0.0013 * expected);
        CHECK(std::abs(m.z.mean - expected) < 3.0 * m.z.error + 0.001 * expected);
    }
}

TEST_CASE("at packing 0.20 disks collide at Enskog's rate, none is lost at the border of a cell") {
    // 6e6 collisions; a box of some hundred cells in each direction, and corrections of 1e-4 (1/N).
    const Measured m = measure(0.2, 10'000, 100.0, 1000.0);
    const double expected = test::collision_rate(0.2, m.temperature);
    CAPTURE(m.rate.mean / expected);
    CHECK(m.rate.error < 0.001 * expected);
    CHECK(std::abs(m.rate.mean - expected) < 0.003 * expected);
}
