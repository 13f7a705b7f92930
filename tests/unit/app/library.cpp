// The library of scenes and templates: every scene has a description and makes a picture with every
// template, and is what it says it is.
#include "support/library.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "films/first_pass.h"
#include "films/render.h"
#include "films/words/letters.h"
#include "physics/theory/theory.h"
#include "scene/load.h"
#include "support/equilibrium.h"
#include "support/process.h"
#include "support/relative.h"
#include "support/resources.h"
#include "support/share_of_cases.h"
#include "support/test_root.h"
#include "util/files/atomic_file.h"

using namespace carom;
using test::relative;
namespace fs = std::filesystem;

namespace {

const fs::path root = carom::test::checkout();

Scene scene(const std::string& name, const Overrides& overrides = {}) {
    return load_scene(test::library_file(name), test::resources(), overrides);
}

void draw_to(const fs::path& picture, const Scene& loaded, double at) {
    Progress silent(Progress::Form::silent, "");
    Canvas canvas = draw_still(prepare(loaded, {}, silent), at, output_format("png"), silent);
    write_file(picture, canvas.file());
}

CollisionCounts collisions_in(const Scene& loaded) {
    Simulation simulation(loaded.gas, loaded.run);
    return simulation.advance_to(loaded.run.until).counts;
}

}  // namespace

TEST_CASE("every scene of the library says what is seen, and makes a picture") {
    const carom::test::TemporaryFolder folder;
    const std::vector<fs::path> files = test::library_files();
    CHECK(files.size() >= 45);
    const auto share = static_cast<std::size_t>(carom::test::every_nth(1, 4));
    for (std::size_t k = 0; k < files.size(); k += share) {
        const fs::path& file = files[k];
        CAPTURE(file.string());
        const Scene loaded =
            load_scene(file, test::resources(), {"film.size=[320, 180]", "film.fps=5"});
        CHECK(loaded.description.size() > 80);
        CHECK(loaded.subtitle.size() > 20);
        CHECK_NOTHROW(require_letters(loaded));
        const fs::path picture = folder.path() / (file.stem().string() + ".png");
        draw_to(picture, loaded, 0.3 * loaded.run.until);
        CHECK(carom::test::contents(picture).starts_with("\x89PNG"));
    }
}

TEST_CASE("every scene of the library tells editors where its schema is") {
    const std::string mark = "# yaml-language-server: $schema=";
    for (const fs::path& file : test::library_files()) {
        CAPTURE(file.string());
        const std::string text = carom::test::contents(file);
        const std::string line = text.substr(0, text.find('\n'));
        REQUIRE(line.starts_with(mark));
        // Relative to the scene, and there, so that it is found wherever the folder is.
        CHECK(fs::equivalent(file.parent_path() / line.substr(mark.size()),
                             root / "scenes/scene.schema.json"));
        CHECK(fs::path(line.substr(mark.size())).is_relative());
    }
}

TEST_CASE("scenes that say they come to equilibrium show the curve") {
    for (const std::string name :
         {"periodic-gas", "maxwell-boltzmann", "mixed-masses", "one-hot-particle", "slow-crowd",
          "circular-particles", "time-reversal", "bonkers", "bonkers-mixture"}) {
        CAPTURE(name);
        Scene loaded = scene(name);
        loaded.run.bits = bits_of_double;  // the start alone is looked at
        Simulation simulation(loaded.gas, loaded.run);
        CHECK(test::equilibrium(loaded.gas.box, simulation.particles(), simulation.sample())
                  .has_value());
    }
}

TEST_CASE("every template makes a picture of a plane and of a wire, in every theme") {
    const carom::test::TemporaryFolder folder;
    const std::vector<fs::path> files = test::yaml_files(root / "templates/films");
    CHECK(files.size() == 9);
    for (const fs::path& file : files)
        for (const std::string name : {"two-to-one", "cradle"})
            for (const std::string theme : {"light", "dark", "print"}) {
                CAPTURE(file.string() + ", " + name);
                const std::string panels = "[]";
                const Scene loaded =
                    scene(name, {"film.template=" + file.stem().string(), "film.panels=" + panels,
                                 "film.theme=" + theme, "film.fps=2", "film.size=[256, 256]"});
                const fs::path picture = folder.path() / "picture.png";
                draw_to(picture, loaded, 1.0);
                CHECK(carom::test::contents(picture).starts_with("\x89PNG"));
            }
}

// tests/reference/galperin.csv
TEST_CASE("a bead a hundred times as heavy gives 31 collisions, one of 10,000 times 314") {
    const CollisionCounts hundred = collisions_in(scene("pi-from-collisions"));
    CHECK(hundred.particle + hundred.wall == 31);
    const CollisionCounts more =
        collisions_in(scene("pi-from-collisions",
                            {"gas.1.mass=10000", "run.until=50", "box.length=90", "film.slow=[]"}));
    CHECK(more.particle + more.wall == 314);
}

TEST_CASE("two disks meet once, and the lighter one changes its velocity by twice as much") {
    const Scene loaded = scene("two-to-one");
    Simulation simulation(loaded.gas, loaded.run);
    simulation.advance_to(0.0);
    const Sample before = simulation.sample();
    const AdvanceResult advanced = simulation.advance_to(loaded.run.until);
    CHECK(advanced.counts.particle == 1);
    CHECK(advanced.counts.wall == 0);
    const Sample after = simulation.sample();
    for (const int axis : {0, 1}) {
        const double heavy = after.velocity(0, axis) - before.velocity(0, axis);
        const double light = after.velocity(1, axis) - before.velocity(1, axis);
        CHECK(std::abs(heavy) > 0.1);
        CHECK(light == relative(-2.0 * heavy, 1e-12));
    }
}

TEST_CASE("the hot particle is seen to fly, and gives its energy away blow by blow") {
    const Scene loaded = scene("one-hot-particle");
    Simulation simulation(loaded.gas, loaded.run);
    const auto hot = static_cast<std::int32_t>(simulation.particles().count() - 1);
    simulation.record_collisions(true);
    const AdvanceResult advanced = simulation.advance_to(0.8);
    std::vector<double> blows;
    for (const Collision& collision : advanced.collisions)
        if (collision.first == hot || collision.second == hot) blows.push_back(collision.time);
    REQUIRE(blows.size() >= 3);
    CHECK(blows[0] * 30.0 > 8.0 * 0.7);  // a way of eight radii at least, at speed 30
    const auto energy = [&] {
        return kinetic_energies(simulation.particles(), simulation.sample())[hot];
    };
    CHECK(energy() < 0.05 * 450.0);  // as the caption says from now on
    simulation.advance_to(1.5);
    CHECK(energy() < 0.01 * 450.0);  // as the figure says
}

TEST_CASE("the disks of the single collision meet once, off centre, and part at right angles") {
    const Scene loaded = scene("single-collision");
    Simulation simulation(loaded.gas, loaded.run);
    const AdvanceResult advanced = simulation.advance_to(loaded.run.until);
    CHECK(advanced.counts.particle == 1);
    CHECK(advanced.counts.wall == 0);
    const Eigen::ArrayXXd& velocity = simulation.sample().velocity;
    CHECK(std::abs((velocity.row(0) * velocity.row(1)).sum()) < 1e-14);
    CHECK(velocity.square().rowwise().sum().minCoeff() > 0.2);
}

TEST_CASE("equal beads keep their speeds for ever, as a set") {
    const Scene loaded = scene("equal-masses-in-one-dimension");
    Simulation simulation(loaded.gas, loaded.run);
    simulation.advance_to(0.0);
    const auto sorted_speeds = [&] {
        const Eigen::ArrayXd speed = speeds(simulation.sample());
        std::vector<double> sorted(speed.data(), speed.data() + speed.size());
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    };
    const std::vector<double> start = sorted_speeds();
    CHECK(simulation.advance_to(loaded.run.until).counts.particle > 100);
    CHECK(sorted_speeds() == start);
}

TEST_CASE("masses of the scenes by density are the squares that they say") {
    for (const auto& [name, of_radius] :
         {std::pair{"circular-particles", 2.0}, std::pair{"fifty-in-a-unit-box", 1.0}}) {
        const Scene loaded = scene(name);
        const Simulation simulation(loaded.gas, loaded.run);
        const Eigen::ArrayXd length = of_radius * simulation.particles().radius;
        CHECK((1.0 / simulation.particles().inverse_mass - length.square()).abs().maxCoeff() <
              1e-13);
    }
}

TEST_CASE("a hundred disks never overlap, and steps of a hundredth would have missed it") {
    const Scene loaded = scene("a-hundred-never-overlap");
    Simulation simulation(loaded.gas, loaded.run);
    const Eigen::ArrayXd& radius = simulation.particles().radius;
    const auto deepest = [&](const Sample& sample, double later) {
        double overlap = 0.0;
        for (Eigen::Index i = 0; i < radius.size(); ++i)
            for (Eigen::Index j = 0; j < i; ++j) {
                const double x = sample.position(i, 0) - sample.position(j, 0) +
                                 later * (sample.velocity(i, 0) - sample.velocity(j, 0));
                const double y = sample.position(i, 1) - sample.position(j, 1) +
                                 later * (sample.velocity(i, 1) - sample.velocity(j, 1));
                overlap = std::max(overlap, 1.0 - std::hypot(x, y) / (radius[i] + radius[j]));
            }
        return overlap;
    };
    double exact = 0.0, stepped = 0.0;
    for (int frame = 0; frame <= 100; ++frame) {
        simulation.advance_to(0.06 * frame);
        exact = std::max(exact, deepest(simulation.sample(), 0.0));
        stepped = std::max(stepped, deepest(simulation.sample(), 0.01));
    }
    CHECK(exact < 1e-12);
    CHECK(stepped > 0.2);
}

namespace {

// The mean kinetic energy of particles at a time, of those for which `is_meant` holds of their
// place along x.
double mean_energy(
    Simulation& simulation, double time,
    const std::function<bool(double)>& is_meant = [](double) { return true; }) {
    simulation.advance_to(time);
    const Eigen::ArrayXd energy = kinetic_energies(simulation.particles(), simulation.sample());
    double sum = 0.0, count = 0.0;
    for (Eigen::Index i = 0; i < energy.size(); ++i)
        if (is_meant(simulation.sample().position(i, 0))) sum += energy[i], count += 1.0;
    REQUIRE(count > 0.0);
    return sum / count;
}

Simulation started(const std::string& name, const Overrides& overrides = {}) {
    const Scene loaded = scene(name, overrides);
    return {loaded.gas, loaded.run};
}

}  // namespace

// As far as a mean over this many particles can tell: the margins are several standard errors.
TEST_CASE("a demon makes one side hot, and what effuses is hotter than what is left") {
    const auto right_of = [](double place) { return [=](double x) { return x > place; }; };
    const auto left_of = [](double place) { return [=](double x) { return x < place; }; };
    Simulation demon = started("maxwells-demon");
    CHECK(mean_energy(demon, 200.0, right_of(32.0)) > 2.0 * mean_energy(demon, 200.0, left_of(32)));
    Simulation slit = started("effusion");
    double passed = 0.0, stayed = 0.0;
    for (const double time : {100.0, 150.0, 200.0, 250.0}) {
        passed += mean_energy(slit, time, right_of(27.5)) / 4.0;
        stayed += mean_energy(slit, time, left_of(27.0)) / 4.0;
    }
    CHECK(passed > 1.2 * stayed);
}

TEST_CASE("pistons heat a gas by the work that they do, unless walls take the heat away") {
    Simulation driven = started("moving-piston");
    CHECK(mean_energy(driven, 14.0) > 2.8 * 50.0);  // slowly, 44/16 of the start, 137, and more
    CHECK(mean_energy(driven, 28.0) < 1.2 * 50.0);
    Simulation cooled = started("isothermal-piston");
    CHECK(mean_energy(cooled, 590.0) == relative(1.0, 0.25));
    Simulation falling = started("adiabatic-piston");
    CHECK(mean_energy(falling, 30.0) > 2.5 * 50.0);
    const double slow = mean_energy(*std::make_unique<Simulation>(started("jarzynski")), 92.0);
    const double fast =
        mean_energy(*std::make_unique<Simulation>(started(
                        "jarzynski", {"run.events.1.velocity=-1.333333333", "run.events.3.at=28"})),
                    92.0);
    // Without haste (4 + 1) / 2, as velocities along the stroke double; the share of these in the
    // energy of the start scatters by 1.5 sqrt(1 / 300). A wall at a third of the thermal speed
    // adds some hundredths.
    CHECK(slow > 2.5 - 3.0 * 0.087);
    CHECK(slow < 2.56 + 3.0 * 0.087);
    CHECK(fast > 1.3 * slow);
}

TEST_CASE("a light piston never rests, and is where theory says, give or take a sixth") {
    Simulation simulation = started("fluctuating-piston");
    double sum = 0.0, squares = 0.0;
    constexpr int samples = 3000;
    for (int i = 1; i <= samples; ++i) {
        const double place = simulation.advance_to(1.0 * i).surfaces.at(3).motion->place;
        sum += place;
        squares += place * place;
    }
    const double mean = sum / samples;
    // E = 16 + 2 * 18: a beta distribution with 17 and 16.5; some 60 swings, each 17 % off
    CHECK(mean == relative(26.0 * 17.0 / 33.5, 0.09));
    CHECK(std::sqrt(squares / samples - mean * mean) / mean == relative(1.0 / 6.0, 0.3));
}

TEST_CASE("what is above the top of the atmosphere has escaped for good") {
    const Scene loaded = scene("atmosphere");
    const double top = loaded.gas.box.surfaces.partitions.front().at;
    Simulation simulation(loaded.gas, loaded.run);
    Eigen::Index before = 0;
    for (double time = 0.0; time <= loaded.run.until; time += 5.0) {
        simulation.advance_to(time);
        const Eigen::Index above = (simulation.sample().position.col(1) > top).count();
        CHECK(above >= before);
        before = above;
    }
    CHECK(before > 10);
    CHECK(before < 100);
}

TEST_CASE("gases that mix come to one mean energy") {
    for (const auto& mixed : {std::pair{"two-gas", std::pair{100, 217}},
                              std::pair{"hot-and-cold-mix", std::pair{80, 80}}}) {
        const auto* const name = mixed.first;
        const auto counts = mixed.second;
        CAPTURE(name);
        Simulation simulation = started(name);
        const auto& species = simulation.particles().species;
        CHECK(std::ranges::count(species, 0) == counts.first);
        CHECK(std::ranges::count(species, 1) == counts.second);
        double first = 0.0, second = 0.0;
        const double until = scene(name).run.until;
        for (double share = 0.7; share <= 1.0; share += 0.05) {
            simulation.advance_to(share * until);
            const Eigen::ArrayXd energy =
                kinetic_energies(simulation.particles(), simulation.sample());
            first += energy.head(counts.first).mean();
            second += energy.tail(counts.second).mean();
        }
        CHECK(first == relative(second, 0.2));
    }
}
