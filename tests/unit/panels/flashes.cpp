// Flashes: where and when two particles touch, never more than three in a second.
#include "panels/gas/marks/flashes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "panels/frame.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::Shot;

namespace {

// The kinds of the gas are named a, b, c, ...
Scene scene_of(const std::string& box, const std::string& kinds, const std::string& run,
               const std::string& film) {
    std::string gas;
    char name = 'a';
    for (const char c : kinds)
        gas += c == '{' ? std::string("{name: ") + name++ + ", " : std::string(1, c);
    return test::scene_from("title: T\nbox: {" + box + "}\ngas: [" + gas + "]\nrun: {" + run +
                            "}\nfilm: {size: [1280, 720], theme: light, panels: [], " + film +
                            "}\n");
}

Scene with_surfaces(Scene scene, const Surfaces& surfaces) {
    scene.gas.box.surfaces = surfaces;
    return scene;
}

struct Pixels {
    std::vector<std::uint32_t> with, without;
    bool differ(std::size_t i) const { return with[i] != without[i]; }
};

// A frame of the same film with flashes and without.
struct Pair {
    Shot with, without;
    FramePainter painter, plain;
    explicit Pair(const std::string& box, const std::string& gas, const std::string& run,
                  const std::string& film, const Surfaces& surfaces = {})
        : with(with_surfaces(scene_of(box, gas, run, "flashes: true, " + film), surfaces)),
          without(with_surfaces(scene_of(box, gas, run, film), surfaces)),
          painter(*with.panels),
          plain(*without.panels) {}
    Pixels at(std::size_t frame) {
        return {test::pixels_of(painter.paint(with.frames[frame])),
                test::pixels_of(plain.paint(without.frames[frame]))};
    }
    /// The middle of what differs, and how wide it is; no width: nothing does.
    struct Spot {
        Point middle;
        double width;
    };
    Spot spot(std::size_t frame) {
        const Pixels pixels = at(frame);
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (std::size_t i = 0; i < pixels.with.size(); ++i) {
            if (!pixels.differ(i)) continue;
            left = std::min(left, double(i % 1280));
            right = std::max(right, double(i % 1280) + 1.0);
            top = std::min(top, double(i / 1280));
            bottom = std::max(bottom, double(i / 1280) + 1.0);
        }
        if (right < left) return {{}, 0.0};
        return {{0.5 * (left + right), 0.5 * (top + bottom)}, right - left};
    }
    Rect box() const {
        return with.panels->gas().frame_in(
            Grid(with.scene.film.layout, with.scene.film.size).place(with.scene.film.layout.gas),
            1.0);
    }
};

// The flashes of a film, frame by frame, as the gas panel chooses them.
std::vector<std::vector<Flash>> all_flashes(const Scene& scene, std::vector<std::string>& remarks) {
    Simulation simulation(scene.gas, scene.run);
    const BoxedGas none;
    const PanelContext context{scene, simulation.particles(), frame_count(scene.film), none};
    Flashes flashes(context);
    simulation.record_collisions(true);
    for (const Tick& tick : timeline(scene)) {
        const AdvanceResult advanced = simulation.advance_to(tick.time);
        const Sample& sample = simulation.sample();
        const Eigen::ArrayXd unused;
        flashes.survey({tick, sample, unused, unused, advanced}, [](const Collision& collision) {
            const Vec middle = 0.5 * (collision.first_position + collision.second_position);
            return middle;
        });
    }
    flashes.fix_scale();
    remarks = flashes.remarks();
    std::vector<std::vector<Flash>> frames;
    for (const Tick& tick : timeline(scene)) frames.push_back(flashes.at(tick));
    return frames;
}

}  // namespace

TEST_CASE("never more than three flashes are seen in any second of film") {
    for (const std::string fps : {"2", "10", "30"})
        for (const std::string gas :
             {"{count: 300, radius: 0.5, speed: 3}", "{count: 6, radius: 1, speed: 3}"})
            for (const std::string events : {"", ", events: [{at: 2.5, reverse: velocities}]"}) {
                CAPTURE(fps);
                CAPTURE(gas);
                CAPTURE(events);
                std::vector<std::string> remarks;
                const Scene scene = scene_of("size: [40, 30]", gas, "until: 5" + events,
                                             "seconds: 12, flashes: true, fps: " + fps);
                const auto frames = all_flashes(scene, remarks);
                std::size_t seen = 0;
                const auto second = static_cast<std::size_t>(scene.film.fps);
                for (std::size_t from = 0; from + second <= frames.size(); ++from) {
                    std::set<std::pair<double, double>> places;
                    for (std::size_t i = from; i < from + second; ++i)
                        for (const Flash& flash : frames[i])
                            places.insert({flash.place[0], flash.place[1]});
                    CHECK(places.size() <= 3);
                    seen = std::max(seen, places.size());
                }
                CHECK(seen >= 1);
            }
}

TEST_CASE("a picture says how many collisions flash where some are left out") {
    std::vector<std::string> remarks;
    all_flashes(scene_of("size: [40, 30]", "{count: 300, radius: 0.5, speed: 3}", "until: 5",
                         "seconds: 12, flashes: true"),
                remarks);
    REQUIRE(remarks.size() == 2);
    CHECK(remarks.front().find("at most three per second") != std::string::npos);
    for (const std::string box : {"size: [40, 30]", "length: 40"}) {
        const auto remark = [&](const std::string& gas) {
            const Shot film(scene_of(box, gas, "until: 5", "seconds: 12, flashes: true"), 1);
            FramePainter painter(*film.panels);
            const TextLog log;
            painter.paint(film.frames.front());
            return std::ranges::any_of(log.lines, [](const DrawnLine& line) {
                return line.markup.find("collisions flash") != std::string::npos;
            });
        };
        CHECK(remark("{count: 40, radius: 0.2, temperature: 40}"));
        CHECK_FALSE(remark(box == "length: 40"
                               ? "{radius: 1, position: 10, velocity: 3}, {radius: 1, position: 20}"
                               : "{radius: 1, position: [10, 15], velocity: [3, 0]}, {radius: 1, "
                                 "position: [20, 15]}"));
    }
}

// The disks of radius 3 and 1 touch at (18, 15), those over the side at (40, 15), at times 1 and
// 2 of 2.5.
TEST_CASE("a flash stands at the point of contact, for a quarter of a second") {
    struct Case {
        std::string box, gas;
        double x, y, time;
    };
    const Case cases[] = {
        {"size: [40, 30]",
         "{radius: 3, position: [13, 15], velocity: [2, 0]}, {radius: 1, position: [19, 15]}", 18.0,
         15.0, 1.0},
        {"size: [40, 30]",
         "{radius: 2, position: [10, 12], velocity: [0, 3]}, {radius: 2, position: [10, 22]}", 10.0,
         20.0, 2.0},
        {"size: [40, 30], walls: periodic",
         "{radius: 2, position: [34, 15], velocity: [2, 0]}, {radius: 2, position: [6, 15], "
         "velocity: [-2, 0]}",
         40.0, 15.0, 2.0},
    };
    for (const Case& one : cases) {
        CAPTURE(one.gas);
        Pair pair(one.box, one.gas, "until: 2.5", "seconds: 7.5, fps: 20, color_by: species");
        const Rect box = pair.box();
        const double scale = box.width / 40.0;
        std::size_t frames = 0, first = 0;
        for (std::size_t i = 0; i < pair.with.frames.size(); ++i) {
            const Pair::Spot spot = pair.spot(i);
            if (spot.width == 0.0) continue;
            if (frames++ == 0) first = i;
            if (one.x < 40.0) {
                CHECK(std::abs(spot.middle.x - (box.x + one.x * scale)) <= 1.0);
                CHECK(spot.width < 0.13 * box.width);
            } else {
                CHECK(spot.width > 0.9 * box.width);  // half of it at each side
            }
            CHECK(std::abs(spot.middle.y - (box.bottom() - one.y * scale)) <= 1.0);
        }
        CHECK(frames >= 4);
        CHECK(frames <= 5);
        CHECK(pair.with.frames[first].tick.time >= one.time);
        CHECK(pair.with.frames[first - 1].tick.time <= one.time);
    }
}

// The disk touches what stands in its way at x = 18 and goes back to the left wall, where it does
// not flash: all boxes have that.
TEST_CASE("hits on surfaces flash at the point of contact, those on plain walls do not") {
    Surfaces peg, door, bath;
    peg.obstacles = {{"peg", Obstacle::Ball{{20.0, 15.0}, 2.0}}};
    door.partitions = {{.name = "door", .at = 18.0}};
    bath.sides[0] = Bath{1.0};
    const char* to_right = "{radius: 3, position: [13, 15], velocity: [2, 0]}";
    const char* to_left = "{radius: 3, position: [5, 15], velocity: [-2, 0]}";
    for (const auto& [surfaces, gas, x, time] : {std::tuple(peg, to_right, 18.0, 1.0),
                                                 {door, to_right, 18.0, 1.0},
                                                 {bath, to_left, 0.0, 1.0}}) {
        Pair pair("size: [40, 30]", gas, "until: 2", "seconds: 6, fps: 20", surfaces);
        const Rect box = pair.box();
        const double scale = box.width / 40.0;
        int frames = 0;
        for (std::size_t i = 0; i < pair.with.frames.size(); ++i) {
            const Pair::Spot spot = pair.spot(i);
            if (spot.width == 0.0) continue;
            ++frames;
            CHECK(pair.with.frames[i].tick.time >= time);
            if (x == 0.0) continue;  // what is drawn around the box leaves it less room
            CHECK(std::abs(spot.middle.x - (box.x + x * scale)) <= 1.5);
            CHECK(std::abs(spot.middle.y - (box.bottom() - 15.0 * scale)) <= 1.5);
        }
        CHECK(frames >= 4);
        CHECK(frames <= 5);
    }
}

TEST_CASE("beads of a wire and of a ring flash where they touch") {
    // Rods touch at 18; points are drawn larger, and touch in the middle of what is drawn.
    const std::string moving = ", position: 14, velocity: 2}, ", resting = ", position: 20}";
    for (const std::string radius : {"1", "2"}) {
        const std::string r = "{radius: " + radius;
        Pair pair("length: 40", r + moving + r + resting, "until: 2.5", "seconds: 7.5, fps: 20");
        const Grid grid(pair.with.scene.film.layout, {1280, 720});
        const Rect area = grid.place(pair.with.scene.film.layout.gas);
        const double scale = (area.width - 4.0 * grid.unit()) / 40.0;
        const double contact = 20.0 - std::stod(radius);
        int frames = 0;
        for (std::size_t i = 0; i < pair.with.frames.size(); ++i) {
            const Pair::Spot spot = pair.spot(i);
            if (spot.width == 0.0) continue;
            ++frames;
            CHECK(std::abs(spot.middle.x - (area.x + 3.4 * grid.unit() + contact * scale)) <= 1.0);
            CHECK(std::abs(spot.middle.y - (area.y + 3.4 * grid.unit())) <= 1.0);
        }
        CHECK(frames >= 4);
    }
    Pair ring("length: 40, walls: periodic",
              "{radius: 1, position: 36, velocity: 2}, {radius: 1, position: 5, velocity: -2}",
              "until: 2.5", "seconds: 7.5, fps: 20");
    std::size_t frames = 0;  // they touch at 0.5 beyond the cut
    const Grid grid(ring.with.scene.film.layout, {1280, 720});
    const Rect area = grid.place(ring.with.scene.film.layout.gas);
    const double scale = (area.width - 4.0 * grid.unit()) / 40.0;
    for (std::size_t i = 0; i < ring.with.frames.size(); ++i) {
        const Pixels pixels = ring.at(i);
        const auto row = static_cast<std::size_t>(area.y + 3.4 * grid.unit()) * 1280;
        const auto x = static_cast<std::size_t>(area.x + 3.4 * grid.unit() + 0.5 * scale);
        frames += pixels.differ(row + x) ? 1 : 0;
    }
    CHECK(frames >= 4);
}

TEST_CASE("the way back flashes at the contacts of the way out") {
    std::vector<std::string> remarks;
    const Scene scene =
        scene_of("size: [40, 30]", "{count: 40, radius: 1, speed: 3}",
                 "until: 8, events: [{at: 4, reverse: velocities}]", "seconds: 20, flashes: true");
    const auto frames = all_flashes(scene, remarks);
    const std::vector<Tick> ticks = timeline(scene);
    std::vector<Point> out, back;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::vector<Point>& leg = ticks[i].time <= 4.0 ? out : back;
        for (const Flash& flash : frames[i]) {
            const auto is_it = [&](const Point& p) {
                return std::hypot(p.x - flash.place[0], p.y - flash.place[1]) < 1e-6;
            };
            if (std::ranges::none_of(leg, is_it)) leg.push_back({flash.place[0], flash.place[1]});
        }
    }
    std::ranges::reverse(back);
    REQUIRE(out.size() > 3);
    REQUIRE(back.size() == out.size());
    for (std::size_t k = 0; k < out.size(); ++k)
        CHECK(std::hypot(out[k].x - back[k].x, out[k].y - back[k].y) < 1e-6);
}

TEST_CASE("a film without flashes has none") {
    const Shot film(
        scene_of("size: [40, 30]", "{count: 30, radius: 1, speed: 3}", "until: 2", "seconds: 4"),
        1);
    CHECK_FALSE(film.panels->wants_collisions());
}
