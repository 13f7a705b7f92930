// Claims of the scenes in the folder scenes itself.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "captions/claims.h"
#include "stats/entropy.h"

namespace carom::test {

namespace {

Measure number_of_collisions(double time) { return at(time, all_collisions()); }

Measure packing_at_start() {
    return {[](const Course& course) {
        const auto& size = course.scene.gas.box.size;
        return std::numbers::pi * course.particles.radius.square().sum() / (size[0] * size[1]);
    }};
}

// The largest overlap of two disks that collide, in units of their contact distance.
Measure largest_overlap() {
    return {[](const Course& course) { return course.moments.back().impulses.largest_overlap; }};
}

Measure return_digits() {
    return {[](const Course& course) { return -course.log10_return_distance; }};
}

std::vector<SceneClaims> claims_of_energy_shared() {
    const Which light = species("light"), heavy = species("heavy");
    const Which fast = species("the fast disk"), others = species("the 200 others");
    const Measure share = at(0, mean_energy(fast)) / (201 * at(0, mean_energy()));
    return {
        {"one-hot-particle",
         {{"until nearly all share it", at(12, count(faster_than(0.1))), nearly_all_of(201)},
          {"one is fast and has nearly all of the energy", share, nearly_all_of(1.0)},
          {"by time 0.7 the first has passed nearly all of its energy on",
           at(0.7, mean_energy(fast)) / at(0, mean_energy(fast)), at_most(1.0 / 8.0)},
          {"and by time 12 nearly all move", at(12, count(faster_than(0.1))), nearly_all_of(201)},
          {"come to lie along the curve of the equilibrium", equilibrium_chance(12),
           at_least(0.05)},
          {"One fast disk has nearly all of the energy", share, nearly_all_of(1.0), 0},
          {"It has passed nearly all of it on",
           at(0.7, mean_energy(fast)) / at(0, mean_energy(fast)), at_most(1.0 / 8.0), 0.7},
          {"Nearly all disks move now", at(9.5, count(faster_than(0.1))), nearly_all_of(201), 9.5},
          {"it has 99.9 % of the energy", share, exactly(0.999, 0.0005)},
          {"by time 1.5 it has passed nearly all of it on",
           at(1.5, mean_energy(fast)) / at(0, mean_energy(fast)), at_most(1.0 / 8.0)},
          {"The fast disk starts with an energy of 450", at(0, mean_energy(fast)), exactly(450)},
          {"stays near 2.24, the mean of all", at(12, mean_energy(others)), about(2.24)}}},
        {"slow-crowd",
         {{"480 disks move at speed 0.001", at(0, mean_speed(species("crowd"))), exactly(0.001)},
          {"until nearly the whole crowd shares the energy", at(8, count(faster_than(0.1))),
           nearly_all_of(481)},
          {"Struck disks strike others", at(0.7, count(faster_than(0.1))), at_least(20), 0.7},
          {"Nearly the whole crowd moves now", at(6.5, count(faster_than(0.1))), nearly_all_of(481),
           6.5},
          {"its energy is shared now",
           at(0.9, mean_energy(species("fast"))) / at(0, mean_energy(species("fast"))),
           at_most(1.0 / 8.0)}}},
        {"mixed-masses",
         {{"All start equally fast", at(0, fastest()), exactly(2.0)},
          {"in the end the light ones are fast and the heavy ones slow",
           at(75, mean_speed(light)) / at(75, mean_speed(heavy)), much_more()},
          {"with the same mean energy", at(75, mean_energy(light)) / at(75, mean_energy(heavy)),
           same_for(160, 30)},
          {"twelve times the energy of a light one",
           at(0, mean_energy(heavy)) / at(0, mean_energy(light)), exactly(12.0)},
          {"Collisions even out the mean energies",
           at(75, mean_energy(light)) / at(75, mean_energy(heavy)), same_for(160, 30)},
          {"with mean energies of 2 and 24", at(0, mean_energy(heavy)), exactly(24.0)},
          {"Collisions bring both to the mean of all, 5.47", at(75, mean_energy()),
           exactly(5.47, 0.005)},
          // the mean of the heavy ones over a time that their fluctuations last
          {"heavy disks are slow and light ones fast",
           mean(50, 75, mean_speed(light)) / mean(50, 75, mean_speed(heavy)), much_more()}}},
        {"maxwell-boltzmann",
         {{"a few collisions each spread the speeds over the whole curve", equilibrium_chance(12.3),
           at_least(0.05)},
          // faster than 2: 2000 exp(-4) in equilibrium; slower than 0.5: all but 2000 exp(-1/4)
          {"the tail fills last",
           (2000.0 - 2000.0 * std::exp(-0.25)) / (2000.0 * std::exp(-4.0)) *
               (at(2.5, count(faster_than(2))) /
                (at(2.5, count(all())) - at(2.5, count(faster_than(0.5))))),
           much_less()},
          {"the histogram of speeds is a single bar", at(0, fastest()), exactly(1.0)},
          {"After about six collisions each", at(12.3, collisions_each()), about(6.0)},
          {"the bars follow the Maxwell-Boltzmann curve", equilibrium_chance(12.3), at_least(0.05)},
          {"and stay there", equilibrium_chance(60), at_least(0.05)},
          {"after 29 collisions each", at(60, collisions_each()), exactly(29, 0.5)},
          {"after half a collision of each disk", at(1, collisions_each()), about(0.5)},
          {"at their mean energy", at(60, temperature()), exactly(0.5)},
          {"it is higher than that of an ideal gas",
           (160.0 * 120.0 / (2000.0 * 0.5) / 560.0) * growth(0, 60, wall_impulse()),
           at_least(1.02)}}},
    };
}

// The entropy of the positions in free-expansion, as its panel shows it.
Reading evenness() {
    return {[](const Course& course, const Moment& moment) {
        const PositionEntropy entropy(course.scene.gas.box, course.particles, {});
        return entropy.of(moment.sample.position);
    }};
}

std::vector<SceneClaims> claims_of_sides() {
    const Which left = left_of(32), right = right_of(32);
    const Reading hotter = ratio(temperature(left), temperature(right));
    const Which blue = species("blau"), yellow = species("gelb");
    const double even = std::sqrt(400.0);
    return {
        {"free-expansion",
         {{"no work is done, and the temperature stays the same", at(220, temperature()),
           exactly(1.0)},
          {"400 disks move on the left of a divider", at(0, count(left)), exactly(400)},
          {"the fastest disks cross first", at(12, hotter), much_less()},
          {"over to the right and back",
           (highest(60, 120, count(left)) - at(0, count(right))) /
               (highest(30, 60, count(right)) - at(0, count(right))),
           {0.9, 1.2}},
          {"until both halves hold as many disks", at(220, count(left)), half_of(400)},
          {"at one temperature.", at(220, hotter), same_for(200, 200)},
          {"the temperature is the same as before", at(220, temperature()), exactly(1.0)},
          {"nearly the logarithm of 2 for each disk",
           (1.0 / std::numbers::ln2) * (mean(180, 220, evenness()) - mean(0, 8, evenness())),
           {7.0 / 8.0, 1.0}},
          {"All disks are on the left", at(0, count(left)), exactly(400), 0},
          {"The fastest disks reach the far side first", at(16, hotter), much_less(), 16},
          {"The gas swings too far", at(48, count(right)), at_least(200 + even), 45},
          {"It swings back", at(85, count(left)), at_least(200 + even), 80},
          {"As many on either side", at(176, count(left)), half_of(400), 176},
          {"on either side, at the same temperature", at(176, hotter), same_for(200, 200), 176}}},
        {"durchmischung",
         {{"bis beide Gase überall gleich verteilt sind", at(640, count(blue && left)),
           half_of(200)},
          {"200 Scheiben links und 200 rechts", at(0, count(blue && left)), exactly(200)},
          {"Druck und Temperatur sind überall gleich", at(0, hotter), exactly(1.0)},
          {"Gleicher Druck, gleiche Temperatur", at(0, hotter), exactly(1.0), 0},
          {"Die Gase dringen langsam ineinander ein",
           at(70, count(yellow && left)),
           {10, half_of(200).least},
           70},
          {"Überall etwa gleich viele von beiden", at(540, count(blue && left)), half_of(200), 540},
          {"etwa gleich viele von beiden", at(540, count(yellow && left)), half_of(200), 540}}},
        {"heat-flow",
         {{"Disks leave the left wall fast and the right wall slowly",
           mean(60, 100, ratio(mean_speed(left_of(8)), mean_speed(right_of(56)))), much_more()},
          {"energy travels through the gas from one to the other",
           growth(60, 100, heat_of_surface(0)), at_least(0.5)},
          {"The disks crowd at the cold side",
           mean(60, 100, ratio(count(right_of(56)), count(left_of(8)))), much_more()},
          {"energy flows through the gas without end", growth(60, 100, heat_of_surface(1)),
           at_most(-0.5)},
          {"Few and fast on the left",
           mean(60, 100, ratio(temperature(left_of(8)), temperature(right_of(56)))), much_more(),
           60},
          {"many and slow on the right",
           mean(60, 100, ratio(count(right_of(56)), count(left_of(8)))), much_more(), 60}}},
        {"thin-air",
         {{"the temperature is the same at every height",
           mean(60, 240, temperature(above(11))) / mean(60, 240, temperature(below(11))),
           about(1.0)},
          // h - H / (exp(H / h) - 1) for the height H = 40 and h = T / g, T = 1.52
          {"as the barometric law says", mean(60, 240, mean_place(1)), about(13.45)},
          {"the temperature is the same below and above",
           mean(60, 240, temperature(above(11))) / mean(60, 240, temperature(below(11))),
           about(1.0)},
          {"At first the disks are everywhere, and fall", at(5, mean_velocity(1)), at_most(-0.1),
           0},
          {"Dense below, thin above: the barometric law", mean(40, 140, mean_place(1)),
           about(13.45), 40},
          {"One temperature at every height, but for chance",
           mean(60, 140, temperature(above(11))) / mean(60, 140, temperature(below(11))),
           about(1.0), 140}}},
        {"gas-under-a-weight",
         {{"until the pressure carries the weight",
           deviation(165, 250, place_of_surface(3)) / mean(165, 250, place_of_surface(3)),
           at_most(0.05)},
          {"which grows hotter", highest(0, 25, temperature()) / at(0, temperature()), much_more()},
          {"The swings become smaller",
           (highest(150, 250, place_of_surface(3)) - lowest(150, 250, place_of_surface(3))) /
               (highest(19, 119, place_of_surface(3)) - lowest(19, 119, place_of_surface(3))),
           much_less()},
          {"the lid only trembles",
           deviation(165, 250, place_of_surface(3)) / mean(165, 250, place_of_surface(3)),
           at_most(0.05)},
          {"A heavy lid falls on the gas", at(15, place_of_surface(3)) - at(0, place_of_surface(3)),
           at_most(-10.0), 0},
          {"The gas stops it, and both oscillate",
           highest(25, 60, place_of_surface(3)) - at(25, place_of_surface(3)), at_least(5.0), 25},
          // its momentum does not grow: the gas pushes as strongly as the force of 42
          {"The pressure of the gas carries the lid",
           highest(165, 250, place_of_surface(3)) - lowest(165, 250, place_of_surface(3)),
           at_most(5.0), 165}}},
    };
}

// -sum p ln p over square cells of velocities, of side 0.5.
Reading disorder_of_velocities() {
    return {[](const Course&, const Moment& moment) {
        const Eigen::ArrayXXi cells = (moment.sample.velocity / 0.5).round().cast<int>();
        std::map<std::pair<int, int>, double> counts;
        for (Eigen::Index i = 0; i < cells.rows(); ++i) counts[{cells(i, 0), cells(i, 1)}] += 1.0;
        double sum = 0.0;
        for (const auto& [cell, found] : counts) {
            const double share = found / static_cast<double>(cells.rows());
            sum -= share * std::log(share);
        }
        return sum;
    }};
}

std::vector<SceneClaims> claims_of_reversals() {
    // After so many collisions of each disk on the way back the disks are as far off as a radius.
    const Measure lost_after{[](const Course& course) {
        const double turn = course.scene.run.until / 2.0;
        for (const Moment& moment : course.moments)
            if (moment.sample.time > turn &&
                distance_between(2.0 * turn - moment.sample.time, moment.sample.time).of(course) >
                    0.05)
                return collisions_each().of(course, moment) -
                       collisions_each().of(course, course.at(turn));
        return 1e9;
    }};
    const Reading disorder = disorder_of_velocities();
    const Measure full = mean(20, 40, disorder);
    return {
        {"time-reversal",
         {{"the same laws bring it back", return_digits(), at_least(9.0)},
          {"After sixty collisions of each", at(95, collisions_each()), exactly(60, 0.5)},
          {"and the word reassembles", return_digits(), at_least(9.0)},
          {"it loses its way after a few collisions", beside(lost_after), at_most(15.0)},
          {"and the word never comes back", beside(distance_between(0, 190)), at_least(10.0)},
          {"The word is gone", distance_between(0, 30), at_least(10.0), 30},
          {"With enough digits each collision is undone in turn",
           number_of_collisions(190) - 2 * number_of_collisions(95), exactly(0), 160},
          {"fly apart through 7101 collisions", number_of_collisions(95), exactly(7101)},
          {"come back through the same 7101", number_of_collisions(190), exactly(2 * 7101)}}},
        {"nudged-reversal",
         {{"the word never comes back", distance_between(0, 190), at_least(10.0)},
          {"After sixty collisions of each", at(95, collisions_each()), exactly(60, 0.5)},
          {"for good after some seventeen collisions", lost_after, exactly(17, 1.5)},
          {"and the word does not come back", distance_between(0, 190), at_least(10.0), 160}}},
        {"reversal-precision",
         {{"After some eighty collisions of each", at(110, collisions_each()), about(80)},
          {"every collision is undone in turn",
           number_of_collisions(220) - 2 * number_of_collisions(110), exactly(0)},
          {"308 digits",
           {[](const Course& course) {
               return std::floor(course.scene.run.bits.value() * std::log10(2.0));
           }},
           exactly(308),
           0},
          {"The word comes back, with two hundred digits to spare",
           return_digits(),
           {190, 220},
           196}}},
        {"entropy-reversed",
         {{"they separate again", at(80, disorder) / at(0, disorder), exactly(1.0)},
          {"200 disks fly to the right and 200 to the left", at(0, mean_velocity(0)), exactly(0)},
          {"the entropy of the velocities rises to that of equilibrium", at(12, disorder) / full,
           about(1.0)},
          {"until two beams are left", at(80, disorder) / at(0, disorder), exactly(1.0)},
          {"Two beams, one to the right", at(0, fastest()), exactly(1.0), 0},
          {"the entropy has risen", at(12, disorder) / full, about(1.0), 12},
          // further than it fluctuates in equilibrium, from the first
          {"The entropy falls: the beams separate again",
           (full - at(74.2, disorder)) / deviation(20, 40, disorder), at_least(3.0), 74}}},
    };
}

std::vector<SceneClaims> claims_of_wires() {
    const Which lightest = species("lightest"), heaviest = species("heaviest");
    const Measure equal_energies =
        mean(0, 300, mean_energy(lightest)) / mean(0, 300, mean_energy(heaviest));
    const Measure thrice = mean(0, 300, mean_speed(lightest)) / mean(0, 300, mean_speed(heaviest));
    const Measure mass_decides =
        mean(0, 60, mean_speed(species("mass 1"))) / mean(0, 60, mean_speed(species("mass 10")));
    const Which six = species("six"), two = species("two");
    return {
        {"bonkers-mixture",
         {{"In the long run the lightest and the heaviest have equal mean energies", equal_energies,
           about(1.0)},
          {"the lightest is three times as fast", thrice, about(3.0)},
          {"become equal, so that the lightest is three times as fast", thrice, about(3.0)}}},
        {"bonkers",
         {{"in the long run, mass decides speed", mass_decides, much_more()},
          {"Collision by collision the light beads gain speed",
           mean(5, 60, mean_speed(species("light"))) / at(0, mean_speed(species("light"))),
           much_more()},
          {"is about three times as fast as the bead of mass 10", mass_decides, about(3.0)},
          {"The light bead's are wider", mass_decides, much_more()},
          {"Neither can pass the other",
           {[](const Course& course) {
               double nearest = 1e9;
               for (const Moment& moment : course.moments)
                   nearest = std::min(nearest,
                                      moment.sample.position(1, 0) - moment.sample.position(0, 0));
               return nearest;
           }},
           at_least(0.0)}}},
        {"cradle",
         {{"if all are equal, two leave at the other end", beside(at(20, count(faster_than(1.9)))),
           exactly(2)},
          {"all eight scatter", at(24, count(faster_than(0.3))), exactly(8)},
          {"just two beads leave at the far end", beside(at(20, mean_velocity(0, number(6)))),
           exactly(2.0)},
          {"which begin at rest", at(0, mean_energy(six)), exactly(0)},
          {"The first two move to the left at speed 2", at(0, mean_velocity(0, two)),
           exactly(-2.0)}}},
        {"equal-masses-in-one-dimension",
         {{"The eight speeds never change", at(60, mean_speed()) - at(0, mean_speed()), exactly(0)},
          {"the initial speeds are only passed on", at(60, fastest()) - at(0, fastest()),
           exactly(0)},
          {"Each of the eight speeds passes from bead to bead",
           at(60, mean_energy()) - at(0, mean_energy()), exactly(0)}}},
        {"tonks-gas",
         {{"so the pressure is 48/18 times", (48.0 / 6.0 / 2.0) * growth(0, 90, wall_impulse()),
           about(48.0 / 18.0)}}},
        {"pi-from-collisions",
         {{"There are 31 collisions in all", number_of_collisions(26), exactly(31)},
          {"there would be 314",
           with({"gas.1.mass=10000", "box.length=900", "run.until=800"}, number_of_collisions(800)),
           exactly(314)},
          {"There were 31 collisions", number_of_collisions(26), exactly(31)},
          {"16 of the two beads", at(26, collisions_each()), exactly(16)},
          {"The light one takes nearly all of the energy, 50",
           highest(0, 26, mean_energy(number(0))), nearly_all_of(50)},
          {"after 31 steps", number_of_collisions(26), exactly(31)}}},
    };
}

std::vector<SceneClaims> claims_of_collisions() {
    const Measure missed = beside(at(6, collisions_each())) / at(6, collisions_each());
    return {
        {"a-hundred-never-overlap",
         {{"fill more than a quarter of a square box", packing_at_start(), {0.25, 1.0 / 3.0}},
          {"many go further than half their radius",
           {[](const Course& course) {
               const Eigen::ArrayXd way = 0.01 * speeds(course.moments.front().sample);
               return static_cast<double>((way > 0.5 * course.particles.radius).count());
           }},
           at_least(30)},
          {"rings touch but never cross", largest_overlap(), at_most(1e-12)},
          {"They overlap, pass through one another", beside(largest_overlap()), at_least(0.5)},
          {"miss a third of the collisions", missed, exactly(2.0 / 3.0, 0.04)}}},
        {"fifty-in-a-unit-box",
         {{"Radii from 0.01 to 0.03",
           {[](const Course& course) { return course.particles.radius.mean(); }},
           about(0.02)},
          {"their speeds from 0.05 to 0.15", at(0, mean_speed()), about(0.1)},
          {"Rings touch when they collide and never cross", largest_overlap(), at_most(1e-12)}}},
        {"periodic-gas",
         {{"One disk starts at rest", at(0, mean_speed(species("traced"))), exactly(0)},
          {"No wall takes momentum from the gas",
           at(60, mean_velocity(0)) - at(0, mean_velocity(0)), exactly(0)}}},
        {"two-to-one",
         {{"that of the light disk by twice as much",
           (at(7.6, mean_velocity(0, number(1))) - at(0, mean_velocity(0, number(1)))) /
               (at(7.6, mean_velocity(0, number(0))) - at(0, mean_velocity(0, number(0)))),
           exactly(-2.0)},
          {"collide once", at(7.6, collisions_each()), exactly(1)},
          {"changes by twice as much",
           (at(7.6, mean_velocity(1, number(1))) - at(0, mean_velocity(1, number(1)))) /
               (at(7.6, mean_velocity(1, number(0))) - at(0, mean_velocity(1, number(0)))),
           exactly(-2.0)}}},
    };
}

}  // namespace

std::vector<SceneClaims> claims_of_others() {
    std::vector<SceneClaims> table;
    for (const auto& part : {claims_of_energy_shared(), claims_of_sides(), claims_of_reversals(),
                             claims_of_wires(), claims_of_collisions()})
        table.insert(table.end(), part.begin(), part.end());
    return table;
}

TEST_CASE("the other scenes show what their words claim") { check(claims_of_others()); }

}  // namespace carom::test
