// Claims of the scenes in scenes/classics.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "captions/claims.h"

namespace carom::test {

namespace {

// The number of disks in a ring around the middle of the blast, by that at an even density.
Reading density_of_ring(double inner, double outer) {
    return {[=](const Course& course, const Moment& moment) {
        const Eigen::ArrayXd x = moment.sample.position.col(0) - 48.0;
        const Eigen::ArrayXd y = moment.sample.position.col(1) - 36.0;
        const Eigen::ArrayXd r = (x.square() + y.square()).sqrt();
        const double found = static_cast<double>((r > inner && r < outer).count());
        const double area = std::numbers::pi * (outer * outer - inner * inner);
        return found / area / (static_cast<double>(course.particles.count()) / (96.0 * 72.0));
    }};
}

// The density and the middle radius of the densest ring, of width 4.
std::pair<double, double> densest_ring(const Course& course, const Moment& moment) {
    double best = 0.0, radius = 0.0;
    for (double inner = 4.0; inner <= 32.0; inner += 1.0) {
        const double density = density_of_ring(inner, inner + 4.0).of(course, moment);
        if (density > best) best = density, radius = inner + 2.0;
    }
    return {best, radius};
}
Reading density_of_densest_ring() {
    return {[](const Course& course, const Moment& moment) {
        return densest_ring(course, moment).first;
    }};
}
Reading radius_of_densest_ring() {
    return {[](const Course& course, const Moment& moment) {
        return densest_ring(course, moment).second;
    }};
}

// The centre of the densest tenth of the box of the sound pulse, along x.
Reading place_of_pulse() {
    return {[](const Course&, const Moment& moment) {
        const Eigen::ArrayXd x = moment.sample.position.col(0);
        Eigen::Index best = 0;
        double place = 0.0;
        for (double from = 10.0; from <= 90.0; from += 1.0) {
            const Eigen::Index found = (x > from && x < from + 10.0).count();
            if (found > best) best = found, place = from + 5.0;
        }
        return place;
    }};
}

Reading highest_place() {
    return {[](const Course&, const Moment& moment) {
        return moment.sample.position.col(1).maxCoeff();
    }};
}

std::vector<SceneClaims> claims_of_waves() {
    const Which behind = right_of(90);
    return {
        {"blast",
         {{"leaves an empty middle behind", at(7, density_of_ring(0, 10)), much_less()},
          {"40 very hot disks begin in the middle",
           at(0, temperature(species("hot"))) / at(0, temperature(species("cold"))), much_more()},
          {"fast at first and then more slowly",
           growth(0.35, 1.05, radius_of_densest_ring()) /
               growth(2.1, 4.2, radius_of_densest_ring()),
           more()},
          {"In its middle few disks are left", at(6.5, density_of_ring(0, 10)), much_less()},
          {"Ahead of the ring nothing has happened yet",
           at(1, temperature(right_of(80))) / at(0, temperature(right_of(80))), about(1.0)},
          {"It sweeps the cold disks into a dense ring", at(3, density_of_densest_ring()), more(),
           0.5},
          {"The ring grows more slowly",
           growth(0.35, 1.05, radius_of_densest_ring()) /
               growth(2.1, 4.2, radius_of_densest_ring()),
           more(), 2.1},
          {"Few disks are left in the middle", at(4.5, density_of_ring(0, 10)), much_less(), 4.5},
          {"A ring of dense gas runs outwards",
           at(4, radius_of_densest_ring()) - at(2, radius_of_densest_ring()), at_least(5.0)}}},
        {"sound-pulse",
         {{"What travels through the gas is the push, not the disks",
           distance_between(16, 40) / (at(40, place_of_pulse()) - at(16, place_of_pulse())),
           much_less()},
          {"a band of higher density runs through the gas to the other wall",
           highest(36, 50, count(behind)) / at(10, count(behind)), more()},
          {"The disks themselves move only about a tenth as far",
           // to the other wall and back to where it is
           {[](const Course& course) {
               const double there = 95.0 - place_of_pulse().of(course, course.at(16));
               const double back = 95.0 - place_of_pulse().of(course, course.at(66));
               return distance_between(16, 66).of(course) / (there + back);
           }},
           {0.05, 0.15}},
          {"faster than most disks",
           {[](const Course& course) {
               const double speed = growth(16, 36, place_of_pulse()).of(course);
               return (speeds(course.at(16).sample) < speed).cast<double>().mean();
           }},
           at_least(0.9),
           16},
          {"It comes back from the other wall", growth(54, 72, place_of_pulse()), at_most(-0.5),
           54},
          {"the pulse has come about halfway", at(26, place_of_pulse()), exactly(50.0, 7.5)}}},
        {"galton-board",
         {{"come back up", highest(18, 50, highest_place()), at_least(40.0)},
          {"spread over the whole width", mean(40, 50, spread_of_places(0)),
           about(64.0 / std::sqrt(12.0)), 40},
          {"the binomial curve about 32", at(0, mean_place(0)), exactly(32.0, 2.0)},
          {"Elastic balls spread over the whole width", mean(25, 50, spread_of_places(0)),
           about(64.0 / std::sqrt(12.0))},
          {"All balls begin at one place", at(0, spread_of_places(0)), at_most(3.2), 0},
          {"they jump wide", at(7, spread_of_places(0)) / at(0, spread_of_places(0)), much_more(),
           7},
          {"so no bell curve builds up", mean(18, 40, spread_of_places(0)),
           about(64.0 / std::sqrt(12.0)), 18},
          {"They spread over the whole width", at(40, spread_of_places(0)),
           about(64.0 / std::sqrt(12.0)), 40}}},
    };
}

std::vector<SceneClaims> claims_of_mixtures() {
    const Which hot = species("hot"), cold = species("cold");
    const Reading hotter = ratio(temperature(hot), temperature(cold));
    const Which passed = right_of(27), stayed = left_of(27);
    const Reading by_passing = ratio(temperature(passed), temperature(stayed));
    return {
        {"hot-and-cold-mix",
         {{"first share their energy, then their places", at(60, hotter), same_for(80, 80)},
          {"80 hot disks are on the left of a divider", at(0, count(hot && left_of(26))),
           exactly(80)},
          {"The hot gas has the higher pressure", at(0, hotter), much_more()},
          {"Collisions soon bring both to one temperature", at(60, hotter), same_for(80, 80)},
          {"The disks themselves take longer", at(60, count(hot && left_of(26))), at_least(54)},
          {"Hot on the left, cold on the right", at(0, count(cold && right_of(26))), exactly(80),
           0},
          {"The hot gas pushes too far", lowest(18, 32, count(left_of(26))),
           at_most(half_of(160).least), 18},
          {"a wave runs back and forth",
           highest(32, 60, count(left_of(26))) - lowest(18, 32, count(left_of(26))), at_least(19),
           18},
          {"The temperatures are equal", at(60, hotter), same_for(80, 80), 60},
          {"but the gases are not yet mixed", at(60, count(cold && left_of(26))),
           at_most(half_of(80).least), 60},
          {"wander more slowly than the energy", at(110, count(hot && left_of(26))),
           at_least(half_of(80).most), 110},
          {"Mixed: about equally many of each kind", at(270, count(hot && left_of(26))),
           half_of(80), 270},
          {"of each kind on both sides", at(270, count(cold && left_of(26))), half_of(80), 270}}},
        {"effusion",
         {{"Fast disks come to a narrow slit more often", mean(30, 600, by_passing), more()},
          {"the disks that got through are hotter than those that stayed.",
           mean(30, 600, by_passing), more()},
          {"about one disk in four finds it", (1.0 / 150.0) * at(600, count(passed)),
           about(1.0 / 4.0)},
          {"A narrow slit into an empty half", at(0, count(passed)), exactly(0), 0},
          {"Disks find it one by one", highest(30, 200, count(passed)) - at(30, count(passed)),
           at_least(5), 30},
          {"The disks that got through are hotter than those that stayed",
           lowest(200, 600, by_passing), more(), 200},
          {"the disks on the right are faster",
           mean(200, 600, ratio(mean_speed(passed), mean_speed(stayed))), at_least(1.1)},
          {"What passes a slit is faster than the gas",
           mean(200, 600, ratio(mean_speed(passed), mean_speed(stayed))), at_least(1.1)},
          {"fewer than fifty have passed here", at(600, count(passed)), {1, 49}}}},
        {"free-expansion-and-back",
         {{"80 disks begin on the left", at(0, count(left_of(24))), exactly(80)},
          {"after nearly two thousand collisions", 40.0 * at(110, collisions_each()), {1800, 2000}},
          {"they fill the box", at(110, count(left_of(24))), half_of(80)},
          {"Every collision happens again in reverse order",
           at(220, all_collisions()) / at(110, all_collisions()), exactly(2.0)},
          {"it comes back", distance_between(0, 220), at_most(1e-9)},
          {"All disks are on the left", at(0, count(left_of(24))), exactly(80), 0},
          {"The gas fills the whole box", at(45, count(left_of(24))), half_of(80), 45},
          {"nothing is on the right", at(210, count(right_of(24))), exactly(0), 210}}},
    };
}

// Each disk's number of neighbours nearer than 1.4 diameters, in the box of `freezing`.
Measure share_with_six_neighbours(double time) {
    return {[=](const Course& course) {
        const Eigen::ArrayXXd& place = course.at(time).sample.position;
        const double height = course.scene.gas.box.size[1];
        int six = 0;
        for (Eigen::Index i = 0; i < place.rows(); ++i) {
            const Eigen::ArrayXd dx = place.col(0) - place(i, 0);
            const Eigen::ArrayXd apart = place.col(1) - place(i, 1);
            const Eigen::ArrayXd dy = apart - height * (apart / height).round();
            six += static_cast<int>(((dx.square() + dy.square()) < 1.96).count() == 7);
        }
        return static_cast<double>(six) / static_cast<double>(place.rows());
    }};
}

Measure packing(double time) {
    return {[=](const Course& course) {
        const auto& motion = course.at(time).surfaces.at(1).motion;
        const double width = motion ? motion->place : course.scene.gas.box.size[0];
        return 396.0 * std::numbers::pi * 0.25 / (width * course.scene.gas.box.size[1]);
    }};
}

// How far the large disk comes in all, in its diameters.
Measure distance_of_large_disk() {
    return {[](const Course& course) {
        return std::sqrt(squared_displacement(200, species("large")).of(course)) / 4.0;
    }};
}

// The number of disks that end as fast as they began.
Measure untouched() {
    return {[](const Course& course) {
        const Eigen::ArrayXd before = speeds(course.moments.front().sample);
        const Eigen::ArrayXd after = speeds(course.moments.back().sample);
        return static_cast<double>(((before - after).abs() < 1e-9).count());
    }};
}

// How far the two disks of the billiard are apart after so many hits of walls and the circle.
Measure apart_after_hits(std::size_t hits) {
    return {[=](const Course& course) {
        return distance_from_beside(course.collisions.at(hits - 1).time).of(course);
    }};
}

// By how much each hit on the circle between two times multiplies their distance.
Measure growth_by_hit(double from, double to) {
    return {[=](const Course& course) {
        const double grown =
            distance_from_beside(to).of(course) / distance_from_beside(from).of(course);
        const auto hits_until = [&](double time) {
            const auto step = course.scene.run.until / 400.0;
            return course.hits.at(static_cast<std::size_t>(std::lround(time / step)));
        };
        return std::pow(grown, 1.0 / (hits_until(to) - hits_until(from)));
    }};
}

Measure log10_growth(double from, double to) {
    return {[=](const Course& course) {
        return std::log10(distance_from_beside(to).of(course) /
                          distance_from_beside(from).of(course));
    }};
}

Measure time_of_tenfold_growth(double from, double to) {
    return {[=](const Course& course) { return (to - from) / log10_growth(from, to).of(course); }};
}

// The Lyapunov exponent of the orbit of the disk between two times, from its own hits alone: a
// front of curvature k stretches by 1 + k s over a path s, and each hit of the circle at the angle
// a adds 2 / (R cos a) to k (Sinai 1970).
Measure exponent_of_fronts(double until) {
    return {[=](const Course& course) {
        const double radius = 3.25;  // at which the centre is reflected
        double curvature = 0.0, stretched = 0.0, before = 0.0;
        const double speed = std::hypot(1.9, 1.3);
        const auto fly = [&](double time) {
            const double longer = 1.0 + curvature * speed * (time - before);
            stretched += std::log(longer);
            curvature /= longer;
            before = time;
        };
        for (const Collision& hit : course.collisions) {
            if (hit.time > until) break;
            fly(hit.time);
            const Vec off = hit.first_position - Vec{7.5, 4.5};
            if (std::abs(length(off) - radius) > 1e-6) continue;  // a wall
            const double cosine = std::abs(dot(off, hit.first_before)) / (radius * speed);
            curvature += 2.0 / (radius * cosine);
        }
        fly(until);
        return stretched / until;
    }};
}

std::vector<SceneClaims> claims_of_many_hits() {
    // for each disk: the temperature was 1
    const Measure rise = at(92, temperature()) - at(0, temperature());
    const Measure work_of_slow = rise, work_of_fast = beside(rise);
    const Which large = species("large");
    const Reading height = place_of_surface(3);
    return {
        {"freezing",
         {{"396 disks fill less than half of a box", packing(0), at_most(0.5)},
          {"more than four in five are soon caught between six neighbours",
           share_with_six_neighbours(80), at_least(0.8)},
          {"they collide more and more often",
           growth(50, 60, collisions_each()) / growth(0, 10, collisions_each()), much_more()},
          {"disks cover less than half of the area", packing(0), at_most(0.5), 0},
          {"At a packing of 0.7", packing(57), exactly(0.7, 0.005), 57},
          // six neighbours: a few in the fluid, most in the crystal
          {"the fluid freezes", share_with_six_neighbours(71) - share_with_six_neighbours(45),
           at_least(0.5), 57},
          {"Nine disks in ten have six neighbours", share_with_six_neighbours(71),
           exactly(0.9, 0.05), 71}}},
        {"brownian-motion",
         {{"A large disk wanders", distance_of_large_disk(), at_least(2.0)},
          {"falls behind that of free flight",
           squared_displacement(9, large) / squared_displacement(4.5, large), at_most(3.6)},
          {"In longer times it diffuses",
           squared_displacement(54, large) / squared_displacement(27, large), exactly(2.0, 0.4)},
          {"it falls behind free flight",
           squared_displacement(9, large) / squared_displacement(4.5, large), at_most(3.6), 250},
          {"Its squared displacement grows in proportion to time",
           squared_displacement(54, large) / squared_displacement(27, large), exactly(2.0, 0.4),
           600},
          {"The pushes add up to a random walk", distance_of_large_disk(), at_least(2.0), 100}}},
        {"fluctuating-piston",
         {{"with a deviation of a sixth of its mean height",
           deviation(0, 2000, height) / mean(0, 2000, height), about(1.0 / 6.0)},
          {"falls until the gas carries it", lowest(0, 80, height), at_most(12.0), 0},
          {"It swings for ever", deviation(1000, 2000, height) / deviation(80, 1000, height),
           exactly(1.0, 0.25), 80},
          // a beta distribution of 17 and 16.5 on 0 to 26
          {"Time lapse: its heights fill the curve that theory gives", mean(0, 2000, height),
           about(26.0 * 17.0 / 33.5), 220}}},
        {"ideal-gas-law",
         {{"Twice the temperature or half the room, twice the pressure",
           growth(130, 240, wall_impulse()) / growth(0, 120, wall_impulse()), about(2.0)},
          {"so that the pressure becomes twice as high.",
           growth(130, 240, wall_impulse()) / growth(0, 120, wall_impulse()), about(2.0)},
          {"the pressure becomes twice as high again",
           (224.0 / 160.0) * growth(560, 660, wall_impulse()) / growth(130, 240, wall_impulse()),
           {2.0, 2.4}},
          {"a little above that of an ideal gas",
           (64.0 * 48.0 / 200.0 / 224.0) * growth(0, 120, wall_impulse()),
           {1.0, 1.2}},
          {"Temperature 1, pressure p", mean(0, 119, temperature()), about(1.0), 0},
          {"Temperature 2: twice the pressure",
           growth(130, 240, wall_impulse()) / growth(0, 120, wall_impulse()), about(2.0), 120},
          {"halves the room slowly, at one temperature", mean(240, 560, temperature()), about(2.0),
           240},
          {"Half the room: twice the pressure, and a little more",
           (224.0 / 160.0) * growth(560, 660, wall_impulse()) / growth(130, 240, wall_impulse()),
           {2.0, 2.4},
           560}}},
        {"jarzynski",
         {{"leaves the gas hotter", beside(at(92, temperature())) / at(92, temperature()), more()},
          {"compressed to half their room", (1.0 / 48.0) * at(92, place_of_surface(1)),
           exactly(0.5, 1e-6)},
          {"although some disks escape the wall", beside(untouched()), at_least(20)},
          {"half the room", (1.0 / 48.0) * at(92, place_of_surface(1)), exactly(0.5, 1e-6), 0},
          {"four times as fast",
           beside(growth(10, 20, place_of_surface(1))) / growth(10, 20, place_of_surface(1)),
           exactly(4.0, 0.05), 10},
          {"The slow compression takes less work", work_of_fast / work_of_slow, more()},
          {"The fast compression has taken more work", work_of_fast / work_of_slow, more(), 82},
          {"and the temperature comes to 2.5", at(92, temperature()), exactly(2.5, 0.1)},
          {"A fast compression makes the gas hotter still",
           beside(at(92, temperature())) / at(92, temperature()), more()}}},
        {"sinai-billiard",
         {{"For thirty hits nobody could tell them apart", apart_after_hits(30), at_most(0.01)},
          {"Two disks, 0.000 000 000 001 apart", distance_from_beside(0), exactly(1e-12, 1e-14), 0},
          {"The starts differ by 10^-12", distance_from_beside(0), exactly(1e-12, 1e-14)},
          {"each hit on the round obstacle makes the difference several times larger",
           growth_by_hit(16, 64), at_least(3.0)},
          {"Each hit on the circle makes the difference far larger", growth_by_hit(16, 64),
           at_least(3.0), 16},
          {"on average tenfold in a time of 6", time_of_tenfold_growth(0, 66), exactly(6.0, 0.5)},
          {"on average tenfold in a time of 6",
           {[](const Course& course) {
               return std::log(10.0) / exponent_of_fronts(66).of(course);
           }},
           exactly(6.0, 0.5)},
          {"The logarithm of their distance rises steadily",
           log10_growth(36, 51) / log10_growth(51, 66), exactly(1.0, 0.25), 36},
          // a quarter of the diameter
          {"Now the difference can be seen", distance_from_beside(66.4), at_least(0.125), 66},
          {"Nothing is left of the common start", distance_from_beside(100), at_least(3.0), 100}}},
    };
}

}  // namespace

std::vector<SceneClaims> claims_of_classics() {
    return joined({claims_of_waves(), claims_of_mixtures(), claims_of_many_hits()});
}

TEST_CASE("classics show what their words claim") { check(claims_of_classics()); }

}  // namespace carom::test
