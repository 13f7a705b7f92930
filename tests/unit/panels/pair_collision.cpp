// One collision as panels show it: against collisions known by hand, a quadratic solved on its own,
// and the exact numbers of two beads; and whether arrows and dots are where these say.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "panels/collision/collision_stages.h"
#include "panels/frame.h"
#include "support/csv.h"
#include "support/pixels.h"
#include "support/relative.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::relative;
using test::Shot;

namespace {

Scene scene_of(const std::string& box, const std::string& gas, double until,
               const std::string& film = "panels: []") {
    return test::scene_from("title: T\nbox: {" + box + "}\ngas: [" + gas +
                            "]\nrun: {until: " + std::to_string(until) +
                            "}\nfilm: {seconds: 2, fps: 20, size: [1920, 1080], " + film + "}\n");
}

// What a watch sees of a simulation in ten frames.
PairCollision pair_collision_in(const Scene& scene, Simulation simulation,
                                const PanelSpec& spec = {}) {
    const Particles particles = simulation.particles();
    const BoxedGas none;
    PairCollisionWatch watch(PanelContext{scene, particles, 10, none}, spec);
    simulation.record_collisions(true);
    const Eigen::ArrayXd zeros = Eigen::ArrayXd::Zero(particles.count());
    for (int frame = 0; frame <= 10; ++frame) {
        Tick tick;
        tick.frame = frame;
        tick.time = scene.run.until * frame / 10;
        const AdvanceResult advanced = simulation.advance_to(tick.time);
        watch.survey({tick, simulation.sample(), zeros, zeros, advanced});
    }
    return watch.collision();
}

PairCollision pair_collision_in(const Scene& scene, const PanelSpec& spec = {}) {
    return pair_collision_in(scene, Simulation(scene.gas, scene.run), spec);
}

PanelSpec pair_of(std::int64_t first, std::int64_t second) {
    PanelSpec spec;
    spec.of = {{{}, first}, {{}, second}};
    return spec;
}

double fraction(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return std::stod(text);
    return std::stod(text.substr(0, slash)) / std::stod(text.substr(slash + 1));
}

double length(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

// A disk of radius 2 meets an equal one at rest, 2 beside its way: the line of centres makes 30
// degrees with it.
Scene at_thirty_degrees(const std::string& film = "panels: []") {
    return scene_of("size: [24, 18]",
                    "{name: a, position: [3.5, 9], radius: 2, velocity: [1, 0]}, "
                    "{name: b, position: [13, 7], radius: 2}",
                    12.0, "template: lecture, " + film);
}

}  // namespace

TEST_CASE("equal disks that meet at 30 degrees part at right angles, at half and 0.866 the speed") {
    const PairCollision met = pair_collision_in(at_thirty_degrees());
    const double cosine = std::sqrt(3.0) / 2.0;
    CHECK(met.time == relative(9.5 - 4.0 * cosine, 1e-14));
    CHECK(met.since == 0.0);
    CHECK(met.until == 12.0);
    CHECK(std::abs(dot(met.after[0], met.after[1])) < 1e-15);
    CHECK(met.after[0][0] == relative(0.25, 1e-13));
    CHECK(met.after[0][1] == relative(0.5 * cosine, 1e-13));
    CHECK(met.after[1][0] == relative(0.75, 1e-13));
    CHECK(met.after[1][1] == relative(-0.5 * cosine, 1e-13));
    CHECK(met.other_root() - met.time == relative(8.0 * cosine, 1e-13));
    CHECK(met.square(met.time) == relative(16.0, 1e-13));
    CHECK(met.square(0.0) == relative(9.5 * 9.5 + 4.0, 1e-13));
    // Speeds along and across the line of centres stay as they are: the way out mirrors the way in.
    CHECK(met.square(met.time + 2.0) == relative(met.square(met.time - 2.0), 1e-13));
}

TEST_CASE("the two times of contact are the roots of a quadratic equation for the flight before") {
    const Scene scene = scene_of("size: [14, 11], walls: periodic",
                                 "{name: a, count: 12, radius: 0.6, speed: 1}, "
                                 "{name: b, count: 5, radius: 1, speed: 2, mass: 3}",
                                 6.0);
    int seen = 0;
    for (std::int64_t i = 0; i < 17; ++i)
        for (std::int64_t j = i + 1; j < 17; ++j) {
            PairCollision met;
            try {
                met = pair_collision_in(scene, pair_of(i, j));
            } catch (const SceneError&) {
                continue;
            }
            // In the middle of the flight, from a simulation of its own.
            Simulation simulation(scene.gas, scene.run);
            const double start = 0.5 * (met.since + met.time);
            simulation.advance_to(start);
            const Sample& sample = simulation.sample();
            long double a = 0, b = 0, c = 0;
            for (int axis = 0; axis < 2; ++axis) {
                const long double v =
                    (long double)sample.velocity(j, axis) - sample.velocity(i, axis);
                const long double size = scene.gas.box.size[axis];
                // The image that touches.
                long double x = (long double)sample.position(j, axis) - sample.position(i, axis);
                const long double there =
                    met.place[1][axis] - met.place[0][axis] - v * ((long double)met.time - start);
                x += size * std::round((there - x) / size);
                a += v * v, b += x * v, c += x * x;
            }
            const long double sigma =
                (long double)simulation.particles().radius[i] + simulation.particles().radius[j];
            const long double root = std::sqrt(b * b - a * (c - sigma * sigma));
            CHECK(met.time == doctest::Approx(double(start + (-b - root) / a)).epsilon(1e-11));
            CHECK(met.other_root() ==
                  doctest::Approx(double(start + (-b + root) / a)).epsilon(1e-11));
            ++seen;
        }
    CHECK(seen > 15);
}

// tests/reference/pair_collision_1d.csv
TEST_CASE("beads leave a collision with exactly the velocities of its matrix") {
    int seen = 0;
    Scene scene = scene_of("length: 1000", "{count: 2}", 40.0);
    for (const auto& row : test::reference_rows("pair_collision_1d.csv")) {
        const double u1 = fraction(row.at(0)), u2 = fraction(row.at(1));
        const double w1 = fraction(row.at(2)), w2 = fraction(row.at(3));
        if (!(u1 > u2) || w1 + w2 == 0.0) continue;
        const Particles particles{Eigen::ArrayXd::Zero(2), Eigen::ArrayXd{{w1, w2}},
                                  Eigen::ArrayXi::Zero(2)};
        Sample start{0.0, Eigen::ArrayXXd{{500.0}, {501.0}}, Eigen::ArrayXXd{{u1}, {u2}}};
        const PairCollision met =
            pair_collision_in(scene, Simulation(scene.gas.box, particles, start, scene.run));
        CHECK(met.before[0][0] == u1);
        CHECK(met.before[1][0] == u2);
        CHECK(met.after[0][0] == doctest::Approx(std::stod(row.at(6))).epsilon(1e-12));
        CHECK(met.after[1][0] == doctest::Approx(std::stod(row.at(7))).epsilon(1e-12));
        CHECK(met.other_root() == met.time);  // points
        ++seen;
    }
    CHECK(seen > 3);
}

TEST_CASE(
    "a free flight begins at the last collision of either, with a wall too, or at a reversal") {
    // 1 meets the wall on the right at 2, and then 0.
    const std::string gas =
        "{name: a, position: [5, 5], radius: 1, velocity: [1, 0]}, "
        "{name: b, position: [17, 5], radius: 1, velocity: [1, 0]}";
    const PairCollision met = pair_collision_in(scene_of("size: [20, 10]", gas, 30.0));
    CHECK(met.since == relative(2.0, 1e-14));
    CHECK(met.time == relative(7.0, 1e-14));
    // They exchange velocities at 12 and 14: 0 goes back to the left wall, 1 to the right one.
    CHECK(met.until == relative(12.0, 1e-14));
    // 0 turns round at 1, meets 1 at 7, and they turn round once more at 8.
    Scene turned = scene_of("size: [20, 10]",
                            "{name: a, position: [5, 5], radius: 1, velocity: [-1, 0]}, "
                            "{name: b, position: [12, 5], radius: 1}",
                            30.0);
    turned.run.events = {{1.0, ReverseVelocities{}}, {8.0, ReverseVelocities{}}};
    const PairCollision after = pair_collision_in(turned);
    CHECK(after.since == 1.0);
    CHECK(after.time == relative(7.0, 1e-14));
    CHECK(after.until == 8.0);
}

TEST_CASE("the pair is the first that collides, or the one asked for, in its order") {
    const Scene scene =
        scene_of("length: 20", "{position: [2, 6, 12], velocity: [1, 0, 0], radius: 0.5}", 30.0);
    CHECK(pair_collision_in(scene).particle == std::array<Eigen::Index, 2>{0, 1});
    const PairCollision met = pair_collision_in(scene, pair_of(2, 1));
    CHECK(met.particle == std::array<Eigen::Index, 2>{2, 1});
    CHECK(met.before[0][0] == 0.0);
    CHECK(met.after[0][0] == 1.0);
    CHECK(met.place[0][0] == relative(12.0, 1e-14));
    CHECK(met.place[1][0] == relative(11.0, 1e-14));
}

TEST_CASE("events that change velocities or places part flights as collisions do") {
    const std::string text =
        "title: T\nbox: {length: 20}\ngas: [{position: [2, 12, 18], velocity: [1, 0, 0], radius: "
        "0.5}]\n"
        "run: {until: 15, events: [";
    const auto flight = [&](const std::string& events) {
        return pair_collision_in(
            test::scene_from(text + events + "]}\nfilm: {seconds: 2, panels: []}\n"));
    };
    CHECK(flight("").since == 0.0);
    CHECK(flight("{at: 1, heat: {by: 0.5}}").since == 1.0);
    CHECK(flight("{at: 2, nudge: {particle: 0, by: 1e-9}}").since == 2.0);
    CHECK(flight("{at: 2, nudge: {particle: 2, by: 1e-9}}").since == 0.0);
    CHECK(flight("{at: 11, nudge: {particle: 2, by: 1e-9}}").until > 11.0);
    CHECK(flight("{at: 11, heat: {by: 0.5}}").until == 11.0);
}

TEST_CASE("a pair that never collides is an error at the panel's place") {
    const std::string panels = "panels: [{kind: contact-time, of: [0, 2]}]";
    const Scene scene = scene_of(
        "length: 20", "{position: [2, 6, 12], velocity: [1, 0, 0], radius: 0.5}", 9.0, panels);
    std::string message;
    try {
        const Shot film(scene);
    } catch (const SceneError& error) {
        message = error.what();
    }
    CHECK(message.starts_with("test:5:"));
    CHECK(message.find("particles 0 and 2 do not collide from time 0 to 9, the end of the run") !=
          std::string::npos);
    CHECK_THROWS_AS(Shot(scene_of("size: [9, 9]", "{count: 2}", 9.0, "panels: [single-collision]")),
                    SceneError);
}

namespace {

Vec along(const StageArrow& arrow) {
    return {arrow.to.x - arrow.from.x, arrow.from.y - arrow.to.y};
}

bool is_inside(const Rect& rect, Point p, double margin) {
    return p.x - margin > rect.x - 1e-9 && p.x + margin < rect.right() + 1e-9 &&
           p.y - margin > rect.y - 1e-9 && p.y + margin < rect.bottom() + 1e-9;
}

}  // namespace

TEST_CASE(
    "stages stand in their area, disks touch, arrows add up, momenta are equal and opposite") {
    // Masses 2 and 1, radii 2 and 1.5.
    const Scene scene = scene_of("size: [24, 18]",
                                 "{name: a, position: [7, 9.6], radius: 2, mass: 2, velocity: [1, "
                                 "0]}, {name: b, position: [17.5, 8], radius: 1.5, velocity: [-1, "
                                 "0.1]}",
                                 7.6);
    const Particles particles = Simulation(scene.gas, scene.run).particles();
    const PairCollision met = pair_collision_in(scene);
    for (const Rect& area :
         {Rect{10, 20, 624, 160}, Rect{0, 0, 2000, 900}, Rect{5, 5, 400, 1200}}) {
        const CollisionStages all = collision_stages(met, particles, area, 24.0, 2);
        const auto& [before, contact, after] = all.stage;
        const double tiny = 1e-9 * area.width;
        CHECK(length(contact.center[0], contact.center[1]) ==
              relative(all.radius[0] + all.radius[1], 1e-9));
        CHECK(length(before.center[0], before.center[1]) ==
              relative(1.6 * (all.radius[0] + all.radius[1]), 1e-9));
        CHECK(all.radius[0] / all.radius[1] == relative(2.0 / 1.5, 1e-12));
        const Vec line{contact.center[1].x - contact.center[0].x,
                       contact.center[0].y - contact.center[1].y};
        Vec momentum, energy;
        for (std::size_t k = 0; k < 2; ++k) {
            const Vec change = along(contact.velocity[k]);
            CHECK(longest(abs(along(before.velocity[k]) + change - along(after.velocity[k])), 2) <
                  tiny);
            CHECK(std::abs(change[0] * line[1] - change[1] * line[0]) < tiny * all.radius[0]);
            const double mass = k == 0 ? 2.0 : 1.0;
            momentum += mass * change;
            energy[0] += mass * square(along(before.velocity[k]));
            energy[1] += mass * square(along(after.velocity[k]));
        }
        CHECK(longest(abs(momentum), 2) < tiny);
        CHECK(energy[0] == relative(energy[1], 1e-9));
        // The centre of mass goes on with (2 * 1 - 1 * 1) / 3 to the right.
        CHECK(along(contact.mass_center_velocity)[0] == relative(all.reach / 3.0, 1e-9));
        for (const CollisionStage& stage : all.stage) {
            CHECK(stage.mass_center.x ==
                  relative((2.0 * stage.center[0].x + stage.center[1].x) / 3.0, 1e-9));
            for (std::size_t k = 0; k < 2; ++k) {
                CHECK(is_inside(area, stage.center[k], all.radius[k]));
                CHECK(is_inside(stage.area, stage.velocity[k].to, 0.0));
            }
        }
        CHECK(all.radius[0] > 8.0);
    }
}

TEST_CASE("an infinite mass is its own centre of mass and keeps its velocity") {
    const Scene scene = scene_of("size: [24, 18]",
                                 "{name: a, position: [5, 9], radius: 2, velocity: [1, 0]}, "
                                 "{name: b, position: [15, 8], radius: 1, mass: infinite}",
                                 9.0);
    const Particles particles = Simulation(scene.gas, scene.run).particles();
    const CollisionStages all =
        collision_stages(pair_collision_in(scene), particles, {0, 0, 900, 300}, 20.0, 2);
    for (const CollisionStage& stage : all.stage)
        CHECK(length(stage.mass_center, stage.center[1]) < 1e-9);
    CHECK(longest(abs(along(all.stage[1].velocity[1])), 2) < 1e-9);
    CHECK(longest(abs(along(all.stage[1].velocity[0])), 2) > 1.0);
}

TEST_CASE("points on a wire are drawn as if they had a size, their arrows beside them") {
    const Scene scene = scene_of("length: 20", "{position: [2, 6], velocity: [1, 0]}", 9.0);
    const Particles particles = Simulation(scene.gas, scene.run).particles();
    const CollisionStages all =
        collision_stages(pair_collision_in(scene), particles, {0, 0, 900, 300}, 20.0, 1);
    const CollisionStage& contact = all.stage[1];
    CHECK(contact.center[0].y == contact.center[1].y);
    CHECK(contact.center[1].x - contact.center[0].x ==
          relative(all.radius[0] + all.radius[1], 1e-9));
    CHECK(contact.velocity[0].from.y < contact.center[0].y - all.radius[0]);
    CHECK(contact.mass_center_velocity.from.y > contact.center[0].y + all.radius[0]);
}

namespace {

// The middle of the pixels of a colour that two pictures do not share.
std::optional<Point> changed(const PixelView& a, const std::vector<std::uint32_t>& b, Color color) {
    const std::uint32_t wanted = to_pixel(color) & 0xFFFFFF;
    double x_sum = 0.0, y_sum = 0.0, count = 0.0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const std::uint32_t pixel = a.data[y * a.stride + x];
            if ((pixel & 0xFFFFFF) != wanted ||
                pixel == b[static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                           static_cast<std::size_t>(x)])
                continue;
            x_sum += x + 0.5, y_sum += y + 0.5, count += 1.0;
        }
    if (count < 20.0) return std::nullopt;
    return Point{x_sum / count, y_sum / count};
}

DrawContext page_of(const Scene& scene, DiskPainter& disks) {
    const Grid grid(scene.film.layout, scene.film.size);
    return {grid.place(shared_slots(scene.film.layout.panels, 1).front()), grid.unit(),
            theme(ThemeKind::light), disks};
}

}  // namespace

TEST_CASE("the time of the contact is written above it, as near as there is room") {
    const Shot film(at_thirty_degrees("panels: [contact-time]"));
    DiskPainter disks;
    const DrawContext dc = page_of(film.scene, disks);
    const TextLog log;
    FramePainter(*film.panels).paint(film.frames.front());
    const Rect plot = plot_area(dc);
    const PairCollision met = pair_collision_in(film.scene);
    const double last = met.time + 1.75 * (met.other_root() - met.time);
    const double at = plot.x + met.time / last * plot.width;
    int seen = 0;
    for (const DrawnLine& line : log.lines) {
        if (!line.markup.starts_with("contact at ")) continue;
        ++seen;
        CHECK(std::abs(line.ink.x + line.ink.width / 2 - at) < dc.unit);
        CHECK(line.ink.bottom() > plot.y + 0.25 * plot.height);
        CHECK(line.ink.bottom() < plot.bottom());
    }
    CHECK(seen == 1);
}

TEST_CASE("the present moves on the curve: across with the time, up with the squared distance") {
    const Shot film(
        at_thirty_degrees("theme: light, panels: "
                          "[contact-time]"));
    DiskPainter disks;
    const Rect plot = plot_area(page_of(film.scene, disks));
    FramePainter painter(*film.panels);
    std::vector<std::uint32_t> ground;
    {
        const Canvas& picture = painter.paint(film.frames.back());
        ground = test::pixels_of(picture);
    }
    const PairCollision met = pair_collision_in(film.scene);
    const double last = met.time + 1.75 * (met.other_root() - met.time);
    std::vector<std::pair<double, double>> heights;  // squared distance, pixels
    for (std::size_t i = 8; i + 12 < film.frames.size(); i += 3) {
        const double time = film.frames[i].tick.time;
        const auto at =
            changed(painter.paint(film.frames[i]).pixels(), ground,
                    edge_of(theme(ThemeKind::light).highlight, theme(ThemeKind::light)));
        if (!at || std::abs(time - met.time) < 0.5) continue;
        CHECK(std::abs(at->x - (plot.x + plot.width * time / last)) < 3.0);
        heights.emplace_back(met.square(time), at->y);
    }
    REQUIRE(heights.size() > 4);
    const auto& [low, low_y] = *std::ranges::min_element(heights);
    const auto& [high, high_y] = *std::ranges::max_element(heights);
    for (const auto& [square, y] : heights)
        CHECK(std::abs(y - (low_y + (square - low) / (high - low) * (high_y - low_y))) < 4.0);
}

TEST_CASE("the arrow before is drawn as long as it is") {
    const Shot film(at_thirty_degrees("theme: light, panels: [single-collision]"));
    DiskPainter disks;
    const DrawContext dc = page_of(film.scene, disks);
    const PairCollision met = pair_collision_in(film.scene);
    FramePainter painter(*film.panels);
    const PixelView view = painter.paint(film.frames.back()).pixels();
    // By the stages' own geometry, with the room that the panel leaves for words.
    const double unit = dc.unit;
    const Rect room{dc.area.x, dc.area.y + 1.9 * unit, dc.area.width,
                    dc.area.height - (1.9 + 4.2) * unit};
    const Particles particles = Simulation(film.scene.gas, film.scene.run).particles();
    const CollisionStages all = collision_stages(met, particles, room, unit, 2);
    const CollisionStage& before = all.stage[0];
    const std::uint32_t ink = to_pixel(dc.theme.ink) & 0xFFFFFF;
    int left = view.width, right = 0;
    const int row = static_cast<int>(before.velocity[0].from.y);
    for (int x = static_cast<int>(before.area.x); x < static_cast<int>(before.area.right()); ++x)
        if ((view.data[row * view.stride + x] & 0xFFFFFF) == ink)
            left = std::min(left, x), right = std::max(right, x);
    CHECK(std::abs(left - before.center[0].x) < 2.0);
    CHECK(std::abs(right + 1 - (before.center[0].x + all.reach)) < 4.0);
}
