// Histograms of the particles that are in parts of a box, against counts and times of residence
// that the tests find themselves.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "panels/plots/histogram_panel.h"
#include "scene/scene.h"
#include "support/relative.h"
#include "support/seen_panel.h"

using namespace carom;
using test::relative;

namespace {

struct Seen : test::SeenPanel {
    explicit Seen(const std::string& text, int steps = 80)
        : SeenPanel(test::scene_from("title: T\n" + text), steps), last(last_state()) {}
    const MeanHistogram& part(std::size_t k) const { return HistogramPanel::histograms(*last)[k]; }
    const Bins& bins() const { return dynamic_cast<const HistogramPanel&>(*panel).bins(); }

    std::shared_ptr<const PanelState> last;
};

// Sixty disks that share a box with a wall across it, at x = 10, with these further keys.
std::string halves(const std::string& wall, const std::string& panel) {
    return "box: {size: [20, 10]}\npartitions: [{name: wall, x: 10" + wall +
           "}]\n"
           "gas:\n"
           "  - {name: a, count: 40, radius: 0.15, speed: 1, position: {side: left, of: wall}}\n"
           "  - {name: b, count: 20, radius: 0.15, speed: 2, position: {side: right, of: wall}}\n"
           "run: {until: 40}\nfilm: {seconds: 8, panels: [" +
           panel + "]}\n";
}

constexpr const char* slit = ", gaps: [[3, 7]]";

// The number of values in a bin, of those for which `counts` holds.
double number(const Eigen::ArrayXd& values, const std::function<bool(Eigen::Index)>& counts,
              double low, double high) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < values.size(); ++i)
        if (counts(i) && values[i] >= low && values[i] < high) sum += 1.0;
    return sum;
}

void check_bars(const MeanHistogram& found, const std::vector<double>& expected, double near) {
    REQUIRE(found.counts.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        CAPTURE(k);
        CHECK(std::abs(found.counts[k] - expected[k]) < near);
    }
}

std::size_t layers_of_part(const plot::Plot& plot, const std::string& part) {
    return static_cast<std::size_t>(std::ranges::count_if(
        plot.layers, [&](const plot::AnyLayer& layer) { return common(layer).part == part; }));
}

}  // namespace

TEST_CASE("a histogram of the sides counts the particles that are on each side at present") {
    for (const std::string kind : {"speed-histogram", "energy-histogram", "position-histogram"}) {
        CAPTURE(kind);
        const Seen seen(halves(slit, "{kind: " + kind + ", surfaces: wall}"));
        Simulation simulation(seen.scene.gas, seen.scene.run);
        simulation.advance_to(40.0);
        const Sample& sample = simulation.sample();
        Eigen::ArrayXd values = sample.position.col(0);
        if (kind != "position-histogram")
            values = (sample.velocity.col(0).square() + sample.velocity.col(1).square()).sqrt();
        if (kind == "energy-histogram") values = 0.5 * values.square();
        double all = 0.0;
        for (const std::size_t side : {0, 1}) {
            std::vector<double> expected;
            const auto is_here = [&](Eigen::Index i) {
                return (sample.position(i, 0) < 10.0) == (side == 0);
            };
            for (int k = 0; k < seen.bins().count; ++k)
                expected.push_back(
                    number(values, is_here, seen.bins().edge(k), seen.bins().edge(k + 1)));
            check_bars(seen.part(side), expected, 1e-9);
            all += seen.part(side).values();
        }
        CHECK(all == 60.0);
    }
}

TEST_CASE("one particle counts in a part for the time that it is there") {
    // From 2 to the right at speed 4 between 1 and 19: back at 19 after 4.25, at 1 after 8.75.
    const Seen seen(
        "box: {size: [20, 10]}\n"
        "gas: [{name: a, count: 1, radius: 1, velocity: [4, 0], position: [2, 5]}]\n"
        "run: {until: 10}\nfilm: {seconds: 8, panels: [{kind: speed-histogram, over: start, "
        "regions: [{name: first, within: [0, 0, 5, 10]}, {name: last, within: [15, 0, 20, 10]},"
        "{name: beside, within: [0, 6, 20, 10]}]}]}\n",
        7);
    CHECK(seen.part(0).values() == relative((0.75 + 1.0 + 1.0) / 10.0, 1e-12));
    CHECK(seen.part(1).values() == relative((1.0 + 1.0) / 10.0, 1e-12));
    CHECK(seen.part(0).mean == relative(4.0, 1e-12));
    CHECK(seen.part(2).values() == 0.0);
    CHECK(std::isnan(seen.part(2).mean));
}

TEST_CASE("a particle that falls through a part has its speeds there") {
    // y = 9 - t^2 / 2, over [2, 7]: from t = 2 to sqrt(14), with speed t.
    const Seen seen(
        "box: {size: [20, 10]}\ngravity: [0, -1]\n"
        "gas: [{name: a, count: 1, radius: 0.5, velocity: [0, 0], position: [5, 9]}]\n"
        "run: {until: 4}\nfilm: {seconds: 8, panels: [{kind: velocity-histogram, component: y, "
        "over: start, range: [-5, 5], bins: 10, "
        "regions: [{name: middle, within: [0, 2, 20, 7]}]}]}\n",
        9);
    const double out = std::sqrt(14.0);
    std::vector<double> expected(10);
    expected[2] = 1.0 / 4.0;          // from -3 to -2
    expected[1] = (out - 3.0) / 4.0;  // from -4 to -3
    check_bars(seen.part(0), expected, 1e-12);
    CHECK(seen.part(0).mean == relative(-0.5 * (2.0 + out), 1e-12));
}

TEST_CASE("the bars of both sides are those of the whole gas, whatever they are averaged over") {
    for (const std::string over : {"now", "start", "{window: 10}", "{window: 10}, samples: clock",
                                   "start, samples: clock"}) {
        CAPTURE(over);
        const std::string rest = ", range: [0, 4], bins: 16, over: " + over + "}";
        const Seen sides(halves(slit, "{kind: speed-histogram, surfaces: wall" + rest));
        const Seen whole(halves(slit, "{kind: speed-histogram" + rest));
        const Seen parts(halves(slit,
                                "{kind: speed-histogram, regions: [{name: low, within: [0, 0, "
                                "10, 10]}, {name: high, within: [10, 0, 20, 10]}]" +
                                    rest));
        std::vector<double> sum = sides.part(0).counts;
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += sides.part(1).counts[k];
        check_bars(whole.part(0), sum, 1e-9);
        CHECK(sides.part(0).values() + sides.part(1).values() == relative(60.0, 1e-12));
        for (const std::size_t side : {0, 1})
            check_bars(parts.part(side), sides.part(side).counts, 1e-12);
    }
}

TEST_CASE("with samples by the clock each sample counts where its particles are") {
    const Seen seen(halves(slit,
                           "{kind: speed-histogram, surfaces: wall, over: start, samples: clock, "
                           "range: [0, 4.4], bins: 8}"),  // no edge at speeds 1 and 2
                    40);
    Simulation simulation(seen.scene.gas, seen.scene.run);
    std::vector<double> expected(8);
    for (const double time : seen.times) {
        simulation.advance_to(time);
        const Sample& sample = simulation.sample();
        const Eigen::ArrayXd speed = sample.velocity.square().rowwise().sum().sqrt();
        for (int k = 0; k < 8; ++k)
            expected[std::size_t(k)] +=
                number(
                    speed, [&](Eigen::Index i) { return sample.position(i, 0) >= 10.0; }, 0.55 * k,
                    0.55 * (k + 1)) /
                static_cast<double>(seen.times.size());
    }
    check_bars(seen.part(1), expected, 1e-9);
}

TEST_CASE("each side of a closed wall has the curve of its own energy, which its bars follow") {
    const Seen seen(halves("",
                           "{kind: speed-histogram, surfaces: wall, over: start, "
                           "range: [0, 6], bins: 12}"),
                    40);
    const plot::Plot plot = seen.plot(seen.last.get());
    REQUIRE(layers_of_part(plot, "curve") == 2);
    std::size_t side = 0;
    for (const plot::AnyLayer& layer : plot.layers) {
        const auto* curve = std::get_if<plot::Polyline>(&layer);
        if (curve == nullptr || curve->part != "curve") continue;
        // N disks with the energy E: p(e) = (N - 1) / E (1 - e / E)^(N - 2).
        const double count = side == 0 ? 40.0 : 20.0, energy = side == 0 ? 20.0 : 40.0;
        for (std::size_t k = 0; k < curve->x.values->size(); ++k) {
            const double v = curve->x.values->at(k), e = 0.5 * v * v;
            const double density =
                e < energy ? (count - 1.0) / energy * std::pow(1.0 - e / energy, count - 2.0) : 0.0;
            CHECK(std::abs(curve->y.values->at(k) - count * density * v * 0.5) < 1e-9);
        }
        const MeanHistogram& bars = seen.part(side++);
        CHECK(bars.values() == relative(count, 1e-12));
        CHECK(bars.deviation * bars.deviation + bars.mean * bars.mean ==
              relative(2.0 * energy / count, 1e-9));
    }
    // Over a longer time the bars come to the curves.
    Scene longer = seen.scene;
    longer.run.until = 4000.0;
    test::SeenPanel settled(longer, 40);
    const auto state = settled.last_state();
    for (const std::size_t its : {0, 1}) {
        const MeanHistogram& bars = HistogramPanel::histograms(*state)[its];
        const double count = its == 0 ? 40.0 : 20.0, energy = its == 0 ? 20.0 : 40.0;
        double apart = 0.0;
        for (int k = 0; k < 12; ++k) {
            const auto above = [&](double v) {
                return std::pow(std::max(0.0, 1.0 - 0.5 * v * v / energy), count - 1.0);
            };
            apart += std::abs(bars.counts[std::size_t(k)] -
                              count * (above(0.5 * k) - above(0.5 * (k + 1))));
        }
        CHECK(apart / count < 0.04);
    }
}

TEST_CASE("where particles pass from part to part there is no curve") {
    for (const std::string panel :
         {"{kind: speed-histogram, surfaces: wall}",
          "{kind: speed-histogram, regions: [{name: a, within: [0, 0, 5, 5]}]}"}) {
        const Seen seen(halves(slit, panel), 10);
        CHECK(layers_of_part(seen.plot(seen.last.get()), "curve") == 0);
        const Law found =
            law(seen.gas, LawOf::side_distribution, {.surface = Surfaces{}.first_partition()});
        CHECK(found.none->why == NoLaw::Why::passes);
    }
}

TEST_CASE("parts are named at their bars, and an empty one has no mean") {
    const Seen seen(
        "box: {size: [20, 10]}\npartitions: [{name: wall, x: 10}]\n"
        "gas: [{name: a, count: 40, radius: 0.2, temperature: 1, position: {side: left, of: "
        "wall}}]\n"
        "run: {until: 20}\nfilm: {seconds: 8, panels: [{kind: speed-histogram, surfaces: wall}]}\n",
        20);
    const plot::Plot plot = seen.plot(seen.last.get());
    std::vector<std::string> names;
    for (const plot::AnyLayer& layer : plot.layers)
        if (const auto* label = std::get_if<plot::Label>(&layer); label && label->swatch)
            names.push_back(label->words.front().pieces.front().markup);
    CHECK(names == std::vector<std::string>{"left", "right"});
    CHECK(layers_of_part(plot, "mean") == 1);
    CHECK(layers_of_part(plot, "mean at start") == 1);
    REQUIRE(plot.bar_notes->names.size() >= 2);
    CHECK(plot.bar_notes->names[1].number == "\u2013");
}
