#include "physics/cells/contact_search.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "physics/collision/loop_types.h"
#include "physics/collision/pair_collision.h"
#include "util/random.h"

using namespace carom;

namespace {

// So that about as many of them meet in the plane and in space.
template <int Dimension>
constexpr double size = Dimension == 2 ? 20.0 : 6.5;

/// Bodies in the plane, or spheres in space.
template <int Dimension>
struct Bodies {
    BodyStates<Dimension> flying;
    BodyProperties properties;
    Pairing<Dimension> pairing;  ///< as drawn below
    double shift;
    bool nearest;
    double now;
};

// Some are without mass's inverse and some are points, or all are alike.
BodyProperties draw_properties(Random& random, std::size_t count, bool alike) {
    Particles particles;
    particles.radius = Eigen::ArrayXd::Constant(static_cast<Eigen::Index>(count), 0.6);
    particles.inverse_mass = Eigen::ArrayXd::Ones(static_cast<Eigen::Index>(count));
    for (Eigen::Index k = 0; !alike && k < particles.count(); ++k) {
        particles.radius[k] = random.uniform() < 0.1 ? 0.0 : random.uniform(0.1, 1.0);
        if (random.uniform() < 0.3) particles.inverse_mass[k] = 0.0;
    }
    return BodyProperties(particles);
}

// Bodies at times of their own, some alike in place and motion, so that times are equal. Some have
// a contact before, and are left to look again themselves.
template <int Dimension>
Bodies<Dimension> draw_bodies(Random& random, std::size_t count) {
    const bool alike = random.uniform() < 0.5;
    Bodies<Dimension> bodies{
        BodyStates<Dimension>(count),         draw_properties(random, count, alike), {}, 0.0, false,
        random.uniform() < 0.5 ? 1.0 : 4096.7};
    for (std::size_t k = 0; k < count; ++k) {
        BodyState<Dimension>& d = bodies.flying[k];
        if (k > 1 && random.uniform() < 0.2) {
            d = bodies.flying[k - 1];
        } else {
            for (double& x : d.x) x = random.uniform(0.0, size<Dimension>);
            for (double& v : d.v) v = random.normal();
            d.time = bodies.now - random.uniform();
            d.collisions = static_cast<std::uint32_t>(random.below(1000));
        }
        d.prediction = {};
        if (random.uniform() < 0.5)
            d.prediction.contact_time = bodies.now + random.uniform(-1.0, 8.0);
    }
    bodies.nearest = random.uniform() < 0.5;
    bodies.shift = bodies.nearest
                       ? 0.0
                       : -size<Dimension> + size<Dimension> * static_cast<double>(random.below(3));
    Box box;
    box.dimension = Dimension;
    box.size = {size<Dimension>, size<Dimension>, size<Dimension>};
    box.walls.fill(Wall::periodic);
    bodies.pairing = bodies.nearest ? Pairing<Dimension>::nearest(box)
                                    : Pairing<Dimension>::shifted({bodies.shift});
    if (bodies.properties.alike()) bodies.pairing.sigma = 1.2;
    return bodies;
}

double nearest_image(double x, double size) {
    return x > 0.5 * size ? x - size : x < -0.5 * size ? x + size : x;
}

// One after the other, as the header has it.
template <int Dimension>
FirstContact slow_search(const Bodies<Dimension>& bodies, std::int32_t i,
                         const std::vector<std::int32_t>& near, FirstContact first) {
    const BodyState<Dimension>& a = bodies.flying[std::size_t(i)];
    const double now = bodies.now;
    for (const std::int32_t other : near) {
        const BodyState<Dimension>& b = bodies.flying[std::size_t(other)];
        const auto apart = [&](std::size_t axis) {
            const double here = a.x[axis] + a.v[axis] * (now - a.time);
            const double there = b.x[axis] + b.v[axis] * (now - b.time);
            return bodies.nearest ? nearest_image(there - here, size<Dimension>)
                                  : there - (here - (axis == 0 ? bodies.shift : 0.0));
        };
        RelativeMotion<double, std::size_t(Dimension)> m;
        for (std::size_t axis = 0; axis < m.r.size(); ++axis) {
            m.r[axis] = apart(axis);
            m.v[axis] = b.v[axis] - a.v[axis];
        }
        const Properties &one = bodies.properties[i], &two = bodies.properties[other];
        const double time =
            now + contact_time(m, one.radius + two.radius, approach_round_off(m, a.v, b.v));
        if (other == i || !std::isfinite(time) || one.inverse_mass + two.inverse_mass == 0.0 ||
            one.radius + two.radius == 0.0 || time > b.prediction.contact_time)
            continue;
        if (time < first.time || (time == first.time && other < first.partner()))
            first = FirstContact(time, other, b.collisions);
    }
    return first;
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

// Sometimes the first to be touched, or another, has a contact just then or just before.
template <int Dimension>
void let_contacts_coincide(Random& random, Bodies<Dimension>& bodies, std::int32_t i,
                           const std::vector<std::int32_t>& near) {
    for (const double chance : {0.5, 0.2}) {
        const FirstContact first = slow_search(bodies, i, near, FirstContact());
        if (!std::isfinite(first.time) || random.uniform() > chance) continue;
        BodyState<Dimension>& other = bodies.flying[std::size_t(first.partner())];
        other.prediction.contact_time =
            random.uniform() < 0.5 ? first.time : std::nextafter(first.time, 0.0);
    }
}

}  // namespace

TEST_CASE_TEMPLATE("the search among many finds what looking at one after the other finds", Space,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    Random random(5, "search");
    int found = 0, equal = 0;
    for (int round = 0; round < 20'000; ++round) {
        const auto count = static_cast<std::size_t>(1 + random.below(most_searched));
        auto bodies = draw_bodies<Space::value>(random, count);
        const double now = bodies.now;
        FirstContact known;
        if (random.uniform() < 0.3) known = FirstContact(now + random.uniform(0.0, 8.0), 3, 5);
        const auto i = static_cast<std::int32_t>(random.below(count));
        const std::vector<std::int32_t> near = all_but(-1, random, count, i);
        let_contacts_coincide(random, bodies, i, near);
        if (random.uniform() < 0.1) known = slow_search(bodies, i, near, FirstContact());

        const FirstContact slow = slow_search(bodies, i, near, known);
        FirstContact fast = known;
        search_contact(bodies.flying, bodies.properties, i, now, near.data(), near.size(),
                       bodies.pairing, fast);
        REQUIRE(fast.time == slow.time);
        REQUIRE(fast.who == slow.who);
        if (!std::isfinite(slow.time) || slow.time == known.time) continue;
        ++found;
        const auto partner = std::size_t(slow.partner());
        if (partner + 1 < count && bodies.flying[partner + 1].x == bodies.flying[partner].x)
            ++equal;
    }
    // Otherwise the comparison would say little.
    CHECK(found > 5'000);
    CHECK(equal > 500);
}

TEST_CASE_TEMPLATE("the search for two at once finds what two searches find", Space,
                   std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
    Random random(8, "search");
    int found = 0;
    for (int round = 0; round < 20'000; ++round) {
        const auto count = static_cast<std::size_t>(2 + random.below(most_searched / 2 - 1));
        auto bodies = draw_bodies<Space::value>(random, count);
        const auto i = static_cast<std::int32_t>(random.below(count));
        const auto j = static_cast<std::int32_t>((i + 1 + random.below(count - 1)) % count);
        const std::vector<std::int32_t> near_i = all_but(j, random, count, i);
        const std::vector<std::int32_t> near_j = all_but(i, random, count, j);
        let_contacts_coincide(random, bodies, i, near_i);
        let_contacts_coincide(random, bodies, j, near_j);
        std::vector<std::int32_t> near = near_i;
        near.insert(near.end(), near_j.begin(), near_j.end());

        const std::array slow{slow_search(bodies, i, near_i, FirstContact()),
                              slow_search(bodies, j, near_j, FirstContact())};
        std::array<FirstContact, 2> fast;
        search_two_contacts(bodies.flying, bodies.properties, {i, j}, bodies.now, near.data(),
                            near_i.size(), near.size(), bodies.pairing, fast);
        for (std::size_t k = 0; k < 2; ++k) {
            REQUIRE(fast[k].time == slow[k].time);
            REQUIRE(fast[k].who == slow[k].who);
            if (std::isfinite(slow[k].time)) ++found;
        }
    }
    CHECK(found > 8'000);
}

TEST_CASE("a disk so fast that it touches before the clock moves is found") {
    // The other's own contact is now, as the clock has it; this one comes 0.4 of its steps later.
    const double now = 4096.0, step = now * 0x1p-52, v = 1e12;
    Random random(6, "fast");
    Bodies<2> bodies{BodyStates<2>(2), draw_properties(random, 2, true), {}, 0.0, false, now};
    bodies.pairing = Pairing<2>::shifted({});
    bodies.pairing.sigma = 1.2;
    bodies.flying[0] = {
        .x = {0.0, 0.0}, .v = {v, 0.0}, .time = now, .collisions = 0, .cell = {}, .prediction = {}};
    bodies.flying[1] = {.x = {1.2 + 0.4 * step * v, 0.0},
                        .v = {0.0, 0.0},
                        .time = now,
                        .collisions = 7,
                        .cell = {},
                        .prediction = {.contact_time = now}};
    const std::vector<std::int32_t> near{1, 0, 0, 0};
    FirstContact first;
    search_contact(bodies.flying, bodies.properties, 0, now, near.data(), near.size(),
                   bodies.pairing, first);
    CHECK(first.time == now);
    CHECK(first.partner() == 1);
    CHECK(first.collisions() == 7);
}

TEST_CASE("properties of bodies are known once where all are alike, and follow a new order") {
    Particles particles;
    particles.radius = Eigen::ArrayXd::Constant(3, 0.5);
    particles.inverse_mass = Eigen::ArrayXd::Constant(3, 2.0);
    BodyProperties same(particles);
    CHECK(same.alike());
    same.renumber({2, 0, 1});
    CHECK(same[2].inverse_mass == 2.0);
    particles.inverse_mass.setZero();  // fixed: none of them ever meets another
    CHECK(!BodyProperties(particles).alike());
    CHECK(BodyProperties(particles)[1].inverse_mass == 0.0);
    particles.inverse_mass << 1.0, 2.0, 3.0;
    BodyProperties mixed(particles);
    CHECK(!mixed.alike());
    mixed.renumber({2, 0, 1});
    CHECK(mixed[0].inverse_mass == 3.0);
    CHECK(mixed[1].inverse_mass == 1.0);
    CHECK(mixed[2].inverse_mass == 2.0);
}
