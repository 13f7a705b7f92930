// The picture of a wire: where beads are drawn, and that frames are pure.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "panels/frame.h"
#include "panels/line/line_map.h"
#include "panels/line/line_panel.h"
#include "panels/plots/histogram_panel.h"
#include "support/equilibrium.h"
#include "support/pixels.h"
#include "support/relative.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::pixels_of;
using test::relative;
using test::Shot;

namespace {

Scene scene_of(const std::string& box, const std::string& gas, const std::string& film,
               const std::string& run = "until: 8") {
    return test::scene_from("title: T\nbox: {" + box + "}\ngas: [" + gas + "]\nrun: {" + run +
                            "}\nfilm: {" + film + "}\n");
}

const std::string mixture =
    "{name: points, count: 9, speed: 1}, {name: rod, count: 1, radius: 0.6, mass: 3, velocity: -2, "
    "position: 1}, {name: post, count: 1, mass: infinite, position: 5, drawn_radius: 0.3}";

}  // namespace

TEST_CASE("beads seem to touch when they meet, and so do a bead and a wall") {
    for (const std::string walls : {"solid", "periodic"}) {
        CAPTURE(walls);
        const Scene scene = scene_of("length: 10, walls: " + walls, mixture, "seconds: 1");
        Simulation simulation(scene.gas, scene.run);
        simulation.record_collisions(true);
        const Particles& particles = simulation.particles();
        const BoxedGas none;
        const PanelContext context{scene, particles, 30, none};
        const LineMap map(context, simulation.sample());
        Eigen::ArrayXd last = map.places(simulation.sample(), {});
        int meetings = 0;
        for (double time = 0.02; time < 8.0; time += 0.02) {
            const AdvanceResult advanced = simulation.advance_to(time);
            for (const Collision& c : advanced.collisions) {
                const double first = map.place(c.first, c.first_position[0], last[c.first]);
                const double r = map.radius(c.first);
                if (c.second.is_surface()) {
                    CHECK(first == relative(c.second == Side::left ? r : map.length() - r, 1e-12));
                    continue;
                }
                ++meetings;
                const double second =
                    map.place(c.second.particle(), c.second_position[0], last[c.second.particle()]);
                const double apart = std::abs(std::remainder(second - first, map.length()));
                CHECK(apart == relative(r + map.radius(c.second.particle()), 1e-12));
            }
            // In between they are apart, in the same order, and nothing jumps.
            const Eigen::ArrayXd places = map.places(simulation.sample(), last);
            CHECK((places - last).abs().maxCoeff() < 0.02 * 40.0);
            for (std::size_t k = 0; k + 1 < map.order().size(); ++k) {
                const Eigen::Index a = map.order()[k], b = map.order()[k + 1];
                REQUIRE(places[b] - places[a] > map.radius(a) + map.radius(b) - 1e-9);
            }
            last = places;
        }
        CHECK(meetings > 20);
    }
}

TEST_CASE("beads are drawn with their own radius, the wanted one, or 0.4 of the mean spacing") {
    const Scene scene = scene_of("length: 11", mixture, "seconds: 1");
    Simulation simulation(scene.gas, scene.run);
    const BoxedGas none;
    const Particles& particles = simulation.particles();
    const LineMap map({scene, particles, 30, none}, simulation.sample());
    CHECK(map.radius(0) == relative(0.4, 1e-12));
    CHECK(map.radius(9) == relative(0.6, 1e-12));
    CHECK(map.radius(10) == relative(0.3, 1e-12));
    CHECK(map.length() == relative(11.0 + 9 * 0.8 + 0.6, 1e-12));
}

TEST_CASE("a frame of a wire is a pure function of it: any order, any painter") {
    for (const std::string walls : {"solid", "periodic"}) {
        const Shot film(scene_of("length: 10, walls: " + walls, mixture,
                                 "seconds: 3, size: [320, 180]",
                                 "until: 8, events: [{at: 4, reverse: velocities}]"));
        FramePainter painter(*film.panels);
        std::vector<std::vector<std::uint32_t>> forward;
        for (const FrameData& frame : film.frames)
            forward.push_back(pixels_of(painter.paint(frame)));
        CHECK(forward.front() != forward.back());
        FramePainter other(*film.panels);
        for (std::size_t i = film.frames.size(); i-- > 0;)
            REQUIRE(pixels_of(other.paint(film.frames[i])) == forward[i]);
    }
}

TEST_CASE("a wire says that labels have no room only where the camera shows none") {
    const Shot shot(scene_of("length: 40", "{count: 20, radius: 0.3, temperature: 1}",
                             "size: [640, 360], fps: 10, seconds: 6, template: minimal, labels: "
                             "index, camera: [{at: 2, view: [0, 4]}]",
                             "until: 10"));
    FramePainter painter(*shot.panels);
    const auto says_so = [&](const FrameData& frame) {
        const TextLog log;
        Canvas page({640, 360}, VectorFormat::svg, {"T", ""});
        painter.paint_on(page, frame);
        return std::ranges::count(log.lines, "no room for labels on the beads",
                                  &DrawnLine::markup) == 1;
    };
    CHECK(says_so(shot.frames.front()));
    CHECK(!says_so(shot.frames.back()));
}

TEST_CASE("every theme and colouring of a wire can be drawn, odd and tiny pictures, few and many") {
    for (const std::string theme : {"light", "dark", "print"})
        for (const std::string color : {"speed", "speed-class", "energy", "species", "mass"})
            for (const std::string& gas :
                 {std::string("{count: 1, speed: 1}"), std::string("{count: 3}"),
                  std::string("{count: 700, temperature: 1}"), mixture}) {
                const Shot film(scene_of(
                    "length: 10", gas,
                    "seconds: 0.2, size: [333, 77], theme: " + theme + ", color_by: " + color,
                    "until: 0.5"));
                FramePainter painter(*film.panels);
                for (const FrameData& frame : film.frames) painter.paint(frame);
                CHECK(film.frames.size() == 6);
            }
}

TEST_CASE("the world lines of a busy wire reach back less far than those of a calm one") {
    const auto memory = [](const std::string& speed) {
        const Shot film(scene_of("length: 10", "{count: 10, speed: " + speed + "}",
                                 "seconds: 40, fps: 60, size: [320, 180]", "until: 40"));
        return dynamic_cast<const LinePanel&>(film.panels->gas()).memory();
    };
    // A round number above 12 seconds of film at most, above 2.5 at least; the pace is nearly 1.
    // Most frames of a film hold no collision: that makes no calm wire.
    CHECK(memory("0.01") >= 12.0);
    CHECK(memory("0.01") < 25.0);
    CHECK(memory("1") < 12.0);
    CHECK(memory("100") >= 2.5);
    CHECK(memory("100") < 5.0);
}

namespace {

// Places and times of the world line of a bead.
std::vector<std::pair<double, double>> world_line(const Shot& film, std::size_t frame) {
    const Table table = film.panels->gas().table(*film.frames[frame].states.front(),
                                                 theme_of(film.scene.film.theme));
    std::vector<std::pair<double, double>> line;
    for (const auto& row : table.rows)
        if (std::get<std::string>(row[0]) == "world line")
            line.emplace_back(std::get<double>(row[3]), std::get<double>(row[4]));
    return line;
}

}  // namespace

TEST_CASE("the world line of a bead that falls is a parabola") {
    // From 16 at rest with g = -1, and up again from the end at times 4 sqrt(2) (1 + 2k).
    const Shot film(test::scene_from(
        "title: T\nbox: {length: 20}\ngravity: -1\n"
        "gas: [{name: a, position: 16, radius: 0, velocity: 0, drawn_radius: 0.01}]\n"
        "run: {until: 24}\nfilm: {seconds: 12, fps: 20, size: [320, 180], template: wide-gas}\n"));
    const double fall = std::sqrt(32.0);
    const auto line = world_line(film, film.frames.size() - 1);
    REQUIRE(line.size() > 100);
    for (std::size_t k = 0; k < line.size(); ++k) {
        const auto& [place, time] = line[k];
        const double since_top = std::abs(std::remainder(time, 2.0 * fall));
        // As drawn it is 0.01 further.
        CHECK(std::abs(place - 0.01 - (16.0 - 0.5 * since_top * since_top)) < 1e-9);
        if (k > 0) CHECK(time - line[k - 1].second < 0.14);  // 24 units of time in 190 frames
    }
}

TEST_CASE("a world line bends where heat changes the velocity, between frames") {
    const Shot film(test::scene_from(
        "title: T\nbox: {length: 20}\n"
        "gas: [{name: a, position: [2, 18], radius: 0, velocity: [1, -1], drawn_radius: 0.01}]\n"
        "run: {until: 4, events: [{at: 3.03, heat: {of: all, to: {temperature: 4}}}]}\n"
        "film: {seconds: 8, fps: 10, size: [320, 180], template: wide-gas}\n"));
    const auto line = world_line(film, film.frames.size() - 1);
    REQUIRE(line.size() == 6);                     // of two beads
    CHECK(std::abs(line[1].first - 5.04) < 1e-9);  // as drawn
    CHECK(line[1].second == 3.03);
}

TEST_CASE("the curve of energies is that of bars, where their density has no value") {
    // Broad bars: the density within them is far from what they hold.
    const Shot film(scene_of("length: 10",
                             "{name: a, count: 50, temperature: 1}, {name: b, count: 50, mass: 2, "
                             "temperature: 1}",
                             "seconds: 1, size: [640, 360], panels: [{kind: energy-histogram, "
                             "bins: 4, range: [0, 4]}]"));
    Simulation simulation(film.scene.gas, film.scene.run);
    const auto gas =
        test::equilibrium(film.scene.gas.box, simulation.particles(), simulation.sample());
    REQUIRE(gas.has_value());
    const double first_bar = 100.0 * energy_probability(*gas, 0.0, 1.0);
    const auto& panel = dynamic_cast<const HistogramPanel&>(*film.panels->panels().back().panel);
    CHECK(panel.tallest() >= 1.2 * first_bar);  // 1.2 to 1.4 times the curve's top, rounded up
    CHECK(panel.tallest() <= round_up_for_axis(1.4 * first_bar));
    FramePainter painter(*film.panels);
    const std::vector<std::uint32_t> pixels = pixels_of(painter.paint(film.frames.back()));
    CHECK(std::count(pixels.begin(), pixels.end(), to_pixel(theme(ThemeKind::dark).accent)) > 30);
}
