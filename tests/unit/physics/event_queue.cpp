#include "physics/events/event_queue.h"

#include <doctest/doctest.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "physics/collision/pair_collision.h"
#include "physics/events/local_clock.h"
#include "util/random.h"

using namespace carom;

namespace {

using Order = std::set<std::pair<double, std::int32_t>>;

// Whether others have events until a time: the quick answer may be wrongly yes, never wrongly no,
// and the slow one is right within a year of the queue.
void compare_others_until(const EventQueue& queue, const Order& order, double now,
                          std::int32_t found) {
    const auto second = std::next(order.begin());
    const double next = second == order.end() ? never<double> : second->first;
    const auto another = [found](std::int32_t particle) { return particle != found; };
    for (const double until : {now, now + 1e-9, now + 0.3, next}) {
        if (!std::isfinite(until)) continue;
        const bool others = next <= until;
        if (others) CHECK(queue.may_have_another_until(until));
        if (others) CHECK(queue.has_another_until(until, another));
        if (!queue.may_have_another_until(until)) CHECK_FALSE(others);
    }
    if (order.size() > 1 && now < next) CHECK_FALSE(queue.has_another_until(now, another));
}

// Draws and replaces events as a simulation does, and compares with a search through all.
void compare_with_all(std::int32_t count, int events_processed, double spread) {
    constexpr double nothing = std::numeric_limits<double>::infinity();
    Random random(3, "queue");
    // Times of very different sizes, many of them equal, some without an event.
    const auto draw = [&random, spread](double now) {
        const double u = random.uniform();
        if (u < 0.1) return nothing;
        if (u < 0.4) return now + std::floor(4.0 * random.uniform());
        if (u < 0.5) return now + 4096.0 * std::floor(1000.0 * random.uniform());
        return now + std::exp(random.uniform(-20.0, spread));
    };
    std::vector<double> times(static_cast<std::size_t>(count));
    std::set<std::pair<double, std::int32_t>> order;
    for (std::int32_t i = 0; i < count; ++i) {
        times[std::size_t(i)] = draw(0.0);
        order.insert({times[std::size_t(i)], i});
    }
    EventQueue queue(count);
    queue.reset(times);
    int processed = 0;
    for (; processed < events_processed; ++processed) {
        const std::int32_t found = queue.earliest();
        if (found < 0) {
            const double shift = queue.next_cycle();
            if (!std::isfinite(shift)) break;
            queue.begin_cycle(shift);
            order.clear();
            for (std::int32_t i = 0; i < count; ++i) {
                times[std::size_t(i)] -= shift;
                order.insert({times[std::size_t(i)], i});
            }
            continue;
        }
        const auto [now, first] = *order.begin();
        REQUIRE(found == first);
        REQUIRE(queue.time(found) == now);
        REQUIRE(queue.earliest() == found);
        compare_others_until(queue, order, now, found);
        // as in the simulation: the one at hand, and another one with it
        for (const auto i : {first, static_cast<std::int32_t>(random.below(count))}) {
            order.erase({times[std::size_t(i)], i});
            times[std::size_t(i)] = draw(now);
            order.insert({times[std::size_t(i)], i});
            queue.schedule(i, times[std::size_t(i)]);
        }
    }
    CHECK(processed == events_processed);
}

}  // namespace

TEST_CASE("events come in the order of their times, at equal times of their numbers") {
    compare_with_all(50, 200'000, 5.0);
}

TEST_CASE("events of cycles of many years come in order") {
    compare_with_all(1'500, 100'000, 5.0);
    compare_with_all(20'000, 300'000, 1.0);
}

TEST_CASE("an event replaced again and again takes no more room") {
    constexpr std::int32_t count = 10'000;
    Random random(6, "queue");
    std::vector<double> times(count);
    for (double& time : times) time = random.uniform();
    EventQueue queue(count);
    queue.reset(times);
    const auto bytes = [] { return mallinfo2().uordblks + mallinfo2().hblkhd; };
    const std::size_t before = bytes();
    for (int k = 0; k < 1'000'000; ++k) {
        const auto i = static_cast<std::int32_t>(random.below(count));
        times[std::size_t(i)] = random.uniform();
        queue.schedule(i, times[std::size_t(i)]);
    }
    // Four notes for each, and as much again that a vector holds ready; all kept would be 400
    // bytes.
    CHECK(bytes() < before + 40 * std::size_t{count});
    std::vector<std::int32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&times](std::int32_t a, std::int32_t b) {
        return times[std::size_t(a)] < times[std::size_t(b)];
    });
    for (const std::int32_t next : order) {
        while (queue.earliest() < 0) queue.begin_cycle(queue.next_cycle());
        REQUIRE(queue.earliest() == next);
        queue.schedule(next, never<double>);
    }
    CHECK(queue.earliest() == -1);
}

TEST_CASE("looking ahead tells of nearly each event of the next hours, and never twice") {
    constexpr std::int32_t count = 8192;
    Random random(4, "queue");
    std::vector<double> times(count);
    for (double& time : times) time = random.uniform();
    EventQueue queue(count);
    queue.reset(times);
    std::vector<int> told(count, 0);
    int in_time = 0;
    for (int k = 0; k < count; ++k) {
        const std::int32_t i = queue.earliest();
        REQUIRE(i >= 0);
        in_time += told[std::size_t(i)];
        std::array<std::int32_t, 3> who;
        const std::uint32_t more = queue.look_ahead(32, who);
        REQUIRE(more <= who.size());
        for (std::uint32_t n = 0; n < more; ++n) {
            ++told[std::size_t(who[n])];
            CHECK(queue.time(who[n]) >= queue.time(i));
        }
        queue.schedule(i, never<double>);
    }
    CHECK(queue.earliest() == -1);
    for (const int times_told : told) REQUIRE(times_told <= 1);
    // all but those that came first on their day, and a fourth in one hour
    CHECK(in_time > 0.97 * count);
    CHECK(in_time < count);
}

TEST_CASE("an empty queue is a valid state") {
    EventQueue queue(3);
    queue.reset(std::vector<double>(3, never<double>));
    CHECK(queue.earliest() == -1);
    CHECK(std::isinf(queue.next_cycle()));
    queue.schedule(1, 2.5);
    while (queue.earliest() < 0) queue.begin_cycle(queue.next_cycle());
    CHECK(queue.earliest() == 1);
}

TEST_CASE("a clock keeps short times exact at late epochs") {
    LocalClock clock;
    clock.start(1e10);
    for (int i = 0; i < 1024; ++i) clock.advance(0x1p-30);  // each less than half an ulp of 1e10
    CHECK(clock.local(1e10 + 0x1p-19) == 0x1p-19 - 0x1p-20);
    CHECK(clock.absolute(0x1p-20) == 1e10 + 0x1p-19);
}
