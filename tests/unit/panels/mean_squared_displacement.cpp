#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numeric>

#include "draw/disks/disks.h"
#include "draw/text.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/correlations/displacement_meter.h"
#include "panels/plot/draw_plot.h"
#include "panels/plot/layers.h"
#include "scene/scene.h"
#include "support/relative.h"
#include "support/seen_panel.h"
#include "support/share_of_cases.h"

using namespace carom;
using test::relative;

namespace {

// A panel of a scene that is seen at some times, after its first pass.
struct Seen : test::SeenPanel {
    Seen(const std::string& text, const PanelSpec& spec, const std::vector<double>& at)
        : SeenPanel(test::scene_from(text), spec, at) {}
    const std::vector<double>& line(std::size_t k = 0) const { return series().y[k]; }
};

PanelSpec displacement(double from = 0.0) {
    return panel_of("mean-squared-displacement", DisplacementOptions{.from = from});
}

const std::string free_disk =
    "title: One disk\nbox: {size: [10, 10], walls: periodic}\n"
    "gas: [{name: a, count: 1, radius: 0.2, velocity: [30, -17], position: [1, 2]}]\n"
    "run: {until: 2}\nfilm: {seconds: 1, fps: 10}\n";

const std::string gas =
    "title: A gas\nbox: {size: [20, 20], walls: periodic}\n"
    "gas: [{name: a, count: 60, radius: 0.5, temperature: 4}]\n"
    "run: {until: 8}\nfilm: {seconds: 1, fps: 10}\n";

}  // namespace

TEST_CASE("a free disk goes v t, through periodic sides, however often between two frames") {
    for (const double from : {0.0, 0.5}) {
        const std::vector<double> times = test::times_up_to(2.0, 8);
        const Seen seen(free_disk, displacement(from), times);
        for (std::size_t i = 0; i < times.size(); ++i) {
            CAPTURE(times[i]);
            if (times[i] < from) {
                CHECK(std::isnan(seen.line()[i]));
                continue;
            }
            const double time = times[i] - from;
            CHECK(std::abs(seen.line()[i] - (900.0 + 289.0) * time * time) < 1e-9);
        }
    }
}

TEST_CASE("at first a gas spreads by its mean squared velocity") {
    const std::vector<double> times = test::times_up_to(1e-4, 4);
    const Seen seen(gas, displacement(), times);
    Simulation fresh(seen.scene.gas, seen.scene.run);
    const double square = fresh.sample().velocity.square().rowwise().sum().mean();
    for (std::size_t i = 1; i < times.size(); ++i)
        CHECK(seen.line()[i] == relative(square * times[i] * times[i], 1e-6));
}

TEST_CASE("displacements with collisions are sums of small steps to the nearest image") {
    const std::vector<double> times =
        test::times_up_to(8.0, 4);  // in which disks cross the box several times
    const Seen seen(gas, displacement(), times);
    Simulation fine(seen.scene.gas, seen.scene.run);
    Eigen::ArrayXXd before = fine.sample().position;
    Eigen::ArrayXXd moved = 0.0 * before;
    constexpr int steps = 2000;
    for (int i = 1; i <= steps; ++i) {
        fine.advance_to(8.0 * i / steps);
        const Eigen::ArrayXXd step = fine.sample().position - before;
        moved += step - 20.0 * (step / 20.0).round();
        before = fine.sample().position;
        if (i % (steps / 4) == 0)
            CHECK(seen.line()[static_cast<std::size_t>(4 * i / steps)] ==
                  relative(moved.square().rowwise().sum().mean(), 1e-10));
    }
}

TEST_CASE("D is the slope of all pairs of frames from a time on, and the words say it") {
    PanelSpec spec = displacement();
    spec.options.change<DisplacementOptions>().fit_from = 3.0;
    const std::vector<double> times = test::times_up_to(8.0, 32);
    Seen seen(gas, spec, times);
    double products = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i)
        for (std::size_t j = 0; j < times.size(); ++j) {
            if (times[i] < 3.0 || times[j] < 3.0) continue;
            products += (times[i] - times[j]) * (seen.line()[i] - seen.line()[j]);
            squares += (times[i] - times[j]) * (times[i] - times[j]);
        }
    const auto& panel = dynamic_cast<const PlotPanel&>(*seen.panel);
    const plot::Plot plot = panel.plot(nullptr);
    double slope = 0.0;
    for (const plot::AnyLayer& layer : plot.layers)
        if (plot::common(layer).part == "fit") {
            const auto& fit = std::get<plot::Polyline>(layer);
            CHECK(fit.x[0] == 3.0);
            slope = (fit.y[1] - fit.y[0]) / (fit.x[1] - fit.x[0]);
        }
    CHECK(slope == relative(products / squares, 1e-12));
    CAPTURE(plot.account);
    const double told = std::stod(plot.account.substr(plot.account.rfind("D = ") + 4));
    CHECK(told == relative(slope / 4.0, 5e-3));
}

TEST_CASE("the error of D is how the slopes of single disks scatter, or those of runs") {
    PanelSpec spec = displacement();
    spec.options.change<DisplacementOptions>().fit_from = 3.0;
    const std::vector<double> times = test::times_up_to(8.0, 16);
    Seen seen(gas, spec, times);
    // The line of each disk by itself.
    std::vector<double> each;
    for (int i = 0; i < 60; ++i) {
        PanelSpec alone = spec;
        alone.of = {{.particle = i}};
        Seen one(gas, alone, times);
        each.push_back(
            dynamic_cast<const SeriesPanel&>(*one.panel).record().runs[0].numbers[0][0].mean);
    }
    const MeanError expected = mean_error(each);
    const auto& all = dynamic_cast<const SeriesPanel&>(*seen.panel).record();
    CHECK(all.runs[0].numbers[0][0].mean == relative(expected.mean, 1e-9));
    CHECK(all.runs[0].numbers[0][0].error == relative(expected.error, 1e-9));
    HistoryRecord other = all;
    other.runs[0].numbers[0][0].mean += 1.0;
    const HistoryRecord mean = mean_of({all, other});
    CHECK(mean.runs[0].numbers[0][0].mean == relative(expected.mean + 0.5, 1e-9));
    CHECK(mean.runs[0].numbers[0][0].error == relative(0.5, 1e-9));
}

TEST_CASE("before collisions the squares lie on the parabola that is drawn") {
    const std::vector<double> times = test::times_up_to(0.4, 8);
    Seen seen(gas, displacement(), times);
    const plot::Plot plot = dynamic_cast<const PlotPanel&>(*seen.panel).plot(nullptr);
    Simulation fresh(seen.scene.gas, seen.scene.run);
    const double square = fresh.sample().velocity.square().rowwise().sum().mean();
    bool is_drawn = false;
    for (const plot::AnyLayer& layer : plot.layers)
        if (plot::common(layer).part == "ballistic") {
            const auto& line = std::get<plot::Polyline>(layer);
            is_drawn = true;
            for (std::size_t i = 1; i < line.x.size(); ++i)
                CHECK(line.y[i] == relative(square * line.x[i] * line.x[i], 1e-9));
        }
    CHECK(is_drawn);
}

namespace {

plot::Plot plot_of(const std::string& text, const PanelSpec& spec, double until, int steps = 200) {
    const Seen seen(text, spec, test::times_up_to(until, steps));
    const std::shared_ptr<const PanelState> state = seen.last_state();
    return dynamic_cast<const PlotPanel&>(*seen.panel).plot(state.get());
}

bool has_part(const plot::Plot& plot, const std::string& part) {
    for (const plot::AnyLayer& layer : plot.layers)
        if (plot::common(layer).part == part) return true;
    return false;
}

std::string scene_with(const std::string& box, const std::string& species, double until) {
    return fmt::format(
        "title: T\nbox: {{{}}}\ngas: [{}]\nrun: {{until: {}}}\nfilm: {{seconds: 1, fps: 10}}\n",
        box, species, until);
}

}  // namespace

TEST_CASE("walls give a plateau and no diffusion coefficient, and the account says why") {
    const std::string text =
        scene_with("size: [16, 12]", "{name: a, count: 60, radius: 0.4, temperature: 1}", 100.0);
    for (const bool all_origins : {false, true}) {
        CAPTURE(all_origins);
        PanelSpec spec = displacement();
        spec.options.change<DisplacementOptions>().all_origins = all_origins;
        const plot::Plot plot = plot_of(text, spec, 100.0);
        CHECK(plot.account.find("iffusion coefficient: the walls limit") != std::string::npos);
        CHECK_FALSE(has_part(plot, "fit"));
        for (const plot::AnyLayer& layer : plot.layers)
            if (plot::common(layer).part == "plateau")
                CHECK(std::get<plot::Level>(layer).value ==
                      relative((15.2 * 15.2 + 11.2 * 11.2) / 6.0, 1e-12));
        CHECK(has_part(plot, "plateau"));
    }
}

namespace {

// The words under the title, as far as they are shown.
std::string key_of(const plot::Plot& plot) {
    std::string words;
    for (const plot::Note& note : plot.notes)
        for (const plot::KeyEntry& entry : note.entries)
            if (!entry.is_hidden) words += entry.words.front().pieces.front().markup + "; ";
    return words;
}

}  // namespace

TEST_CASE("displacements that are bounded along some axes only do not level off") {
    const std::string half = "size: [16, 12], walls: {left: periodic, right: periodic}";
    for (const bool all_origins : {false, true}) {
        PanelSpec spec = displacement();
        spec.options.change<DisplacementOptions>().all_origins = all_origins;
        const plot::Plot plot =
            plot_of(scene_with(half, "{name: a, count: 60, radius: 0.4, temperature: 1}", 100.0),
                    spec, 100.0);
        CHECK(plot.account.find("along some axes") != std::string::npos);
        CHECK_FALSE(has_part(plot, "plateau"));
        CHECK(key_of(plot).find("plateau") == std::string::npos);
    }
}

TEST_CASE("the key names a plateau only where its line is drawn") {
    for (const bool all_origins : {false, true})
        for (const double until : {2.0, 100.0}) {
            CAPTURE(until);
            PanelSpec spec = displacement();
            spec.options.change<DisplacementOptions>().all_origins = all_origins;
            const plot::Plot plot =
                plot_of(scene_with("size: [16, 12]",
                                   "{name: a, count: 60, radius: 0.4, temperature: 1}", until),
                        spec, until);
            CHECK(has_part(plot, "plateau") == (until > 10.0));
            CHECK((key_of(plot).find("plateau") != std::string::npos) == (until > 10.0));
        }
}

TEST_CASE("the reason why there is no diffusion coefficient is whole in narrow panels") {
    for (const bool all_origins : {false, true}) {
        CAPTURE(all_origins);
        PanelSpec spec = displacement();
        spec.options.change<DisplacementOptions>().all_origins = all_origins;
        const plot::Plot plot =
            plot_of(scene_with("size: [16, 12]",
                               "{name: a, count: 60, radius: 0.4, temperature: 1}", 100.0),
                    spec, 100.0);
        DiskPainter disks;
        const DrawContext dc{{0, 0, 280, 400}, 20, theme(ThemeKind::light), disks};
        Canvas canvas({280, 400});
        const TextLog log;
        for (const plot::DrawnPart part : {plot::DrawnPart::still, plot::DrawnPart::changing})
            plot::draw_plot(canvas, dc, plot, part);
        std::string words;
        for (const DrawnLine& line : log.lines) {
            CAPTURE(line.markup);
            words += line.markup + " ";
            CHECK_FALSE(line.is_cut);
        }
        CHECK(words.find("no <i>D</i>: the walls limit how far particles can move") !=
              std::string::npos);
    }
}

TEST_CASE(
    "there is no diffusion coefficient of what flies freely, or has collided rarely or with light "
    "disks only") {
    struct Case {
        std::string box, species;
        double until;
        std::string reason;
        bool all_origins = false;
        std::vector<Chosen> of = {};
    };
    const std::string gas60 = "{name: a, count: 60, radius: 0.5, temperature: 4}";
    for (const Case& one : std::vector<Case>{
             {"size: [10, 10], walls: periodic", "{name: a, count: 1, radius: 0.2}", 5.0,
              "all particles are at rest"},
             {"size: [10, 10], walls: periodic",
              "{name: a, radius: 0.2, position: [[2, 2], [8, 8]], velocity: [[1, 0], [-1, 0]]}",
              50.0, "in a periodic box two particles keep the energy"},
             {"size: [40, 40], walls: periodic", "{name: a, count: 20, radius: 0.1, speed: 1}", 2.0,
              "there have been no collisions yet"},
             {"size: [20, 20], walls: periodic", gas60, 1.0, "there have been too few collisions"},
             {"size: [20, 20], walls: periodic",
              gas60,
              20.0,
              "too few measurements are independent of each other",
              false,
              {{.particle = 3}}},
             {"size: [20, 20], walls: periodic",
              "{name: big, count: 10, radius: 0.5, mass: 100, temperature: 4}, " + gas60,
              40.0,
              "there have been too few collisions",
              true,
              {{.species = 0}}}}) {
        CAPTURE(one.species);
        PanelSpec spec = displacement();
        spec.options.change<DisplacementOptions>().all_origins = one.all_origins;
        spec.of = one.of;
        const plot::Plot plot =
            plot_of(scene_with(one.box, one.species, one.until), spec, one.until);
        CAPTURE(plot.account);
        CHECK(plot.account.find("iffusion coefficient: " + one.reason) != std::string::npos);
        CHECK_FALSE(has_part(plot, "fit"));
    }
}

TEST_CASE("reasons that may pass are short in the key, whose rows they keep") {
    PanelSpec spec = displacement();
    spec.options.change<DisplacementOptions>().all_origins = true;
    spec.options.change<DisplacementOptions>().lags = 8.0;
    spec.of = {{.particle = 3}};
    const plot::Plot plot =
        plot_of(scene_with("size: [20, 20], walls: periodic",
                           "{name: a, count: 60, radius: 0.5, temperature: 4}", 20.0),
                spec, 20.0);
    CHECK(plot.account.find("too few measurements are independent of each other") !=
          std::string::npos);
    CHECK(key_of(plot).find("<i>D</i>") == std::string::npos);  // nothing in a film
    DiskPainter disks;
    const DrawContext dc{{0, 0, 440, 280}, 20, theme(ThemeKind::light), disks};
    plot::LabelPlacer placer({});
    CHECK(plot::frame_of(plot, dc, placer).area.height >= plot_area(dc).height - 2.0 * 1.5 * 20.0);
}

TEST_CASE("a curve is drawn as far as it is known") {
    PanelSpec spec = displacement();
    spec.options.change<DisplacementOptions>().all_origins = true;
    spec.options.change<DisplacementOptions>().lags = 15.0;
    plot::Plot plot = plot_of(scene_with("size: [20, 20], walls: periodic",
                                         "{name: a, count: 60, radius: 0.5, temperature: 4}", 10.0),
                              spec, 10.0);
    plot.notes.clear();
    std::erase_if(plot.layers,
                  [](const plot::AnyLayer& layer) { return plot::common(layer).part != "curve"; });
    REQUIRE(plot.layers.size() == 1);
    CHECK(std::isnan(std::get<plot::Polyline>(plot.layers.front()).y[lag_count - 1]));
    DiskPainter disks;
    const DrawContext dc{{0, 0, 440, 280}, 20, theme(ThemeKind::light), disks};
    Canvas canvas({440, 280});
    canvas.fill_all(dc.theme.page);
    plot::draw_plot(canvas, dc, plot, plot::DrawnPart::changing);
    const PixelView view = canvas.pixels();
    int columns = 0;  // that the curve crosses
    for (int x = 0; x < view.width; ++x) {
        bool is_crossed = false;
        for (int y = 0; y < view.height; ++y)
            is_crossed = is_crossed || view.data[y * view.stride + x] != view.data[0];
        columns += is_crossed;
    }
    const double share = columns / plot_area(dc).width;
    CHECK(share > 0.6);
    CHECK(share < 0.72);  // 10 of 15
}

TEST_CASE("the error of D of a single disk is how D scatters between runs" *
          doctest::skip(test::has_sanitizers)) {
    PanelSpec spec = displacement();
    spec.options.change<DisplacementOptions>().all_origins = true;
    spec.options.change<DisplacementOptions>().lags = 6.0;
    spec.of = {{.particle = 0}};
    std::vector<double> coefficients;
    double squares = 0.0;
    constexpr int runs = 24;
    for (int seed = 1; seed <= runs; ++seed) {
        const std::string text =
            "seed: " + std::to_string(seed) + "\n" +
            scene_with("size: [20, 20], walls: periodic",
                       "{name: a, count: 60, radius: 0.5, temperature: 1}", 240.0);
        const Seen seen(text, spec, test::times_up_to(240.0, 240));
        const auto state = seen.last_state();
        const CurveValues& values = dynamic_cast<const CurveState&>(*state).runs.front();
        const std::vector<MeanError> numbers = values.numbers.front();
        CHECK(numbers[of_pieces].mean == 20.0);
        coefficients.push_back(numbers[of_diffusion].mean);
        squares += numbers[of_diffusion].error * numbers[of_diffusion].error / runs;
    }
    // A variance of 24 values is known to 30 %, and so is the mean of 24 of 20 pieces to 7 %; parts
    // use 20 starts of the 39 that overlap, so that theirs is at most a little larger.
    const double scatter = mean_error(coefficients).error * std::sqrt(double(runs));
    CAPTURE(scatter);
    CAPTURE(std::sqrt(squares));
    CHECK(std::sqrt(squares) < 1.8 * scatter);
    CHECK(std::sqrt(squares) > 0.7 * scatter);
}
