// Claims of the scenes in the folder scenes itself that show beads on a wire, or single collisions.
#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "captions/claims.h"

namespace carom::test {

namespace {

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
         {{"In the long run the lightest bead is three times as fast", thrice, about(3.0)},
          {"the heaviest and the lightest bead become equal", equal_energies, about(1.0)},
          {"The lightest is three times as fast as the heaviest", thrice, about(3.0), 120},
          {"become equal, so that the lightest is three times as fast", thrice, about(3.0)}}},
        {"bonkers",
         {{"In the long run light beads are fast", mass_decides, much_more()},
          {"Four heavy beads move right", at(0, mean_velocity(0, species("heavy"))), at_least(1.0),
           0},
          {"four light ones left", at(0, mean_velocity(0, species("light"))), at_most(-0.1), 0},
          {"The light beads gain speed",
           mean(5, 60, mean_speed(species("light"))) / at(0, mean_speed(species("light"))),
           much_more(), 5},
          {"Mass 1 is three times as fast as mass 10", mass_decides, about(3.0), 35},
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
         {{"Two equal beads drive two out", beside(at(20, count(faster_than(1.9)))), exactly(2)},
          {"two heavy beads scatter all", at(24, count(faster_than(0.3))), exactly(8)},
          {"Two beads fly to the wall on the left", at(0, mean_velocity(0, two)), exactly(-2.0), 0},
          {"and come back", at(14, mean_velocity(0, two)), at_least(0.5), 0},
          {"They strike six beads at rest", at(14, mean_energy(six)), exactly(0), 14},
          {"Equal beads: two leave", beside(at(21, count(faster_than(1.9)))), exactly(2), 21},
          {"Two heavy beads: all scatter", at(24, count(faster_than(0.3))), exactly(8), 21},
          {"all eight scatter", at(24, count(faster_than(0.3))), exactly(8)},
          {"just two beads leave at the far end", beside(at(20, mean_velocity(0, number(6)))),
           exactly(2.0)},
          {"which begin at rest", at(0, mean_energy(six)), exactly(0)},
          {"The first two move to the left at speed 2", at(0, mean_velocity(0, two)),
           exactly(-2.0)}}},
        {"equal-masses-in-one-dimension",
         {{"The eight speeds are still the same", at(35, mean_speed()) - at(0, mean_speed()),
           exactly(0), 35},
          {"The eight speeds never change", at(60, mean_speed()) - at(0, mean_speed()), exactly(0)},
          {"The speeds are only passed on", at(60, fastest()) - at(0, fastest()), exactly(0)},
          {"Each of the eight speeds passes from bead to bead",
           at(60, mean_energy()) - at(0, mean_energy()), exactly(0)}}},
        {"tonks-gas",
         {{"Only 18 of the 48 units of length are free",
           {[](const Course& course) { return 48.0 - 2.0 * course.particles.radius.sum(); }},
           exactly(18),
           0},
          {"The pressure is 48/18 times that of points",
           (48.0 / 6.0 / 2.0) * growth(0, 90, wall_impulse()), about(48.0 / 18.0), 60},
          {"raises the pressure", (48.0 / 6.0 / 2.0) * growth(0, 90, wall_impulse()), much_more()},
          {"so the pressure is 48/18 times", (48.0 / 6.0 / 2.0) * growth(0, 90, wall_impulse()),
           about(48.0 / 18.0)}}},
        {"pi-from-collisions",
         {{"There are 31 collisions in all", at(20, all_collisions()), exactly(31)},
          {"there would be 314",
           with({"gas.1.mass=10000", "box.length=900", "run.until=800", "film.slow=[]"},
                at(800, all_collisions())),
           exactly(314)},
          {"There were 31 collisions", at(20, all_collisions()), exactly(31)},
          {"A heavy bead approaches", at(0, mean_velocity(0, number(1))), exactly(-1.0), 0},
          {"faster and faster", at(8, mean_speed(number(0))) / at(5.5, mean_speed(number(0))),
           much_more(), 5.5},
          {"The heavy bead has turned back", at(8.1, mean_velocity(0, number(1))), at_least(0.1),
           8.1},
          {"the light one slows down",
           at(12, mean_speed(number(0))) / at(8.1, mean_speed(number(0))), much_less(), 8.1},
          {"31 collisions: 3.1.", at(15.8, all_collisions()), exactly(31), 15.8},
          {"With mass 10 000 there are 314",
           with({"gas.1.mass=10000", "box.length=900", "run.until=800", "film.slow=[]"},
                at(800, all_collisions())),
           exactly(314), 15.8},
          {"16 of the two beads", at(20, collisions_each()), exactly(16)},
          {"The light one takes nearly all of the energy, 50",
           highest(0, 20, mean_energy(number(0))), nearly_all_of(50)},
          {"after 31 steps", at(20, all_collisions()), exactly(31)}}},
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
          {"Left: they touch but never cross", largest_overlap(), at_most(1e-12), 1.5},
          {"Right: they overlap", beside(largest_overlap()), at_least(0.5), 1.5},
          {"Fixed time steps miss a third of the collisions", missed, exactly(2.0 / 3.0, 0.04), 4},
          {"and miss a third of the collisions", missed, exactly(2.0 / 3.0, 0.04)}}},
        {"fifty-in-a-unit-box",
         {{"Masses equal to the radius squared",
           {[](const Course& course) {
               const Particles& p = course.particles;
               return (p.inverse_mass * p.radius.square() - 1.0).abs().maxCoeff();
           }},
           exactly(0),
           0},
          {"Rings touch but never cross", largest_overlap(), at_most(1e-12), 20},
          {"Radii from 0.01 to 0.03, and masses",
           {[](const Course& course) { return course.particles.radius.mean(); }},
           about(0.02)},
          {"their speeds from 0.05 to 0.15", at(0, mean_speed()), about(0.1)},
          {"Rings touch when they collide and never cross", largest_overlap(), at_most(1e-12)}}},
        {"periodic-gas",
         {{"The orange disk starts at rest", at(0, mean_speed(species("traced"))), exactly(0), 0},
          {"Others hit it, and it moves", at(6, mean_speed(species("traced"))), at_least(0.1), 6},
          {"One disk starts at rest", at(0, mean_speed(species("traced"))), exactly(0)},
          {"No wall takes momentum from the gas",
           at(60, mean_velocity(0)) - at(0, mean_velocity(0)), exactly(0)}}},
        {"two-to-one",
         {{"The velocity of the light disk changes by twice as much",
           (at(7.6, mean_velocity(0, number(1))) - at(0, mean_velocity(0, number(1)))) /
               (at(7.6, mean_velocity(0, number(0))) - at(0, mean_velocity(0, number(0)))),
           exactly(-2.0)},
          {"collide once", at(7.6, collisions_each()), exactly(1)},
          {"of the lighter one changes by twice as much",
           (at(7.6, mean_velocity(1, number(1))) - at(0, mean_velocity(1, number(1)))) /
               (at(7.6, mean_velocity(1, number(0))) - at(0, mean_velocity(1, number(0)))),
           exactly(-2.0)},
          {"A disk of mass 2 meets one of mass 1", at(0, mean_energy(number(1))),
           exactly(0.5 * 1.01), 0},
          {"The light disk's velocity changes by twice as much",
           (at(7.6, mean_velocity(0, number(1))) - at(3.5, mean_velocity(0, number(1)))) /
               (at(7.6, mean_velocity(0, number(0))) - at(3.5, mean_velocity(0, number(0)))),
           exactly(-2.0), 3.9}}},
    };
}

}  // namespace

std::vector<SceneClaims> claims_of_beads() {
    return joined({claims_of_wires(), claims_of_collisions()});
}

TEST_CASE("scenes of beads and single collisions show what their words claim") {
    check(claims_of_beads());
}

}  // namespace carom::test
