// What the instruments of a scene read at the end of its run, and what their numbers are called.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "physics/mechanics.h"
#include "runs/run.h"
#include "runs/run_numbers.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

const std::string gas =
    "title: T\nbox: {size: [30, 20]}\ngas: [{name: hot, count: 1, radius: 0.5, speed: 5}, "
    "{name: cold, count: 40, radius: 0.5, temperature: 0.2}]\nrun: {until: 12}\n";

Scene scene_that(const std::string& measures) {
    return test::scene_from(gas + "measure: " + measures + "\n", {}, Wanted::physics);
}

std::map<std::string, double> readings_of(const RunReport& report) {
    std::map<std::string, double> all;
    for (const LastReading& one : report.readings) all[one.number.name] = one.value;
    return all;
}

std::vector<std::string> names_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const RunNumber& number : numbers_of_runs(scene)) names.push_back(number.name);
    return names;
}

std::string message_of(const std::string& measures) {
    try {
        numbers_of_runs(scene_that(measures));
    } catch (const SceneError& error) {
        return error.diagnostics().front().message;
    }
    return "";
}

}  // namespace

TEST_CASE("instruments read what the last sample and all collisions say") {
    std::vector<double> speed, energy, place, way(41), since(41);
    std::vector<bool> is_hot;
    double collisions = 0.0;
    const auto take_samples = [&](const Particles& particles, const Sample& sample,
                                  const std::vector<SurfaceState>&) {
        const Eigen::ArrayXd its = speeds(sample), kinetic = kinetic_energies(particles, sample);
        speed.assign(its.begin(), its.end());
        energy.assign(kinetic.begin(), kinetic.end());
        place.assign(sample.position.col(0).begin(), sample.position.col(0).end());
    };
    const auto add_way = [&](std::size_t particle, const Vec& velocity, double until) {
        way[particle] += length(velocity) * (until - since[particle]);
        since[particle] = until;
    };
    const auto take_collisions = [&](const Particles&, std::span<const Collision> all) {
        for (const Collision& one : all) {
            add_way(std::size_t(one.first), one.first_before, one.time);
            if (!one.second.is_particle()) continue;
            add_way(std::size_t(one.second.particle()), one.second_before, one.time);
            collisions += 2.0;
        }
    };
    const RunReport report = run_physics(
        scene_that(
            "[{kind: particle-speed, of: [3, hot]}, {kind: halves, title: part}, mean-free-path]"),
        {.sample = take_samples, .collisions = take_collisions});
    const auto found = readings_of(report);
    CHECK(found.at("speed at the end (particle 3)") == speed[3]);
    CHECK(found.at("speed at the end (hot)") == speed[0]);
    double left = 0.0, right = 0.0, all = 0.0;
    for (std::size_t i = 0; i < 41; ++i) {
        (place[i] < 15.0 ? left : right) += energy[i];
        all += way[i] + speed[i] * (12.0 - since[i]);
    }
    const double rounding = 1e-12;
    CHECK(found.at("part (left half)") == doctest::Approx(left).epsilon(rounding));
    CHECK(found.at("part (right half)") == doctest::Approx(right).epsilon(rounding));
    REQUIRE(collisions > 40.0);
    CHECK(found.at("mean free path at the end") ==
          doctest::Approx(all / collisions).epsilon(rounding));
}

TEST_CASE("instruments do not change the run") {
    const RunReport plain = run_physics(test::scene_from(gas));
    const RunReport measured = run_physics(scene_that("[mean-free-path, particle-speed]"));
    CHECK(measured.state == plain.state);
    CHECK(measured.summary.temperature == plain.summary.temperature);
    CHECK(plain.readings.empty());
}

TEST_CASE("readings follow the other numbers of a run, under the same names") {
    const Scene scene = scene_that("[temperature, {kind: particle-speed, of: hot, title: v}]");
    const std::vector<std::string> names = names_of(scene);
    const std::size_t plain = names_of(test::scene_from(gas)).size();
    REQUIRE(names.size() == plain + 2);
    CHECK(names[plain] == "temperature at the end");
    CHECK(names[plain + 1] == "v");
    const RunReport report = run_physics(scene);
    const std::vector<double> values = values_of(scene, report);
    REQUIRE(values.size() == names.size());
    CHECK(values[plain] == report.readings[0].value);
    CHECK(values[plain + 1] == report.readings[1].value);
}

TEST_CASE("instruments whose numbers cannot be told apart are refused") {
    CHECK(message_of("[temperature, {kind: temperature, over: start}]") ==
          "another number is called `temperature at the end`, too");
    CHECK(message_of("[{kind: particle-speed, title: mean speed}]") ==
          "another number is called `mean speed`, too");
    CHECK(message_of("[temperature, {kind: temperature, over: start, title: mean}]").empty());
}

TEST_CASE("theory is no reading") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 20]}\ngas: [{count: 50, radius: 0.2, temperature: 1}]\n"
        "run: {until: 10}\nmeasure: [{kind: flux, line: {x: 10}}]\n");
    const RunReport report = run_physics(scene);
    REQUIRE(report.readings.size() == 2);
    CHECK(report.readings[0].number.name == "crossing rate at the end (to the right)");
}

TEST_CASE("instruments give the numbers that curves are summed up in, where the gas has them") {
    const Scene open = test::scene_from(
        "title: T\nbox: {size: [30, 20], walls: periodic}\ngas: [{name: a, count: 60, radius: 0.5, "
        "temperature: 1}]\nrun: {until: 600}\nmeasure: [free-path, free-time, {kind: "
        "mean-squared-displacement, origins: all, lags: 40}, mean-free-path]\n");
    const RunReport report = run_physics(open);
    const auto found = readings_of(report);
    CHECK(found.at("mean length of free flights") ==
          doctest::Approx(found.at("mean free path at the end")).epsilon(1e-9));
    CHECK(found.at("mean length of free flights") / found.at("mean time of free flights") ==
          doctest::Approx(report.summary.species[0].speed.value()).epsilon(1e-9));
    // Chapman and Enskog for hard disks; the error is that of groups of particles. The first Sonine
    // approximation, taken here, is 2.7 % too small for a dilute gas (docs/validation.md), and the
    // slow decay of the velocity correlation in a plane adds to that: 10 % are left to both.
    const LastReading& diffusion = report.readings.at(2);
    CHECK(diffusion.number.name == "diffusion coefficient");
    REQUIRE(diffusion.error > 0.0);
    const double density = 60.0 / 600.0, packing = density * std::numbers::pi / 4.0;
    const double contact = (1.0 - 7.0 / 16.0 * packing) / ((1.0 - packing) * (1.0 - packing));
    const double kinetic = std::sqrt(report.summary.temperature.value() / std::numbers::pi) /
                           (2.0 * density * contact);
    CHECK(std::abs(diffusion.value - kinetic) < 4.0 * diffusion.error + 0.1 * kinetic);

    const Scene closed = test::scene_from(
        "title: T\nbox: {size: [30, 20]}\ngas: [{name: a, count: 20, radius: 0.5, temperature: 1}, "
        "{name: b, count: 20, radius: 0.5, temperature: 1}]\nrun: {until: 200}\nmeasure: [{kind: "
        "mean-squared-displacement, of: [a, b]}, {kind: free-path, of: [a, b], title: L}]\n");
    const RunReport bounded = run_physics(closed);
    std::vector<std::string> names;
    for (const LastReading& reading : bounded.readings) names.push_back(reading.number.name);
    CHECK(names == std::vector<std::string>{"mean squared displacement at the end (a)",
                                            "mean squared displacement at the end (b)",
                                            "diffusion coefficient (a)",
                                            "diffusion coefficient (b)", "L (a)", "L (b)"});
    CHECK(std::isnan(bounded.readings.at(2).value));  // walls end the diffusion
    CHECK(bounded.readings.at(4).value > 0.0);
}

TEST_CASE("the error of a mean free path is the scatter of runs with other seeds") {
    constexpr int seeds = 24;
    std::vector<double> means, errors;
    for (int seed = 1; seed <= seeds; ++seed) {
        const Scene scene = test::scene_from(
            "title: T\nbox: {size: [30, 20], walls: periodic}\ngas: [{count: 60, radius: 0.5, "
            "temperature: 1}]\nrun: {until: 60}\nmeasure: [free-path]\nseed: " +
            std::to_string(seed) + "\n");
        const LastReading reading = run_physics(scene).readings.front();
        means.push_back(reading.value);
        if (std::isfinite(reading.error)) errors.push_back(reading.error);
    }
    REQUIRE(errors.size() > seeds / 2);  // the pieces of some runs seem to depend on each other
    double mean = 0.0, squares = 0.0, error = 0.0;
    for (const double one : means) mean += one / seeds;
    for (const double one : means) squares += (one - mean) * (one - mean) / (seeds - 1);
    for (const double one : errors) error += one * one / static_cast<double>(errors.size());
    // A variance of 24 values scatters by sqrt(2 / 23), that of 20 pairs in each by less: the
    // logarithm of the ratio of the deviations by 0.16, of which four are allowed.
    CHECK(std::abs(0.5 * std::log(error / squares)) < 4.0 * 0.16);
}
