// How disks and beads look: rings, words that fit on them, and the numbers of monitors.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "draw/palette.h"
#include "panels/frame.h"
#include "panels/gas/bead_words.h"
#include "panels/gas/gas_colors.h"
#include "support/first_frame.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"
#include "util/text.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& gas, const std::string& film,
               const std::string& box = "size: [40, 40]") {
    return test::scene_from(
        "title: T\nbox: {" + box + "}\ngas: [" + gas +
        "]\nrun: {until: 4}\nfilm: {seconds: 1, theme: dark, size: "
        "[640, 720], " +
        (film.find("template") == std::string::npos ? "template: wide-gas, " : "") + film + "}\n");
}

// Where the data of the last panel lie on a picture.
Rect area_of_last_plot(const PanelSet& panels, const Grid& grid) {
    DiskPainter disks;
    const Slot& slot = panels.panels().back().slot;
    return plot_area({grid.place(slot), grid.unit(), theme(ThemeKind::dark), disks});
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

    // The lowest row that has it.
    int last_row_of(std::uint32_t color) const {
        for (int y = view.height; y-- > 0;)
            for (int x = 0; x < view.width; ++x)
                if ((view.data[y * view.stride + x] & 0xFFFFFF) == color) return y;
        return -1;
    }

    // The first and the last column that has it.
    std::pair<int, int> columns_of(std::uint32_t color) const {
        std::pair<int, int> columns{view.width, -1};
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                if ((view.data[y * view.stride + x] & 0xFFFFFF) == color)
                    columns = {std::min(columns.first, x), std::max(columns.second, x)};
        return columns;
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
    const auto key_of = [](const std::string& fill) {
        return Picture(scene_of("{count: 1, radius: 0.001, position: [20, 20], color: \"#ff0000\"" +
                                    fill + "}",
                                "color_by: species"))
            .count(0xFF0000);
    };
    const int key = key_of(""), ring_key = key_of(", fill: false");
    CHECK(ring_key > 0);
    CHECK(ring_key < 0.6 * key);  // a ring there too
    // The rim is blended: of a line of w pixels about w - 1 are wholly covered.
    CHECK(full.count(0xFF0000) - key ==
          doctest::Approx(std::numbers::pi * radius * radius).epsilon(0.02));
    const double circumference = 2.0 * std::numbers::pi * radius;
    CHECK(ring.count(0xFF0000) - ring_key < circumference * line);
    CHECK(ring.count(0xFF0000) - ring_key > 0.15 * circumference * line);
}

TEST_CASE("small rings have thin lines, those of less than six pixels are dots") {
    for (const double unit : {12.0, 24.0, 48.0}) {
        CHECK(ring_line(1e3, unit) == 0.13 * unit);
        for (const double radius : {4.0, 5.0, 7.0, 12.0}) {
            CHECK(radius > 2.0 * ring_line(radius, unit));
            CHECK(ring_line(radius, unit) >= 1.5);
        }
        CHECK(3.0 <= 2.0 * ring_line(3.0, unit));
    }
}

TEST_CASE("words stand on disks that have room for them, and on no others") {
    const std::string big = "{count: 1, radius: 6, mass: 12.5, position: [20, 20]}";
    const std::string small = "{count: 1, radius: 0.2, mass: 12.5, position: [20, 20]}";
    const auto drawn = [&](const std::string& gas, const std::string& labels) {
        return Picture(scene_of(gas, "color_by: species" + labels)).pixels();
    };
    CHECK(drawn(big, ", labels: mass") != drawn(big, ""));
    CHECK(drawn(big, ", labels: index") != drawn(big, ", labels: mass"));
    // A small one has none; a remark says so.
    CHECK(drawn(small, ", labels: mass") == drawn(small, ", labels: index"));
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
    const Rect box = alone.panels.gas().frame_in(area, 1.0);
    CHECK(box.x - area.x == doctest::Approx(area.right() - box.right()));
    Scene beside = scene_of("{count: 1}", "fps: 30", "size: [10, 40]");
    beside.film.layout.panels.push_back({78, 10, 1, 1});
    CHECK(Picture(std::move(beside)).panels.gas().frame_in(area, 1.0).x == doctest::Approx(area.x));
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
        const Grid grid(picture.scene.film.layout, picture.scene.film.size);
        const Rect area = area_of_last_plot(picture.panels, grid);
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
        // Below the count of the broken bar.
        const int top_row = static_cast<int>(area.y + 1.6 * grid.unit());
        for (int y = std::max(row, top_row) + 1; y < middle; ++y)
            for (const int column : {x - 8, x - 7, x - 6, x - 5, x + 5, x + 6, x + 7, x + 8}) {
                if (column >= static_cast<int>(area.right())) continue;
                // A plate of the page over the page may be a step of the 8 bits off.
                for (const int shift : {0, 8, 16})
                    REQUIRE(std::abs(int(at(column, y) >> shift & 0xFF) -
                                     int(page >> shift & 0xFF)) <= 1);
                ++seen;
            }
    }
    CHECK(seen > 1000);
}

TEST_CASE("the mark of a mean does not cross out the count of a broken bar") {
    // One bar of 400, beyond the axis, which fits the gas in equilibrium. The mean is 0.73, where
    // its count would be if it stood beside the bar.
    Scene scene = scene_of(
        "{name: slow, count: 400, radius: 0.5, speed: 0.3}, "
        "{name: fast, count: 40, radius: 0.5, speed: 5}",
        "template: lecture, panels: [{kind: speed-histogram, range: [0, 6], bins: 12}]");
    scene.film.size = {1600, 900};
    const test::Shot film(scene, 1);
    FramePainter painter(*film.panels);
    const TextLog log;
    painter.paint(film.frames.front());
    const Rect area = area_of_last_plot(*film.panels, Grid(scene.film.layout, scene.film.size));
    const double mark = area.x + area.width * 0.727 / 6.0, half_of_mark = 2.0;
    const auto count = std::ranges::find_if(log.lines, [](const DrawnLine& line) {
        return line.markup.find("400") != std::string::npos;
    });
    REQUIRE(count != log.lines.end());
    CHECK((count->ink.right() < mark - half_of_mark || count->ink.x > mark + half_of_mark ||
           count->ink.bottom() <= area.y));
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

TEST_CASE("a time with a power of ten has room, and its arrow too") {
    int compared = 0;
    for (double width = 6.0; width <= 24.0; width += 1.0) {
        CAPTURE(width);
        Scene scene = scene_of("{count: 3, speed: 1}", "fps: 30");
        scene.run.until = 2e-9;
        scene.run.events = {{1e-9, ReverseVelocities{}}};
        scene.film.layout.monitors = Slot{1, 1, width, 3.8};
        scene.film.monitors = {Monitor::time, Monitor::collisions};
        TextLog log;
        const Picture picture(std::move(scene));
        const auto line = [&](const std::string& words) {
            return std::ranges::find(log.lines, words, &DrawnLine::markup);
        };
        const auto time = line("time"), number = line("0"), other = line("collisions");
        REQUIRE(number != log.lines.end());
        const double widest =
            measure_text(three_digits(2e-9), {.size = number->size, .color = {}}).width;
        const auto [left, right] = picture.columns_of(0xFF9F43);  // the arrow
        if (picture.last_row_of(0xFF9F43) > time->ink.bottom())
            CHECK(left - time->ink.x > widest);
        else
            CHECK(left > time->ink.right());  // no room beside the number
        if (other == log.lines.end() || other->ink.y > time->ink.bottom()) continue;  // no room
        CHECK(other->ink.x > right);
        ++compared;
    }
    CHECK(compared > 3);
}

TEST_CASE("rows of numbers leave none alone: the last are the longer ones") {
    for (std::size_t count = 2; count <= 7; ++count) {
        const std::vector<Monitor> all{
            Monitor::time, Monitor::collisions, Monitor::mean_speed, Monitor::mean_energy,
            Monitor::slow, Monitor::medium,     Monitor::fast};
        Scene scene = scene_of("{count: 3, speed: 1}", "fps: 30");
        scene.film.layout.monitors = Slot{1, 1, 24, 18};
        scene.film.monitors = {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
        const std::vector<std::string> labels{
            "time",   "collisions",        "mean speed", "mean energy", "slow, &lt; ½ mean",
            "medium", "fast, &gt; 1½ mean"};
        TextLog log;
        const Picture picture(std::move(scene));
        std::map<int, std::size_t> rows;  // labels by the height of their baseline
        std::size_t seen = 0;
        for (const DrawnLine& line : log.lines)
            if (std::ranges::find(labels, line.markup) != labels.end()) {
                ++rows[static_cast<int>(std::lround(line.ink.y / 20.0))];
                ++seen;
            }
        REQUIRE(seen == count);
        std::vector<std::size_t> lengths;
        for (const auto& [y, length] : rows) lengths.push_back(length);
        CAPTURE(count);
        CHECK(std::ranges::is_sorted(lengths));
        CHECK(lengths.back() - lengths.front() <= 1);
    }
}

TEST_CASE("on a wire all beads bear their mass, or none") {
    const auto masses = [](const std::string& size) {
        TextLog log;
        Scene scene = scene_of("{count: 2, mass: [8.182, 9], drawn_radius: 1, position: [10, 28]}",
                               "color_by: species", "length: " + size);
        const Picture picture(std::move(scene));
        return std::ranges::count_if(log.lines, [](const DrawnLine& line) {
            return line.markup.starts_with("8") || line.markup == "9";
        });
    };
    CHECK(masses("30") == 2);
    CHECK(masses("200") == 0);
    for (int length = 30; length < 200; length += 5) CHECK(masses(std::to_string(length)) != 1);
}

TEST_CASE(
    "beads of a wire are rods where they fill it or one is long; points are disks beside them") {
    // How many different widths the rows of a bead have: a rod's are all the same.
    const auto widths = [](const std::string& gas, double from, double to) {
        const Picture picture(scene_of(gas, "fps: 30, color_by: species", "length: 40"));
        const Rect box = picture.box();
        std::set<int> seen;
        for (int y = 0; y < picture.view.height; ++y) {
            int width = 0;
            for (int x = static_cast<int>(box.x + from * picture.scale());
                 x < box.x + to * picture.scale(); ++x)
                width += (picture.view.data[y * picture.view.stride + x] & 0xFFFFFF) == 0xFF0000;
            if (width > 0) seen.insert(width);
            if (width == 0 && !seen.empty()) break;
        }
        REQUIRE(!seen.empty());
        return seen.size();
    };
    const std::string red = ", color: '#ff0000'";
    const auto two = [&](const std::string& radius, const std::string& other) {
        return "{name: a, count: 1, position: 10, radius: " + radius + red +
               "}, {name: b, count: 1, position: 28, " + other + red + "}";
    };
    const std::string five = "{count: 5, position: [10, 16, 22, 28, 34]" + red;
    CHECK(widths(two("0.9", "radius: 0.9"), 5, 18) > 4);      // disks
    CHECK(widths(five + ", radius: 0.9}", 7, 13) == 1);       // a quarter of the wire
    CHECK(widths(five + ", drawn_radius: 0.9}", 7, 13) > 4);  // not their lengths
    CHECK(widths(two("0.9", "radius: 6"), 5, 18) == 1);       // beside a long one
    CHECK(widths(two("0.9", "radius: 6"), 20, 36) == 1);
    CHECK(widths(two("0, drawn_radius: 0.9", "radius: 6"), 5, 18) > 4);
    CHECK(widths(two("0, drawn_radius: 0.9", "radius: 0, drawn_radius: 6"), 5, 18) == 1);
}

TEST_CASE("disks too small and too many to be told apart cover their share, but one with a trail") {
    constexpr double count = 31000, radius = 0.07;
    Picture picture(
        scene_of("{name: dust, count: 31000, radius: 0.07, temperature: 1, color: '#00ff00'}",
                 "trails: {of: 0}"));
    const double scale = picture.scale();
    REQUIRE(radius * scale < 1.2);  // pixels
    const Rect box = picture.box();
    const auto level = [&](double x, double y, int shift) {
        const std::uint32_t pixel =
            picture.view.data[static_cast<int>(y) * picture.view.stride + static_cast<int>(x)];
        return static_cast<double>(pixel >> shift & 0xFF);
    };
    const double ground = 255.0 * theme_of(picture.scene.film.theme).ground.green;
    double sum = 0.0, pixels = 0.0;
    for (double y = box.y + 20.5; y < box.bottom() - 20; y += 1.0)
        for (double x = box.x + 20.5; x < box.right() - 20; x += 1.0) {
            sum += (level(x, y, 8) - ground) / (255.0 - ground);
            pixels += 1.0;
        }
    // The number in that part of the box scatters by half a per cent.
    const double share = count * std::numbers::pi * radius * radius / 1600.0;
    CHECK(sum / pixels == doctest::Approx(share).epsilon(0.02));

    const auto place = picture.simulation.sample().position.row(0);
    const double x = box.x + place[0] * scale, y = box.bottom() - place[1] * scale;
    CHECK(level(x, y, 8) > 220);
    CHECK(level(x, y, 16) < 90);
}
