// Claims of the scenes in scenes/space.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "captions/claims.h"
#include "stats/pairs/bond_order.h"

namespace carom::test {

namespace {

Measure share_of_volume() {
    return {[](const Course& course) {
        const auto& size = course.scene.gas.box.size;
        return 4.0 / 3.0 * std::numbers::pi * course.particles.radius.cube().sum() /
               (size[0] * size[1] * size[2]);
    }};
}

// Steinhardt's order of the whole gas.
Measure order(double time) {
    return {[=](const Course& course) {
        return global_order(
            bond_order(course.scene.gas.box, course.particles, course.at(time).sample.position));
    }};
}

// The packing at the time at which the order of the whole gas is half of that at the end.
Measure packing_when_half_in_order() {
    return {[](const Course& course) {
        const double half = 0.5 * order(course.scene.run.until).of(course);
        const auto moment = std::ranges::find_if(course.moments, [&](const Moment& one) {
            return order(one.sample.time).of(course) > half;
        });
        const double room = place_of_surface(1).of(course, *moment) / course.scene.gas.box.size[0];
        return share_of_volume().of(course) / room;
    }};
}

// The share of the spheres that lie in layers along x, between the two that touch the walls: in
// intervals of 0.3 diameters about equidistant places, as many as close-packed planes have room.
Measure share_in_layers(double time) {
    return {[=](const Course& course) {
        const Eigen::ArrayXd x = course.at(time).sample.position.col(0);
        const double first = x.minCoeff(), across = x.maxCoeff() - first;
        const double apart = across / std::round(across / 0.886);
        const Eigen::ArrayXd places = (x - first) / apart;
        return ((places - places.round()).abs() < 0.15 / apart).cast<double>().mean();
    }};
}

// The number of spheres whose speed along x lies from `low` to `low` + 0.2 at the start.
Measure number_along_x(double low) {
    return {[=](const Course& course) {
        const Eigen::ArrayXd speed = course.at(0).sample.velocity.col(0).abs();
        return static_cast<double>((speed >= low && speed < low + 0.2).count());
    }};
}

// The share of the spheres that are slow, below 0.3, in their motion along these axes.
Measure share_of_slow(double time, const std::vector<int>& axes) {
    return {[=](const Course& course) {
        const Eigen::ArrayXXd& velocity = course.at(time).sample.velocity;
        return (velocity(Eigen::all, axes).square().rowwise().sum() < 0.09).cast<double>().mean();
    }};
}

std::vector<SceneClaims> claims_of_speeds() {
    const Which fast = species("the fast sphere"), light = species("light"),
                heavy = species("heavy");
    const Measure share = {[=](const Course& course) {
        return at(0, mean_energy(fast)).of(course) / (201.0 * at(0, mean_energy()).of(course));
    }};
    const Measure left_over = at(1.5, mean_energy(fast)) / at(0, mean_energy(fast));
    const Measure same = at(90, mean_energy(light)) / at(90, mean_energy(heavy));
    const Measure twelve = at(0, mean_energy(heavy)) / at(0, mean_energy(light));
    // 2000 spheres in fifths of the speeds up to 1: 400 in each, to three standard deviations.
    const Bounds a_fifth{400.0 - 3.0 * std::sqrt(320.0), 400.0 + 3.0 * std::sqrt(320.0)};
    return {
        {"one-fast-sphere",
         {{"until nearly all share it", at(44, count(faster_than(0.1))), nearly_all_of(201)},
          {"One is fast and has nearly all of the energy", share, nearly_all_of(1.0)},
          {"soon has passed nearly all of its energy on", left_over, at_most(1.0 / 8.0)},
          {"follows the equilibrium curve", equilibrium_chance(44), at_least(0.05)},
          {"One fast sphere has nearly all of the energy", share, nearly_all_of(1.0), 0},
          {"It has passed nearly all of its energy on", left_over, at_most(1.0 / 8.0), 1.5},
          {"Those that were hit are fast now", at(2.4, count(faster_than(1))), at_least(10), 2.4},
          {"Nearly all spheres move now", at(16, count(faster_than(0.1))), nearly_all_of(201), 16},
          {"the bars follow the curve", equilibrium_chance(32), at_least(0.05), 32},
          {"201 spheres share the energy that one had", equilibrium_chance(44), at_least(0.05)}}},
        {"maxwell-in-space",
         {{"2000 equal spheres start at speed 1", at(0, fastest()), exactly(1.0)},
          {"all speeds up to 1 along x are equally frequent", number_along_x(0.0), a_fifth},
          {"yet along x all are equally frequent", number_along_x(0.8), a_fifth, 0},
          {"along x the most frequent speed becomes 0",
           share_of_slow(40, {0}) / share_of_slow(0, {0}), more()},
          {"Each histogram follows a law of its own", equilibrium_chance(40, {0}), at_least(0.05)},
          {"make some spheres slower", at(0.8, count(all())) - at(0.8, count(faster_than(0.9))),
           at_least(100), 0.8},
          {"and some faster", at(0.8, count(faster_than(1.1))), at_least(100), 0.8},
          {"in space few are slow", share_of_slow(6, {0, 1, 2}) / share_of_slow(6, {0}),
           much_less(), 6},
          {"Three laws, one temperature", equilibrium_chance(20, {0, 1}), at_least(0.05), 20},
          {"Speeds along x over times 20 to 40", equilibrium_chance(30, {0}), at_least(0.05)},
          {"at the temperature 1/3", at(40, temperature()), exactly(1.0 / 3.0)},
          {"Speeds in the plane xy", equilibrium_chance(30, {0, 1}), at_least(0.05)},
          {"Speeds in space of the same spheres", equilibrium_chance(30), at_least(0.05)}}},
        {"mixed-spheres",
         {{"All start equally fast", at(0, fastest()), exactly(2.0)},
          {"in the end they have the same mean energy", same, same_for(200, 30)},
          {"twelve times the energy of a light one", twelve, exactly(12.0)},
          {"Collisions even out the mean energies", same, same_for(200, 30)},
          {"a heavy sphere has twelve times the energy", twelve, exactly(12.0), 0},
          {"Collisions pass it on to the light ones",
           at(10, mean_energy(light)) / at(4, mean_energy(light)), more(), 4},
          {"The lines meet: the mean energies are the same",
           mean(30, 40, mean_energy(light)) / mean(30, 40, mean_energy(heavy)), about(1.0), 40},
          {"light spheres are fast, heavy ones slow",
           mean(60, 90, mean_speed(light)) / mean(60, 90, mean_speed(heavy)), much_more(), 60},
          {"times as fast", mean(25, 90, mean_speed(light)) / mean(25, 90, mean_speed(heavy)),
           about(std::sqrt(12.0))}}},
    };
}

std::vector<SceneClaims> claims_of_room() {
    const Which left = left_of(18), right = right_of(18);
    const Reading hotter = ratio(temperature(right), temperature(left));
    const Which low = below(9), high = above(9);
    const Measure even = mean(300, 1000, temperature(high)) / mean(300, 1000, temperature(low));
    // h - H / (exp(H / h) - 1) above the lowest place of a centre, 0.35, with the height H = 25.3
    // of the room for centres and h = T / g, T = 1.32
    const double h = 1.32 / 0.12;
    const Bounds barometric = about(0.35 + h - 25.3 / (std::exp(25.3 / h) - 1.0));
    const Measure twice_in_plane =
        with({"box.size=[36, 24]", "gas.0.radius=0.06"}, at(180, temperature()));
    return {
        {"free-expansion-in-space",
         {{"no work is done, and the temperature stays the same", at(160, temperature()),
           exactly(1.0)},
          {"400 spheres move on the left of a divider", at(0, count(left)), exactly(400)},
          {"that for a while the right is hot and the left is cold", at(14, hotter), much_more()},
          {"both halves hold equally many spheres", at(160, count(left)), half_of(400)},
          {"the temperature is the same as before", at(160, temperature()), exactly(1.0)},
          {"All spheres are on the left", at(0, count(left)), exactly(400), 0},
          {"hot on the right, cold on the left", at(14, hotter), much_more(), 14},
          {"Equal numbers on both sides", at(42, count(left)), half_of(400), 42},
          {"on both sides, at the same temperature", at(42, hotter), same_for(200, 200), 42},
          {"the gas has kept its energy", at(110, temperature()), exactly(1.0), 110}}},
        {"piston-in-space",
         {{"two thirds hotter", at(180, temperature()), exactly(5.0 / 3.0, 0.05)},
          {"in a plane it would be twice as hot", twice_in_plane, about(2.0)},
          {"whose right wall moves in slowly", at(90, place_of_surface(1)), exactly(27.0, 0.05)},
          {"Each sphere that it hits leaves it faster", at(60, temperature()), at_least(1.1)},
          {"far above the isotherm", at(180, temperature()), much_more()},
          {"The pressure follows the adiabat of hard spheres", at(120, temperature()), more(), 120},
          {"Half the volume: temperature", at(180, place_of_surface(1)), exactly(18.0, 0.05), 180},
          {"What hits it leaves it faster", at(60, temperature()), at_least(1.1), 60},
          {"spheres are 1.7 times as hot", at(180, temperature()), about(1.7)}}},
        {"thin-air-in-space",
         {{"the temperature is the same everywhere", even, exactly(1.0, 0.05)},
          {"as the barometric law says", mean(60, 1000, mean_place(1)), barometric},
          {"the temperature is the same below and above", even, exactly(1.0, 0.05)},
          {"At first the spheres are everywhere, and fall", at(5, mean_velocity(1)), at_most(-0.1),
           0},
          {"dense below, thin above: the barometric law", mean(60, 700, mean_place(1)), barometric,
           60},
          {"The temperature is the same at every height", even, exactly(1.0, 0.05), 700}}},
        {"effusion-in-space",
         {{"Fast spheres come to a small hole more often", mean(30, 400, hotter), more()},
          {"the spheres that got through are hotter than those that stayed.", mean(30, 400, hotter),
           more()},
          {"A small hole into an empty half", at(0, count(right)), exactly(0), 0},
          {"Spheres find it one by one", highest(30, 200, count(right)) - at(30, count(right)),
           at_least(5), 30},
          {"Those that got through are hotter than those that stayed", lowest(200, 400, hotter),
           more(), 200}}},
    };
}

std::vector<SceneClaims> claims_of_order() {
    const Which large = species("large");
    const Measure growth_at_long_times =
        squared_displacement(60, large) / squared_displacement(30, large);
    return {
        {"brownian-sphere",
         {{"A large sphere wanders", squared_displacement(60, large), at_least(20.0)},
          {"For short times it flies freely",
           squared_displacement(4.5, large) / squared_displacement(2.25, large), at_least(3.0)},
          {"grows in proportion to time.", growth_at_long_times, about(2.0)},
          {"The pushes add up to a random walk", growth_at_long_times, about(2.0), 60},
          {"it falls behind free flight",
           squared_displacement(27, large) / squared_displacement(9, large), at_most(9.0 / 1.5),
           150},
          {"Its squared displacement grows in proportion to time", growth_at_long_times, about(2.0),
           300}}},
        {"freezing-in-space",
         {{"504 spheres fill two fifths of a box", share_of_volume(), exactly(0.4, 0.005)},
          {"At a packing of about one half they freeze", packing_when_half_in_order(), about(0.5)},
          {"rises from less than a tenth", order(0), at_most(0.1)},
          {"to nearly a half.", order(130), {0.4, 0.5}},
          {"spheres fill two fifths of the volume", share_of_volume(), exactly(0.4, 0.005), 0},
          {"At a packing of about one half the fluid freezes", packing_when_half_in_order(),
           about(0.5), 70},
          {"planes of spheres along the walls", share_in_layers(114), nearly_all_of(1.0), 114}}},
        {"reversal-in-space",
         {{"reversed, the same laws bring it back", distance_between(0, 240), at_most(1e-9)},
          {"After hundreds of collisions with each other", 65.0 * at(120, collisions_each()),
           at_least(200.0)},
          {"and more with the walls",
           at(120, all_collisions()) / (65.0 * at(120, collisions_each())), at_least(2.0)},
          {"and the word reassembles", distance_between(0, 240), at_most(1e-9)},
          {"and the word never comes back", beside(distance_between(0, 240)), at_least(5.0)},
          {"every collision obeyed the laws", distance_between(0, 40), at_least(5.0), 40},
          {"each collision is undone in turn",
           at(240, all_collisions()) / at(120, all_collisions()), exactly(2.0), 200},
          {"each sphere is where it began", distance_between(0, 240), at_most(1e-9)},
          {"come back through the same collisions in reverse order",
           at(240, all_collisions()) / at(120, all_collisions()), exactly(2.0)}}},
        {"equation-of-state",
         {{"Spheres of the left crystal are a tenth smaller",
           share_of_volume() / beside(share_of_volume()), exactly(0.75, 0.03)},
          {"On the left the spheres fill 45 per cent", share_of_volume(), exactly(0.45, 0.005)},
          {"its order is soon gone", order(3), at_most(0.1)},
          {"the right one stays a crystal", beside(order(20)), at_least(0.45)},
          {"the left spheres are a tenth smaller", share_of_volume() / beside(share_of_volume()),
           exactly(0.75, 0.03), 0},
          {"The left crystal melts", order(2), at_most(0.2), 2},
          {"Left a fluid", order(9), at_most(0.1), 9},
          {"right still a crystal", beside(order(9)), at_least(0.45), 9},
          {"Up to the packing 0.44", with({"gas.0.radius=0.4706"}, order(12)), at_most(0.15)},
          {"From 0.546 on the crystal stays", with({"gas.0.radius=0.507"}, order(12)),
           at_least(0.4)}}},
    };
}

}  // namespace

std::vector<SceneClaims> claims_of_space() {
    return joined({claims_of_speeds(), claims_of_room(), claims_of_order()});
}

TEST_CASE("scenes in space show what their words claim") { check(claims_of_space()); }

}  // namespace carom::test
