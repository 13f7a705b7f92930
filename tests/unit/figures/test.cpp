// Goodness of fit of a figure's bars: what it says, and when it refuses.
#include <doctest/doctest.h>

#include "figures/figure_words.h"
#include "panels/plots/histogram_panel.h"
#include "support/figure_run.h"
#include "support/goodness_of_fit.h"
#include "support/scene_text.h"
#include "util/diagnostics.h"

using namespace carom;
using test::run_of;

namespace {

Scene scene_of(const std::string& gas, const std::string& figure) {
    return test::scene_from("title: A gas\nbox: {size: [40, 30]}\ngas: " + gas +
                            "\nrun: {until: 30}\nfilm: {seconds: 1, fps: 10}\nfigures: [" + figure +
                            "]\n");
}

std::string refusal(const Scene& scene) {
    try {
        run_of(scene);
    } catch (const SceneError& error) {
        return error.diagnostics().front().message;
    }
    return "";
}

double p_at(const Scene& scene) {
    const FigureRun run = run_of(scene);
    const Figure& figure = run.figures().front();
    const auto& panel = dynamic_cast<const HistogramPanel&>(*figure.panel);
    return panel.test(*figure.moments.front().state, 0).value().p;
}

}  // namespace

TEST_CASE("a caption tells the test, its statistic, its degrees of freedom and p") {
    const std::string gas = "[{name: a, count: 200, radius: 0.3, speed: 2}]";
    const Scene scene = scene_of(gas,
                                 "{name: a, kind: speed-histogram, at: 20, test: true, caption: "
                                 "Mine.}, {name: b, kind: speed-histogram, at: 20}");
    const FigureRun run = run_of(scene);
    const std::string caption = words_of(run, run.figures()[0]).caption;
    CAPTURE(caption);
    CHECK(caption.starts_with("Mine. Pearson’s chi-squared test against equilibrium: χ² = "));
    CHECK(caption.find(" degrees of freedom, p = ") != std::string::npos);
    CHECK(words_of(run, run.figures()[1]).caption.find("Pearson") == std::string::npos);
}

TEST_CASE("all particles at one speed are no gas in equilibrium, later they are") {
    const std::string gas = "[{name: a, count: 200, radius: 0.3, speed: 2}]";
    CHECK(p_at(scene_of(gas, "{name: a, kind: speed-histogram, at: 0, test: true}")) < 1e-12);
    CHECK(p_at(scene_of(gas, "{name: a, kind: speed-histogram, at: 30, test: true}")) > 1e-4);
}

TEST_CASE("over many seeds p of simulated gases is spread evenly") {
    Scene scene = scene_of("[{name: a, count: 150, radius: 0.4, speed: 2}]",
                           "{name: a, kind: speed-histogram, test: true, bins: 12, range: [0, 5]}");
    std::vector<double> found;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        scene.seed = scene.gas.seed = seed;
        found.push_back(p_at(scene));
    }
    CHECK(test::chance(found, [](double p) { return p; }) > 1e-3);
}

TEST_CASE("what cannot be tested is refused with the reason") {
    const std::string test = "{name: a, kind: speed-histogram, test: true}";
    const auto refused = [](const std::string& gas, const std::string& figure) {
        try {
            return refusal(scene_of(gas, figure));
        } catch (const SceneError& error) {  // as soon as the scene is read
            return error.diagnostics().front().message;
        }
    };
    CHECK(refused("[{name: a, count: 90, radius: 0.3, speed: 2}, {name: b, count: 9, radius: 0.3, "
                  "mass: 2}]",
                  test) == "this gas has no equilibrium to be tested against: the masses differ");
    // Fewer than 15 are refused before the run (tests/scenes_bad/figure_test_few.yaml).
    CHECK(refusal(scene_of("[{name: a, count: 15, radius: 0.3, speed: 2}]", test)) ==
          "too few particles for the test: fewer than three bars have 5 expected counts");
    CHECK(refused("[{name: a, count: 90, radius: 0.3, speed: 2}, {name: b, count: 30, radius: 0.3, "
                  "mass: infinite}]",
                  "{name: a, kind: speed-histogram, of: all, test: true}") ==
          "the test is for particles of one finite mass");
    CHECK(refusal(scene_of("[{name: a, count: 90, radius: 0.3, speed: 2}, {name: b, count: 9, "
                           "radius: 0.3, mass: 2}]",
                           "{name: a, kind: speed-histogram, of: a, test: true}")) == "");
}
