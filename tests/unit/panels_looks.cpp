// How disks and beads look: rings, words that fit on them, and the numbers of monitors.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "draw/palette.h"
#include "panels/frame.h"
#include "scene/load.h"
#include "support/pixels.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& gas, const std::string& film,
               const std::string& box = "size: [40, 40]") {
    return load_scene_text("title: T\nbox: {" + box + "}\ngas: [" + gas +
                               "]\nrun: {until: 4}\nfilm: {seconds: 1, theme: dark, template: "
                               "wide-gas, size: [640, 720], " +
                               film + "}\n",
                           "test", std::filesystem::path(CAROM_TEST_ROOT) / "templates");
}

// The first frame of a scene.
struct Picture {
    Scene scene;
    Simulation simulation;
    Observers observers;
    std::unique_ptr<FramePainter> painter;
    PixelView view;

    explicit Picture(Scene loaded)
        : scene(std::move(loaded)),
          simulation(scene.gas, scene.run),
          observers(scene, simulation.particles(), simulation.sample()) {
        const Passage passage = simulation.advance_to(0.0);
        const Tick tick{};
        observers.survey(tick, simulation.sample(), passage);
        observers.settle();
        const FrameData frame = observers.frame_data(tick, simulation.sample(), passage);
        painter = std::make_unique<FramePainter>(scene, observers);
        view = painter->paint(frame).pixels();
    }

    // How many pixels of the whole frame are exactly of this colour.
    int count(std::uint32_t color) const {
        int count = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                count += (view.data[y * view.stride + x] & 0xFFFFFF) == color;
        return count;
    }

    std::vector<std::uint32_t> pixels() const { return test::pixels_of(view); }

    double scale() const {
        const Rect box = observers.gas().frame_in(
            Grid(scene.film.layout, scene.film.size).place(scene.film.layout.gas));
        return box.width / scene.gas.box.size[0];
    }
};

}  // namespace

TEST_CASE("a ring has the outer edge of its disk, and nothing inside") {
    const std::string gas = "{count: 1, radius: 8, position: [20, 20], color: \"#ff0000\", ";
    const Picture full(scene_of(gas + "fill: true}", "color_by: species"));
    const Picture ring(scene_of(gas + "fill: false}", "color_by: species"));
    const double radius = 8.0 * full.scale();
    const double line =
        std::max(1.5, 0.13 * Grid(ring.scene.film.layout, ring.scene.film.size).unit());
    const int key =
        Picture(scene_of("{count: 1, radius: 0.001, position: [20, 20], color: \"#ff0000\"}",
                         "color_by: species"))
            .count(0xFF0000);
    // The rim is blended: of a line of w pixels about w - 1 are wholly covered.
    CHECK(full.count(0xFF0000) - key ==
          doctest::Approx(std::numbers::pi * radius * radius).epsilon(0.02));
    const double circumference = 2.0 * std::numbers::pi * radius;
    CHECK(ring.count(0xFF0000) - key < circumference * line);
    CHECK(ring.count(0xFF0000) - key > 0.2 * circumference * line);
}

TEST_CASE("words stand on disks that have room for them, and on no others") {
    const std::string big = "{count: 1, radius: 6, mass: 12.5, position: [20, 20]}";
    const std::string small = "{count: 1, radius: 0.4, mass: 12.5, position: [20, 20]}";
    const auto drawn = [&](const std::string& gas, const std::string& labels) {
        return Picture(scene_of(gas, "color_by: species" + labels)).pixels();
    };
    CHECK(drawn(big, ", labels: mass") != drawn(big, ""));
    CHECK(drawn(big, ", labels: index") != drawn(big, ", labels: mass"));
    CHECK(drawn(small, ", labels: mass") == drawn(small, ""));
}

TEST_CASE("beads and rods on a wire can be rings with numbers on them") {
    for (const std::string radius : {"0.5", "8"}) {
        const auto drawn = [&](const std::string& look, const std::string& film) {
            const std::string gas = "{count: 2, position: [10, 28], radius: " + radius + look + "}";
            return Picture(scene_of(gas, "color_by: species" + film, "length: 40")).pixels();
        };
        CHECK(drawn(", fill: false", "") != drawn("", ""));
        CHECK(drawn("", ", labels: index") != drawn("", ""));
        CHECK(drawn("", ", labels: mass") != drawn("", ", labels: index"));
    }
}

TEST_CASE("the box stands in the middle where nothing is beside it, else at the left") {
    const Picture alone(scene_of("{count: 1}", "fps: 30", "size: [10, 40]"));
    const Rect area =
        Grid(alone.scene.film.layout, alone.scene.film.size).place(alone.scene.film.layout.gas);
    const Rect box = alone.observers.gas().frame_in(area);
    CHECK(box.x - area.x == doctest::Approx(area.right() - box.right()));
    Scene beside = scene_of("{count: 1}", "fps: 30", "size: [10, 40]");
    beside.film.layout.panels.push_back({78, 10, 1, 1});
    CHECK(Picture(std::move(beside)).observers.gas().frame_in(area).x == doctest::Approx(area.x));
}

TEST_CASE("the colours of speed classes in NetLogo's models stand out from every ground") {
    for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light, ThemeKind::print}) {
        const Theme& colors = theme(kind);
        for (const double share : {0.0, 0.5, 1.0})
            CHECK(contrast(netlogo_map(colors.dark).at(share), colors.ground) >= 3.0);
    }
}
