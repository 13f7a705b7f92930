#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numeric>

#include "draw/disks/disks.h"
#include "draw/palette.h"
#include "draw/text.h"
#include "panels/frame.h"
#include "panels/gas/gas_colors.h"
#include "panels/plot/draw_plot.h"
#include "panels/plot/label_placer.h"
#include "panels/plot/layers.h"
#include "panels/plots/points_panel.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "stats/speed_classes.h"
#include "support/relative.h"
#include "support/scene_text.h"
#include "support/seen_panel.h"
#include "support/shot.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

// A gas of light particles (mass 1) and as many heavy ones (mass 4) in a box of 10 by 10.
struct Stage {
    Scene scene;
    Particles particles;
    BoxedGas equilibrium;
    AdvanceResult advanced;

    explicit Stage(Eigen::Index each) {
        scene.gas.box.size = {10.0, 10.0};
        scene.gas.species = {{.name = "light", .count = each}, {.name = "heavy", .count = each}};
        scene.looks.resize(2);
        particles.radius = Eigen::ArrayXd::Constant(2 * each, 0.5);
        particles.inverse_mass = Eigen::ArrayXd::Ones(2 * each);
        particles.inverse_mass.tail(each) = 0.25;
        particles.species = Eigen::ArrayXi::Zero(2 * each);
        particles.species.tail(each) = 1;
    }

    std::unique_ptr<SeriesPanel> panel(const PanelSpec& spec) const {
        const PanelContext context{scene, particles, 3, equilibrium};
        return std::unique_ptr<SeriesPanel>(
            static_cast<SeriesPanel*>(make_panel(context, spec).release()));
    }

    void show(SeriesPanel& panel, double time, const Eigen::ArrayXXd& velocity) const {
        const Sample sample{time, Eigen::ArrayXXd::Constant(velocity.rows(), 2, 5.0), velocity};
        Tick tick;
        tick.time = time;
        const Eigen::ArrayXd speed = speeds(sample);
        const Eigen::ArrayXd energy = kinetic_energies(particles, sample);
        panel.survey({tick, sample, speed, energy, advanced});
    }
};

Eigen::ArrayXXd along_x(const std::vector<double>& values) {
    Eigen::ArrayXXd velocity = Eigen::ArrayXXd::Zero(static_cast<Eigen::Index>(values.size()), 2);
    for (std::size_t i = 0; i < values.size(); ++i)
        velocity(static_cast<Eigen::Index>(i), 0) = values[i];
    return velocity;
}

}  // namespace

TEST_CASE("a series with a title of the scene names its lines beside them, and its axis") {
    const Stage stage(2);
    for (const bool is_own : {false, true}) {
        PanelSpec spec{.kind = "temperature", .of = {{.species = 0}, {.species = 1}}};
        if (is_own) spec.title = "They meet & mix";
        const auto panel = stage.panel(spec);
        stage.show(*panel, 0.0, along_x({1, -1, 2, -2}));
        stage.show(*panel, 1.0, along_x({1, -1, 2, -2}));
        panel->fix_axes();
        const plot::Plot plot = panel->plot(nullptr);
        std::vector<std::string> key;
        for (const plot::AnyLayer& layer : plot.layers)
            if (const auto* label = std::get_if<plot::Label>(&layer))
                key.push_back(label->words.front().pieces[0].markup);
        CHECK(key == std::vector<std::string>{"light", "heavy"});
        if (is_own) {
            CHECK(plot.titles.at(0).pieces.at(0).markup == "They meet &amp; mix");
            CHECK(plot.y.title.pieces.at(0).markup == "temperature");
            CHECK(!plot.at_lines);
        } else {  // the title names them only where they have no place at their lines
            CHECK(plot.titles.at(0).pieces.at(1).markup == "Temperature");
            CHECK(plot.titles.at(0).pieces.at(3).markup == "light");
            CHECK(plot.at_lines->titles.at(0).pieces.at(0).markup == "Temperature");
            CHECK(plot.at_lines->titles.at(0).pieces.size() == 1);
            CHECK(plot.y.title.empty());
        }
    }
}

TEST_CASE("the title of a pressure names the walls if any side is solid") {
    const auto names_walls = [](const std::string& box) {
        const test::SeenPanel seen(
            test::scene_from("title: T\nbox: {" + box +
                             "}\ngas: [{count: 5, radius: 0.5, speed: 1}]\nrun: {until: 1}\n"
                             "film: {seconds: 1, panels: [pressure]}\n"),
            4);
        const plot::Plot plot = seen.plot();
        std::string title;
        for (const auto& piece : plot.titles.at(0).pieces) title += piece.markup;
        return title.find("on the walls") != std::string::npos;
    };
    CHECK(names_walls("size: [10, 10], walls: solid"));
    CHECK(names_walls("size: [10, 10], walls: {left: periodic, right: periodic}"));
    CHECK_FALSE(names_walls("size: [10, 10], walls: periodic"));
    CHECK(names_walls("size: [10, 10, 10], walls: {left: periodic, right: periodic}"));
    CHECK_FALSE(names_walls("size: [10, 10, 10], walls: periodic"));
}

TEST_CASE("the bounds of the classes of speed are medium") {
    const std::array<double, 3> shares =
        class_shares(Eigen::ArrayXd{{0.0, 0.99, 1.0, 2.0, 3.0, 3.01, 7.0, 2.5}}, 2.0);
    CHECK(shares[0] == 2.0 / 8);
    CHECK(shares[1] == 4.0 / 8);
    CHECK(shares[2] == 2.0 / 8);
}

TEST_CASE("slow and fast are beside the present mean speed, or that at the start") {
    const Stage stage(2);
    for (const bool initial : {false, true}) {
        const auto panel = stage.panel(test::panel_from(
            std::string("{kind: speed-classes, reference: ") + (initial ? "initial}" : "now}")));
        stage.show(*panel, 0.0, along_x({1.0, 1.0, 1.0, 1.0}));
        stage.show(*panel, 1.0, along_x({0.0, 1.0, 3.0, 4.0}));  // mean 2
        CHECK(panel->record().runs.front().y[1][0] == 100.0);
        CHECK(panel->record().runs.front().y[0][1] == 25.0);
        CHECK(panel->record().runs.front().y[1][1] == (initial ? 25.0 : 50.0));
        CHECK(panel->record().runs.front().y[2][1] == (initial ? 50.0 : 25.0));
    }
}

// Light energies: 0.5 up to time 4, 2 from then on; linear between 4 and 5.
TEST_CASE("a series over a window is the mean over the time before the present") {
    const Stage stage(2);
    for (const std::string kind : {"energy-by-species", "temperature"}) {
        CAPTURE(kind);
        PanelSpec spec{.kind = kind, .over = Over{Over::Since::window, 4.0}};
        const auto panel = stage.panel(spec);
        for (int time = 0; time <= 12; ++time) {
            const double v = time < 5 ? 1.0 : 2.0;
            stage.show(*panel, time, along_x({v, v, 0.5 * v, 0.5 * v}));  // of mass 1 and 4
        }
        panel->fix_axes();
        const std::vector<double>& line = panel->record().runs.front().y[0];
        CHECK(line[0] == relative(0.5, 1e-14));
        CHECK(line[4] == relative(0.5, 1e-14));
        CHECK(line[6] == relative((2.0 * 0.5 + 1.25 + 2.0) / 4.0, 1e-14));
        CHECK(line[8] == relative((1.25 + 3.0 * 2.0) / 4.0, 1e-14));
        CHECK(line[9] == relative(2.0, 1e-14));
        CHECK(panel->plot(nullptr).notes.at(0).entries.at(0).words.at(0).pieces.at(0).markup ==
              "mean over the last 4");
    }
}

TEST_CASE("the temperature of a plane is its mean energy, of all and of those chosen") {
    const Stage stage(2);
    PanelSpec spec{.kind = "temperature"};
    spec.of = {{}, {1, {}}, {{}, 0}};
    const auto panel = stage.panel(spec);
    stage.show(*panel, 0.0, along_x({1.0, 2.0, 3.0, -1.0}));  // energies 0.5, 2, 18, 2
    CHECK(panel->record().runs.front().y[0][0] == relative(22.5 / 4, 1e-14));
    CHECK(panel->record().runs.front().y[1][0] == relative(10.0, 1e-14));
    CHECK(panel->record().runs.front().y[2][0] == relative(0.5, 1e-14));
}

TEST_CASE("pressures are of what changed hands since the start, in a while, or since a frame ago") {
    Stage stage(2);
    const auto last = [&](Over over) {
        PanelSpec spec{.kind = "pressure"};
        spec.over = over;
        const auto panel = stage.panel(spec);
        const Eigen::ArrayXXd velocity = along_x({1.0, -1.0, 1.0, -1.0});  // energy 5
        double received = 0.0;
        for (const double t : {0.0, 1.0, 1.0, 2.0, 4.0}) {
            received = 10.0 * t * t;  // by each wall
            stage.advanced.impulses.wall = {received, received, received, received};
            stage.advanced.impulses.virial = 8.0 * t;
            stage.show(*panel, t, velocity);
        }
        CHECK(std::isnan(panel->record().runs.front().y[0][0]));
        // P V = 2 K / 2 + virial / (2 t) over the room of the centres, (10 * 9 + 10 * 9) / 2.
        CHECK(panel->record().runs.front().y[1].back() ==
              relative((5.0 + 8.0 / 2.0) / 90.0, 1e-14));
        return panel->record().runs.front().y[0].back();
    };
    // Four walls of length 10.
    CHECK(last({Over::Since::start, 0.0}) == relative(4 * 160.0 / (40.0 * 4.0), 1e-14));
    CHECK(last({Over::Since::window, 3.0}) == relative(4 * 150.0 / (40.0 * 3.0), 1e-14));
    CHECK(last({Over::Since::now, 0.0}) == relative(4 * 120.0 / (40.0 * 2.0), 1e-14));
}

TEST_CASE("the pressure of a gas that was parted counts from when the last partition has opened") {
    Stage stage(2);
    Partition door{.name = "door", .at = 5.0};
    stage.scene.gas.box.surfaces.partitions = {door};
    stage.advanced.surfaces.resize(5);
    PanelSpec spec{.kind = "pressure"};
    spec.over = Over{Over::Since::start, 0.0};
    const auto panel = stage.panel(spec);
    for (const double t : {0.0, 1.0, 2.0, 4.0, 6.0}) {
        const double received = 10.0 * t * t;
        stage.advanced.impulses.wall = {received, received, received, received};
        stage.advanced.surfaces[4].is_open = t >= 2.0;
        stage.show(*panel, t, along_x({1.0, -1.0, 1.0, -1.0}));
    }
    const std::vector<double>& on_walls = panel->record().runs.front().y[0];
    REQUIRE(on_walls.size() == 5);
    for (const std::size_t k : {0, 1, 2}) CHECK(std::isnan(on_walls[k]));
    CHECK(on_walls[3] == relative(4 * 120.0 / (40.0 * 2.0), 1e-14));
    CHECK(on_walls[4] == relative(4 * 320.0 / (40.0 * 4.0), 1e-14));
}

TEST_CASE(
    "entropy is 0 where all of a kind move alike, ln 2 for two streams, most at equilibrium") {
    Stage stage(100);
    const auto panel = stage.panel({.kind = "entropy"});
    Random random(3, "velocities");
    Eigen::ArrayXXd alike = Eigen::ArrayXXd::Ones(200, 2);
    alike.bottomRows(100) = -0.5;
    Eigen::ArrayXXd streams = Eigen::ArrayXXd::Zero(200, 2);
    for (Eigen::Index i = 0; i < 200; ++i) streams(i, 0) = i % 2 == 0 ? 1.0 : -1.0;
    Eigen::ArrayXXd thermal(200, 2);
    for (double& v : thermal.reshaped()) v = random.normal();
    stage.show(*panel, 0.0, alike);
    stage.show(*panel, 1.0, streams);
    stage.show(*panel, 2.0, thermal);
    stage.show(*panel, 3.0, -alike);
    CHECK(std::abs(panel->record().runs.front().y[0][0]) < 1e-15);
    CHECK(panel->record().runs.front().y[0][1] == relative(std::log(2.0), 1e-14));
    CHECK(panel->record().runs.front().y[0][2] > 2.0);
    CHECK(std::abs(panel->record().runs.front().y[0][3]) < 1e-15);
}

TEST_CASE("points are positions against velocities, or against another particle's") {
    const Stage stage(2);
    const PanelContext context{stage.scene, stage.particles, 1, stage.equilibrium};
    Eigen::ArrayXXd position(4, 2), velocity(4, 2);
    position << 1, 2, 3, 4, 5, 6, 7, 8;
    velocity << -1, -2, -3, -4, -5, -6, -7, -8;
    const Sample sample{0.0, position, velocity};
    const Eigen::ArrayXd speed = speeds(sample);
    const Tick tick;
    const FrameInput input{tick, sample, speed, speed, stage.advanced};
    const auto points = [&](const PanelSpec& spec, std::size_t set) {
        const std::unique_ptr<Panel> panel = make_panel(context, spec);
        panel->survey(input);
        panel->fix_axes();
        std::vector<std::pair<double, double>> pairs;
        const std::shared_ptr<const PanelState> state = panel->state(input);
        for (const Point& point : PointsPanel::points(*state, set))
            pairs.emplace_back(point.x, point.y);
        return pairs;
    };
    using Pairs = std::vector<std::pair<double, double>>;
    PanelSpec phase{.kind = "phase"};
    phase.of = {{0, {}}, {{}, 3}};
    CHECK(points(phase, 0) == Pairs{{1, -1}, {3, -3}});
    phase.component = Component::y;
    CHECK(points(phase, 1) == Pairs{{8, -8}});
    PanelSpec both{.kind = "positions"};
    both.of = {{{}, 2}, {{}, 1}};
    CHECK(points(both, 0) == Pairs{{5, 3}});
    both.component = Component::y;
    CHECK(points(both, 0) == Pairs{{6, 4}});
}

// Cairo rounds a channel otherwise than to_pixel().
bool is_pixel_of(Color color, std::uint32_t pixel) {
    bool same = true;
    for (const int shift : {0, 8, 16})
        same = same && std::abs(static_cast<int>(to_pixel(color) >> shift & 0xFF) -
                                static_cast<int>(pixel >> shift & 0xFF)) <= 1;
    return same;
}

TEST_CASE("points stand before the paths of all, and out from them") {
    // Bead 1 comes, stays at 2 while 0 goes to the wall and back, and goes on: its path crosses the
    // place of 0, which is at rest at 2 from then on.
    const test::Shot film(test::scene_from(
        "title: T\nbox: {length: 20}\ngas: [{position: [2, 6], velocity: [0, -1]}]\n"
        "run: {until: 10}\nfilm: {seconds: 4, fps: 20, theme: light, "
        "panels: [{kind: phase, of: [0, 1]}]}\n"));
    const Grid grid(film.scene.film.layout, film.scene.film.size);
    DiskPainter disks;
    const DrawContext dc{grid.place(shared_slots(film.scene.film.layout.panels, 1).front()),
                         grid.unit(), theme(ThemeKind::light), disks};
    const Rect plot = plot_area(dc);
    FramePainter painter(*film.panels);
    const PixelView view = painter.paint(film.frames.back()).pixels();
    const auto pixel = [&](double x, double y) {
        return view.data[static_cast<int>(y) * view.stride + static_cast<int>(x)] & 0xFFFFFF;
    };
    const double x = plot.x + 0.1 * plot.width, y = plot.y + plot.height / 2;
    const Color own = edge_of(kind_in(film.scene.film, 1, dc.theme), dc.theme);
    for (const double down : {-0.25, 0.0, 0.25})
        CHECK(is_pixel_of(own, pixel(x, y + down * dc.unit)));
    CHECK(pixel(x, y - 0.42 * dc.unit) == (to_pixel(dc.theme.page) & 0xFFFFFF));
    const Color other = edge_of(kind_in(film.scene.film, 2, dc.theme), dc.theme);
    CHECK(is_pixel_of(other, pixel(x, y - 1.2 * dc.unit)));
}

TEST_CASE("two beads have a line that they never cross, unless they go around") {
    const auto share_of_line = [](const std::string& walls) {
        const test::Shot film(test::scene_from(
            "title: T\nbox: {length: 20, walls: " + walls +
            "}\ngas: [{position: [2, 18], velocity: [0.1, 0]}]\nrun: {until: 1}\n"
            "film: {seconds: 4, fps: 5, theme: light, panels: [{kind: positions, of: [0, 1]}]}\n"));
        const Grid grid(film.scene.film.layout, film.scene.film.size);
        DiskPainter disks;
        const DrawContext dc{grid.place(shared_slots(film.scene.film.layout.panels, 1).front()),
                             grid.unit(), theme(ThemeKind::light), disks};
        const Rect plot = plot_area(dc);
        FramePainter painter(*film.panels);
        const PixelView view = painter.paint(film.frames.back()).pixels();
        int drawn = 0;
        for (int i = 1; i < 100; ++i) {
            const auto x = static_cast<int>(plot.x + 0.01 * i * plot.width);
            const auto y = static_cast<int>(plot.bottom() - 0.01 * i * plot.height);
            const std::uint32_t pixel = view.data[y * view.stride + x] & 0xFFFFFF;
            if (pixel != (to_pixel(dc.theme.page) & 0xFFFFFF) &&
                pixel != (to_pixel(dc.theme.grid) & 0xFFFFFF))
                ++drawn;
        }
        return 0.01 * drawn;
    };
    CHECK(share_of_line("solid") > 0.3);
    CHECK(share_of_line("periodic") == 0.0);
}

namespace {

// A panel of a gas in a periodic box, over a long run.
test::SeenPanel seen_long(const std::string& gas, const std::string& panel) {
    return {
        test::scene_from("title: T\nbox: {size: [20, 15], walls: periodic}\ngas: " + gas +
                         "\nrun: {until: 18000}\nfilm: {seconds: 2, panels: [" + panel + "]}\n"),
        24000};
}

// The mean over time from a twentieth of the run on, and its error from 20 parts of the run.
MeanError mean_over_time(const std::vector<double>& line) {
    constexpr std::size_t parts = 20;
    const std::size_t each = line.size() / (parts + 1);
    std::vector<double> means;
    for (std::size_t part = 1; part <= parts; ++part) {
        const auto first = line.begin() + static_cast<std::ptrdiff_t>(part * each);
        means.push_back(std::accumulate(first, first + static_cast<std::ptrdiff_t>(each), 0.0) /
                        static_cast<double>(each));
    }
    return mean_error(means);
}

}  // namespace

TEST_CASE("in a periodic box each species has its own mean energy, and tends to it") {
    const test::SeenPanel seen = seen_long(
        "[{name: light, count: 10, radius: 0.5, speed: 1.24}, {name: heavy, count: 1, radius: 0.8, "
        "mass: 20}]",
        "energy-by-species");
    const History& run = seen.series();
    REQUIRE(run.levels.size() == 2);
    const double temperature = seen.accounts.front().kinetic / 10.0;  // E / (N - 1)
    const std::array<double, 2> masses{1.0, 20.0};
    for (std::size_t k = 0; k < 2; ++k) {
        CAPTURE(k);
        CHECK(run.levels[k].line == k);
        CHECK(run.levels[k].name == "equilibrium");  // no equipartition: they differ
        CHECK(run.levels[k].value == relative(temperature * (1.0 - masses[k] / 30.0), 1e-9));
        const MeanError measured = mean_over_time(run.y[k]);
        CHECK(std::abs(measured.mean - run.levels[k].value) < 4.0 * measured.error);
    }
}

TEST_CASE("the level of each species is named at its line in the colour of the species") {
    const test::SeenPanel seen(
        test::scene_from("title: T\nbox: {size: [60, 40], walls: periodic}\ngas:\n"
                         "  - {name: light, count: 200, radius: 0.3, temperature: 4}\n"
                         "  - {name: middle, count: 60, radius: 0.3, mass: 4, temperature: 1}\n"
                         "  - {name: heavy, count: 20, radius: 0.6, mass: 40, temperature: 1}\n"
                         "run: {until: 80}\nfilm: {seconds: 2, panels: [energy-by-species]}\n"),
        80);
    const plot::Plot plot = seen.plot();
    for (const PixelSize size : {PixelSize{280, 260}, PixelSize{400, 200}, PixelSize{1200, 600}}) {
        CAPTURE(size.width);
        DiskPainter disks;
        const DrawContext dc{
            {0, 0, double(size.width), double(size.height)}, 20.0, theme(ThemeKind::light), disks};
        Canvas canvas(size);
        const TextLog log;
        plot::draw_plot(canvas, dc, plot, plot::DrawnPart::still);
        plot::LabelPlacer placer({});
        const plot::Frame frame = plot::frame_of(plot::with_names(plot, dc), dc, placer);
        std::size_t at_lines = 0;
        for (const plot::AnyLayer& layer : plot.layers) {
            const auto* level = std::get_if<plot::Level>(&layer);
            if (level == nullptr) continue;
            REQUIRE(level->label);
            for (const plot::Text& text : level->label->words) {
                const auto line = std::ranges::find(log.lines, plot::markup_of(text, dc.theme),
                                                    &DrawnLine::markup);
                if (line == log.lines.end()) continue;
                if (std::ranges::any_of(log.in_keys, [&](const std::string& words) {
                        return line->markup.find(words) != std::string::npos;
                    }))
                    continue;
                const double y = frame.y(level->value);
                CAPTURE(line->markup);
                CHECK(std::max(line->ink.y - y, y - line->ink.bottom()) < 2.5 * dc.unit);
                ++at_lines;
            }
        }
        CHECK(at_lines + log.in_keys.size() + log.left_out.size() >= 3);
        if (size.width > 1000) CHECK(at_lines >= 2);
    }
}

TEST_CASE("the entropy of velocities of few disks tends to its level, momentum conserved") {
    const test::SeenPanel seen = seen_long("[{count: 20, radius: 0.5, speed: 1}]", "entropy");
    const History& run = seen.series();
    REQUIRE(run.levels.size() == 1);
    const MeanError measured = mean_over_time(run.y[0]);
    CHECK(measured.error < 0.004);
    // The level is computed to 4e-4.
    CHECK(std::abs(measured.mean - run.levels[0].value) < 4.0 * std::hypot(measured.error, 4e-4));
}
