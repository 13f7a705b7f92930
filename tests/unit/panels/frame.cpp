#include "panels/frame.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "support/equilibrium.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::pixels_of;
using test::Shot;

namespace {

Scene scene_of(const std::string& film,
               const std::string& gas = "{count: 40, radius: 0.5, speed: 1}") {
    return test::scene_from("title: T\nbox: {size: [40, 30]}\ngas: [" + gas +
                            "]\nrun: {until: 4}\nfilm: {" + film + "}\n");
}

}  // namespace

TEST_CASE("every kind of panel has a name of its own and what makes it") {
    std::set<std::string> names;
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        CHECK(names.insert(kind.name).second);
        CHECK((kind.make != nullptr));
    }
}

TEST_CASE("drawing a frame is a pure function of it: any order, any painter, any thread") {
    // A large chosen disk reaches over the periodic sides: its ring and name may leave nothing
    // behind.
    const Shot film(test::scene_from(
        "title: T\nbox: {size: [40, 30], walls: periodic}\n"
        "gas: [{name: a, count: 30, radius: 0.3, speed: 1}, {name: b, count: 1, "
        "radius: 6, position: [3, 4], velocity: [-8, -6]}]\n"
        "run: {until: 4, events: [{at: 1, mark: here}, {at: 0, caption: words}]}\n"
        "film: {seconds: 4, fps: 15, size: [320, 180], slow: [{factor: 0.5}], title_card: 1, "
        "end_card: The end}\n"));
    FramePainter painter(*film.panels);
    std::vector<std::vector<std::uint32_t>> forward;
    for (const FrameData& frame : film.frames) forward.push_back(pixels_of(painter.paint(frame)));
    CHECK(forward.front() != forward.back());

    std::vector<std::thread> threads;
    std::vector<int> differences(3, 0);
    for (std::size_t k = 0; k < differences.size(); ++k)
        threads.emplace_back([&, k] {
            FramePainter other(*film.panels);
            for (std::size_t i = film.frames.size(); i-- > 0;)
                differences[k] += pixels_of(other.paint(film.frames[i])) != forward[i];
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(differences == std::vector<int>{0, 0, 0});
}

TEST_CASE("a disk is drawn where it is, to an eighth of a pixel") {
    const Shot film(scene_of(
        "seconds: 1, size: [1280, 720], theme: dark, color_by: species, template: lecture, "
        "panels: [temperature]",
        "{count: 1, radius: 2, position: [13.37, 17.91], color: \"#ffffff\"}"));
    FramePainter painter(*film.panels);
    const Canvas& canvas = painter.paint(film.frames.front());
    // A box of 40 : 30 stands at the top left of lecture's place for the gas.
    const LayoutSpec& layout = film.scene.film.layout;
    const Rect gas = Grid(layout, film.scene.film.size).place(layout.gas);
    const double scale = std::min(gas.width / 40, gas.height / 30);
    const double x = gas.x + 13.37 * scale;
    const double y = gas.y + (30 - 17.91) * scale;
    const PixelView view = canvas.pixels();
    double weight = 0.0, sum_x = 0.0, sum_y = 0.0;
    const double ground = 255.0 * theme(ThemeKind::dark).ground.green;
    for (int row = int(y) - 50; row < int(y) + 50; ++row)
        for (int column = int(x) - 50; column < int(x) + 50; ++column) {
            const double green = (view.data[row * view.stride + column] >> 8) & 0xFF;
            const double share = (green - ground) / (255.0 - ground);
            weight += share;
            sum_x += share * (column + 0.5);
            sum_y += share * (row + 0.5);
        }
    CHECK(std::abs(sum_x / weight - x) < 0.125);
    CHECK(std::abs(sum_y / weight - y) < 0.125);
    const double area = 3.14159265358979 * 4.0 * scale * scale;
    CHECK(weight == doctest::Approx(area).epsilon(
                        0.01));  // 0.5 % of coverage, and the 8-bit steps of the rim
}

TEST_CASE("a caption changes its own line and nothing else, in every template") {
    for (const char* name : {"lecture", "wide-gas", "minimal", "data", "square", "portrait"}) {
        CAPTURE(name);
        const auto frame_of = [&](const std::string& words) {
            const Shot film(test::scene_from(
                "title: T\nbox: {size: [40, 30]}\ngas: [{count: 20, speed: 1}]\n"
                "run: {until: 4, events: [{at: 0, caption: \"" +
                words +
                "\"}]}\n"
                "film: {seconds: 4, fps: 5, panels: [], size: [480, 480], template: " +
                std::string(name) + "}\n"));
            FramePainter painter(*film.panels);
            painter.paint(film.frames[7]);
            return std::pair{pixels_of(painter.paint(film.frames[9])), film.scene.film.layout};
        };
        // Sixty of the widest letters do not fit and are cut.
        const auto [wide, layout] = frame_of(std::string(60, 'W'));
        const auto [none, same] = frame_of("");
        const Rect line = Grid(layout, {480, 480}).place(*layout.caption);
        bool inside = false, outside = false;
        for (std::size_t i = 0; i < wide.size(); ++i) {
            if (wide[i] == none[i]) continue;
            const double x = double(i % 480) + 0.5, y = double(i / 480) + 0.5;
            const bool within =
                x > line.x - 1.0 && x < line.right() + 1.0 && y > line.y && y < line.bottom();
            (within ? inside : outside) = true;
        }
        CHECK(inside);
        CHECK_FALSE(outside);
    }
}

TEST_CASE("fewer panels than places share the height of the whole column") {
    const Scene two = scene_of("seconds: 1, panels: [speed-histogram, energy-histogram]");
    const Simulation simulation(two.gas, two.run);
    Simulation copy(two.gas, two.run);
    const PanelSet panels(two, simulation.particles(), copy.sample());
    const std::size_t count = panels.panels().size();
    const Slot& first = panels.panels()[count - 2].slot;
    const Slot& second = panels.panels()[count - 1].slot;
    const std::vector<Slot>& places = two.film.layout.panels;
    CHECK(first.y == doctest::Approx(places.front().y));
    CHECK(first.height == doctest::Approx(second.height));
    CHECK(second.y + second.height == doctest::Approx(places.back().y + places.back().height));
    CHECK(second.y - (first.y + first.height) ==
          doctest::Approx(places[1].y - places[0].y - places[0].height));
}

TEST_CASE("every frame of every theme and colouring can be drawn, odd and tiny pictures too") {
    for (const std::string theme : {"light", "dark", "print"})
        for (const std::string color : {"speed", "speed-class", "energy", "species", "mass"})
            for (const std::string size : {"[65, 131]", "[333, 77]"}) {
                const Shot film(scene_of("seconds: 0.2, theme: " + theme + ", color_by: " + color +
                                         ", size: " + size));
                FramePainter painter(*film.panels);
                for (const FrameData& frame : film.frames) painter.paint(frame);
                CHECK(film.frames.size() == 6);
            }
}

TEST_CASE("a gas at rest, one particle, and infinite masses make a film without a curve") {
    for (const std::string gas : {"{count: 5}", "{count: 1, speed: 1}",
                                  "{name: a, count: 5, speed: 1}, {name: wall, count: 1, mass: "
                                  "infinite, radius: 3, velocity: [0.1, 0]}"}) {
        CAPTURE(gas);
        const Shot film(scene_of("seconds: 0.5, size: [320, 180]", gas));
        Simulation simulation(film.scene.gas, film.scene.run);
        CHECK_FALSE(
            test::equilibrium(film.scene.gas.box, simulation.particles(), simulation.sample()));
        FramePainter painter(*film.panels);
        for (const FrameData& frame : film.frames) painter.paint(frame);
    }
}

TEST_CASE("a picture drawn at once on another canvas is the film's") {
    const Shot film(scene_of("seconds: 2, fps: 5, size: [320, 180]"));
    FramePainter painter(*film.panels);
    Canvas canvas({320, 180});
    painter.paint(film.frames.front());
    painter.paint_on(canvas, film.frames.back());
    CHECK(pixels_of(canvas) == pixels_of(painter.paint(film.frames.back())));
}

TEST_CASE("the bars of a histogram are one shape: no seams at any size of a vector picture") {
    const auto text_of = [](Canvas& canvas) {
        const std::vector<std::uint8_t> bytes = canvas.file();
        return std::string(bytes.begin(), bytes.end());
    };
    Canvas sample({10, 10}, VectorFormat::svg, {});
    sample.fill({1, 1, 5, 5}, theme(ThemeKind::dark).bar);
    const std::string drawn = text_of(sample);
    const std::size_t from = drawn.find("rgb(");  // of a style up to Cairo 1.16, then of `fill`
    REQUIRE(from != std::string::npos);
    const std::string bar = drawn.substr(from, drawn.find(')', from) + 1 - from);

    // The disks are coloured by something else than what the bars count.
    const Shot film(scene_of(
        "seconds: 2, fps: 5, size: [640, 360], color_by: species, panels: [speed-histogram]",
        "{count: 200, radius: 0.3, temperature: 1}"));
    FramePainter painter(*film.panels);
    Canvas canvas({640, 360}, VectorFormat::svg, {});
    painter.paint_on(canvas, film.frames.back());
    const std::string svg = text_of(canvas);
    int shapes = 0;
    for (std::size_t at = svg.find("<path"); at != std::string::npos;
         at = svg.find("<path", at + 1))
        shapes += svg.substr(at, svg.find('>', at) - at).find(bar) != std::string::npos ? 1 : 0;
    CHECK(shapes == 1);
}

TEST_CASE("bars in the colours of disks stand apart, at the places of their bins") {
    const Shot film(
        scene_of("seconds: 2, fps: 5, size: [1920, 1080], theme: dark, template: "
                 "lecture, panels: [{kind: speed-histogram, theory: false, range: [0, "
                 "3], bins: 12, mean_now: false, mean_start: false}]",
                 "{count: 200, radius: 0.3, temperature: 1}"));
    FramePainter painter(*film.panels);
    const PixelView view = painter.paint(film.frames.back()).pixels();
    DiskPainter disks;
    const Grid grid(film.scene.film.layout, film.scene.film.size);
    const Slot& slot = film.panels->panels().back().slot;
    const Rect area = plot_area({grid.place(slot), grid.unit(), theme(ThemeKind::dark), disks});
    const std::uint32_t page = to_pixel(theme(ThemeKind::dark).page) & 0xFFFFFF;
    // A row over the axis and its ramp: runs of pixels that are not the page's, and gaps.
    const auto row = static_cast<std::ptrdiff_t>(area.bottom() - 1.2 * grid.unit());
    const auto is_bar = [&](int x) {
        return (view.data[row * view.stride + x] & 0xFFFFFF) != page;
    };
    int bars = 0, shortest = view.width, longest = 0;
    const int end = static_cast<int>(area.right());
    for (int x = static_cast<int>(area.x) + 4; x < end;) {
        const int from = x;
        while (x < end && is_bar(x) == is_bar(from)) ++x;
        if (is_bar(from)) {
            ++bars;
            CHECK(x - from == doctest::Approx(area.width / 12 - 3).epsilon(3.0 / 44));
        } else if (bars > 0 && x < end) {
            shortest = std::min(shortest, x - from);
            longest = std::max(longest, x - from);
        }
    }
    CHECK(bars >= 6);
    CHECK(shortest == 3);
    CHECK(longest == 3);
}

TEST_CASE("pictures too small for their words are drawn all the same") {
    // With sanitizers algorithms also check their arguments: room may be less than none.
    const std::string plane =
        "box: {size: [8, 6]}\ngas: [{name: disk, count: 1, radius: 2}, {name: b, count: 3, radius: "
        "0.5}]\n";
    const std::string wire =
        "box: {length: 8}\ngas: [{name: a bead, count: 1, radius: 1}, {name: b, count: 2, radius: "
        "0.5}]\n";
    for (const char* size : {"[64, 64]", "[64, 200]", "[200, 64]", "[160, 120]"})
        for (const std::string& box : {plane, wire})
            for (const char* shown :
                 {"labels: mass", "field: {of: flow, cells: 2}",
                  "field: {of: temperature, cells: 2}", "end_card: The end, title_card: 1"}) {
                CAPTURE(box);
                CAPTURE(shown);
                CAPTURE(size);
                const Shot film(test::scene_from("title: T\n" + box + "run: {until: 4}\nfilm: " +
                                                 "{seconds: 2, fps: 5, size: " + size + ", " +
                                                 shown + "}\n"));
                FramePainter painter(*film.panels);
                for (const FrameData& frame : film.frames) {
                    const std::vector<std::uint32_t> pixels = pixels_of(painter.paint(frame));
                    CHECK(std::ranges::count(pixels, pixels.front()) < std::ssize(pixels));
                }
            }
}

TEST_CASE("vector pictures hold no pixels, whatever they show") {
    const auto svg_of = [](const Scene& scene) {
        const Shot film(scene);
        FramePainter painter(*film.panels);
        Canvas canvas({film.scene.film.size.width, film.scene.film.size.height}, VectorFormat::svg,
                      {"T", "D"});
        painter.paint_on(canvas, film.frames.back());
        const std::vector<std::uint8_t> bytes = canvas.file();
        return std::string(bytes.begin(), bytes.end());
    };
    const std::string gas =
        "{name: a, count: 40, radius: 0.5, speed: 1, fill: false}, "
        "{name: b, count: 1, radius: 3, position: [4, 20], velocity: [3, 2], trail: 1}";
    const std::string film =
        "seconds: 2, fps: 5, size: [640, 360], template: data, velocities: true, labels: index, ";
    std::vector<std::string> svgs;
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        try {
            svgs.push_back(svg_of(scene_of(film + "panels: [" + kind.name + "]", gas)));
        } catch (const SceneError&) {
            continue;  // a kind that wants to be told more
        }
    }
    CHECK(svgs.size() > 5);
    svgs.push_back(svg_of(test::scene_from(
        "title: T\nbox: {length: 40}\ngas: [{name: a, count: 9, radius: 1, speed: 1}]\n"
        "run: {until: 4}\nfilm: {seconds: 2, fps: 5, size: [640, 360], velocities: true}\n")));
    for (const std::string& svg : svgs) {
        CHECK(svg.find("<path") != std::string::npos);
        CHECK(svg.find("<image") == std::string::npos);
    }
}

TEST_CASE(
    "at a reversal everything but the words and the clock's arrow stands still for a second") {
    for (const char* box : {"size: [40, 30]", "length: 40"}) {
        CAPTURE(box);
        const bool is_wire = std::string(box).starts_with("length");
        const Shot film(test::scene_from(
            "title: T\nbox: {" + std::string(box) +
            "}\ngas: [{count: 12, speed: 1}]\n"
            "run: {until: 4, events: [{at: 2, reverse: velocities}]}\n"
            "film: {seconds: 20, fps: 10, size: [320, 180], monitors: [time], panels: []}\n"));
        std::vector<std::size_t> stopped;
        for (std::size_t i = 0; i < film.frames.size(); ++i)
            if (film.frames[i].tick.phase == Phase::reversing) stopped.push_back(i);
        REQUIRE(stopped.size() == 10);
        FramePainter painter(*film.panels);
        const auto before = pixels_of(painter.paint(film.frames[stopped.front() - 1]));
        const LayoutSpec& layout = film.scene.film.layout;
        const Grid grid(layout, {320, 180});
        const Rect gas = grid.place(layout.gas), clock = grid.place(*layout.clock);
        for (const std::size_t i : {stopped[3], stopped[5]}) {
            const auto now = pixels_of(painter.paint(film.frames[i]));
            bool words = false, arrow = false, others = false;
            for (std::size_t k = 0; k < now.size(); ++k) {
                if (now[k] == before[k]) continue;
                const Point at{double(k % 320), double(k / 320)};
                if (at.x > clock.x && at.y > clock.y && at.y < clock.bottom())
                    arrow = true;
                else if (std::abs(at.y - gas.y - 0.5 * gas.height) < 13.0)
                    words = true;
                else if (is_wire && std::abs(at.y - gas.y - 40.0) < 12.0)
                    words = true;  // above the world lines, with their mark of the reversal
                else
                    others = true;
            }
            CHECK(words);
            CHECK(arrow);
            CHECK_FALSE(others);
        }
    }
}
