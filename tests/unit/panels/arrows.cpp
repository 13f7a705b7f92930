// Arrows of velocity: as long as the scene says, or by one scale for the whole film; what they do
// at walls and at joined sides.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "panels/frame.h"
#include "panels/gas/velocity_arrows.h"
#include "panels/surfaces/surface_sizes.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

struct Extent {
    double left = 1e9, right = -1e9, lowest = 1e9, highest = -1e9;
    int pixels = 0;
};

// The last frame of a run, of which the survey has seen the first too.
struct Shot {
    Scene scene;
    Simulation simulation;
    PanelSet panels;
    std::unique_ptr<FramePainter> painter;
    PixelView view;
    Rect box;

    Shot(const std::string& gas, const std::string& film,
         const std::string& room = "size: [40, 40]", double time = 0.0)
        : scene(test::scene_from("title: T\nbox: {" + room + "}\ngas: [" + gas +
                                 "]\nrun: {until: 4}\nfilm: {seconds: 1, template: wide-gas, "
                                 "size: [1600, 1800], color_by: species, " +
                                 film + "}\n")),
          simulation(scene.gas, scene.run),
          panels(scene, simulation.particles(), simulation.sample()) {
        Tick tick{};
        panels.survey(tick, simulation.sample(), simulation.advance_to(0.0));
        panels.fix_axes();
        const AdvanceResult advanced = simulation.advance_to(time);
        tick.time = time;
        const FrameData frame = panels.frame_data(tick, simulation.sample(), advanced);
        painter = std::make_unique<FramePainter>(panels);
        view = painter->paint(frame).pixels();
        const Rect place = Grid(scene.film.layout, scene.film.size).place(scene.film.layout.gas);
        const bool is_joined = scene.gas.box.dimension == 2 && scene.gas.box.is_periodic(0);
        const double margin = is_joined ? SurfaceSize::chevron * unit() : 0.0;
        box = panels.gas().frame_in(place, is_joined ? unit() : 1.0);
        box = {box.x + margin, box.y + margin, box.width - 2.0 * margin, box.height - 2.0 * margin};
    }

    double scale() const { return box.width / scene.gas.box.size[0]; }
    double unit() const { return Grid(scene.film.layout, scene.film.size).unit(); }

    // Where pixels of the ink are, in units of the scene from the lower left corner of the box, in
    // and close around it.
    Extent ink() const {
        const std::uint32_t color = to_pixel(theme(theme_kind()).ink) & 0xFFFFFF;
        Extent extent;
        const int more = static_cast<int>(0.75 * unit());  // the key begins at 0.8
        const int above = static_cast<int>(box.y) - more, below = static_cast<int>(box.bottom());
        for (int y = std::max(0, above); y < std::min(view.height, below + more); ++y)
            for (int x = std::max(0, static_cast<int>(box.x) - more);
                 x < std::min(view.width, static_cast<int>(box.right()) + more); ++x) {
                if ((view.data[y * view.stride + x] & 0xFFFFFF) != color) continue;
                ++extent.pixels;
                extent.left = std::min(extent.left, (x - box.x) / scale());
                extent.right = std::max(extent.right, (x + 1 - box.x) / scale());
                extent.highest = std::max(extent.highest, (box.bottom() - y) / scale());
                extent.lowest = std::min(extent.lowest, (box.bottom() - y - 1) / scale());
            }
        return extent;
    }

    ThemeKind theme_kind() const {
        return scene.film.theme == ThemeName::light   ? ThemeKind::light
               : scene.film.theme == ThemeName::print ? ThemeKind::print
                                                      : ThemeKind::dark;
    }
};

std::string disk(const std::string& place, const std::string& velocity) {
    return "{count: 1, radius: 1, color: teal, position: " + place + ", velocity: " + velocity +
           "}";
}

}  // namespace

TEST_CASE("an arrow is velocity times the scene's time long, from the centre, in every theme") {
    for (const std::string theme : {"dark", "light", "print"}) {
        CAPTURE(theme);
        const Shot film(disk("[10, 20]", "[3, 0]"), "velocities: 4, theme: " + theme);
        const Extent ink = film.ink();
        const double pixel = 1.0 / film.scale();
        CHECK(std::abs(ink.left - 10.0) < 2.0 * pixel);
        CHECK(std::abs(ink.right - 22.0) < 3.0 * pixel);  // the tip is a point
        CHECK(ink.pixels > 50);
        const Extent none =
            Shot(disk("[10, 20]", "[3, 0]"), "velocities: false, theme: " + theme).ink();
        CHECK(none.pixels == 0);
    }
}

TEST_CASE("arrows point up where velocities do") {
    const Shot film(disk("[20, 20]", "[0, 2]"), "velocities: 5, theme: dark");
    const Extent ink = film.ink();
    const double pixel = 1.0 / film.scale();
    CHECK(std::abs(ink.lowest - 20.0) < 2.0 * pixel);
    // Between two columns of pixels the tip is ink where it is two pixels wide: 2.2 behind its end,
    // and up to one more to the next row.
    CHECK(std::abs(ink.highest - 30.0) < 3.2 * pixel);
    CHECK(std::abs(ink.left + ink.right - 40.0) < 2.0 * pixel);
}

TEST_CASE("with words on the disks arrows begin at the rim") {
    const Shot film(
        "{count: 1, radius: 4, mass: infinite, color: white, position: [10, 20], velocity: [2, 0]}",
        "velocities: 5, labels: index, theme: dark");
    const Extent ink = film.ink();
    CHECK(std::abs(ink.right - 24.0) < 3.0 / film.scale());
}

TEST_CASE("without a scale of its own a film chooses one, the same for all its frames") {
    const std::string two = "{name: a, " + disk("[10, 10]", "[1, 0]").substr(1) + ", {name: b, " +
                            disk("[10, 30]", "[2, 0]").substr(1);
    const Shot start(two, "velocities: true, theme: dark");
    // The fastest: four mean radii, here between a twentieth and a fifth of the box.
    CHECK(std::abs(start.ink().right - 14.0) < 3.0 / start.scale());
    const Shot later(two, "velocities: true, theme: dark", "size: [40, 40]", 4.0);
    CHECK(std::abs(later.ink().right - 22.0) < 3.0 / later.scale());
    CHECK(std::abs(later.ink().left - 14.0) < 2.0 / later.scale());
}

TEST_CASE("arrows end a little beyond a wall, and come in again through a joined side") {
    const Shot solid(disk("[36, 20]", "[2, 0]"), "velocities: 5, theme: dark");
    const Extent cut = solid.ink();
    const double beyond = 0.7 * solid.unit() / solid.scale();
    CHECK(std::abs(cut.right - 40.0 - beyond) < 3.0 / solid.scale());
    CHECK(cut.left > 35.0);
    CHECK(cut.highest - cut.lowest > 0.5 * solid.unit() / solid.scale());  // the head is there
    const Shot joined(disk("[36, 20]", "[2, 0]"), "velocities: 5, theme: dark",
                      "size: [40, 40], walls: periodic");
    const Extent around = joined.ink();
    CHECK(around.left < 2.0 / joined.scale());
    CHECK(around.right <= 40.0 + 1e-9);
    CHECK(around.right > 40.0 - 2.0 / joined.scale());
}

TEST_CASE("a gas at rest has no arrows") {
    for (const std::string room : {"size: [40, 40]", "length: 40"}) {
        const std::string gas = "{count: 3, radius: 1, color: teal}";
        const Shot rest(gas, "velocities: true, theme: dark", room);
        const Shot none(gas, "velocities: false, theme: dark", room);
        CHECK(rest.ink().pixels == none.ink().pixels);
    }
}

TEST_CASE("beads have their arrows in a row below the wire, and a ring joins its ends") {
    const std::string bead = "{count: 1, radius: 1, color: teal, position: 36, velocity: 2}";
    for (const std::string walls : {"solid", "periodic"}) {
        CAPTURE(walls);
        const std::string room = "length: 40, walls: " + walls;
        const Shot with(bead, "velocities: 4, theme: dark", room);
        const Shot without(bead, "velocities: false, theme: dark", room);
        const double plot_left = 3.4 * with.unit(), plot_width = with.box.width - 4.0 * with.unit();
        const auto place = [&](double x) {
            return (plot_left + x * plot_width / 40.0) / with.scale();
        };
        REQUIRE(without.ink().pixels == 0);
        const Extent ink = with.ink();
        const double pixel = 1.0 / with.scale();
        if (walls == "periodic") {
            CHECK(ink.left < place(0.0) + 2.0 * pixel);
            CHECK(std::abs(ink.right - place(40.0)) < 2.0 * pixel);
        } else {
            CHECK(std::abs(ink.left - place(36.0)) < 2.0 * pixel);
            CHECK(std::abs(ink.right - place(40.0) - 0.7 * with.unit() / with.scale()) <
                  3.0 * pixel);
        }
    }
}

TEST_CASE("a bead that has gone round a ring has its arrow still") {
    // From 36 on a ring of 40 three times round in the film.
    const test::Shot film(test::scene_from(
        "title: T\nbox: {length: 40, walls: periodic}\ngas: [{count: 1, radius: 1, color: teal, "
        "position: 36, velocity: 30}]\nrun: {until: 4}\nfilm: {seconds: 4, template: wide-gas, "
        "size: [1600, 1800], theme: dark, color_by: species, velocities: 0.1}\n"));
    FramePainter painter(*film.panels);
    const auto ink = [&](const FrameData& frame) {
        const PixelView view = painter.paint(frame).pixels();
        const std::uint32_t color = to_pixel(theme(ThemeKind::dark).ink) & 0xFFFFFF;
        int count = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                count += (view.data[y * view.stride + x] & 0xFFFFFF) == color;
        return count;
    };
    const int start = ink(film.frames.front()), end = ink(film.frames.back());
    CHECK(start > 500);
    CHECK(std::abs(end - start) < 50);
}

// All as long and nowhere over one another: 80 arrows, then one of every two and of every three.
TEST_CASE("of many disks some have arrows, evenly chosen, and the key says how many") {
    const auto many = [](int count) {
        const std::string gas = "{count: " + std::to_string(count) +
                                ", radius: 0.1, color: teal, position: lattice, velocity: [0.5, "
                                "0]}";
        const Shot film(gas, "velocities: 2, theme: dark");
        return film.ink().pixels;
    };
    const int one = many(1);
    REQUIRE(one > 20);
    const auto arrows = [&](int count) { return static_cast<double>(many(count)) / one; };
    CHECK(arrows(80) == doctest::Approx(80).epsilon(0.1));
    CHECK(arrows(81) == doctest::Approx(41).epsilon(0.1));
    CHECK(arrows(160) == doctest::Approx(80).epsilon(0.1));
    CHECK(arrows(161) == doctest::Approx(54).epsilon(0.1));
    const auto says_some = [](int count) {
        const TextLog log;
        const Shot film("{count: " + std::to_string(count) +
                            ", radius: 0.1, position: lattice, velocity: [0.5, 0]}",
                        "velocities: 2, theme: dark");
        return std::ranges::any_of(
            log.lines, [](const DrawnLine& line) { return line.markup.ends_with("of 1 in 3"); });
    };
    CHECK(says_some(161));
    CHECK_FALSE(says_some(80));
}
