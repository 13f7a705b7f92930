// How disks and beads look: rings, words that fit on them, and the numbers of monitors.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "draw/palette.h"
#include "panels/bead_words.h"
#include "panels/frame.h"
#include "scene/load.h"
#include "support/first_frame.h"
#include "support/pixels.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& gas, const std::string& film,
               const std::string& box = "size: [40, 40]") {
    return load_scene_text(
        "title: T\nbox: {" + box + "}\ngas: [" + gas +
            "]\nrun: {until: 4}\nfilm: {seconds: 1, theme: dark, size: "
            "[640, 720], " +
            (film.find("template") == std::string::npos ? "template: wide-gas, " : "") + film +
            "}\n",
        "test", std::filesystem::path(CAROM_TEST_ROOT) / "templates");
}

// The first frame of a scene.
struct Picture : test::FirstFrame {
    using FirstFrame::FirstFrame;

    // How many pixels of the whole frame are exactly of this colour.
    int count(std::uint32_t color) const {
        int count = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                count += (view.data[y * view.stride + x] & 0xFFFFFF) == color;
        return count;
    }

    std::vector<std::uint32_t> pixels() const { return test::pixels_of(view); }

    double scale() const { return box().width / scene.gas.box.size[0]; }
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

TEST_CASE("a number on a bead may be shorter by a digit") {
    CHECK(shorter_number("8.18") == "8.2");
    CHECK(shorter_number("0.909") == "0.91");
    CHECK(shorter_number("0.91") == "0.9");
    CHECK(shorter_number("0.9") == "0.9");
    CHECK(shorter_number("12") == "12");
    CHECK(shorter_number("∞") == "∞");
    CHECK(shorter_number("1.23×10⁷") == "1.23×10⁷");
}

TEST_CASE("a title that would be cut gives way to a shorter one") {
    DiskPainter disks;
    const Theme& colors = theme(ThemeKind::dark);
    const std::vector<std::string> titles{"Position and velocity of particles 2, 3 and 5",
                                          "particles 2, 3 and 5", "particles"};
    const auto in = [&](double width) {
        return fitting_title({{0, 0, width, 200}, 16.0, colors, disks}, titles);
    };
    CHECK(in(500) == titles[0]);
    CHECK(in(200) == titles[1]);
    CHECK(in(100) == titles[2]);
    CHECK(in(10) == titles[2]);  // the last is cut
}

// Wherever the mean is in the range.
TEST_CASE("the means' names keep clear of their marks") {
    const std::uint32_t ink = to_pixel(theme(ThemeKind::dark).ink) & 0xFFFFFF;
    const std::uint32_t page = to_pixel(theme(ThemeKind::dark).page) & 0xFFFFFF;
    int seen = 0;
    for (int step = 0; step < 120; ++step) {
        const bool narrow = step % 2 == 1;  // with no room for names beside a mark in the middle
        const double top = 1.05 * std::pow(1.02, step);
        CAPTURE(top);
        CAPTURE(narrow);
        // One bar of 400, far beyond the axis; the mark of its mean stands beside it.
        Scene scene = scene_of("{count: 400, radius: 0.1, speed: 1}",
                               std::string("template: ") + (narrow ? "square" : "lecture") +
                                   ", panels: [{kind: speed-histogram, theory: false, range: [0, " +
                                   std::to_string(top) + "], bins: 1000}]");
        scene.film.size = {narrow ? 900 : 1600, 900};
        const Picture picture(std::move(scene));
        const Observers::Placed& placed = picture.observers.panels().back();
        DiskPainter disks;
        const Grid grid(picture.scene.film.layout, picture.scene.film.size);
        const Rect area =
            plot_area({grid.place(placed.slot), grid.unit(), theme(ThemeKind::dark), disks});
        const int x = static_cast<int>(std::lround(area.x + area.width / top));
        const auto at = [&](int column, int row) {
            return picture.view.data[row * picture.view.stride + column] & 0xFFFFFF;
        };
        // From the middle up along the mark, as far as it goes.
        int row = static_cast<int>(area.y + 0.5 * area.height);
        const int middle = row;
        const auto is_mark = [&](int y) {
            for (int near = x - 2; near <= x + 2; ++near)
                if (at(near, y) == ink) return true;
            return false;
        };
        while (row > 0 && is_mark(row)) --row;
        REQUIRE(row < middle);
        for (int y = row + 1; y < middle; ++y)
            for (const int column : {x - 8, x - 7, x - 6, x - 5, x + 5, x + 6, x + 7, x + 8}) {
                if (column >= static_cast<int>(area.right())) continue;
                REQUIRE(at(column, y) == page);
                ++seen;
            }
    }
    CHECK(seen > 1000);
}

TEST_CASE("as many numbers stand in a row as it has room for") {
    const auto drawn = [](double width, const std::vector<Monitor>& numbers) {
        Scene scene = scene_of("{count: 3, speed: 1}", "fps: 30");
        scene.film.layout.monitors = Slot{1, 1, width, 3.8};
        scene.film.monitors = numbers;
        return Picture(std::move(scene)).pixels();
    };
    const std::vector<Monitor> two{Monitor::time, Monitor::mean_speed};
    CHECK(drawn(7.4, {}) == drawn(7.4, {Monitor::time}));
    CHECK(drawn(7.4, two) == drawn(7.4, {Monitor::time}));
    CHECK(drawn(20, two) != drawn(20, {Monitor::time}));
    CHECK(drawn(1, two) == drawn(1, {Monitor::time}));  // one is always there
}
