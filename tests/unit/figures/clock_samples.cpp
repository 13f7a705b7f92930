// `samples: clock`: what is shown are the samples of the run, against the same moments of a
// simulation.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "panels/plots/histogram_panel.h"
#include "panels/precision.h"
#include "physics/sample_times.h"
#include "support/figure_run.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

const std::string three_beads =
    "title: T\nbox: {length: 12}\ngas: [{name: a, count: 2, radius: 0.1, mass: 1, temperature: 1}, "
    "{name: b, count: 1, radius: 0.1, mass: 3, speed: 1}]\n"
    "run: {until: 120, sample_every: 0.3}\n";

// Position and velocity of a bead at each sample.
std::vector<std::array<double, 2>> beads_by_clock(const Scene& scene, Eigen::Index bead) {
    Simulation simulation = start_scene(scene).simulation;
    std::vector<std::array<double, 2>> all;
    for (int k = 0; k <= 400; ++k) {
        simulation.advance_to(k == 400 ? 120.0 : 0.3 * k);
        all.push_back(
            {simulation.sample().position(bead, 0), simulation.sample().velocity(bead, 0)});
    }
    return all;
}

// The rows of a part of a table: their last two numbers.
std::vector<std::array<double, 2>> points_in(const Table& table, const std::string& part) {
    std::vector<std::array<double, 2>> all;
    const std::string text = csv(table);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string row = text.substr(at, end - at);
        at = end + 1;
        if (row.find(part) == std::string::npos) continue;
        const std::size_t last = row.rfind(','), before = row.rfind(',', last - 1);
        all.push_back({std::stod(row.substr(before + 1)), std::stod(row.substr(last + 1))});
    }
    return all;
}

Table table_of(const FigureRun& run, std::size_t figure) {
    const Figure& its = run.figures()[figure];
    return its.panel->table(*its.moments.back().state, theme(ThemeKind::print));
}

}  // namespace

TEST_CASE("points by a clock are those of the samples of the run, 401 of 400 intervals") {
    const Scene scene =
        test::scene_from(three_beads +
                         "figures:\n"
                         "  - {name: both, kind: positions, of: [0, 2], samples: clock}\n"
                         "  - {name: moves, kind: phase, of: [2], samples: clock}\n");
    const FigureRun run = test::run_of(scene);
    const auto first = beads_by_clock(scene, 0), last = beads_by_clock(scene, 2);
    const auto both = points_in(table_of(run, 0), "sample");
    const auto moves = points_in(table_of(run, 1), "sample");
    REQUIRE(both.size() == 401);
    REQUIRE(moves.size() == 401);
    for (std::size_t k = 0; k < 401; ++k) {
        CHECK(both[k][0] == doctest::Approx(first[k][0]).epsilon(1e-9));
        CHECK(both[k][1] == doctest::Approx(last[k][0]).epsilon(1e-9));
        CHECK(moves[k][0] == doctest::Approx(last[k][0]).epsilon(1e-9));
        CHECK(moves[k][1] == doctest::Approx(last[k][1]).epsilon(1e-9));
    }
}

TEST_CASE("a histogram by a clock counts the samples") {
    const Scene scene = test::scene_from(
        three_beads +
        "figures: [{name: f, kind: velocity-histogram, of: [2], samples: clock, bins: 9, range: "
        "[-3, 3]}]\n");
    const FigureRun run = test::run_of(scene);
    const MeanHistogram& found =
        HistogramPanel::histograms(*run.figures().front().moments.back().state).front();
    std::vector<double> counts(9);
    double sum = 0.0;
    for (const auto& [place, velocity] : beads_by_clock(scene, 2)) {
        counts[static_cast<std::size_t>(std::floor((velocity + 3.0) / 6.0 * 9.0))] += 1.0;
        sum += velocity;
    }
    double all = found.below + found.above;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        CHECK(401.0 * found.counts[k] == doctest::Approx(counts[k]).epsilon(1e-9));
        all += found.counts[k];
    }
    CHECK(401.0 * all == doctest::Approx(401.0).epsilon(1e-12));
    CHECK(found.mean == doctest::Approx(sum / 401.0).epsilon(1e-9));
}

TEST_CASE("films show points by a clock so far, whatever their frames") {
    for (const int fps : {3, 30}) {
        const test::Shot film(test::scene_from(
            three_beads +
            fmt::format("film: {{template: data, size: [640, 360], seconds: 4, fps: {}, panels: "
                        "[{{kind: positions, of: [0, 2], samples: clock}}]}}\n",
                        fps)));
        for (const FrameData& frame : film.frames) {
            const Table table = film.panels->panels().back().panel->table(*frame.states.back(),
                                                                          theme(ThemeKind::print));
            const double expected = frame.tick.time >= 120.0
                                        ? 401.0
                                        : std::floor(frame.tick.time / 0.3 * (1.0 + 1e-12)) + 1.0;
            CHECK(static_cast<double>(points_in(table, "sample").size()) == expected);
        }
    }
}
