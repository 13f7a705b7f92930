// Marks: outlines where the particles were.
#include "panels/gas/marks/ghosts.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "panels/frame.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::Shot;

namespace {

// One particle of radius 2 goes from 5 to 35, by 5 in a unit of time.
Scene one_particle(const std::string& events, bool wire) {
    const std::string box = wire ? "length: 40" : "size: [40, 30]";
    const std::string gas =
        wire ? "position: 5, velocity: 5" : "position: [5, 15], velocity: [5, 0]";
    return test::scene_from("title: T\nbox: {" + box + "}\ngas: [{radius: 2, " + gas +
                            "}]\nrun: {until: 6, events: [" + events +
                            "]}\nfilm: {seconds: 12, fps: 10, size: [1280, 720], theme: light, "
                            "template: lecture, panels: [temperature]}\n");
}

std::size_t frame_at(const Shot& film, double time) {
    std::size_t i = 0;
    while (film.frames[i].tick.time < time) ++i;
    return i;
}

/// How much darker than `without` the circle of radius 2 around x is, on the average.
struct Outline {
    double rim, inside;
};

Outline outline(const Shot& with, const Shot& without, std::size_t frame, double x, bool wire) {
    FramePainter painter(*with.panels), plain(*without.panels);
    const auto a = test::pixels_of(painter.paint(with.frames[frame]));
    const auto b = test::pixels_of(plain.paint(without.frames[frame]));
    const LayoutSpec& layout = with.scene.film.layout;
    const Grid grid(layout, {1280, 720});
    const Rect area = grid.place(layout.gas);
    const Rect box = with.panels->gas().frame_in(area, 1.0);
    const double scale = wire ? (area.width - 4.0 * grid.unit()) / 40.0 : box.width / 40.0;
    const Point center =
        wire ? Point{area.x + 3.4 * grid.unit() + x * scale, area.y + 3.4 * grid.unit()}
             : Point{box.x + x * scale, box.y + 0.5 * box.height};
    const auto darker = [&](double radius) {
        double sum = 0.0;
        for (int k = 0; k < 64; ++k) {
            const double angle = 0.1 * k;
            const auto column = static_cast<std::size_t>(center.x + radius * std::cos(angle));
            const auto row = static_cast<std::size_t>(center.y + radius * std::sin(angle));
            sum += std::abs(double((b[row * 1280 + column] >> 8) & 0xFF) -
                            double((a[row * 1280 + column] >> 8) & 0xFF));
        }
        return sum / 64.0;
    };
    return {std::max(darker(2.0 * scale - 0.5), darker(2.0 * scale - 1.5)), darker(1.0 * scale)};
}

}  // namespace

TEST_CASE("a mark leaves an outline where a particle was, until the next mark") {
    for (const bool wire : {false, true}) {
        CAPTURE(wire);
        const Shot plain(one_particle("", wire));
        const Shot marked(one_particle("{at: 1, mark: first}, {at: 3, mark: second}", wire));
        const auto at = [&](double time, double x) {
            return outline(marked, plain, frame_at(marked, time), x, wire);
        };
        const double x1 = 5.0 + 5.0 * marked.frames[frame_at(marked, 1.0)].tick.time;
        const double x2 = 5.0 + 5.0 * marked.frames[frame_at(marked, 3.0)].tick.time;
        CHECK(at(2.5, x1).rim > 20.0);
        CHECK(at(2.5, x1).inside < 3.0);
        CHECK(at(2.5, x2).rim < 3.0);
        CHECK(at(5.0, x2).rim > 20.0);
        CHECK(at(5.0, x1).rim < 3.0);
        // Under the particle: nothing of it is seen where both are.
        CHECK(at(1.0, x1).inside < 3.0);
        CHECK(at(0.5, x1).rim < 3.0);
    }
}

TEST_CASE("the words of a mark stay for four seconds and come again at the end") {
    const Shot film(one_particle("{at: 1, mark: here}", false));
    GhostKeeper keeper(film.scene);
    const Eigen::ArrayXXf places = Eigen::ArrayXXf::Zero(1, 2);
    const std::size_t first = frame_at(film, 1.0);
    for (std::size_t i = 0; i < film.frames.size(); ++i) {
        const Tick& tick = film.frames[i].tick;
        keeper.see(tick, places);
        const double alpha = keeper.words_alpha(tick);
        if (i < first) CHECK(alpha == 0.0);
        if (i >= first && i <= first + 35) CHECK(alpha == 1.0);
        if (i > first + 40 && tick.phase == Phase::moving) CHECK(alpha == 0.0);
    }
    CHECK(keeper.words_alpha(film.frames.back().tick) == 1.0);
    CHECK(keeper.present()->frame == static_cast<int>(first));
}

TEST_CASE("a mark at time 0 is there from the first frame on") {
    const Shot film(one_particle("{at: 0, mark: start}", false));
    GhostKeeper keeper(film.scene);
    keeper.see(film.frames.front().tick, Eigen::ArrayXXf::Constant(1, 2, 7.0F));
    REQUIRE(keeper.present());
    CHECK(keeper.present()->words == "start");
    CHECK((keeper.present()->place == 7.0F).all());
}
