// When captions are on the screen, and the room that they take.
#include "scene/time/captions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "support/resources.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

const std::filesystem::path templates = test::resources().templates;

Scene film(const std::string& events, const std::string& film = "seconds: 20",
           const Overrides& overrides = {}) {
    return test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 1}]\nrun: {until: 12, "
        "events: [" +
            events + "]}\nfilm: {" + film + "}\n",
        overrides);
}

std::string complaint(const std::string& events, const std::string& length) {
    try {
        film(events, length);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE(
    "a caption stands from the first frame at its time until the next, its seconds or the end") {
    const Scene scene = film(
        "{at: 4, caption: two, for: 3}, {at: 0, caption: one}, {at: 8, caption: three}, "
        "{at: 10.5, caption: ''}");
    const std::vector<Tick> ticks = timeline(scene);
    const std::vector<CaptionSpan> spans = caption_schedule(scene);
    REQUIRE(spans.size() == 4);
    CHECK(spans[0].words == "one");
    CHECK(spans[0].first == 0);
    CHECK(spans[0].last + 1 == spans[1].first);
    for (std::size_t i = 1; i < spans.size(); ++i) {
        const double at = scene.captions[i].at;
        const auto first = static_cast<std::size_t>(spans[i].first);
        CHECK(ticks[first].time >= at);
        CHECK(ticks[first - 1].time < at);
    }
    CHECK(spans[1].last - spans[1].first + 1 == 90);
    CHECK(spans[1].last + 1 < spans[2].first);
    CHECK(spans[2].last + 1 == spans[3].first);
    CHECK(spans[3].words.empty());
    CHECK(spans[3].last == 599);
    CHECK(spans[0].start == 0.0);
    CHECK(spans[3].end == doctest::Approx(20.0));
    CHECK(spans[1].end - spans[1].start == doctest::Approx(3.0));
}

TEST_CASE("at a reversal a caption comes when the gas stops") {
    const Scene scene = film("{at: 6, reverse: velocities}, {at: 6, caption: back}");
    const std::vector<Tick> ticks = timeline(scene);
    const auto first = static_cast<std::size_t>(caption_schedule(scene)[0].first);
    CHECK(ticks[first].time == 6.0);
    CHECK(ticks[first].phase == Phase::moving);
    CHECK(ticks[first + 1].phase == Phase::reversing);
}

TEST_CASE("captions come and go within 0.2 s, but stand whole at both ends of the film") {
    const Scene scene = film("{at: 0, caption: one}, {at: 6, caption: two}");
    const std::vector<CaptionSpan> spans = caption_schedule(scene);
    CHECK(opacity(spans[0], scene.film, 0, caption_fade_seconds) == 1.0);
    CHECK(opacity(spans[1], scene.film, 599, caption_fade_seconds) == 1.0);
    const int change = spans[1].first;
    CHECK(opacity(spans[0], scene.film, change, caption_fade_seconds) == 0.0);
    CHECK(opacity(spans[1], scene.film, change - 1, caption_fade_seconds) == 0.0);
    double last = 0.0;
    for (int i = 0; i < 6; ++i) {  // 0.2 s
        const double coming = opacity(spans[1], scene.film, change + i, caption_fade_seconds);
        CHECK(coming > last);
        CHECK(coming < 1.0);
        CHECK(opacity(spans[0], scene.film, change - 1 - i, caption_fade_seconds) == coming);
        last = coming;
    }
    CHECK(opacity(spans[1], scene.film, change + 6, caption_fade_seconds) == 1.0);
}

TEST_CASE("a caption that is cut below 2.5 s is refused, one that just fits is not") {
    // 12 units in 16.5 s without the holds: 2.5 s are 1.82 units.
    const std::string two = "{at: 4, caption: one}, {at: 5.83, caption: two}";
    CHECK(complaint(two, "seconds: 20") == "");
    const std::string cut =
        complaint("{at: 4, caption: one}, {at: 5.5, caption: two}", "seconds: 20");
    CHECK(cut.find("on the screen for 2.0") != std::string::npos);
    CHECK(cut.find("seconds of film, until the next one at time 5.5; expected at least 2.5") !=
          std::string::npos);
    CHECK(complaint("{at: 11.9, caption: late}", "seconds: 20").find("until the film ends") !=
          std::string::npos);
    CHECK(complaint("{at: 11.9, caption: ''}", "seconds: 20") == "");
    CHECK(complaint("{at: 0, caption: one}", "seconds: 2").find("for 2 seconds") !=
          std::string::npos);
}

TEST_CASE("a film that the command line makes shorter shows its captions as long as it can") {
    const Scene scene =
        film("{at: 0, caption: one}, {at: 4, caption: two}", "seconds: 20", {"film.seconds=1"});
    for (const CaptionSpan& span : caption_schedule(scene)) CHECK(span.end - span.start < 1.0);
    const Scene still =
        film("{at: 0, caption: one}, {at: 4, caption: two}, {at: 4.1, caption: three}",
             "seconds: 20", {"film.seconds=0.1"});
    CHECK(caption_schedule(still).size() == 3);
}

TEST_CASE("every template has a line for captions, in which numbers of one line may stand") {
    for (const auto& entry : std::filesystem::directory_iterator(templates / "films")) {
        const std::string name = entry.path().stem().string();
        CAPTURE(name);
        const std::string length = "seconds: 20, panels: [], template: " + name;
        const LayoutSpec without = film("{at: 6, reverse: velocities}", length).film.layout;
        const LayoutSpec with = film("{at: 0, caption: words}", length).film.layout;
        REQUIRE(with.caption.has_value());
        const Slot& line = *with.caption;
        CHECK(line.height >= 2.0);
        CHECK(line.y >= with.gas.y + with.gas.height - 1e-9);
        std::vector<Slot> places{with.title, with.gas, with.color_bar};
        if (with.clock) places.push_back(*with.clock);
        if (with.monitors && !is_one_line(*with.monitors)) places.push_back(*with.monitors);
        places.insert(places.end(), with.panels.begin(), with.panels.end());
        for (const Slot& place : places) {
            const bool across = place.x < line.x + line.width && line.x < place.x + place.width;
            const bool over = place.y + place.height <= line.y + 1e-9;
            const bool under = place.y >= line.y + line.height - 1e-9;
            CHECK((!across || over || under));
        }
        CHECK(with.gas.height > 0.85 * without.gas.height);
    }
}

TEST_CASE("without panels the gas has their room, and nothing overlaps") {
    for (const auto& [name, gas] : {std::pair{"lecture", Slot{2, 4, 60, 27.2}},
                                    {"side-by-side", Slot{2, 4, 60, 27.4}},
                                    {"data", Slot{2, 4, 60, 24.4}},
                                    {"portrait", Slot{1.4, 5.8, 24.2, 32.4}},
                                    {"square", Slot{1.6, 4, 32.8, 26}}}) {
        CAPTURE(name);
        const LayoutSpec layout = film("{at: 0, caption: words}",
                                       std::string("seconds: 20, panels: [], template: ") + name)
                                      .film.layout;
        CHECK(layout.gas.x == gas.x);
        CHECK(layout.gas.y == gas.y);
        CHECK(layout.gas.width == doctest::Approx(gas.width));
        CHECK(layout.gas.height == doctest::Approx(gas.height));
        CHECK(layout.panels.empty());
        for (const Slot& other : {layout.color_bar, *layout.caption, *layout.clock}) {
            CHECK(is_within(other, {0.0, 0.0, layout.grid_width, layout.grid_height}));
            const bool is_apart = other.y + other.height <= layout.gas.y + 1e-9 ||
                                  other.y >= layout.gas.y + layout.gas.height - 1e-9;
            CHECK(is_apart);
        }
    }
}

TEST_CASE("a template without a place for captions has it at the gas's foot") {
    LayoutSpec layout;
    layout.gas = {1.0, 6.0, 40.0, 30.0};
    layout.monitors = {1.0, 36.0, 40.0, 4.0};
    const LayoutSpec with = with_caption_line(layout);
    CHECK(with.caption->y + with.caption->height == 36.0);
    CHECK(with.gas.y + with.gas.height == with.caption->y);
    CHECK(with.monitors->y == 36.0);
}

TEST_CASE("a callout to a panel that a template of the command line leaves out goes with it") {
    const std::string over =
        "seconds: 20, panels: [temperature, entropy], callouts: [{at: 1, points_to: {panel: "
        "entropy, x: "
        "2}, "
        "text: here}, {at: 1, points_to: 0, text: there}]";
    CHECK(film("{at: 0, caption: one}", over).film.callouts.size() == 2);
    const Scene without = film("{at: 0, caption: one}", over, {"film.template=wide-gas"});
    CHECK(without.film.panels.empty());
    REQUIRE(without.film.callouts.size() == 1);
    CHECK(without.film.callouts[0].words == "there");
}
