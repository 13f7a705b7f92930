// A still drawn alone, against the frame of the whole plan.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "films/first_pass.h"
#include "films/render.h"
#include "support/files.h"
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

TEST_CASE("so is one of two runs, which takes as little from the cache") {
    const Scene both = scene_of("{until: 20}",
                                "seconds: 6, panels: [temperature], "
                                "beside: {own_label: A, label: B, set: gas.0.speed=3}");
    for (const double at : {0.0, 7.0}) CHECK(is_the_frame_of_the_film(both, at, false));
    const test::TemporaryFolder cache;
    Progress silent(Progress::Form::silent, "");
    const auto at_seven = [&] {
        Still still =
            draw_still_alone(both, 7.0, false, cache.path(), output_format("png"), silent);
        CHECK(still.frames_seen == still.frames);
        return still.picture.file();
    };
    const std::vector<std::uint8_t> first = at_seven();
    CHECK_FALSE(std::filesystem::is_empty(cache.path()));
    CHECK(at_seven() == first);
}

TEST_CASE("the plan of a still has its frames only, and of later ones what its panels saw") {
    const Scene both = scene_of("{until: 20}",
                                "seconds: 6, panels: [temperature], "
                                "beside: {own_label: A, label: B, set: gas.0.speed=3}");
    Progress silent(Progress::Form::silent, "");
    const StillPlan still = prepare_still(both, 5.0, false, "", silent);
    const FilmPlan whole = prepare(both, {}, silent);
    CHECK(still.plan.axes == whole.axes);
    REQUIRE(still.plan.runs.size() == 2);
    for (const Recording& run : still.plan.runs) {
        CHECK(run.is_kept());
        CHECK(run.ticks().back().time == doctest::Approx(5.0).epsilon(0.02));
    }
    CHECK(still.plan.ticks().size() < whole.ticks().size() / 2);
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
