// The times that captions and alternative texts give: those of what the picture shows.
#include <doctest/doctest.h>

#include <cctype>
#include <cmath>
#include <string>

#include "figures/figure_words.h"
#include "support/figure_run.h"
#include "support/relative.h"
#include "support/resources.h"
#include "support/scene_text.h"
#include "support/test_root.h"

using namespace carom;
using test::relative;
using test::run_of;

namespace {

// Of the figure that the manual shows of a kind of panel.
FigureWords words_of_manual(const std::string& kind, const std::string& language = "en") {
    const Scene scene = load_scene((test::checkout() / "docs/panels" / (kind + ".yaml")).string(),
                                   test::resources(), {.set = {"film.language=" + language}});
    const FigureRun run = run_of(scene);
    REQUIRE(run.figures().size() == 1);
    return words_of(run, run.figures().front());
}

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

}  // namespace

// The centres of two disks of radius 2 are 2 apart across the motion, and touch when they are
// sqrt(16 - 4) apart along it, of the 9 at the start: at 9 - sqrt(12) = 5.536, and, if they passed
// through each other, at 9 + sqrt(12) = 12.46 again.
TEST_CASE("figures of a collision give its time, not that of the end of the run") {
    const double contact = 9.0 - std::sqrt(12.0);
    const FigureWords single = words_of_manual("single-collision");
    CHECK(
        single.caption ==
        "One disk hits another off centre. Single collision. Particles 0 (moving) and 1 (at rest) "
        "collide at time 5.54: speeds 1.00 and 0 before and 0.500 and 0.866 after.");
    CHECK(single.alt.starts_with(
        "Single collision at time 5.54. Particles 0 (moving) and 1 (at rest)"));
    const FigureWords parabola = words_of_manual("contact-time");
    CHECK(has(parabola.caption,
              "touch at time 5.54; if they passed through each other, they would "
              "separate at time 12.5."));
    CHECK(parabola.alt.starts_with("Contact time at time 5.54."));
    for (const FigureWords* words : {&single, &parabola}) {
        CHECK(words->time == "5.54");
        REQUIRE(words->shown.times.size() == 1);
        CHECK(words->shown.times.front() == relative(contact, 1e-12));
        CHECK_FALSE(words->shown.over);
    }
    CHECK(
        words_of_manual("single-collision", "de").alt.starts_with("Einzelner Stoß zur Zeit 5,54."));
}

TEST_CASE("a map of one collision is of its time, and a walk of the whole run") {
    const std::string beads =
        "title: T\nbox: {length: 26}\ngas:\n  - {name: light, position: 4, velocity: 0}\n"
        "  - {name: heavy, position: 14, mass: 9, velocity: -1}\nrun: {until: 40}\nfigures:\n"
        "  - {name: one, kind: collision-map}\n  - {name: all, kind: collision-map, walk: true}\n"
        "  - {name: given, kind: collision-map, masses: [1, 3], velocities: [1, -0.2]}\n";
    const Scene scene = test::scene_from(beads);
    const FigureRun run = run_of(scene);
    const auto words = [&](std::size_t k) { return words_of(run, run.figures()[k]); };
    CHECK(words(0).alt.starts_with("Collision map at time 10."));  // 14 - 4 at speed 1
    CHECK(words(1).alt.starts_with("Collision map from time 0 to 40."));
    CHECK(words(2).alt.starts_with("Collision map. "));
}

TEST_CASE("means are of the time that is averaged over, also by default") {
    CHECK(words_of_manual("free-time").alt.starts_with("Free time from time 0 to 100."));
    CHECK(
        words_of_manual("pair-correlation").alt.starts_with("Pair correlation from time 0 to 10."));
    CHECK(words_of_manual("profile").alt.starts_with("Profile from time 50 to 200."));
    CHECK(words_of_manual("speed-histogram").alt.starts_with("Speed histogram from time 100 to "));
}

TEST_CASE("curves against a time lag are of the time from which they are measured") {
    for (const std::string kind : {"velocity-autocorrelation", "mean-squared-displacement"}) {
        CAPTURE(kind);
        const FigureRun run = run_of(test::scene_from(
            "title: A gas\nbox: {size: [20, 20]}\ngas: [{count: 60, radius: 0.5, temperature: 4}]\n"
            "run: {until: 20}\nfigures: [{name: f, kind: " +
            kind + ", from: 5, lags: 4" +
            (kind == "mean-squared-displacement" ? ", origins: all" : "") + "}]\n"));
        const FigureWords words = words_of(run, run.figures().front());
        CHECK(has(words.alt, " from time 5 to 20. "));
        REQUIRE(words.shown.over);
        CHECK((*words.shown.over)[0] == 5.0);
    }
}

TEST_CASE("the caption of a result of a run gives its time and numbers, also if there is none") {
    for (const std::string of : {"", ", of: [a, b]"})
        for (const std::string origins : {"", ", origins: all, lags: 4"}) {
            const FigureRun run = run_of(test::scene_from(
                "title: A gas\nbox: {size: [20, 20]}\n"
                "gas: [{name: a, count: 50, radius: 0.5, temperature: 4}, {name: b, count: 10, "
                "radius: 0.5, temperature: 4}]\nrun: {until: 20}\n"
                "figures: [{name: f, kind: mean-squared-displacement" +
                of + origins + "}]\n"));
            const std::string caption = words_of(run, run.figures().front()).caption;
            CAPTURE(caption);
            CHECK(caption.starts_with("A gas. Mean squared displacement "));
            CHECK(has(caption, "20: 60 disks, "));
            CHECK(has(caption, " collisions between them by then; reduced units. "));
            CHECK(has(caption, "o diffusion coefficient"));
            const std::size_t account = caption.find("units. ") + 7;
            CHECK(std::isupper(static_cast<unsigned char>(caption[account])) != 0);
        }
}

TEST_CASE("a curve against time is not of the window of its last point alone") {
    for (const std::string kind : {"pressure", "flux", "pressure-volume"}) {
        const FigureWords words = words_of_manual(kind);
        CAPTURE(words.alt);
        CHECK(has(words.alt, " at time "));
        CHECK_FALSE(words.shown.over);
    }
}
