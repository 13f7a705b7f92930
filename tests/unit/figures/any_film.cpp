// What figures measure does not depend on the frames of a film.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "panels/plots/histogram_panel.h"
#include "panels/precision.h"
#include "support/figure_run.h"
#include "support/measured_gases.h"
#include "support/scene_text.h"

using namespace carom;
using namespace carom::test;

namespace {

struct Case {
    std::string gas;
    std::vector<std::string> panels;
};

const std::vector<Case> cases{
    {two_masses,
     {"{kind: speed-histogram, over: start}",
      "{kind: speed-histogram, over: [6, 9], of: [light, heavy]}",
      "{kind: energy-histogram, over: start}", "{kind: velocity-histogram, over: start, fit: true}",
      "{kind: position-histogram, over: start}", "{kind: temperature, of: [heavy]}",
      "{kind: pressure, over: [7, 9]}", "{kind: pressure, over: now}",
      "{kind: thermometer, over: [7, 9]}", "{kind: entropy}", "{kind: energy-by-species}",
      "{kind: free-path, over: start}", "{kind: pair-correlation, over: start}",
      "{kind: velocity-autocorrelation}", "{kind: profile, over: [6, 9]}"}},
    {falling_disks,
     {"{kind: speed-histogram, over: start}", "{kind: energy-histogram, over: [7, 9]}",
      "{kind: velocity-histogram, over: start, component: y}",
      "{kind: position-histogram, over: start, component: y}"}},
    {rods_and_points,
     {"{kind: velocity-histogram, over: start, fit: true}", "{kind: pressure, over: [7.5, 9]}"}}};

constexpr double until = 9.0;

std::string run_and_film(int fps, const std::string& panels) {
    return fmt::format(
        "title: T\nrun: {{until: {}}}\nfilm: {{template: data, size: [640, 360], seconds: 4, fps: "
        "{}, panels: [{}]}}\n",
        until, fps, panels);
}

Scene figures_of(const Case& of, int fps, const std::string& more = "") {
    std::string text = run_and_film(fps, "") + of.gas + "figures:\n";
    for (std::size_t k = 0; k < of.panels.size(); ++k) {
        std::string keys = of.panels[k];
        keys.pop_back();
        text += fmt::format("  - {}, name: f{}}}\n", keys, k);
    }
    return test::scene_from(text + more);
}

using Tables = std::map<std::string, std::string>;

Tables tables(const Scene& scene) {
    const FigureRun run = test::run_of(scene);
    Tables all;
    for (const Figure& figure : run.figures())
        if (figure.spec->name.starts_with("f"))
            all[figure.spec->name] =
                csv(figure.panel->table(*figure.moments.back().state, theme(ThemeKind::print)));
    return all;
}

}  // namespace

TEST_CASE("figures show the same numbers whatever the frames of the film") {
    for (const Case& one : cases) {
        const Tables expected = tables(figures_of(one, 30));
        CHECK(expected.size() == one.panels.size());
        const std::string gas = "  - {name: gas, kind: gas, at: 2.718}\n";
        for (const auto& [fps, more] :
             std::vector<std::pair<int, std::string>>{{1, ""}, {7, ""}, {7, gas}}) {
            CAPTURE(fps);
            const Tables found = tables(figures_of(one, fps, more));
            for (std::size_t k = 0; k < one.panels.size(); ++k) {
                CAPTURE(one.panels[k]);
                CHECK(found.at(fmt::format("f{}", k)) == expected.at(fmt::format("f{}", k)));
            }
        }
    }
}

namespace {

// The mean number of particles in each bin over [from, to], summed from event to event: between two
// events all speeds are constant.
std::vector<double> slowly(const Scene& scene, const Bins& bins, double from, double to) {
    Simulation simulation = start_scene(scene).simulation;
    simulation.record_collisions(true);
    Eigen::ArrayXXd velocity = simulation.sample().velocity;
    const AdvanceResult all = simulation.advance_to(to);
    std::vector<double> counts(std::size_t(bins.count));
    double time = 0.0;
    const auto last_until = [&](double next) {
        const double span = next - std::max(time, from);
        for (Eigen::Index i = 0; span > 0.0 && i < velocity.rows(); ++i) {
            const double speed = std::hypot(velocity(i, 0), velocity(i, 1));
            const auto bin = std::floor((speed - bins.low) / bins.width());
            if (bin < bins.count) counts[std::size_t(bin)] += span / (to - from);
        }
        time = next;
    };
    for (const Collision& one : all.collisions) {
        last_until(one.time);
        put(one.first_after, velocity, one.first);
        if (one.second.is_particle()) put(one.second_after, velocity, one.second.particle());
    }
    last_until(to);
    return counts;
}

}  // namespace

TEST_CASE("a mean histogram is the mean over all events, exactly") {
    const Scene scene = test::scene_from(
        "title: T\nrun: {until: 9, sample_every: 0.75}\n" + two_masses +
        "figures:\n"
        "  - {name: start, kind: speed-histogram, over: start, bins: 20, range: [0, 4]}\n"
        "  - {name: while, kind: speed-histogram, over: [3, 7.5], bins: 20, range: [0, 4]}\n");
    const FigureRun run = test::run_of(scene);
    for (const Figure& figure : run.figures()) {
        CAPTURE(figure.spec->name);
        const MeanHistogram& mean =
            HistogramPanel::histograms(*figure.moments.back().state).front();
        const bool is_start = figure.spec->name == "start";
        const std::vector<double> expected =
            slowly(scene, mean.bins, is_start ? 0.0 : 3.0, is_start ? 9.0 : 7.5);
        REQUIRE(mean.counts.size() == expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k)
            CHECK(std::abs(mean.counts[k] - expected[k]) < 1e-11);
    }
}
