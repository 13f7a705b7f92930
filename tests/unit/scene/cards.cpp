// The cards before and after a film.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/scene.h"
#include "scene/time/captions.h"
#include "scene/time/timeline.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene film(const std::string& film, const std::string& events = "") {
    return test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 1}]\nrun: {until: 12, "
        "events: [" +
        events + "]}\nfilm: {" + film + "}\n");
}

std::ptrdiff_t frames_of(const std::vector<Tick>& ticks, Phase phase) {
    return std::ranges::count_if(ticks, [=](const Tick& tick) { return tick.phase == phase; });
}

}  // namespace

TEST_CASE("cards are part of the film's seconds: the number of frames stays") {
    for (const char* cards :
         {"", ", title_card: true", ", end_card: The end", ", title_card: 5, end_card: The end"})
        for (const double seconds : {0.1, 1.0, 7.77, 30.0}) {
            CAPTURE(cards);
            CAPTURE(seconds);
            const auto ticks = timeline(film("seconds: " + std::to_string(seconds) + cards));
            CHECK(ticks.size() == static_cast<std::size_t>(std::lround(seconds * 30)));
            CHECK(ticks.front().time == 0.0);
            CHECK(ticks.back().time == 12.0);
            const auto shown =
                frames_of(ticks, Phase::title_card) + frames_of(ticks, Phase::end_card);
            CHECK(shown <= static_cast<std::ptrdiff_t>(ticks.size() / 3));
        }
}

TEST_CASE("a film with a pace has room for its cards and for a pause of half of it") {
    const Scene scene = film("pace: 4, title_card: true, end_card: The end", "{at: 1, pause: 4}");
    CHECK(scene.film.seconds == 3.0 + 7.0 + 4.0);
}

TEST_CASE(
    "a title card is 3 s and an end card 4 s long where the film has room, before the holds") {
    const auto ticks = timeline(film("seconds: 30, title_card: true, end_card: The end"));
    CHECK(frames_of(ticks, Phase::title_card) == 90);
    CHECK(frames_of(ticks, Phase::end_card) == 120);
    CHECK(ticks[89].phase == Phase::title_card);
    CHECK(ticks[90].phase == Phase::opening);
    CHECK(ticks[90].seconds == 0.0);
    CHECK(ticks[120].seconds == doctest::Approx(1.0));
    CHECK(frames_of(ticks, Phase::opening) == 45);
    CHECK(ticks[779].phase == Phase::closing);
    CHECK(ticks[780].phase == Phase::end_card);
    CHECK(frames_of(timeline(film("seconds: 30, title_card: 1.5")), Phase::title_card) == 45);
    CHECK(frames_of(timeline(film("seconds: 30, title_card: false")), Phase::title_card) == 0);
}

TEST_CASE("with a pace the cards come on top") {
    CHECK(film("pace: 1").film.seconds == 12.0);
    CHECK(film("pace: 1, title_card: true, end_card: The end").film.seconds == 19.0);
}

TEST_CASE("with cards the way back still mirrors the way out, and captions begin with the gas") {
    const Scene scene = film("seconds: 30, title_card: true, end_card: The end",
                             "{at: 6, reverse: velocities}, {at: 0, caption: words}");
    std::vector<double> out, back;
    for (const Tick& tick : timeline(scene)) {
        if (tick.phase != Phase::moving) continue;
        if (tick.time <= 6.0) out.push_back(tick.time);
        if (tick.time >= 6.0) back.push_back(12.0 - tick.time);
    }
    std::ranges::reverse(back);
    REQUIRE(out.size() == back.size());
    for (std::size_t i = 0; i < out.size(); ++i) CHECK(std::abs(out[i] - back[i]) < 1e-12);
    const CaptionSpan span = caption_schedule(scene).at(0);
    CHECK(span.first == 90);
    CHECK(span.last == 779);
    CHECK(span.start == doctest::Approx(3.0));
    CHECK(span.end == doctest::Approx(26.0));
    CHECK(opacity(span, scene.film, 90, caption_fade_seconds) == 1.0);
    CHECK(opacity(span, scene.film, 779, caption_fade_seconds) == 1.0);
}

TEST_CASE("an end card appears over the gas in the half second before it, a title card is over") {
    const Scene scene = film("seconds: 30, fps: 20, title_card: true, end_card: The end");
    const auto ticks = timeline(scene);
    for (const Tick& tick : ticks) {
        CAPTURE(tick.frame);
        const double cover = card_cover(scene.film, tick);
        const int before = 519 - tick.frame;  // frames of the gas
        if (is_card(tick.phase))
            CHECK(cover == 1.0);
        else
            CHECK(cover == doctest::Approx(std::max(0.0, 0.9 - 0.1 * before)));
    }
    const Scene bare = film("seconds: 30");
    CHECK(card_cover(bare.film, timeline(bare).front()) == 0.0);
    CHECK(card_cover(bare.film, timeline(bare).back()) == 0.0);
}
