// A still drawn alone, against the frame of the whole plan.
#include <doctest/doctest.h>

#include <string>

#include "films/film_plan.h"
#include "films/render.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& run, const std::string& film) {
    return test::scene_from(
        "title: T\nbox: {size: [20, 15], walls: periodic}\ngas:\n"
        "  - {name: light, count: 20, radius: 0.4, speed: 2}\n"
        "  - {name: heavy, count: 5, radius: 0.6, mass: 3, temperature: 1, trail: 2}\n"
        "run: " +
        run + "\nfilm: {size: 720p, " + film + "}\n");
}

bool is_the_frame_of_the_film(const Scene& scene, double at, bool is_quick) {
    Progress silent(Progress::Form::silent, "");
    const OutputFormat& png = output_format("png");
    return draw_still_alone(scene, at, is_quick, "", png, silent).picture.file() ==
           draw_still(prepare(scene, {}, silent), at, png, silent).file();
}

}  // namespace

TEST_CASE("a still drawn alone is the frame of the film") {
    constexpr bool is_quick = false;
    const Scene gas = scene_of("{until: 20}", "seconds: 6, panels: [temperature, pressure]");
    for (const double at : {0.0, 7.0, 20.0}) CHECK(is_the_frame_of_the_film(gas, at, is_quick));
    const Scene echo = scene_of("{until: 4, events: [{at: 2, reverse: velocities}]}",
                                "seconds: 6, title_card: 1, panels: [return-distance]");
    CHECK(is_the_frame_of_the_film(echo, 3.5, is_quick));
}

TEST_CASE("a quick still sees thirty frames, all of a film that has no more") {
    constexpr bool is_quick = true;
    const Scene shortest = scene_of("{until: 20}", "seconds: 1, panels: [temperature, pressure]");
    CHECK(is_the_frame_of_the_film(shortest, 7.0, is_quick));
    // Speeds are the highest in few of the frames, which set the scale of colours.
    const Scene gas = scene_of("{until: 20}", "seconds: 20, panels: [temperature, pressure]");
    CHECK_FALSE(is_the_frame_of_the_film(gas, 7.0, is_quick));
    const Scene echo = scene_of("{until: 4, events: [{at: 2, reverse: velocities}]}",
                                "seconds: 6, panels: [return-distance]");
    CHECK(is_the_frame_of_the_film(echo, 3.5, is_quick));  // it needs all
}
