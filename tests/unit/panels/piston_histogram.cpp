// Where a wall that moves has been, against exact distributions.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "scene/scene.h"
#include "support/relative.h"
#include "support/seen_panel.h"

using namespace carom;
using test::relative;

namespace {

plot::Plot seen_histogram(const std::string& text, int steps) {
    const test::SeenPanel seen(
        test::scene_from("title: T\n" + text + "film: {seconds: 8, panels: [piston-histogram]}\n"),
        steps);
    return seen.plot(seen.last_state().get());
}

template <class Layer>
const Layer* layer_of(const plot::Plot& plot) {
    for (const plot::AnyLayer& layer : plot.layers)
        if (const auto* one = std::get_if<Layer>(&layer)) return one;
    return nullptr;
}

}  // namespace

TEST_CASE("a piston is where its exact distribution says, for the time that it says") {
    // Nine points between the floor and a light lid mix well: h has the exact law.
    const plot::Plot plot = seen_histogram(
        "box: {size: [6, 14], walls: {top: {mass: 5, force: -2}}}\n"
        "gas: [{name: a, count: 9, radius: 0.01, temperature: {exact: 2}}]\nrun: {until: 20000}\n",
        400);
    const auto* bars = layer_of<plot::Bars>(plot);
    const auto* law = layer_of<plot::Polyline>(plot);
    REQUIRE(bars != nullptr);
    REQUIRE(law != nullptr);
    double all = 0.0, under_law = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < bars->value.size(); ++i) {
        const double middle = 0.5 * (bars->from[i] + bars->to[i]);
        const auto at = static_cast<std::size_t>(std::lround(200.0 * middle / plot.x.high));
        all += bars->value[i];
        under_law += law->y[at];
        apart += std::abs(bars->value[i] - law->y[at]);
    }
    CHECK(all == relative(100.0, 1e-9));
    CHECK(under_law == relative(100.0, 1e-3));
    // Some 4000 swings, each a value of its own: 40 bars differ by 0.8 sqrt(p / 4000) each, in all
    // by some 5 %.
    CHECK(apart < 12.0);
}

TEST_CASE("a wall that has gone below 0 has bars there") {
    for (const auto& [wall, size] : {std::pair{"left", "[6, 5]"}, {"bottom", "[5, 6]"}}) {
        CAPTURE(wall);
        const plot::Plot plot = seen_histogram(
            fmt::format("box: {{size: {}, walls: {{{}: {{velocity: -0.5}}}}}}\n"
                        "gas: [{{name: a, count: 1, radius: 0.1, position: [3, 3]}}]\n"
                        "run: {{until: 12}}\n",
                        size, wall),
            60);
        const auto* bars = layer_of<plot::Bars>(plot);
        REQUIRE(bars != nullptr);
        CHECK(plot.x.low == bars->from[0]);
        CHECK(plot.x.low <= -6.0);
        // It goes evenly from 0 to -6.
        for (std::size_t k = 0; k < bars->value.size(); ++k) {
            const double inside =
                std::max(0.0, std::min(bars->to[k], 0.0) - std::max(bars->from[k], -6.0));
            CHECK(std::abs(bars->value[k] - 100.0 * inside / 6.0) < 1e-9);
        }
    }
}

TEST_CASE("a piston at the left has the law of one at the right, turned") {
    const auto mean_of_law = [](const std::string& wall) {
        const plot::Plot plot = seen_histogram(
            "box: {size: [14, 6], walls: {" + wall +
                "}}\ngas: [{name: a, count: 9, radius: 0.01, temperature: {exact: 2}}]\n"
                "run: {until: 2000}\n",
            100);
        const auto* law = layer_of<plot::Polyline>(plot);
        REQUIRE(law != nullptr);
        double all = 0.0, mean = 0.0;
        for (std::size_t k = 0; k < law->x.size(); ++k) {
            all += law->y[k];
            mean += law->y[k] * law->x[k];
        }
        return mean / all;
    };
    // E/F (N + 1) / (2 N + 3/2) from the other wall on, with E = 9 * 2 + 2 * 14. The part of the
    // tail that is beyond the axis moves the mean by less than a hundredth.
    const double height = 46.0 / 2.0 * 10.0 / 19.5;
    CHECK(mean_of_law("right: {mass: 5, force: -2}") == relative(height, 0.01));
    CHECK(14.0 - mean_of_law("left: {mass: 5, force: 2}") == relative(height, 0.01));
}
