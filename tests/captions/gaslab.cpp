// Claims of the scenes in scenes/gaslab.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "captions/claims.h"
#include "physics/theory/law.h"

namespace carom::test {

namespace {

// The pressure on all walls between two times is this, divided by the length of the walls.
Measure push(double from, double to) { return growth(from, to, wall_impulse()); }

// Given to the gas of isothermal-piston.
Reading heat_of_three_walls() {
    return {[](const Course& course, const Moment& moment) {
        double heat = 0.0;
        for (const int wall : {0, 2, 3}) heat += heat_of_surface(wall).of(course, moment);
        return heat;
    }};
}

// The temperature to which slow work brings the gas under the piston of a scene, from its start.
double adiabat_at(const Course& course, double height) {
    const BoxedGas gas(course.scene.gas.box, course.scene.run.events, course.particles,
                       course.moments.front().sample);
    return law(gas, LawOf::adiabat, {.surface = 3, .lengths = {height}}).temperatures.at(0);
}
Measure adiabat(double height) {
    return {[=](const Course& course) { return adiabat_at(course, height); }};
}
Reading by_adiabat() {
    return {[](const Course& course, const Moment& moment) {
        return temperature().of(course, moment) /
               adiabat_at(course, place_of_surface(3).of(course, moment));
    }};
}

std::vector<SceneClaims> claims_of_pistons() {
    const Measure coldest = at(0.0, temperature());
    return {
        {"adiabatic-piston",
         {{"The piston falls and heats the gas", highest(0, 68, temperature()) / coldest,
           much_more()},
          {"squeezed to two fifths of its room", (1.0 / 38.0) * lowest(0, 68, place_of_surface(3)),
           exactly(0.4, 0.05)},
          {"becomes three times as hot", highest(0, 68, temperature()) / coldest, about(3.0)},
          {"two fifths of its room left at the lowest",
           (1.0 / 38.0) * lowest(0, 68, place_of_surface(3)), exactly(0.4, 0.05)},
          {"as the adiabat of hard disks demands", at(30.4, by_adiabat()), about(1.0)},
          {"Then it rises again, and the gas cools", at(60, temperature()) / coldest, about(1.1)},
          {"gets back going up, nearly all of it", (1.0 / 38.0) * at(61, place_of_surface(3)),
           nearly_all_of(1.0)},
          {"It falls, and the gas becomes hot", highest(10, 31, temperature()) / coldest,
           much_more(), 10},
          {"The gas drives it up, and cools", at(55, temperature()) / at(31, temperature()),
           much_less(), 31},
          {"Hot and cold by work alone",
           highest(0, 58, temperature()) / lowest(58, 68, temperature()), much_more(), 58}}},
        {"isothermal-piston",
         {{"a little over twice the pressure",
           (224.0 / 160.0) * push(530, 590) / push(0, 30),
           {2.0, 2.5}},
          {"over twice the pressure",
           (224.0 / 160.0) * push(530, 590) / push(0, 30),
           {2.0, 2.5},
           530},
          {"to a little more than twice the pressure p of the start",
           (224.0 / 160.0) * push(530, 590) / push(0, 30),
           {2.0, 2.5}},
          {"The temperature stays near 1", mean(30, 530, temperature()), about(1.0)},
          {"The piston moves in slowly: it heats", mean(30, 530, temperature()), at_least(1.0), 30},
          {"the walls cool", growth(30, 530, heat_of_three_walls()), at_most(-0.1), 30},
          {"The temperature stays nearly the same", highest(280, 530, temperature()), at_most(1.2),
           280},
          {"one temperature", mean(530, 590, temperature()) / mean(0, 30, temperature()),
           about(1.0), 530},
          {"while three walls keep it at the temperature 1", mean(0, 590, temperature()),
           about(1.0)}}},
        {"moving-piston",
         {{"and the gas becomes hot; going up it makes them slower, and the gas cools",
           at(14, temperature()) / at(28, temperature()), much_more()},
          {"comes back almost to its first temperature",
           (at(14, temperature()) - at(28, temperature())) / (at(14, temperature()) - coldest),
           nearly_all_of(1.0)},
          {"The piston goes down, and the gas becomes hot", at(14, temperature()) / coldest,
           much_more(), 0},
          {"The piston goes up: the gas cools", at(28, temperature()) / at(14, temperature()),
           much_less(), 14},
          {"Almost as cold as at the start",
           (at(14, temperature()) - at(28, temperature())) / (at(14, temperature()) - coldest),
           nearly_all_of(1.0), 28},
          {"goes down to 16/44 of the room", (1.0 / 44.0) * lowest(0, 33, place_of_surface(3)),
           exactly(16.0 / 44.0, 0.005)},
          {"they would come from 50 to 137.5", coldest, exactly(50.0)},
          {"their adiabat leads to 162", adiabat(16), exactly(162.0, 0.5)},
          {"makes them a little hotter still", at(14, by_adiabat()), {1.0, 1.1}},
          {"Going down, the gas stays near the adiabat", highest(0, 14, by_adiabat()),
           about(1.0)}}},
    };
}

std::vector<SceneClaims> claims_of_two_sides() {
    const Which light = species("light"), heavy = species("heavy");
    const Measure hot = at(240, temperature(right_of(32))),
                  cold = at(240, temperature(left_of(32)));
    return {
        {"maxwells-demon",
         {{"Fast disks pass to the right, slow ones to the left: one side becomes hot", hot / cold,
           much_more()},
          {"400 disks at one temperature fill two chambers",
           at(0, temperature(right_of(32))) / at(0, temperature(left_of(32))), same_for(200, 200)},
          {"the right becomes hot and the left cold", hot / cold, much_more()},
          {"Both sides have the same temperature",
           at(0, temperature(right_of(32))) / at(0, temperature(left_of(32))), same_for(200, 200),
           0},
          {"Hot on the right, cold on the left",
           at(130, temperature(right_of(32))) / at(130, temperature(left_of(32))), much_more(),
           130},
          {"and no work was done", at(240, temperature()), exactly(1.0), 130},
          {"It was 1 everywhere", at(0, temperature(left_of(32))), exactly(1.0, 0.15)}}},
        {"second-law",
         {{"never gather there again", highest(5, 84, count(within(0, 0, 13, 13))), at_most(25)},
          {"in the end both halves hold about equally many", at(84, count(left_of(35))),
           half_of(100)},
          {"slow ones and fast ones",
           at(84, temperature(left_of(35))) / at(84, temperature(right_of(35))), same_for(50, 50)},
          {"All disks are in one corner", at(0, count(within(0, 0, 13, 13))), exactly(100), 0},
          {"They spread over the left half", at(2.5, count(right_of(13) && left_of(35))),
           at_least(50), 2.5},
          {"They pass through the opening into the right half",
           highest(10, 66, count(right_of(35))) - at(10, count(right_of(35))), at_least(20), 10},
          {"Equal numbers on both sides", at(66, count(left_of(35))), half_of(100), 66},
          {"they never gather again", highest(66, 84, count(within(0, 0, 13, 13))), at_most(25),
           66}}},
        {"two-gas",
         {{"with the same mean energy, and",
           mean(42, 54, mean_energy(light)) / mean(42, 54, mean_energy(heavy)), about(1.0)},
          {"each with 46 times the energy of a light one",
           at(0, mean_energy(heavy)) / at(0, mean_energy(light)), exactly(46.0, 0.5)},
          {"Light disks go to the right", at(54, count(light && right_of(36))),
           at_least(100.0 / 3.0)},
          {"In the end both gases fill both chambers", at(54, count(heavy && left_of(36))),
           half_of(217)},
          {"the light disks are the fastest", at(54, mean_speed(light)) / at(54, mean_speed(heavy)),
           much_more()},
          {"light and cold", at(0, count(light && left_of(36))), exactly(100), 0},
          {"heavy and hot", at(0, count(heavy && right_of(36))), exactly(217), 0},
          {"The light disks take up energy from the heavy ones",
           at(9, mean_energy(light)) / at(0, mean_energy(light)), much_more(), 9},
          {"Equal mean energies already", at(18, mean_energy(light)) / at(18, mean_energy(heavy)),
           same_for(100, 217), 18},
          {"the disks mix more slowly", at(18, count(light && left_of(36))), at_least(60), 18},
          {"Half of each gas on each side", at(42, count(light && left_of(36))), half_of(100), 42},
          {"on each side, with equal mean energies", at(42, count(heavy && left_of(36))),
           half_of(217), 42}}},
    };
}

// The temperatures of the upper and the lower half of the particles, of a box of this height.
Measure upper_by_lower(double from, double to, double height) {
    return mean(from, to, temperature(above(height))) / mean(from, to, temperature(below(height)));
}

std::vector<SceneClaims> claims_in_gravity() {
    const Which escaped = above(48), left = below(48);
    return {
        {"atmosphere",
         {{"200 disks begin in the lower two thirds", at(0, count(below(40))), exactly(200)},
          {"Most never come far", at(60, count(left)), at_least(100)},
          {"what stays has less energy for each disk",
           at(60, mean_energy(left)) / at(8, mean_energy(left)), at_most(0.95)},
          {"lies lower", at(60, mean_place(1, left)) / at(0, mean_place(1)), much_less()},
          {"ever fewer escape", growth(40, 60, count(escaped)) / growth(0, 20, count(escaped)),
           much_less()},
          {"Gravity pulls all disks down", at(1, mean_velocity(1)), at_most(-1.0), 0},
          {"What rises over the top does not come back",
           at(60, count(escaped)) - highest(8, 60, count(escaped)), exactly(0), 8},
          {"more than their share of energy",
           {[](const Course& course) {
               const Moment& end = course.at(35);
               const Eigen::ArrayXd height = end.sample.position.col(1);
               const Eigen::ArrayXd energy = 0.5 * speeds(end.sample).square() + 5.0 * height;
               const double all_above = (height > 48.0).select(energy, 0.0).sum();
               return all_above / energy.sum() /
                      (static_cast<double>((height > 48.0).count()) / 200.0);
           }},
           much_more(),
           35}}},
        {"gravity-box",
         {{"yet the temperature is the same everywhere", upper_by_lower(140, 300, 15),
           exactly(1.0, 0.05)},
          {"dense below and thin above", mean(10, 30, ratio(count(below(15)), count(above(45)))),
           much_more()},
          {"so that the temperature is the same at every height", upper_by_lower(140, 300, 15),
           exactly(1.0, 0.05)},
          {"All fall at first", at(1, mean_velocity(1)), at_most(-5.0), 0},
          // of the kinetic energy, 178 for each disk, less than a tenth is common to all
          {"The fall becomes disorder", highest(5, 12, mean_velocity(1)), at_most(5.9), 4},
          // (h - H / (exp(H / h) - 1)) for the height H = 60 and h = T / g, T = 178
          {"thin above, as the barometric law says", mean(16, 190, mean_place(1)), about(15.9), 16},
          {"The temperature is the same at every height", upper_by_lower(30, 300, 15),
           exactly(1.0, 0.05), 190}}},
    };
}

// The share of free paths between two collisions that are shorter than their mean.
Measure share_of_short_paths() {
    return {[](const Course& course) {
        std::vector<double> last(static_cast<std::size_t>(course.particles.count()), -1.0), paths;
        const auto end_path = [&](std::int32_t particle, const Vec& velocity, double time) {
            double& before = last[static_cast<std::size_t>(particle)];
            if (before >= 0.0) paths.push_back(length(velocity) * (time - before));
            before = time;
        };
        for (const Collision& c : course.collisions) {
            end_path(c.first, c.first_before, c.time);
            end_path(c.second.particle(), c.second_before, c.time);
        }
        double sum = 0.0;
        for (const double path : paths) sum += path;
        const double mean_path = sum / static_cast<double>(paths.size());
        return static_cast<double>(
                   std::ranges::count_if(paths, [&](double path) { return path < mean_path; })) /
               static_cast<double>(paths.size());
    }};
}

// Of the two disks of single-collision, at the end.
Measure product_of_velocities() {
    return {[](const Course& course) {
        const auto& v = course.moments.back().sample.velocity;
        return (v.row(0) * v.row(1)).sum();
    }};
}
Reading distance_of_both() {
    return {[](const Course&, const Moment& moment) {
        const auto& place = moment.sample.position;
        return std::sqrt((place.row(1) - place.row(0)).square().sum());
    }};
}

// The mean speed of the particles of circular-particles with less than the mean radius, by that of
// the others.
Measure speed_of_small_by_large() {
    return {[](const Course& course) {
        const Eigen::ArrayXd is_small = (course.particles.radius < 1.25).cast<double>();
        double small = 0.0, large = 0.0;
        for (const Moment& moment : course.moments) {
            const Eigen::ArrayXd speed = speeds(moment.sample);
            small += (is_small * speed).sum() / is_small.sum();
            large += ((1.0 - is_small) * speed).sum() / (1.0 - is_small).sum();
        }
        return small / large;
    }};
}

std::vector<SceneClaims> claims_of_boxes() {
    const Measure start = at(0, mean_speed());
    const Which middle = within(24, 12, 52, 38), edge = left_of(12);
    return {
        {"circular-particles",
         {{"All start at the same speed", at(0, fastest()), exactly(1.0), 0},
          {"Collisions make some slow and some fast", at(12, count(faster_than(1.6))), at_least(10),
           12},
          {"the small ones the fastest", speed_of_small_by_large(), much_more()},
          {"The small ones are the fastest", speed_of_small_by_large(), much_more(), 60},
          {"All are green at the start", at(0, fastest()), exactly(1.0)},
          {"until the histograms follow their equilibrium curves", equilibrium_chance(120),
           at_least(0.05)}}},
        {"free-gas",
         {{"most of its free paths are short", share_of_short_paths(), at_least(0.55)},
          {"soon grows in proportion to time",
           squared_displacement_until(40) / squared_displacement_until(20), about(2.0)},
          {"Many short paths, a few long ones", share_of_short_paths(), at_least(0.55), 14},
          {"as the square of time, as without collisions",
           squared_displacement(0.4) / squared_displacement(0.2), about(4.0)},
          {"then in proportion to time",
           squared_displacement_until(40) / squared_displacement_until(20), about(2.0)}}},
        {"gas-in-a-box",
         {{"Some become slow, some fast", at(40, count(faster_than(13.4))), at_least(10)},
          {"their total energy stays", at(40, mean_energy()), exactly(50.0)},
          {"all of them medium (green)", at(0, fastest()), exactly(10.0)},
          {"some become slow (blue) and some fast (red)", at(40, count(faster_than(13.4))),
           at_least(10)},
          {"the mean speed falls", at(40, mean_speed()) / start, at_most(0.95)},
          {"All have the same speed", at(0, fastest()), exactly(10.0), 0},
          {"Collisions make some slow and some fast", at(6, count(faster_than(13.7))), at_least(10),
           6},
          {"The mean speed has fallen", at(22, mean_speed()) / start, at_most(0.95), 22},
          {"the energy is the same", at(22, mean_energy()), exactly(50.0), 22},
          {"All began with an energy of 50", at(0, mean_energy()), exactly(50.0)}}},
        {"heat-box",
         {{"first the disks near them are fast, then all",
           mean(60, 70, temperature(edge)) / mean(60, 70, temperature(middle)), more()},
          {"Gas and walls have the temperature 1", at(0, temperature()), exactly(1.0), 0},
          {"The gas takes on the temperature of its walls", mean(130, 220, temperature()),
           about(4.0)},
          {"The gas takes on their temperature", mean(130, 220, temperature()), about(4.0), 130},
          {"and so does the gas", mean(320, 400, temperature()), about(1.0)},
          {"And so does the gas", mean(320, 400, temperature()), about(1.0), 320},
          {"it gives its heat back", growth(220, 320, heat_of_surface(0)), at_most(0.0), 320}}},
        {"pressure-box",
         {{"hit the walls twice as often", beside(at(40, wall_hits())) / at(40, wall_hits()),
           about(2.0)},
          {"twice as many hits", beside(at(40, wall_hits())) / at(40, wall_hits()), about(2.0)},
          {"the pressure is twice as high, or a little higher",
           beside(push(0, 40)) / push(0, 40),
           {2.0, 2.4}},
          {"twice the hits, twice the pressure", beside(push(0, 40)) / push(0, 40), about(2.0),
           12}}},
        {"single-collision",
         {{"collide off centre and separate at right angles", product_of_velocities(),
           exactly(0.0)},
          {"A disk comes towards an equal one at rest", at(0, mean_speed(species("at rest"))),
           exactly(0.0), 0},
          {"Contact comes when r² first falls to σ²", at(6.03, distance_of_both()),
           exactly(4.0, 0.03), 2.5},
          {"Velocities along the line of centres are exchanged", at(6.1, all_collisions()),
           exactly(1.0), 6.1},
          {"Equal disks separate at right angles", product_of_velocities(), exactly(0.0), 9}}},
    };
}

}  // namespace

std::vector<SceneClaims> claims_of_gaslab() {
    return joined(
        {claims_of_pistons(), claims_of_two_sides(), claims_in_gravity(), claims_of_boxes()});
}

TEST_CASE("scenes of GasLab show what their words claim") { check(claims_of_gaslab()); }

}  // namespace carom::test
