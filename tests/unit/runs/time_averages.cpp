#include "stats/paths/time_averages.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "physics/mechanics.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

struct SlowMeans {
    std::vector<double> energy, speed;
    double temperature = 0.0;
};

// Means over very many moments, halfway between which velocities are taken.
SlowMeans slowly_averaged(const Scene& scene, int species, int moments) {
    Simulation simulation(scene.gas, scene.run);
    const Particles& particles = simulation.particles();
    SlowMeans sums{std::vector<double>(std::size_t(species)),
                   std::vector<double>(std::size_t(species))};
    std::vector<double> counts(sums.energy.size());
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        counts[std::size_t(particles.species[i])] += 1.0;
    for (int k = 0; k < moments; ++k) {
        simulation.advance_to(scene.run.until * (k + 0.5) / moments);
        const Sample& sample = simulation.sample();
        const Eigen::ArrayXd speed = speeds(sample), energy = kinetic_energies(particles, sample);
        for (Eigen::Index i = 0; i < particles.count(); ++i) {
            const auto of = std::size_t(particles.species[i]);
            sums.energy[of] += energy[i] / (counts[of] * moments);
            sums.speed[of] += speed[i] / (counts[of] * moments);
        }
        sums.temperature += thermal_motion(simulation.box(), particles, sample).temperature();
    }
    sums.temperature /= moments;
    return sums;
}

TimeAverages::Values exactly_averaged(const Scene& scene, int species,
                                      const std::vector<double>& times) {
    Simulation simulation(scene.gas, scene.run);
    simulation.record_collisions(true);
    TimeAverages averages(simulation.box(), simulation.particles(), species,
                          velocity_changes(scene.run));
    averages.see(simulation.sample(), {});
    for (const double time : times) {
        const AdvanceResult advanced = simulation.advance_to(time);
        Sample alone;
        alone.time = time;
        averages.see(averages.needs_samples() ? simulation.sample() : alone, advanced.collisions);
    }
    return averages.averages();
}

}  // namespace

TEST_CASE("averages over time are those of very many moments, however often samples are taken") {
    const std::string two =
        "gas: [{name: a, count: 12, radius: 0.4, temperature: 1}, {name: b, count: 2, radius: 1, "
        "mass: 9, speed: 1}]\n";
    for (const std::string& more : {std::string("box: {size: [20, 15]}\n"),
                                    std::string("box: {size: [20, 15], walls: periodic}\n"),
                                    std::string("box: {size: [20, 15]}\ngravity: [0, -0.3]\n")}) {
        CAPTURE(more);
        const Scene scene = test::scene_from("title: T\nrun: {until: 8}\n" + more + two);
        const TimeAverages::Values once = exactly_averaged(scene, 2, {8.0});
        std::vector<double> often;
        for (int k = 1; k <= 100; ++k) often.push_back(0.08 * k);
        const TimeAverages::Values many = exactly_averaged(scene, 2, often);
        constexpr int moments = 40'000;
        constexpr double error = 20.0 / moments;  // a collision moves by half of a step at most
        const SlowMeans slow = slowly_averaged(scene, 2, moments);
        for (std::size_t k = 0; k < 2; ++k) {
            CHECK(once.energy[k] == doctest::Approx(many.energy[k]).epsilon(1e-12));
            CHECK(once.speed[k] == doctest::Approx(many.speed[k]).epsilon(1e-12));
            CHECK(once.energy[k] == doctest::Approx(slow.energy[k]).epsilon(error));
            CHECK(once.speed[k] == doctest::Approx(slow.speed[k]).epsilon(error));
        }
        CHECK(once.temperature == doctest::Approx(many.temperature).epsilon(1e-12));
        CHECK(once.temperature == doctest::Approx(slow.temperature).epsilon(error));
    }
}

TEST_CASE("heat at a moment changes averages over time from then on") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 15]}\ngas: [{count: 6, radius: 0.4, speed: 1}]\n"
        "run: {until: 8, events: [{at: 2, heat: {by: 9}}]}\n");
    // 3 in all for 2 units of time, then 12 for 6: 9.75 of 6 particles with two directions each.
    const TimeAverages::Values found = exactly_averaged(scene, 1, {1.0, 2.0, 8.0});
    CHECK(found.energy[0] == doctest::Approx(9.75 / 6.0).epsilon(1e-12));
    CHECK(found.temperature == doctest::Approx(9.75 / 6.0).epsilon(1e-12));
}
