#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "physics/event_queue.h"
#include "physics/local_clock.h"
#include "util/random.h"

using namespace carom;

TEST_CASE("events come in the order of their times, at equal times of their numbers") {
    constexpr std::int32_t count = 50;
    constexpr double nothing = std::numeric_limits<double>::infinity();
    Random random(3, "queue");
    // Times of very different sizes, many of them equal, some without an event.
    const auto draw = [&random](double now) {
        const double u = random.uniform();
        if (u < 0.1) return nothing;
        if (u < 0.4) return now + std::floor(4.0 * random.uniform());
        if (u < 0.5) return now + 4096.0 * std::floor(1000.0 * random.uniform());
        return now + std::exp(random.uniform(-20.0, 5.0));
    };
    std::vector<Event> events(count);
    for (Event& event : events) event.time = draw(0.0);
    EventQueue queue(count);
    queue.reset(events);
    int processed = 0;
    for (; processed < 200'000; ++processed) {
        const std::int32_t found = queue.earliest();
        if (found < 0) {
            const double shift = queue.next_lap();
            if (!std::isfinite(shift)) break;
            queue.begin_lap(shift);
            for (Event& event : events) event.time -= shift;
            continue;
        }
        std::int32_t first = 0;
        for (std::int32_t i = 1; i < count; ++i)
            if (events[std::size_t(i)].time < events[std::size_t(first)].time) first = i;
        REQUIRE(found == first);
        const double now = events[std::size_t(first)].time;
        REQUIRE(queue.event(found).time == now);
        // as in the simulation: the one at hand, and another one with it
        for (const auto i : {first, static_cast<std::int32_t>(random.below(count))}) {
            events[std::size_t(i)].time = draw(now);
            queue.schedule(i, events[std::size_t(i)]);
        }
    }
    CHECK(processed == 200'000);
}

TEST_CASE("an empty queue is a valid state") {
    EventQueue queue(3);
    queue.reset(std::vector<Event>(3));
    CHECK(queue.earliest() == -1);
    CHECK(std::isinf(queue.next_lap()));
    queue.schedule(1, {.time = 2.5, .contact_time = 3.0, .partner = 7});
    while (queue.earliest() < 0) queue.begin_lap(queue.next_lap());
    CHECK(queue.earliest() == 1);
    CHECK(queue.event(1).partner == 7);
    CHECK(queue.event(1).contact_time - queue.event(1).time == 0.5);
}

TEST_CASE("a clock keeps short times exact at late epochs") {
    LocalClock clock(1e10);
    for (int i = 0; i < 1024; ++i) clock.advance(0x1p-30);  // each less than half an ulp of 1e10
    CHECK(clock.local(1e10 + 0x1p-19) == 0x1p-19 - 0x1p-20);
    CHECK(clock.absolute(0x1p-20) == 1e10 + 0x1p-19);
}
