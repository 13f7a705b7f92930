#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "panels/plot/bar_notes.h"
#include "panels/plots/histogram_panel.h"
#include "support/pixels.h"
#include "support/relative.h"
#include "support/scene_text.h"
#include "support/seen_panel.h"
#include "support/shot.h"

using namespace carom;
using test::relative;

namespace {

struct Stage {
    Scene scene;
    Particles particles;
    BoxedGas none;

    explicit Stage(Eigen::Index count) {
        particles.radius = Eigen::ArrayXd::Constant(count, 0.5);
        particles.inverse_mass = Eigen::ArrayXd::Ones(count);
        particles.species = Eigen::ArrayXi::Zero(count);
    }
};

using Density = std::function<double(const EquilibriumGas&, double)>;

HistogramSubject speeds_with(Density density) {
    return {.title = Phrase{"Speed distribution"},
            .quantity = quantities::speed,
            .values = [](const FrameInput& o) { return values_in(o.speed); },
            .density = std::move(density)};
}

void survey(HistogramPanel& panel, const std::vector<Eigen::ArrayXd>& frames) {
    const Sample sample;
    const AdvanceResult advanced;
    for (const Eigen::ArrayXd& speed : frames) {
        const Tick tick;
        panel.survey({tick, sample, speed, speed, advanced});
    }
    panel.fix_axes();
}

}  // namespace

TEST_CASE("the axis of a histogram holds the run, and round-off never splits equal values") {
    Stage stage(100);
    HistogramPanel panel({stage.scene, stage.particles, 2, stage.none}, {}, speeds_with({}));
    survey(panel, {Eigen::ArrayXd::Constant(100, 2.0), Eigen::ArrayXd::LinSpaced(100, 0.0, 4.0)});
    const Bins& bins = panel.bins();
    CHECK(bins.low == 0.0);
    CHECK(bins.high >= 3.9);
    CHECK(bins.high <= 6.5);
    const double place = 2.0 / bins.width();
    CHECK(std::abs(place - std::round(place)) > 1e-3);
}

TEST_CASE("bins and range of the scene are taken as they are") {
    Stage stage(10);
    const PanelSpec spec =
        panel_of("speed-histogram", HistogramOptions{.bins = 7, .range = {{1.0, 3.0}}});
    HistogramPanel panel({stage.scene, stage.particles, 1, stage.none}, spec, speeds_with({}));
    survey(panel, {Eigen::ArrayXd::LinSpaced(10, 0.0, 4.0)});
    CHECK(panel.bins().count == 7);
    CHECK(panel.bins().low == 1.0);
    CHECK(panel.bins().high == 3.0);
}

TEST_CASE("a start far from equilibrium does not flatten the curve") {
    Stage stage(1000);
    BoxedGas thousand;
    thousand.particles = &stage.particles;
    thousand.no_equilibrium.reset();
    thousand.equilibrium = {.energy = 1000.0, .beta = 999.0, .groups = {{1.0, 1000.0}}};
    // Expected number in a bin: 1000 * width * density; the start puts all 1000 into one.
    HistogramPanel panel(
        {stage.scene, stage.particles, 2, thousand}, {},
        speeds_with([](const EquilibriumGas&, double v) { return v * std::exp(-v * v / 2); }));
    survey(panel,
           {Eigen::ArrayXd::Constant(1000, 0.01), Eigen::ArrayXd::LinSpaced(1000, 0.0, 4.0)});
    const double curve = 1000 * panel.bins().width() * std::exp(-0.5);  // its top, at v = 1
    CHECK(panel.tallest() >= 1.1 * curve);
    CHECK(panel.tallest() <= 2.5 * curve);
}

TEST_CASE("the curve is that of the particles that share the energy") {
    Stage stage(1000);  // 900 of them infinitely heavy and at rest
    stage.particles.inverse_mass.tail(900) = 0.0;
    BoxedGas hundred;
    hundred.particles = &stage.particles;
    hundred.no_equilibrium.reset();
    hundred.equilibrium = {.energy = 100.0, .beta = 99.0, .groups = {{1.0, 100.0}}};
    HistogramPanel panel(
        {stage.scene, stage.particles, 1, hundred}, {},
        speeds_with([](const EquilibriumGas&, double v) { return v * std::exp(-v * v / 2); }));
    survey(panel, {Eigen::ArrayXd::LinSpaced(1000, 0.0, 4.0)});
    const double curve = 100 * panel.bins().width() * std::exp(-0.5);  // its top, at v = 1
    double top = 0.0;
    for (const plot::AnyLayer& layer : panel.plot(nullptr).layers)
        if (const auto* line = std::get_if<plot::Polyline>(&layer))
            for (std::size_t i = 0; i < line->y.size(); ++i) top = std::max(top, line->y[i]);
    CHECK(top == relative(curve, 1e-2));
}

namespace {

// What the frames of a panel show, seen as a film sees it: first all, then one by one.
std::vector<std::vector<MeanHistogram>> shown(HistogramPanel& panel,
                                              const std::vector<double>& times,
                                              const std::vector<Eigen::ArrayXd>& speeds) {
    const Sample sample;
    const AdvanceResult advanced;
    std::vector<std::vector<MeanHistogram>> result;
    for (const bool surveying : {true, false}) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            Tick tick;
            tick.time = times[i];
            const FrameInput input{tick, sample, speeds[i], speeds[i], advanced};
            if (surveying) panel.survey(input);
            if (!surveying) result.push_back(HistogramPanel::histograms(*panel.state(input)));
        }
        if (surveying) panel.fix_axes();
    }
    return result;
}

PanelSpec four_bins(Over::Since since, double window = 0.0) {
    PanelSpec spec =
        panel_of("speed-histogram", HistogramOptions{.bins = 4, .range = {{0.0, 4.0}}});
    spec.over = Over{since, window};
    return spec;
}

}  // namespace

TEST_CASE("chosen particles are drawn together, each choice with its own bars and curve") {
    Stage stage(10);
    stage.particles.species.tail(3) = 1;
    stage.scene.gas.species.resize(2);
    stage.scene.looks.resize(2);
    PanelSpec spec = four_bins(Over::Since::now);
    spec.of = {{}, {1, {}}, {{}, 0}};
    HistogramPanel panel({stage.scene, stage.particles, 1, stage.none}, spec, speeds_with({}));
    Eigen::ArrayXd speeds = Eigen::ArrayXd::Constant(10, 0.5);
    speeds.tail(3) = 2.5;
    speeds[0] = 1.5;
    const auto frame = shown(panel, {0.0}, {speeds}).front();
    REQUIRE(frame.size() == 3);
    CHECK(frame[0].counts == std::vector{6.0, 1.0, 3.0, 0.0});
    CHECK(frame[1].counts == std::vector{0.0, 0.0, 3.0, 0.0});
    CHECK(frame[2].counts == std::vector{0.0, 1.0, 0.0, 0.0});
    CHECK(frame[0].mean == relative((6 * 0.5 + 1.5 + 3 * 2.5) / 10, 1e-14));
}

TEST_CASE("the number beyond the lower end is told beside the axis, which stays whole") {
    Stage stage(10);
    PanelSpec spec = four_bins(Over::Since::now);
    spec.options.change<HistogramOptions>().range = {-1.0, 1.0};
    HistogramSubject subject = speeds_with({});
    subject.symmetric = true;
    HistogramPanel panel({stage.scene, stage.particles, 1, stage.none}, spec, std::move(subject));
    Eigen::ArrayXd values = Eigen::ArrayXd::Constant(10, 0.2);
    values[0] = -1.5;
    REQUIRE(shown(panel, {0.0}, {values}).front().front().below == 1.0);

    DiskPainter disks;
    const DrawContext dc{{20, 20, 560, 360}, 20, theme(ThemeKind::light), disks};
    Canvas canvas({600, 400});
    canvas.fill({0, 0, 600, 400}, dc.theme.page);
    const std::vector<std::uint32_t> blank = test::pixels_of(canvas);
    panel.draw_ground(canvas, dc);
    const std::vector<std::uint32_t> ground = test::pixels_of(canvas);
    const Tick tick;
    const Sample sample;
    const AdvanceResult advanced;
    const TextLog log;
    panel.draw(canvas, dc, *panel.state({tick, sample, values, values, advanced}));
    CHECK(std::ranges::count(log.lines, "← 1", &DrawnLine::markup) == 1);
    const std::vector<std::uint32_t> drawn = test::pixels_of(canvas);
    CHECK(drawn != ground);
    // The axis is the column with most ink.
    const auto inked = [&](const std::vector<std::uint32_t>& picture, std::size_t x) {
        int rows = 0;
        for (std::size_t at = x; at < picture.size(); at += 600) rows += picture[at] != blank[at];
        return rows;
    };
    std::size_t axis = 0;
    for (std::size_t x = 0; x < 300; ++x)
        if (inked(ground, x) > inked(ground, axis)) axis = x;
    CHECK(inked(ground, axis) > 200);
    int changed = 0;
    for (std::size_t y = 0; y < 300; ++y)
        if (ground[y * 600 + axis] != blank[y * 600 + axis])
            changed += drawn[y * 600 + axis] != ground[y * 600 + axis];
    CHECK(changed == 0);
}

TEST_CASE("the scene's own title is shown in panels of any width, and curves are explained") {
    for (const std::string choice :
         {"", "of: [light, heavy], ", "of: [light, heavy], mean_now: false, "})
        for (const int width : {640, 1280, 2400}) {
            CAPTURE(choice);
            CAPTURE(width);
            const test::Shot film(test::scene_from(
                "title: T\nbox: {size: [40, 30]}\n"
                "gas: [{name: light, count: 30, temperature: 1}, "
                "{name: heavy, count: 30, mass: 4, temperature: 1}]\n"
                "run: {until: 1}\nfilm: {seconds: 1, size: [" +
                std::to_string(width) + ", 720], panels: [{kind: speed-histogram, " + choice +
                "title: How fast they fly}]}\n"));
            FramePainter painter(*film.panels);
            const TextLog log;
            painter.paint(film.frames.back());
            std::string words;
            for (const DrawnLine& line : log.lines) words += line.markup + "\n";
            CAPTURE(words);
            CHECK(words.find("How fast they fly") != std::string::npos);
            CHECK(words.find("equilibrium") != std::string::npos);
            CHECK(words.find("now") != std::string::npos);
            if (!choice.empty()) CHECK(words.find("light") != std::string::npos);
        }
}

TEST_CASE("the names of means over the bars are whole") {
    for (const int width : {640, 1280, 2400}) {
        CAPTURE(width);
        const test::Shot film(test::scene_from(
            "title: T\nbox: {size: [40, 30]}\n"
            "gas: [{name: light, count: 30, temperature: 1}, "
            "{name: heavy, count: 30, mass: 4, temperature: 1}]\n"
            "run: {until: 1}\nfilm: {seconds: 1, size: [" +
            std::to_string(width) +
            ", 720], panels: [{kind: velocity-histogram, component: x, of: [light, heavy], "
            "mean_now: true}]}\n"));
        FramePainter painter(*film.panels);
        const TextLog log;
        painter.paint(film.frames.back());
        const auto names = std::ranges::count_if(log.lines, [](const DrawnLine& line) {
            return line.markup.starts_with("mean") || line.markup.starts_with("light ") ||
                   line.markup.starts_with("heavy ");
        });
        CHECK(names == 2);
        for (const DrawnLine& line : log.lines) CHECK_FALSE_MESSAGE(line.is_cut, line.markup);
    }
}

TEST_CASE("names of means over bars stand in as many rows as they need") {
    const test::SeenPanel seen(
        test::scene_from("title: T\nbox: {size: [40, 40]}\ngas:\n"
                         "  - {name: neon, count: 9, radius: 0.3, mass: 2, temperature: 1}\n"
                         "  - {name: argon, count: 9, radius: 0.3, mass: 3, temperature: 1}\n"
                         "  - {name: krypton, count: 9, radius: 0.3, mass: 4, temperature: 1}\n"
                         "  - {name: xenon, count: 9, radius: 0.3, mass: 5, temperature: 1}\n"
                         "run: {until: 4}\nfilm: {seconds: 4, panels: [{kind: speed-histogram, of: "
                         "[neon, argon, krypton, xenon]}]}\n"),
        8);
    const auto state = seen.last_state();
    plot::Plot plot = seen.plot(state.get());
    REQUIRE(plot.bar_notes);
    plot.bar_notes->may_be_beside = false;
    REQUIRE(plot.bar_notes->names.size() == 5);  // with that of the means at the start
    DiskPainter disks;
    const auto rows = [&](double width, double height) {
        const DrawContext dc{
            {0.0, 0.0, 10.0 * width, 10.0 * height}, 10.0, theme(ThemeKind::dark), disks};
        plot::LabelPlacer placer({});
        return plot::frame_of(plot, dc, placer).notes.row / note_height;
    };
    CHECK(rows(60.0, 20.0) == 1.0);
    CHECK(rows(28.0, 20.0) == 2.0);
    CHECK(rows(14.0, 24.0) == 4.0);
    CHECK(rows(28.0, 8.0) == 0.0);  // they would leave too little
}
