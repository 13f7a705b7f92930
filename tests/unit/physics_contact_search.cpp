#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "physics/arena.h"
#include "physics/contact_search.h"
#include "physics/pair_collision.h"
#include "util/random.h"

using namespace carom;

namespace {

constexpr double size = 20.0;

// Disks at times of their own; some without mass's inverse, some points, some alike in place and
// motion, so that times are equal; all with one radius if `alike`.
FlyingDisks draw_disks(Random& random, std::size_t count, bool alike) {
    FlyingDisks disks(count);
    for (std::size_t k = 0; k < count; ++k) {
        FlyingDisk& d = disks[k];
        if (k > 1 && random.uniform() < 0.2) {
            d = disks[k - 1];
            continue;
        }
        d.x = {random.uniform(0.0, size), random.uniform(0.0, size)};
        d.v = {random.normal(), random.normal()};
        d.time = random.uniform();
        d.radius = random.uniform() < 0.1 ? 0.0 : random.uniform(0.1, 1.0);
        if (alike) d.radius = 0.6;
        d.inverse_mass = random.uniform() < 0.3 ? 0.0 : 1.0;
        d.collisions = static_cast<std::uint32_t>(random.below(1000));
    }
    return disks;
}

double nearest_image(double x) {
    return x > 0.5 * size ? x - size : x < -0.5 * size ? x + size : x;
}

// One after the other, as the header has it.
FirstContact slow_search(const FlyingDisks& disks, std::int32_t i, double now,
                         const std::vector<std::int32_t>& near, double shift, bool nearest,
                         const EventQueue& queue, FirstContact first) {
    const FlyingDisk& a = disks[std::size_t(i)];
    for (const std::int32_t other : near) {
        const FlyingDisk& b = disks[std::size_t(other)];
        const auto apart = [&](std::size_t axis) {
            const double here = a.x[axis] + a.v[axis] * (now - a.time);
            const double there = b.x[axis] + b.v[axis] * (now - b.time);
            return nearest ? nearest_image(there - here)
                           : there - (here - (axis == 0 ? shift : 0.0));
        };
        const RelativeMotion<double> m{apart(0), apart(1), b.v[0] - a.v[0], b.v[1] - a.v[1]};
        const double time =
            now + contact_time(m, a.radius + b.radius,
                               approach_round_off(m, a.v[0], a.v[1], b.v[0], b.v[1]));
        if (other == i || !std::isfinite(time) || a.inverse_mass + b.inverse_mass == 0.0 ||
            a.radius + b.radius == 0.0 || time > queue.event(other).contact_time)
            continue;
        if (time < first.time || (time == first.time && other < first.partner()))
            first = FirstContact(time, other, b.collisions);
    }
    return first;
}

}  // namespace

// Some have a contact before, and are left to look again themselves.
EventQueue draw_contacts(Random& random, std::size_t count) {
    std::vector<Event> events(count);
    for (Event& event : events)
        if (random.uniform() < 0.5) event = {.time = 0.5, .contact_time = random.uniform(0, 9)};
    EventQueue queue(static_cast<std::int32_t>(count));
    queue.reset(events);
    return queue;
}

// All numbers below count but one, in no order, filled up with i to whole lanes.
std::vector<std::int32_t> all_but(std::int32_t one, Random& random, std::size_t count,
                                  std::int32_t i) {
    std::vector<std::int32_t> near;
    for (std::size_t k = 0; k < count; ++k)
        if (static_cast<std::int32_t>(k) != one) near.push_back(static_cast<std::int32_t>(k));
    for (std::size_t k = near.size(); k > 1; --k) std::swap(near[k - 1], near[random.below(k)]);
    near.resize((near.size() + lanes - 1) / lanes * lanes, i);
    return near;
}

Pairing draw_pairing(Random& random, bool& nearest, double& shift) {
    nearest = random.uniform() < 0.5;
    Box box;
    box.size = {size, size};
    box.walls = {Wall::periodic, Wall::periodic};
    shift = nearest ? 0.0 : -size + size * static_cast<double>(random.below(3));
    return nearest ? Pairing::nearest(box) : Pairing::shifted(shift, 0.0);
}

TEST_CASE("the search among many finds what looking at one after the other finds") {
    Random random(5, "search");
    int found = 0, equal = 0;
    for (int round = 0; round < 20'000; ++round) {
        const auto count = static_cast<std::size_t>(1 + random.below(most_searched));
        const bool alike = random.uniform() < 0.5;
        const FlyingDisks disks = draw_disks(random, count, alike);
        const EventQueue queue = draw_contacts(random, count);
        FirstContact known;
        if (random.uniform() < 0.3) known = FirstContact(random.uniform(1.0, 9.0), 3, 5);
        const auto i = static_cast<std::int32_t>(random.below(count));
        const std::vector<std::int32_t> near = all_but(-1, random, count, i);
        bool nearest;
        double shift;
        Pairing pairing = draw_pairing(random, nearest, shift);
        if (alike) pairing.sigma = 1.2;

        const FirstContact slow = slow_search(disks, i, 1.0, near, shift, nearest, queue, known);
        FirstContact fast = known;
        search_contact(disks, i, 1.0, near.data(), near.size(), pairing, queue, fast);
        REQUIRE(fast.time == slow.time);
        REQUIRE(fast.who == slow.who);
        if (!std::isfinite(slow.time) || slow.time == known.time) continue;
        ++found;
        const auto partner = std::size_t(slow.partner());
        if (partner + 1 < count && disks[partner + 1].x == disks[partner].x) ++equal;
    }
    // Otherwise the comparison would say little.
    CHECK(found > 5'000);
    CHECK(equal > 500);
}

TEST_CASE("the search for two at once finds what two searches find") {
    Random random(8, "search");
    int found = 0;
    for (int round = 0; round < 20'000; ++round) {
        const auto count = static_cast<std::size_t>(2 + random.below(most_searched / 2 - 1));
        const bool alike = random.uniform() < 0.5;
        const FlyingDisks disks = draw_disks(random, count, alike);
        const EventQueue queue = draw_contacts(random, count);
        const auto i = static_cast<std::int32_t>(random.below(count));
        const auto j = static_cast<std::int32_t>((i + 1 + random.below(count - 1)) % count);
        const std::vector<std::int32_t> near_i = all_but(j, random, count, i);
        const std::vector<std::int32_t> near_j = all_but(i, random, count, j);
        std::vector<std::int32_t> near = near_i;
        near.insert(near.end(), near_j.begin(), near_j.end());
        bool nearest;
        double shift;
        Pairing pairing = draw_pairing(random, nearest, shift);
        if (alike) pairing.sigma = 1.2;

        const std::array slow{slow_search(disks, i, 1.0, near_i, shift, nearest, queue, {}),
                              slow_search(disks, j, 1.0, near_j, shift, nearest, queue, {})};
        std::array<FirstContact, 2> fast;
        search_two_contacts(disks, {i, j}, 1.0, near.data(), near_i.size(), near.size(), pairing,
                            queue, fast);
        for (std::size_t k = 0; k < 2; ++k) {
            REQUIRE(fast[k].time == slow[k].time);
            REQUIRE(fast[k].who == slow[k].who);
            if (std::isfinite(slow[k].time)) ++found;
        }
    }
    CHECK(found > 10'000);
}
