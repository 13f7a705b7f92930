// The collision of two beads in the plane of their velocities: against exact fractions, against the
// conservation laws, and as pixels where geometry says.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "panels/collision/collision_map_keys.h"
#include "panels/collision/pair_motion.h"
#include "panels/plot/layers.h"
#include "panels/plot/plot_panel.h"
#include "panels/registry.h"
#include "support/csv.h"
#include "support/pixels.h"
#include "support/relative.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::fraction;
using test::relative;

namespace {

constexpr double round_off = 4e-16;

Scene wire(const std::string& gas, double until, const std::string& more = "",
           const std::string& length = "26") {
    return test::scene_from("title: T\nbox: {length: " + length + "}\ngas: [" + gas +
                            "]\nrun: {until: " + std::to_string(until) + more +
                            "}\nfilm: {seconds: 2, fps: 20}\n");
}

const std::string light_and_heavy =
    "{name: light, position: 4, mass: 1, velocity: 0}, "
    "{name: heavy, position: 14, mass: 100, velocity: -1}";

PanelSpec walk_of(std::int64_t first, std::int64_t second) {
    PanelSpec spec = panel_of("collision-map", CollisionMapOptions{.walk = true});
    spec.of = {{{}, first}, {{}, second}};
    return spec;
}

// A panel that has seen a run of 40 frames, and its state at the end of it, or until `last`.
struct Seen {
    Scene scene;
    Particles particles;
    BoxedGas none = {};
    std::unique_ptr<Panel> made;
    PlotPanel& panel;
    std::vector<std::shared_ptr<const PanelState>> states = {};

    Seen(Scene loaded, const PanelSpec& spec, bool in_film = true)
        : scene(std::move(loaded)),
          particles(Simulation(scene.gas, scene.run).particles()),
          made(make_panel(PanelContext{scene, particles, 40, none, in_film}, spec)),
          panel(dynamic_cast<PlotPanel&>(*made)) {
        const Eigen::ArrayXd zeros = Eigen::ArrayXd::Zero(particles.count());
        for (const bool survey : {true, false}) {
            Simulation simulation(scene.gas, scene.run);
            simulation.record_collisions(survey);
            for (int frame = 0; frame <= 40; ++frame) {
                Tick tick;
                tick.frame = frame;
                tick.time = scene.run.until * frame / 40;
                const AdvanceResult advanced = simulation.advance_to(tick.time);
                const FrameInput seen{tick, simulation.sample(), zeros, zeros, advanced};
                if (survey)
                    panel.survey(seen);
                else
                    states.push_back(panel.state(seen));
            }
            if (survey) panel.fix_axes();
        }
    }

    Table table(std::size_t state = 40) const {
        return panel.table(*states[state], theme(ThemeKind::light));
    }
};

// Where velocities are in the picture of a panel: on axes of velocities times `factor`.
struct Plane {
    plot::LabelPlacer placer{{}};
    plot::Frame frame;
    Eigen::Array2d factor;

    Plane(const PlotPanel& panel, const DrawContext& dc, const Eigen::Array2d& times = {1.0, 1.0})
        : frame(plot::frame_of(panel.plot(nullptr), dc, placer)), factor(times) {}
    Point operator()(const Eigen::Array2d& v) const {
        return {frame.x(factor[0] * v[0]), frame.y(factor[1] * v[1])};
    }
};

struct Row {
    std::string of;
    Eigen::Array2d v;
};

std::vector<Row> rows(const Table& table, const std::string& part) {
    std::vector<Row> found;
    for (const auto& row : table.rows)
        if (std::get<std::string>(row[0]) == part)
            found.push_back({std::get<std::string>(row[1]),
                             {std::get<double>(row[4]), std::get<double>(row[5])}});
    return found;
}

std::string message_of(const Scene& scene, const PanelSpec& spec) {
    try {
        const Seen seen(scene, spec);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

double largest(const Eigen::Array2d& v) { return v.abs().maxCoeff(); }

}  // namespace

// tests/reference/pair_collision_1d.csv
TEST_CASE("the map of a collision is the reference's, its own inverse, with its eigenvectors") {
    int seen = 0;
    for (const auto& row : test::reference_rows("pair_collision_1d.csv")) {
        const Eigen::Array2d w{fraction(row.at(2)), fraction(row.at(3))};
        if (w.sum() == 0.0) continue;
        const Eigen::Vector2d before{fraction(row.at(0)), fraction(row.at(1))};
        const Eigen::Vector2d after{std::stod(row.at(6)), std::stod(row.at(7))};
        const Eigen::Matrix2d map = collision_matrix(w);
        const double speed = before.cwiseAbs().maxCoeff() + after.cwiseAbs().maxCoeff();
        CHECK(largest(map * before - after) <= 4.0 * round_off * speed);
        CHECK((map * map - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff() < 8.0 * round_off);
        PairMotion motion{.inverse_mass = w};
        const Eigen::Vector2d turning = motion.turning();
        CHECK(turning == Eigen::Vector2d{w[0], -w[1]});
        CHECK(largest(map * Eigen::Vector2d::Ones() - Eigen::Vector2d::Ones()) < 4.0 * round_off);
        CHECK(largest(map * turning + turning) < 4.0 * round_off * largest(w));
        ++seen;
    }
    CHECK(seen > 15);
}

// tests/reference/pair_collision_1d.csv
TEST_CASE("a given pair is shown before and after, on the ellipse of its energy") {
    const Scene scene = wire(light_and_heavy, 1.0);
    int seen = 0, walls = 0;
    for (const auto& row : test::reference_rows("pair_collision_1d.csv")) {
        const Eigen::Array2d w{fraction(row.at(2)), fraction(row.at(3))};
        const Eigen::Array2d before{fraction(row.at(0)), fraction(row.at(1))};
        if (w.sum() == 0.0 || before[0] == before[1]) continue;
        const CollisionMapOptions options{.given = GivenPair{w, before}};
        const Table table = Seen(scene, panel_of("collision-map", options)).table();
        const std::vector<Row> points = rows(table, "point");
        REQUIRE(points.size() == 3);
        CHECK(points[0].of == "before");
        CHECK((points[0].v == before).all());
        CHECK(points[1].of == "after");
        const Eigen::Array2d after = points[1].v;
        const double speed = largest(before) + largest(after);
        CHECK(std::abs(after[0] - std::stod(row.at(6))) <= 4.0 * round_off * speed);
        CHECK(std::abs(after[1] - std::stod(row.at(7))) <= 4.0 * round_off * speed);
        // From the middle it is as far to either, along the eigenvector that turns round.
        const Eigen::Array2d middle = points[2].v;
        CHECK(middle[0] == middle[1]);
        CHECK(largest(before + after - 2.0 * middle) <= 8.0 * round_off * speed);
        const Eigen::Array2d turning = rows(table, "eigenvector").at(1).v;
        const Eigen::Array2d relative_motion = before - middle;
        CHECK(std::abs(relative_motion[0] * turning[1] - relative_motion[1] * turning[0]) <=
              8.0 * round_off * speed * largest(w));
        const std::vector<Row> curve = rows(table, "curve");
        if (w[0] == 0.0 || w[1] == 0.0) {
            CHECK(curve.empty());
            CHECK(after[w[0] == 0.0 ? 0 : 1] == before[w[0] == 0.0 ? 0 : 1]);
            ++walls;
            continue;
        }
        const double twice = (before.square() / w).sum();
        CHECK((after.square() / w).sum() == relative(twice, 1e-11));
        REQUIRE(curve.size() > 100);
        for (const Row& point : curve)
            CHECK((point.v.square() / w).sum() == relative(twice, 1e-14));
        ++seen;
    }
    CHECK(seen > 10);
    CHECK(walls >= 2);
}

TEST_CASE("a pair of the run is the first that collides, or the one asked for in its order") {
    const std::string gas = "{name: a, position: [2, 6, 12], mass: [1, 3, 1], velocity: [1, 0, 0]}";
    PanelSpec spec{.kind = "collision-map"};
    const std::vector<Row> first = rows(Seen(wire(gas, 20.0), spec).table(), "point");
    CHECK((first[0].v == Eigen::Array2d{1.0, 0.0}).all());
    CHECK(largest(first[1].v - Eigen::Array2d{-0.5, 0.5}) < round_off);
    spec.of = {{{}, 2}, {{}, 1}};
    const std::vector<Row> second = rows(Seen(wire(gas, 20.0), spec).table(), "point");
    CHECK(largest(second[0].v - Eigen::Array2d{0.0, 0.5}) < round_off);
    CHECK(largest(second[1].v - Eigen::Array2d{0.75, 0.25}) < 2.0 * round_off);
}

// tests/reference/galperin.csv
TEST_CASE("the walk of the digits of pi: every point on one circle, equal steps between them") {
    for (const auto& row : test::reference_rows("galperin.csv")) {
        const int n = std::stoi(row.at(0)), expected = std::stoi(row.at(1));
        if (n > 2) continue;
        const double mass = std::pow(100.0, n), until = n == 2 ? 400.0 : 26.0;
        Scene scene = wire(
            "{name: light, position: 4, mass: 1, velocity: 0}, {name: heavy, "
            "position: 14, mass: " +
                std::to_string(mass) + ", velocity: -1}",
            until, "", "1000");
        const Seen seen(scene, walk_of(1, 0));
        const std::vector<Row> points = rows(seen.table(), "point");
        REQUIRE(points.size() == static_cast<std::size_t>(expected + 1));
        CHECK(points.front().of == "start");
        const double radius = std::sqrt(mass), theta = std::atan(1.0 / radius);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Array2d& v = points[i].v;
            CHECK(std::hypot(v[0], v[1]) == relative(radius, 1e-12));
            // It starts at an angle of -pi; from one collision of the two to the next, 2 theta.
            if (points[i].of != "collision of the two") continue;
            const double turned = std::atan2(v[1], v[0]);
            const double steps = static_cast<double>(i + 1) / 2.0;
            CHECK(std::remainder(turned - (2.0 * theta * steps - std::acos(-1.0)),
                                 2.0 * std::acos(-1.0)) == doctest::Approx(0.0).epsilon(1e-9));
            // Momentum stays; scaled velocities times the root of the mass.
            const Eigen::Array2d& before = points[i - 1].v;
            CHECK(std::abs(radius * (v[0] - before[0]) + v[1] - before[1]) < 1e-11 * mass);
        }
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (points[i].of != "wall") continue;
            CHECK(points[i].v[0] == points[i - 1].v[0]);
            CHECK(points[i].v[1] == -points[i - 1].v[1]);
        }
        // So far as many steps as there have been collisions.
        Simulation simulation(scene.gas, scene.run);
        for (std::size_t frame = 0; frame <= 40; frame += 4) {
            const CollisionCounts counts =
                simulation.advance_to(until * static_cast<double>(frame) / 40.0).counts;
            CHECK(rows(seen.table(frame), "point").size() ==
                  static_cast<std::size_t>(counts.particle + counts.wall + 1));
        }
    }
}

TEST_CASE("a walk on unscaled axes lies on the ellipse, and a reversal mirrors it") {
    PanelSpec spec = walk_of(0, 1);
    spec.options.change<CollisionMapOptions>().scaled = false;
    const Seen there(wire(light_and_heavy, 16.0), spec);
    const Seen back(wire(light_and_heavy, 32.0, ", events: [{at: 16, reverse: velocities}]"), spec);
    const std::vector<Row> out = rows(there.table(), "point"), all = rows(back.table(), "point");
    REQUIRE(all.size() >= 2 * out.size() - 1);
    CHECK(all[out.size()].of == "reversal");
    for (std::size_t i = 0; i < all.size(); ++i)
        CHECK(0.5 * (all[i].v[0] * all[i].v[0] + 100.0 * all[i].v[1] * all[i].v[1]) ==
              relative(50.0, 1e-12));
    for (std::size_t i = 0; i + 1 < out.size(); ++i)  // the same way back, mirrored
        CHECK(largest(all[out.size() + i].v + out[out.size() - 1 - i].v) < 1e-6);
    // The frame at the reversal shows it.
    CHECK(rows(back.table(20), "point").back().of == "reversal");
}

TEST_CASE("a walk without a pair begins at time 0, before it is known which two collide") {
    // 0 meets the wall on the left at 4, then 1 at 5 + 1/3; 2 and 3 are far away.
    PanelSpec spec = walk_of(0, 1);
    spec.of = {};
    const std::string gas =
        "{name: a, position: [4, 12, 20, 23], mass: [1, 4, 1, 1], velocity: [-1, -0.5, 0, 0]}";
    const std::vector<Row> points = rows(Seen(wire(gas, 11.0), spec).table(), "point");
    REQUIRE(points.size() == 3);
    CHECK(points[0].of == "start");
    CHECK((points[0].v == Eigen::Array2d{-1.0, -1.0}).all());  // the root of 4 times -0.5
    CHECK(points[1].of == "wall");
    CHECK((points[1].v == Eigen::Array2d{1.0, -1.0}).all());
    CHECK(points[2].of == "collision of the two");
    CHECK(largest(points[2].v - Eigen::Array2d{-1.4, 0.2}) < 4.0 * round_off);
}

TEST_CASE("a walk needs one ellipse and not too many steps, and says so at its place") {
    PanelSpec spec = walk_of(0, 1);
    const std::string third = message_of(
        wire("{name: a, position: [2, 6, 12], velocity: [1, 0, 0], mass: [1, 2, 1]}", 25.0), spec);
    CHECK(third.find("particle 2 strikes particle 1 at 13") != std::string::npos);
    CHECK(third.find("`walk` is for two beads that collide only with each other and with walls") !=
          std::string::npos);
    const std::string infinite =
        "{name: a, position: 2, velocity: 1}, {name: b, position: 9, mass: infinite}";
    CHECK(message_of(wire(infinite, 25.0), spec).find("has no ellipse of energy, which `walk`") !=
          std::string::npos);
    const PanelSpec scaled = panel_of("collision-map", CollisionMapOptions{.scaled = true});
    CHECK(message_of(wire(infinite, 25.0), scaled).find("which `scaled` needs") !=
          std::string::npos);
    const std::string many = message_of(wire("{name: light, position: 4, mass: 1, velocity: 0}, "
                                             "{name: heavy, position: 14, mass: 1e8, velocity: -1}",
                                             26.0),
                                        spec);
    CHECK(many.find("collide with each other and with walls 31415 times") != std::string::npos);
    // The energy does not stay that of the ellipse.
    for (const std::string more : {"walls: {left: {temperature: 2}}", "walls: {left: {mass: 5}}"})
        CHECK(message_of(test::scene_from("title: T\nbox: {length: 26, " + more + "}\n" +
                                          "gas: [{position: [4, 14], velocity: [0, -1]}]\n"
                                          "run: {until: 20}\n"),
                         spec)
                  .find("walls, gravity or events change the energy of particles 0 and 1") !=
              std::string::npos);
    CHECK(message_of(test::scene_from("title: T\nbox: {length: 26}\n"
                                      "gas: [{position: [4, 14], velocity: [0, -1]}]\n"
                                      "run: {until: 20, events: [{at: 12, heat: {by: 2}}]}\n"),
                     spec)
              .find("walls, gravity or events change the energy") != std::string::npos);
    CHECK(message_of(wire("{name: a, position: [2, 6], velocity: [-1, 1]}", 3.0), spec)
              .find("particles 0 and 1 do not collide") != std::string::npos);
}

namespace {

std::uint32_t pixel(const PixelView& view, const Point& at) {
    return view.data[static_cast<int>(at.y) * view.stride + static_cast<int>(at.x)] & 0xFFFFFF;
}

std::uint32_t rgb_of(Color color) { return to_pixel(color) & 0xFFFFFF; }

}  // namespace

TEST_CASE("equal scales on both axes, 0 in the middle, the points where their velocities are") {
    const Scene scene = wire(light_and_heavy, 1.0);
    for (const bool scaled : {false, true}) {
        const CollisionMapOptions options{.given = GivenPair{{1.0, 1.0 / 3.0}, {1.0, -0.2}},
                                          .scaled = scaled};
        const Seen seen(scene, panel_of("collision-map", options), false);
        DiskPainter disks;
        for (const PixelSize size : {PixelSize{1000, 700}, PixelSize{500, 900}}) {
            CAPTURE(size.width);
            Canvas canvas(size);
            const DrawContext dc{{20, 20, size.width - 40.0, size.height - 40.0},
                                 24.0,
                                 theme(ThemeKind::light),
                                 disks};
            canvas.fill_all(dc.theme.page);
            seen.panel.draw_ground(canvas, dc);
            seen.panel.draw(canvas, dc, *seen.states.back());
            const double root = scaled ? std::sqrt(3.0) : 1.0;
            const Plane to(seen.panel, dc, {1.0, root});
            const Point zero = to({0.0, 0.0});
            const Rect& area = to.frame.area;
            CHECK(zero.x == relative(area.x + area.width / 2, 1e-12));
            CHECK(zero.y == relative(area.y + area.height / 2, 1e-12));
            const double across = to({1.0, 0.0}).x - zero.x, up = zero.y - to({0.0, 1.0}).y;
            CHECK(up == relative(across * root, 1e-12));

            const PixelView view = canvas.pixels();
            const Color ink = dc.theme.ink;
            CHECK(pixel(view, to({-0.8, 0.4})) == rgb_of(ink));            // after, by hand
            CHECK(pixel(view, to({1.0, -0.2})) == rgb_of(dc.theme.page));  // before: hollow
            // On the ellipse v1^2 + 3 v2^2 = 1.12, away from the rest; and beside it nothing.
            for (const double turn : {1.2, 2.0, 3.6, 5.0}) {
                const Eigen::Array2d on{std::sqrt(1.12) * std::cos(turn),
                                        std::sqrt(1.12 / 3.0) * std::sin(turn)};
                CHECK(pixel(view, to(on)) == rgb_of(dc.theme.muted));
                CHECK(pixel(view, to(1.05 * on)) == rgb_of(dc.theme.page));
            }
            // The line of momentum 0.4 beyond the points, and the end of the mass centre's arrow.
            CHECK(pixel(view, to({-1.1, 0.5})) == rgb_of(edge_of(dc.theme.highlight, dc.theme)));
            if (size.width == 1000) CHECK(pixel(view, to({0.06, 0.06})) == rgb_of(dc.theme.muted));
            for (const double v : {-0.2, -0.6})
                CHECK(pixel(view, to({v, (0.4 - v) / 3.0})) ==
                      rgb_of(ink));  // from the middle to after
        }
    }
}

TEST_CASE("an infinite mass has two lines instead of an ellipse") {
    const CollisionMapOptions options{.given = GivenPair{{1.0, 0.0}, {1.0, -0.5}}};
    const Seen seen(wire(light_and_heavy, 1.0), panel_of("collision-map", options), false);
    DiskPainter disks;
    Canvas canvas(PixelSize{1000, 700});
    const DrawContext dc{{20, 20, 960, 660}, 24.0, theme(ThemeKind::light), disks};
    canvas.fill_all(dc.theme.page);
    seen.panel.draw_ground(canvas, dc);
    const Plane to(seen.panel, dc);
    const PixelView view = canvas.pixels();
    for (const double wall : {-0.8, 0.3, 0.7})
        for (const double bead : {-2.0, 1.0})
            CHECK(pixel(view, to({bead, wall})) == rgb_of(dc.theme.muted));
    CHECK(pixel(view, to({-2.0, -0.5})) == rgb_of(dc.theme.ink));
    CHECK(pixel(view, to({1.7, -0.5})) == rgb_of(edge_of(dc.theme.highlight, dc.theme)));
}

TEST_CASE("in a film a ring stands around the point of the present, before and after") {
    const Scene scene = wire("{name: a, position: [2, 6], velocity: [1, 0], mass: [1, 3]}", 6.0);
    const Seen seen(scene, PanelSpec{.kind = "collision-map"});
    DiskPainter disks;
    const DrawContext dc{{20, 20, 960, 660}, 24.0, theme(ThemeKind::light), disks};
    const auto picture = [&](std::size_t state) {
        Canvas canvas(PixelSize{1000, 700});
        canvas.fill_all(dc.theme.page);
        seen.panel.draw(canvas, dc, *seen.states[state]);
        return canvas;
    };
    const Plane to(seen.panel, dc);
    const std::uint32_t ring = rgb_of(edge_of(dc.theme.highlight, dc.theme));
    for (const auto& [state, v] :
         {std::pair<std::size_t, Eigen::Array2d>{10, {1.0, 0.0}}, {35, {-0.5, 0.5}}}) {
        const Canvas canvas = picture(state);
        const Point at = to(v);
        CHECK(pixel(canvas.pixels(), {at.x + 0.75 * 24.0, at.y}) == ring);
        CHECK(pixel(canvas.pixels(), {at.x, at.y - 0.75 * 24.0}) == ring);
    }
}
