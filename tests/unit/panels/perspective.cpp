// The perspective of a box in space, read back from its picture.
#include "panels/surfaces/perspective.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "draw/palette.h"
#include "draw/style.h"
#include "panels/frame.h"
#include "panels/gas/gas_colors.h"
#include "panels/gas/particle_panel.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::Shot;

namespace {

// The same by matrices: the box is turned about y and then tilted about x; the eye is on the z
// axis.
struct Matrices {
    Viewpoint from;
    Vec size;

    double distance() const { return from.lens * length(size); }
    Eigen::Vector3d turned(const Vec& place) const {
        constexpr double degree = std::numbers::pi / 180.0;
        const Eigen::Vector3d off(place[0] - size[0] / 2, place[1] - size[1] / 2,
                                  place[2] - size[2] / 2);
        return Eigen::AngleAxisd(from.tilt * degree, Eigen::Vector3d::UnitX()) *
               (Eigen::AngleAxisd(from.turn * degree, Eigen::Vector3d::UnitY()) * off);
    }
    // With y down, for a scale of 1 at the middle; and the scale there.
    std::pair<Point, double> image(const Vec& place) const {
        const Eigen::Vector3d at = turned(place);
        const double scale = distance() / (distance() - at.z());
        return {{scale * at.x(), -scale * at.y()}, scale};
    }
    // The place at which the eye is, in the box.
    Vec eye() const {
        constexpr double degree = std::numbers::pi / 180.0;
        const Eigen::Vector3d at =
            Eigen::AngleAxisd(-from.turn * degree, Eigen::Vector3d::UnitY()) *
            (Eigen::AngleAxisd(-from.tilt * degree, Eigen::Vector3d::UnitX()) *
             Eigen::Vector3d(0.0, 0.0, distance()));
        return {at.x() + size[0] / 2, at.y() + size[1] / 2, at.z() + size[2] / 2};
    }
};

const Vec cube{20.0, 20.0, 20.0};
constexpr const char *red = "'#E04040'", *green = "'#40B050'";  // nothing else has these hues

// A cube with spheres that rest, all of them of a species and a colour of their own.
Scene resting(const std::vector<Vec>& places, const std::string& more = "",
              const std::string& film = "") {
    std::string gas;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec& at = places[i];
        gas += (i > 0 ? ", " : "") + std::string("{color: ") + (i == 0 ? red : green) +
               ", name: s" + std::to_string(i) + ", count: 1, radius: 2, trail: 0, position: [" +
               std::to_string(at[0]) + ", " + std::to_string(at[1]) + ", " + std::to_string(at[2]) +
               "]}";
    }
    return test::scene_from("title: T\nbox: {size: [20, 20, 20]}\n" + more + "gas: [" + gas +
                            "]\nrun: {until: 1}\nfilm: {seconds: 1, fps: 2, size: [1280, 1280], "
                            "panels: [], color_by: species" +
                            film + "}\n");
}

// The picture of the first frame.
struct Seen {
    explicit Seen(const Scene& scene, const Viewpoint& from = {})
        : shot(scene), painter(*shot.panels), exact{from, cube} {
        const Grid grid(shot.scene.film);
        frame = shot.panels->gas().frame_in(grid.place(shot.scene.film.layout.gas), grid.unit());
        const double rim = 0.3 * grid.unit();
        double left = 1e9, right = -1e9, top = 1e9;
        for (const double x : {0.0, cube[0]})
            for (const double y : {0.0, cube[1]})
                for (const double z : {0.0, cube[2]}) {
                    const Point at = exact.image({x, y, z}).first;
                    left = std::min(left, at.x), right = std::max(right, at.x);
                    top = std::min(top, at.y);
                }
        scale = (frame.width - 2.0 * rim) / (right - left);
        origin = {frame.x + rim - scale * left, frame.y + rim - scale * top};
        pixels = painter.paint(shot.frames.at(0)).pixels();
    }

    Point place(const Vec& at) const {
        const Point seen = exact.image(at).first;
        return {origin.x + scale * seen.x, origin.y + scale * seen.y};
    }
    Color color(int x, int y) const { return rgb(pixels.data[y * pixels.stride + x] & 0xFFFFFF); }
    Color color(const Vec& at) const {
        const Point pixel = place(at);
        return color(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
    }

    // Whether a colour is a shade or a tint of that of a species: light and depth change neither
    // the hue nor its opposite.
    bool is_of(Color its, std::size_t species) const {
        const Color of = *parse_color(std::string(species == 0 ? red : green).substr(1, 7));
        const auto hue = [](Color one) {
            const double mean = (one.red + one.green + one.blue) / 3.0;
            return Eigen::Vector3d(one.red - mean, one.green - mean, one.blue - mean);
        };
        const Eigen::Vector3d a = hue(its), b = hue(of);
        return a.norm() > 0.2 * b.norm() && a.dot(b) > 0.95 * a.norm() * b.norm();
    }
    bool shows(const Vec& at, std::size_t species) const { return is_of(color(at), species); }

    Shot shot;
    FramePainter painter;
    Matrices exact;
    Rect frame;
    double scale = 0.0;
    Point origin;
    PixelView pixels;
};

// What lies behind a place of the box, or before it, as seen from the eye.
Vec beyond(const Vec& place, double by) {
    const Vec eye = Matrices{{}, cube}.eye();
    return place + by / length(place - eye) * (place - eye);
}

const Vec middle = 0.5 * cube;

}  // namespace

TEST_CASE("a place in the box appears where matrices put it, from any viewpoint") {
    const Region box{{0, 0, 0}, {30, 22, 18}};
    for (const Viewpoint& from :
         {Viewpoint{}, Viewpoint{0, 0, 1}, Viewpoint{130, -40, 1.3}, Viewpoint{-90, 90, 20}}) {
        const Matrices exact{from, box.high};
        const Perspective seen(from, box, {100, 50}, 7.0);
        CHECK(length(seen.eye() - exact.eye()) < 1e-12 * exact.distance());
        for (const Vec& at : {Vec{0, 0, 0}, Vec{30, 22, 18}, Vec{3, 17, 11}, Vec{15, 11, 9}}) {
            const auto [point, scale] = exact.image(at);
            const Perspective::Image image = seen.image(at);
            CHECK(std::abs(image.at.x - (100 + 7 * point.x)) < 1e-10);
            CHECK(std::abs(image.at.y - (50 + 7 * point.y)) < 1e-10);
            CHECK(std::abs(image.scale - 7 * scale) < 1e-10);
            // A velocity is the change of the place, here by central differences.
            const Vec v{1, -2, 3};
            const double h = 1e-4;
            const Point late = seen.at(at + h * v), early = seen.at(at - h * v);
            const Point moves = seen.velocity(at, v);
            CHECK(std::abs((late.x - early.x) / (2 * h) - image.scale * moves.x) < 1e-4);
            CHECK(std::abs((late.y - early.y) / (2 * h) - image.scale * moves.y) < 1e-4);
            // A part of the picture is the same picture, larger.
            const Point part = seen.magnified({5, 6, 7}, 3.0).at(at), target = seen.at({5, 6, 7});
            CHECK(std::abs(part.x - (100 + 3 * (image.at.x - target.x))) < 1e-9);
            CHECK(std::abs(part.y - (50 + 3 * (image.at.y - target.y))) < 1e-9);
        }
    }
}

TEST_CASE("spheres stand in the picture where the projection puts them, and as large") {
    for (const Viewpoint& from : {Viewpoint{}, Viewpoint{35, 20, 1.2}}) {
        const std::string keys = ", viewpoint: {turn: " + std::to_string(from.turn) +
                                 ", tilt: " + std::to_string(from.tilt) +
                                 ", lens: " + std::to_string(from.lens) + "}";
        for (const Vec& at : {Vec{4, 5, 16}, Vec{17, 16, 3}, middle}) {
            const Seen seen(resting({at}, "", keys), from);
            double area = 0.0, x = 0.0, y = 0.0;
            for (int row = 0; row < 1280; ++row)
                for (int column = 0; column < 1280; ++column)
                    if (row > seen.frame.y && row < seen.frame.bottom() &&  // above is the key
                        seen.is_of(seen.color(column, row), 0))
                        area += 1.0, x += column + 0.5, y += row + 0.5;
            const Point expected = seen.place(at);
            const double radius = 2.0 * seen.scale * seen.exact.image(at).second;
            // Edges may lie over it, a few pixels wide, and its rim is mixed with what is behind.
            CHECK(std::abs(x / area - expected.x) < 1.0);
            CHECK(std::abs(y / area - expected.y) < 1.0);
            CHECK(std::abs(std::sqrt(area / std::numbers::pi) - radius) < 1.5);
        }
    }
}

TEST_CASE("the sphere in front hides the one behind it, whatever their numbers are") {
    const Vec near = beyond(middle, -4.0), far = beyond(middle, 4.0), aside{0.0, 2.0, 0.0};
    const Seen first(resting({near, far + aside})), second(resting({far + aside, near}));
    CHECK(first.shows(middle, 0));
    CHECK(second.shows(middle, 1));
    CHECK(first.shows(far + 1.7 * aside, 1));
    CHECK(second.shows(far + 1.7 * aside, 0));
}

TEST_CASE(
    "of two spheres that touch, that on the eye's side of the plane between them is in front") {
    const Region box{{}, cube};
    for (const Viewpoint& from : {Viewpoint{}, Viewpoint{60, -30, 1.0}}) {
        const Perspective seen(from, box, {}, 1.0);
        const Vec eye = Matrices{from, cube}.eye();
        for (const Vec& along : {Vec{0.6, 0.8, 0}, Vec{-0.6, 0, 0.8}, Vec{0, -0.8, 0.6}}) {
            const Vec touch = middle + 4.0 * along, other = touch + 0.5 * along;
            CHECK((seen.power(other, 0.5) < seen.power(middle, 4.0)) ==
                  (dot(eye - touch, along) > 0.0));
        }
    }
}

TEST_CASE("edges behind the gas are hidden by it, those before it are drawn over it") {
    const Vec front{20, 10, 20}, back{0, 10, 0};
    CHECK_FALSE(Seen(resting({beyond(front, 8.0)})).shows(front, 0));
    CHECK(Seen(resting({beyond(back, -8.0)})).shows(back, 0));
    const Seen empty(resting({middle}));
    const Theme& theme = theme_of(empty.shot.scene.film);
    CHECK(contrast(empty.color(front), theme.page) > 1.5 * contrast(empty.color(back), theme.page));
}

TEST_CASE("a partition dims what is behind it and nothing before it") {
    // The eye is at large x.
    const std::string sheet = "partitions: [{name: a, x: 10, gaps: [[0, 14, 6, 20]]}]\n";
    const Vec before{14, 10, 10}, behind{6, 10, 10}, in_gap{6, 3, 17};
    for (const auto& [at, is_dimmed] :
         {std::pair{before, false}, std::pair{behind, true}, std::pair{in_gap, false}}) {
        // Names at the axes make the box smaller; a partition far off makes it as small.
        const std::string other = "partitions: [{name: a, x: 0.5, gaps: [[0, 0, 20, 20]]}]\n";
        const Scene with = resting({at}, sheet), without = resting({at}, other);
        const Color a = Seen(with).color(at), b = Seen(without).color(at);
        CHECK((to_pixel(a) != to_pixel(b)) == is_dimmed);
    }
}

TEST_CASE("spheres and obstacles hide each other in the order of their depths") {
    const std::string ball = "obstacles: [{name: a, sphere: [10, 10, 10], radius: 3}]\n",
                      block = "obstacles: [{name: a, cuboid: [8, 8, 8, 12, 12, 12]}]\n";
    for (const std::string& obstacle : {ball, block}) {
        CAPTURE(obstacle);
        CHECK(Seen(resting({beyond(middle, -6.0)}, obstacle)).shows(middle, 0));
        CHECK_FALSE(Seen(resting({beyond(middle, 7.0)}, obstacle)).shows(middle, 0));
    }
    for (const Vec& beside : {Vec{14.5, 10, 10}, Vec{10, 14.5, 10}, Vec{10, 10, 14.5}})
        CHECK(Seen(resting({beside}, block)).shows(beside, 0));
}

TEST_CASE("spheres at the back keep a part that stands out") {
    for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light})
        for (const std::string& name : palette_names()) {
            Film film;
            film.palette = name;
            const Theme& its = theme(kind);
            for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                const Color faded = mix(scale_colors(film, its).at(share), its.page, 0.5);
                Canvas canvas({64, 64});
                canvas.fill_all(its.page);
                const Disk disk{32.0F, 32.0F, 24.0F, to_pixel(faded) & 0xFFFFFF};
                DiskPainter().draw_lit(canvas, {&disk, 1}, {0, 0, 64, 64});
                double most = 0.0;
                for (const std::uint32_t pixel : test::pixels_of(canvas))
                    most = std::max(most, contrast(rgb(pixel & 0xFFFFFF), its.page));
                CAPTURE(name);
                CAPTURE(share);
                CHECK(most >= least_contrast_of_marks);
            }
        }
}

TEST_CASE("a spinning box keeps its size and stays in its frame") {
    const Region box{{0, 0, 0}, {30, 22, 18}};
    std::vector<Viewpoint> all;
    for (double turn = -28.0; turn <= 62.0; turn += 5.0) all.push_back({turn, 14.0, 1.9});
    const Rect around = rect_around(box, all);
    for (double turn = -28.0; turn <= 62.0; turn += 0.5)
        for (const double x : {0.0, 30.0})
            for (const double y : {0.0, 22.0})
                for (const double z : {0.0, 18.0}) {
                    const Point at = Perspective({turn, 14.0, 1.9}, box, {}, 1.0).at({x, y, z});
                    // Between two viewpoints the box grows by less than a per cent.
                    CHECK(at.x > around.x - 0.2);
                    CHECK(at.x < around.right() + 0.2);
                    CHECK(at.y > around.y - 0.2);
                    CHECK(at.y < around.bottom() + 0.2);
                }
}

TEST_CASE("the film turns by its spin, slowly at first and at last") {
    const Shot shot(test::scene_from(
        "title: T\nbox: {size: [20, 20, 20]}\ngas: [{name: a, count: 20, radius: 1, speed: 3}]\n"
        "run: {until: 4}\nfilm: {seconds: 6, fps: 5, size: [320, 320], panels: [], viewpoint: "
        "{turn: 10, spin: 60}, camera: [{at: 2, view: box, viewpoint: {tilt: 40}, over: 1}]}\n"));
    std::vector<Viewpoint> seen;
    for (const FrameData& frame : shot.frames)
        seen.push_back(dynamic_cast<const ParticleState&>(*frame.states.at(0)).viewpoint);
    CHECK(seen.front().turn == doctest::Approx(10.0));
    CHECK(seen.back().turn == doctest::Approx(70.0).epsilon(0.01));
    CHECK(seen.front().tilt == 14.0);
    CHECK(seen.back().tilt == 40.0);
    const std::size_t half = seen.size() / 2;
    const double start = seen[1].turn - seen[0].turn, fast = seen[half].turn - seen[half - 1].turn;
    CHECK(start > 0.0);
    CHECK(fast > 4.0 * start);
    // A picture does not depend on those that its painter has drawn before.
    FramePainter one(*shot.panels), other(*shot.panels);
    for (const FrameData& frame : shot.frames) one.paint(frame);
    const auto last = test::pixels_of(one.paint(shot.frames.back()));
    CHECK(last == test::pixels_of(other.paint(shot.frames.back())));
}
