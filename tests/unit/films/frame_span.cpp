// Which frames show a time, and a part of a film.
#include "films/frame_span.h"

#include <doctest/doctest.h>

#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene film(const std::string& keys) {
    return test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 1}]\n"
        "run: {until: 20}\nfilm: {fps: 10, " +
        keys + "}\n");
}

}  // namespace

TEST_CASE("a time and a part of a film are shown without the cards over them") {
    for (const char* keys :
         {"seconds: 20, title_card: true, end_card: The end", "seconds: 20, title_card: true",
          "seconds: 20, end_card: The end", "seconds: 20"}) {
        CAPTURE(keys);
        const Scene scene = film(keys);
        const auto ticks = timeline(scene);
        const auto tick = [&](int frame) { return ticks[static_cast<std::size_t>(frame)]; };
        for (const double time : {0.0, 7.0, 20.0}) {
            CAPTURE(time);
            const Tick shown = tick(frame_nearest_to(scene.film, ticks, time));
            CHECK(shown.time == doctest::Approx(time).epsilon(0.02));
            CHECK(card_cover(scene.film, shown) == 0.0);
        }
        const FrameSpan span = frames_between(scene.film, ticks, 0.0, 20.0);
        CHECK(tick(span.first).time == 0.0);
        CHECK(tick(span.end - 1).time == 20.0);
        for (int frame = span.first; frame < span.end; ++frame)
            CHECK(card_cover(scene.film, tick(frame)) == 0.0);
        // No more is left out, and all where no end is asked for.
        CHECK(span.frames() == std::ranges::count_if(ticks, [&](const Tick& one) {
                  return card_cover(scene.film, one) == 0.0;
              }));
        CHECK(frames_between(scene.film, ticks, {}, {}).frames() == frame_count(scene.film));
    }
}

TEST_CASE("frames that all have a card over them are shown as they are") {
    const Scene scene = film("seconds: 1, title_card: true, end_card: The end");
    const auto ticks = timeline(scene);
    for (const double time : {0.0, 20.0}) {
        const Tick& shown =
            ticks[static_cast<std::size_t>(frame_nearest_to(scene.film, ticks, time))];
        CHECK(shown.time == time);
        CHECK_FALSE(is_card(shown.phase));
    }
    const FrameSpan span = frames_between(scene.film, ticks, 0.0, 20.0);
    CHECK(span.frames() ==
          std::ranges::count_if(ticks, [](const Tick& one) { return !is_card(one.phase); }));
}
