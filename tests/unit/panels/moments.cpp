#include <doctest/doctest.h>

#include "panels/means/trailing.h"
#include "panels/recording.h"

using namespace carom;

TEST_CASE("the moments of a first pass are frames, samples and events, each once") {
    Run run;
    run.until = 2.0;
    run.sample_every = 0.5;
    run.events = {{.at = 0.75, .action = ReverseVelocities{}}};
    std::vector<Tick> ticks;
    for (const double time : {0.0, 0.0, 0.4, 0.5, 0.6, 2.0, 2.0})
        ticks.push_back({.frame = static_cast<int>(ticks.size()), .time = time});
    ticks.front().phase = Phase::title_card;
    std::vector<double> frames, samples;
    double last = 0.0;
    for (const SeenMoment& moment : moments_of(ticks, run)) {
        CHECK(moment.tick.time >= last);
        last = moment.tick.time;
        if (moment.is_frame) frames.push_back(moment.tick.time);
        if (moment.is_sample) samples.push_back(moment.tick.time);
        if (is_card(moment.tick.phase)) CHECK(!moment.is_sample);
    }
    CHECK(frames == std::vector{0.0, 0.0, 0.4, 0.5, 0.6, 2.0, 2.0});
    CHECK(samples == std::vector{0.0, 0.5, 0.75, 1.0, 1.5, 2.0});
}

TEST_CASE("collisions of several advances are joined in order") {
    std::vector<Collision> all(5);
    for (std::size_t k = 0; k < all.size(); ++k) all[k].time = static_cast<double>(k);
    const std::span<const Collision> span(all);
    JoinedCollisions joined;
    CHECK(joined.take(span.first(2)).data() == all.data());  // not copied
    joined.add(span.subspan(2, 1));
    joined.add(span.subspan(3, 1));
    const auto taken = joined.take(span.subspan(4));
    REQUIRE(taken.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(taken[k].time == 2.0 + static_cast<double>(k));
    CHECK(joined.take({}).empty());
}

TEST_CASE("a window begins at a sample, whatever is added in between") {
    struct Sum {
        double time;
    };
    const auto since = [](Over over, bool with_between) {
        Trailing<Sum> sums(over);
        std::vector<double> from;
        for (int k = 0; k <= 40; ++k) {
            const bool is_sample = k % 4 == 0;
            if (is_sample || with_between || k == 39) sums.add({0.25 * k}, is_sample);
            if (is_sample || k == 39) {
                from.push_back(sums.from().time);
                from.push_back(sums.to().time);
            }
        }
        return from;
    };
    for (const Over over : {Over{Over::Since::start, 0.0}, Over{Over::Since::window, 2.5},
                            Over{Over::Since::window, 0.4}, Over{Over::Since::now, 0.0}})
        CHECK(since(over, true) == since(over, false));
    CHECK(since({Over::Since::window, 2.5}, true)[20] ==
          7.0);                                              // at 9.75: 7 is the last before 7.25
    CHECK(since({Over::Since::now, 0.0}, true)[20] == 8.0);  // from the sample at 8 to that at 9
}
