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

TEST_CASE("the box stands in the middle where nothing is beside it, else at the top left") {
    const Picture alone(scene_of("{count: 1}", "fps: 30", "size: [10, 40]"));
    const Rect area =
        Grid(alone.scene.film.layout, alone.scene.film.size).place(alone.scene.film.layout.gas);
    const Rect box = alone.panels.gas().frame_in(area, 1.0);
    CHECK(box.x - area.x == doctest::Approx(area.right() - box.right()));
    Scene beside = scene_of("{count: 1}", "fps: 30", "size: [10, 40]");
    beside.film.layout.panels.push_back({78, 10, 1, 1});
    CHECK(Picture(std::move(beside)).panels.gas().frame_in(area, 1.0).x == doctest::Approx(area.x));
    // Where it leaves height, it stands at the top beside panels, else in the middle.
    const auto flat = [&](bool has_panels) {
        Scene scene = scene_of("{count: 1}", "fps: 30", "size: [40, 10]");
        if (has_panels) scene.film.layout.panels.push_back({78, 10, 1, 1});
        return Picture(std::move(scene)).panels.gas().frame_in(area, 1.0);
    };
    const Rect middle = flat(false);
    CHECK(middle.y - area.y == doctest::Approx(area.bottom() - middle.bottom()));
    CHECK(middle.y > area.y + 1.0);
    CHECK(flat(true).y == doctest::Approx(area.y));
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

// Wherever the mean is in the range, and whether the bars have the disks' colours, with a ramp
// under the axis, or not.
TEST_CASE("the mark of a mean is a tick under the axis, which crosses neither bars nor words") {
    const std::uint32_t ink = to_pixel(theme(ThemeKind::dark).ink) & 0xFFFFFF;
    for (int step = 0; step < 120; ++step) {
        const bool narrow = step % 2 == 1, has_ramp = step % 4 < 2;
        const double top = 1.05 * std::pow(1.02, step);
        CAPTURE(top);
        CAPTURE(narrow);
        CAPTURE(has_ramp);
        // One bar of 400, far beyond the axis; the mean is in it.
        Scene scene = scene_of(
            "{count: 400, radius: 0.1, speed: 1}",
            std::string("template: ") + (narrow ? "square" : "lecture") +
                ", color_by: " + (has_ramp ? "speed" : "species") +
                ", panels: [{kind: speed-histogram, theory: false, mean_start: false, range: [0, " +
                std::to_string(top) + "], bins: 1000}]");
        scene.film.size = {narrow ? 900 : 1600, 900};
        const TextLog log;
        const Picture picture(std::move(scene));
        const Grid grid(picture.scene.film.layout, picture.scene.film.size);
        const Rect area = area_of_last_plot(picture.panels, grid);
        const double x = area.x + area.width / top;
        const auto is_mark = [&](int y) {
            const int column = static_cast<int>(x);
            for (int near = column - 2; near <= column + 2; ++near)
                if ((picture.view.data[y * picture.view.stride + near] & 0xFFFFFF) == ink)
                    return true;
            return false;
        };
        // From the middle of the plot down, over the bar, to the tick and to its end.
        const double over_ramp = has_ramp ? 0.52 * grid.unit() : 0.0;
        const double axis = area.bottom() - over_ramp;
        int first = static_cast<int>(area.y + 0.5 * area.height);
        while (first < picture.view.height && !is_mark(first)) ++first;
        int end = first;
        while (end < picture.view.height && is_mark(end)) ++end;
        REQUIRE(first >= axis - 1.0);
        CHECK(first <= axis + 3.0);  // the axis itself may lie over it
        CHECK(end >= axis + 0.4 * grid.unit());
        const double half = 0.06 * grid.unit();
        const auto touches = [&](const DrawnLine& line) {
            return line.ink.x < x + half && line.ink.right() > x - half && line.ink.y < end &&
                   line.ink.bottom() > first;
        };
        CHECK(std::ranges::none_of(log.lines, touches));
    }
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
        scene.film.layout.clock.reset();
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

TEST_CASE("the line of captions ends with two numbers at most, and says which it leaves out") {
    Scene scene = scene_of("{count: 3, speed: 1}", "fps: 30");
    scene.film.size = {1920, 1080};
    scene.film.layout.clock.reset();
    scene.film.layout.monitors = Slot{2, 32, 60, 2.4};  // room for three
    scene.film.monitors = {Monitor::time, Monitor::collisions, Monitor::medium};
    const TextLog log;
    const Picture picture(std::move(scene));
    const auto is_drawn = [&](const std::string& words) {
        return std::ranges::find(log.lines, words, &DrawnLine::markup) != log.lines.end();
    };
    CHECK(is_drawn("time"));
    CHECK(is_drawn("collisions"));
    CHECK(!is_drawn("medium"));
    const std::vector<std::string> cut = picture.painter->cut_words();
    CHECK(std::ranges::count(cut, "the monitor `medium`") == 1);
    CHECK(std::ranges::count(cut, "the monitor `collisions`") == 0);
}

TEST_CASE("a time with a power of ten has room, and its arrow too") {
    int compared = 0;
    for (double width = 6.0; width <= 24.0; width += 1.0) {
        CAPTURE(width);
        Scene scene = scene_of("{count: 3, speed: 1}", "fps: 30");
        scene.run.until = 2e-9;
        scene.run.events = {{1e-9, ReverseVelocities{}}};
        scene.film.layout.clock.reset();
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
        const std::uint32_t arrow = to_pixel(theme(ThemeKind::dark).highlight) & 0xFFFFFF;
        const auto [left, right] = picture.columns_of(arrow);
        REQUIRE(left <= right);
        if (picture.last_row_of(arrow) > time->ink.bottom())
            CHECK(left - time->ink.x > widest);
        else
            CHECK(left > time->ink.right());  // no room beside the number
        if (other == log.lines.end() || other->ink.y > time->ink.bottom()) continue;  // no room
        CHECK(other->ink.x > right);
        ++compared;
    }
    CHECK(compared > 3);
}

TEST_CASE("numbers in one line end at its right, as many as have room in about half of it") {
    const std::vector<std::string> labels{"collisions", "mean speed", "mean energy"};
    std::size_t before = 0;
    for (double width = 6.0; width <= 62.0; width += 2.0) {
        CAPTURE(width);
        Scene scene = scene_of("{count: 3, speed: 1}", "fps: 30");
        scene.film.layout.monitors = Slot{1, 60, width, 2.4};
        scene.film.layout.grid_height = 72;
        scene.film.monitors = {Monitor::time, Monitor::collisions, Monitor::mean_speed,
                               Monitor::mean_energy};
        const Rect place =
            Grid(scene.film.layout, scene.film.size).place(*scene.film.layout.monitors);
        const TextLog log;
        const Picture picture(std::move(scene));
        std::size_t shown = 0;
        double left = place.right(), right = place.x;
        for (const DrawnLine& line : log.lines) {
            if (line.ink.y < place.y) continue;
            shown += std::ranges::find(labels, line.markup) != labels.end();
            left = std::min(left, line.ink.x);
            right = std::max(right, line.ink.right());
        }
        CHECK(shown >= std::max<std::size_t>(1, before));  // one is always there
        before = shown;
        CHECK(right <= place.right() + 1.0);
        CHECK(right > place.right() - 0.3 * Grid(picture.scene.film.layout, {640, 720}).unit());
        if (shown > 1) CHECK(left >= place.right() - 0.55 * place.width - 1.0);
    }
    CHECK(before == 2);  // half of the picture has no room for three
}

TEST_CASE("before the clock's time are its arrow and slow motion, apart from it and the key") {
    for (const double until : {4.0, 2e-9, 2e7}) {
        CAPTURE(until);
        Scene scene = scene_of("{count: 3, speed: 1}",
                               "fps: 30, slow: [{factor: 0.125}], template: wide-gas");
        scene.run.until = until;
        scene.run.events = {{0.5 * until, ReverseVelocities{}}};
        scene.film.size = {1280, 720};
        const test::Shot film(scene);
        const auto frame = std::ranges::find_if(
            film.frames, [](const FrameData& one) { return one.tick.slow.share == 1.0; });
        REQUIRE(frame != film.frames.end());
        FramePainter painter(*film.panels);
        const TextLog log;
        const PixelView view = painter.paint(*frame).pixels();
        const auto line = [&](const std::string& words) {
            return std::ranges::find_if(
                log.lines, [&](const DrawnLine& one) { return one.markup.starts_with(words); });
        };
        const auto time = line("t = "), slow = line("×0.125");
        REQUIRE(time != log.lines.end());
        REQUIRE(slow != log.lines.end());
        // The arrow has the colour of the words of slow motion, which end before it.
        const std::uint32_t color = to_pixel(theme(ThemeKind::dark).highlight) & 0xFFFFFF;
        int left = view.width, right = -1;
        for (int y = int(time->ink.y); y < int(time->ink.bottom()); ++y)
            for (int x = int(slow->ink.right()) + 1; x < view.width; ++x)
                if ((view.data[y * view.stride + x] & 0xFFFFFF) == color)
                    left = std::min(left, x), right = std::max(right, x);
        REQUIRE(left <= right);
        const double unit = Grid(scene.film.layout, scene.film.size).unit();
        CHECK(left > slow->ink.right() + 0.3 * unit);
        CHECK(right < time->ink.x - 0.3 * unit);
        CHECK(time->ink.right() <= (scene.film.layout.clock->x + scene.film.layout.clock->width) *
                                       1280 / scene.film.layout.grid_width);
        for (const DrawnLine& other : log.lines)
            if (&other != &*slow && &other != &*time && other.ink.width > 0 &&
                other.ink.y < time->ink.bottom() && other.ink.bottom() > time->ink.y) {
                CAPTURE(other.markup);
                CHECK(other.ink.right() < slow->ink.x - 0.3 * unit);
            }
    }
}

TEST_CASE("rows of numbers leave none alone: the last are the longer ones") {
    for (std::size_t count = 2; count <= 7; ++count) {
        const std::vector<Monitor> all{
            Monitor::time, Monitor::collisions, Monitor::mean_speed, Monitor::mean_energy,
            Monitor::slow, Monitor::medium,     Monitor::fast};
        Scene scene = scene_of("{count: 3, speed: 1}", "fps: 30");
        scene.film.layout.clock.reset();
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
        for (int y = static_cast<int>(box.y); y < box.bottom(); ++y) {  // not the key
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
