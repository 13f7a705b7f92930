// Claims of the scenes in the folder scenes itself, but for those in beads.cpp.
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

Measure return_digits() {
    return {[](const Course& course) { return -course.log10_return_distance; }};
}

bool takes_part(const Collision& collision, std::int32_t particle) {
    return collision.first == particle || collision.second == particle;
}

// The number of collisions of a particle until a time, with walls included.
Measure collisions_of(std::int32_t particle, double time) {
    return {[=](const Course& course) {
        return static_cast<double>(std::ranges::count_if(
            course.collisions,
            [&](const Collision& c) { return c.time <= time && takes_part(c, particle); }));
    }};
}

// The time of the first collision of a particle.
Measure first_collision_of(std::int32_t particle) {
    return {[=](const Course& course) {
        return std::ranges::find_if(course.collisions,
                                    [&](const Collision& c) { return takes_part(c, particle); })
            ->time;
    }};
}

// The middle of the interval of speeds, 0.2 wide, that holds the most particles from a time on.
Measure most_frequent_speed(double from) {
    return {[=](const Course& course) {
        double middle = 0.0, most = 0.0;
        for (double low = 0.0; low < 2.0; low += 0.02) {
            const Reading found = count(faster_than(low));
            const Reading beyond = count(faster_than(low + 0.2));
            const double end = course.scene.run.until;
            const double within = (mean(from, end, found) - mean(from, end, beyond)).of(course);
            if (within > most) most = within, middle = low + 0.1;
        }
        return middle;
    }};
}

std::vector<SceneClaims> claims_of_energy_shared() {
    const Which light = species("light"), heavy = species("heavy");
    const Which fast = species("the fast disk"), others = species("the 200 others");
    const Measure share = at(0, mean_energy(fast)) / (201 * at(0, mean_energy()));
    return {
        {"one-hot-particle",
         {{"until nearly all share it", at(36, count(faster_than(0.1))), nearly_all_of(201)},
          {"one is fast and has nearly all of the energy", share, nearly_all_of(1.0)},
          {"flies freely at first", first_collision_of(200), at_least(0.3)},
          {"by time 0.8, it has passed nearly all of its energy on",
           at(0.8, mean_energy(fast)) / at(0, mean_energy(fast)), at_most(1.0 / 8.0)},
          {"Those that were hit are fast, and hit others", at(1.5, count(faster_than(1))),
           at_least(10)},
          {"by time 12 nearly all move", at(12, count(faster_than(0.1))), nearly_all_of(201)},
          {"follows the equilibrium curve", equilibrium_chance(36), at_least(0.05)},
          {"One fast disk has nearly all of the energy", share, nearly_all_of(1.0), 0},
          {"After three hits it", collisions_of(200, 0.8), exactly(3), 0.8},
          {"it has passed on nearly all its energy",
           at(0.8, mean_energy(fast)) / at(0, mean_energy(fast)), at_most(1.0 / 8.0), 0.8},
          {"Those that were hit are fast now", at(1.5, count(faster_than(1))), at_least(10), 1.5},
          {"Nearly all disks move now", at(12, count(faster_than(0.1))), nearly_all_of(201), 12},
          {"the bars follow the curve", equilibrium_chance(26), at_least(0.05), 26},
          {"After 17 collisions of each disk", at(36, collisions_each()), exactly(17, 0.5)},
          {"201 share the energy that one had", equilibrium_chance(36), at_least(0.05)},
          {"it has 99.9 % of the energy", share, exactly(0.999, 0.0005)},
          {"by time 1.5 it has passed nearly all of it on",
           at(1.5, mean_energy(fast)) / at(0, mean_energy(fast)), at_most(1.0 / 8.0)},
          {"The fast disk starts with an energy of 450", at(0, mean_energy(fast)), exactly(450)},
          {"stays near 2.24, the mean of all", at(36, mean_energy(others)), about(2.24)}}},
        {"slow-crowd",
         {{"480 disks move at speed 0.001", at(0, mean_speed(species("crowd"))), exactly(0.001)},
          {"until nearly the whole crowd shares the energy", at(8, count(faster_than(0.1))),
           nearly_all_of(481)},
          {"Disks that were hit strike others", at(0.7, count(faster_than(0.1))), at_least(20),
           0.7},
          {"Nearly the whole crowd moves now", at(6.5, count(faster_than(0.1))), nearly_all_of(481),
           6.5},
          {"its energy is shared now",
           at(0.9, mean_energy(species("fast"))) / at(0, mean_energy(species("fast"))),
           at_most(1.0 / 8.0)}}},
        {"mixed-masses",
         {{"All start equally fast", at(0, fastest()), exactly(2.0)},
          {"The same mean energy at a twelfth of the mass",
           mean(20, 75, mean_energy(light)) / mean(20, 75, mean_energy(heavy)), same_for(160, 30)},
          {"times as fast", mean(20, 75, mean_speed(light)) / mean(20, 75, mean_speed(heavy)),
           exactly(std::sqrt(12.0), 0.05)},
          {"in the end they have the same mean energy",
           at(75, mean_energy(light)) / at(75, mean_energy(heavy)), same_for(160, 30)},
          {"twelve times the energy of a light one",
           at(0, mean_energy(heavy)) / at(0, mean_energy(light)), exactly(12.0)},
          {"Collisions even out the mean energies",
           at(75, mean_energy(light)) / at(75, mean_energy(heavy)), same_for(160, 30)},
          {"a heavy disk has twelve times the energy",
           at(0, mean_energy(heavy)) / at(0, mean_energy(light)), exactly(12.0), 0},
          {"Collisions pass it on to the light ones",
           at(10, mean_energy(light)) / at(4, mean_energy(light)), more(), 4},
          {"The lines meet: the mean energies are the same",
           mean(14, 24, mean_energy(light)) / mean(14, 24, mean_energy(heavy)), about(1.0), 24},
          {"With the same energy",
           mean(45, 75, mean_energy(light)) / mean(45, 75, mean_energy(heavy)), same_for(160, 30),
           45},
          {"light disks are fast, heavy ones slow",
           mean(45, 75, mean_speed(light)) / mean(45, 75, mean_speed(heavy)), much_more(), 45},
          {"with mean energies of 2 and 24", at(0, mean_energy(heavy)), exactly(24.0)},
          {"Collisions bring both to the mean of all, 5.47", at(75, mean_energy()),
           exactly(5.47, 0.005)},
          // the mean of the heavy ones over a time that their fluctuations last
          {"heavy disks are slow and light ones fast",
           mean(50, 75, mean_speed(light)) / mean(50, 75, mean_speed(heavy)), much_more()}}},
        {"maxwell-boltzmann",
         {{"a few collisions each spread the speeds", equilibrium_chance(10), at_least(0.05)},
          // faster than 2: 2000 exp(-4) in equilibrium; slower than 0.5: all but 2000 exp(-1/4)
          {"the tail fills last",
           (2000.0 - 2000.0 * std::exp(-0.25)) / (2000.0 * std::exp(-4.0)) *
               (at(2.4, count(faster_than(2))) /
                (at(2.4, count(all())) - at(2.4, count(faster_than(0.5))))),
           much_less()},
          // the curve is flat there: 0.1 away it is lower by 2 %
          {"the most frequent speed", most_frequent_speed(10), exactly(0.7, 0.1)},
          {"the histogram of speeds is a single bar", at(0, fastest()), exactly(1.0)},
          {"After about six collisions each", at(10.5, collisions_each()), about(6.0)},
          {"the bars follow the Maxwell-Boltzmann curve", equilibrium_chance(10.5), at_least(0.05)},
          {"and stay there", equilibrium_chance(40), at_least(0.05)},
          {"Six collisions of each disk", at(10.5, collisions_each()), exactly(6, 0.5)},
          {"one speed has become the Maxwell-Boltzmann curve", equilibrium_chance(10.5),
           at_least(0.05)},
          {"All disks have the same speed", at(0, fastest()), exactly(1.0), 0},
          {"Collisions make some slower", at(0.8, count(all())) - at(0.8, count(faster_than(0.9))),
           at_least(100), 0.8},
          {"and some faster", at(0.8, count(faster_than(1.1))), at_least(100), 0.8},
          {"After a few collisions each", at(10, collisions_each()), {3, 7}, 10},
          {"the bars follow the curve", equilibrium_chance(10), at_least(0.05), 10},
          {"Each disk's speed still changes", growth(24, 40, collisions_each()), at_least(0.1), 24},
          {"the distribution does not", equilibrium_chance(32), at_least(0.05), 24},
          {"after 23 collisions each", at(40, collisions_each()), exactly(23, 0.5)},
          {"after half a collision of each disk", at(0.8, collisions_each()), about(0.5)},
          {"at their mean energy", at(40, temperature()), exactly(0.5)},
          {"it is higher than that of an ideal gas",
           (176.0 * 80.0 / (2000.0 * 0.5) / 512.0) * growth(0, 40, wall_impulse()),
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

// The mean of -sum p ln p over throws of `balls` into the cells of free-expansion, less that over
// throws into half of them: a cell holds a binomial number.
Measure evenness_gained_by_throwing(int balls) {
    return {[=](const Course& course) {
        const PositionEntropy entropy(course.scene.gas.box, course.particles, {});
        const auto mean_of_throws = [=](double cells) {
            double sum = 0.0;
            for (int k = 1; k <= balls; ++k)
                sum -= std::exp(std::lgamma(balls + 1.0) - std::lgamma(k + 1.0) -
                                std::lgamma(balls - k + 1.0) - k * std::log(cells) +
                                (balls - k) * std::log1p(-1.0 / cells)) *
                       k / balls * std::log(static_cast<double>(k) / balls);
            return cells * sum;
        };
        const auto cells = static_cast<double>(entropy.cells().count.prod());
        return mean_of_throws(cells) - mean_of_throws(cells / 2.0);
    }};
}

std::vector<SceneClaims> claims_of_sides() {
    const Which left = left_of(32), right = right_of(32);
    const Reading hotter = ratio(temperature(left), temperature(right));
    const Which blue = species("blau"), yellow = species("gelb");
    const double even = std::sqrt(400.0);
    return {
        {"free-expansion",
         {{"no work is done, and the temperature stays the same", at(320, temperature()),
           exactly(1.0)},
          {"400 disks move on the left of a divider", at(0, count(left)), exactly(400)},
          {"the fastest disks cross first", at(12, hotter), much_less()},
          {"over to the right and back",
           (highest(60, 120, count(left)) - at(0, count(right))) /
               (highest(30, 60, count(right)) - at(0, count(right))),
           {0.9, 1.2}},
          {"until both halves hold equally many disks", at(320, count(left)), half_of(400)},
          {"at the same temperature.", at(320, hotter), same_for(200, 200)},
          {"the temperature is the same as before", at(320, temperature()), exactly(1.0)},
          {"nearly ln 2 for each disk",
           (1.0 / std::numbers::ln2) * (mean(240, 320, evenness()) - mean(0, 8, evenness())),
           {7.0 / 8.0, 1.0}},
          {"holds only a few.",
           (mean(240, 320, evenness()) - mean(0, 8, evenness())) / evenness_gained_by_throwing(400),
           exactly(1.0, 0.02)},
          {"All disks are on the left", at(0, count(left)), exactly(400), 0},
          {"The fastest disks reach the far side first", at(16, hotter), much_less(), 16},
          {"The gas swings too far", at(48, count(right)), at_least(200 + even), 45},
          {"It swings back", at(85, count(left)), at_least(200 + even), 80},
          {"Each swing is smaller than the one before",
           (highest(125, 180, count(left)) - mean(240, 320, count(left))) /
               (highest(60, 110, count(left)) - mean(240, 320, count(left))),
           much_less(), 125},
          {"Equal numbers on both sides", at(260, count(left)), half_of(400), 260},
          {"on both sides, at the same temperature", at(260, hotter), same_for(200, 200), 260}}},
        {"durchmischung",
         {{"bis beide Gase gemischt sind", at(300, count(blue && left_of(22))), half_of(100)},
          {"100 Scheiben links und 100 rechts", at(0, count(blue && left_of(22))), exactly(100)},
          {"Druck und Temperatur sind überall gleich",
           at(0, ratio(temperature(blue), temperature(yellow))), exactly(1.0)},
          {"Gleicher Druck, gleiche Temperatur",
           at(0, ratio(temperature(blue), temperature(yellow))), exactly(1.0), 0},
          {"Die Gase dringen langsam ineinander ein",
           at(35, count(yellow && left_of(22))),
           {10, half_of(100).least},
           35},
          {"Überall etwa gleich viele von beiden", at(230, count(blue && left_of(22))),
           half_of(100), 230},
          {"etwa gleich viele von beiden", at(230, count(yellow && left_of(22))), half_of(100),
           230}}},
        {"heat-flow",
         {{"What comes from the hot wall is fast",
           mean(60, 100, ratio(mean_speed(left_of(8)), mean_speed(right_of(56)))), much_more()},
          {"Energy travels through the gas from the hot wall to the cold one",
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
         {{"the temperature is the same everywhere",
           mean(400, 1200, temperature(above(11))) / mean(400, 1200, temperature(below(11))),
           exactly(1.0, 0.05)},
          // h - H / (exp(H / h) - 1) for the height H = 40 and h = T / g, T = 1.52
          {"as the barometric law says", mean(60, 1200, mean_place(1)), about(13.45)},
          {"the temperature is the same below and above",
           mean(400, 1200, temperature(above(11))) / mean(400, 1200, temperature(below(11))),
           exactly(1.0, 0.05)},
          {"At first the disks are everywhere, and fall", at(5, mean_velocity(1)), at_most(-0.1),
           0},
          {"dense below, thin above: the barometric law", mean(60, 850, mean_place(1)),
           about(13.45), 60},
          {"The temperature is the same at every height",
           mean(400, 1200, temperature(above(11))) / mean(400, 1200, temperature(below(11))),
           exactly(1.0, 0.05), 850}}},
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
          {"After fifty-nine collisions of each", at(95, collisions_each()), exactly(59, 0.5)},
          {"and the word reassembles", return_digits(), at_least(9.0)},
          {"it loses its way after a few collisions", beside(lost_after), at_most(15.0)},
          {"and the word never comes back", beside(distance_between(0, 190)), at_least(10.0)},
          {"The word is gone", distance_between(0, 30), at_least(10.0), 30},
          {"With enough digits each collision is undone in turn",
           number_of_collisions(190) - 2 * number_of_collisions(95), exactly(0), 160},
          {"6988 collisions out", number_of_collisions(95), exactly(6988)},
          {"the same 6988 back", number_of_collisions(190), exactly(2 * 6988)},
          {"fly apart through 6988 collisions", number_of_collisions(95), exactly(6988)},
          {"come back through the same 6988", number_of_collisions(190), exactly(2 * 6988)}}},
        {"nudged-reversal",
         {{"the word never comes back", distance_between(0, 190), at_least(10.0)},
          {"After sixty collisions of each", at(95, collisions_each()), exactly(60, 0.5)},
          {"for good after some seventeen collisions", lost_after, exactly(17, 1.5)},
          {"after seventeen collisions of each disk the way back is lost", lost_after,
           exactly(17, 1.5)},
          {"yet the word does not come back", distance_between(0, 190), at_least(10.0), 160}}},
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

}  // namespace

std::vector<SceneClaims> claims_of_others() {
    return joined({claims_of_energy_shared(), claims_of_sides(), claims_of_reversals()});
}

TEST_CASE("the other scenes show what their words claim") { check(claims_of_others()); }

}  // namespace carom::test
