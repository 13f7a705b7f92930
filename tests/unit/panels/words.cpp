// The words of frames: whole, apart from one another and inside of the picture, in every scene of
// the library with every template.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "panels/frame.h"
#include "scene/load.h"
#include "support/files.h"
#include "support/library.h"
#include "support/pixels.h"
#include "support/resources.h"
#include "support/scene_text.h"
#include "support/share_of_cases.h"
#include "support/shot.h"
#include "support/test_root.h"

using namespace carom;
using test::pixels_of;
namespace fs = std::filesystem;

namespace {

const fs::path root = carom::test::checkout();

double overlap(double a, double a_end, double b, double b_end) {
    return std::min(a_end, b_end) - std::max(a, b);
}

// A line that comes nearer to another than a word to the next one (0.28 em in Inter).
bool collide(const DrawnLine& a, const DrawnLine& b) {
    const double least_gap = 0.28 * std::min(a.size, b.size);
    return overlap(a.ink.x, a.ink.right(), b.ink.x, b.ink.right()) > -least_gap &&
           overlap(a.ink.y, a.ink.bottom(), b.ink.y, b.ink.bottom()) > 0.0;
}

void check_words(const std::vector<DrawnLine>& lines, PictureSize size, double smallest) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const DrawnLine& line = lines[i];
        CAPTURE(line.markup);
        CHECK_FALSE(line.is_cut);
        CHECK(line.size > 0.999 * smallest);
        if (line.ink.width == 0) continue;
        CHECK(line.ink.x >= 0);
        CHECK(line.ink.y >= 0);
        CHECK(line.ink.right() <= size.width);
        CHECK(line.ink.bottom() <= size.height);
        for (std::size_t k = 0; k < i; ++k) {
            CAPTURE(lines[k].markup);
            CHECK_FALSE(collide(line, lines[k]));
        }
    }
}

}  // namespace

TEST_CASE(
    "words are whole, apart and inside of the picture, in every scene with every template, and "
    "frames "
    "are the same whatever was drawn before") {
    int seen = 0;
    // In print there are swatches before words; the other two themes differ in colours alone. Every
    // scene is seen with a third of the templates, in both themes, and every template with a third
    // of the scenes; the slow tests see all three together.
    const auto share = static_cast<std::size_t>(test::every_nth(6, 48));
    const std::vector<fs::path> layouts = test::yaml_files(root / "templates/films");
    std::size_t scene_number = 0;
    for (const fs::path& file : test::library_files()) {
        bool is_first = true;
        ++scene_number;
        for (std::size_t one = 0; one < 2 * layouts.size(); ++one) {
            const bool is_print = one >= layouts.size();
            const std::size_t number = one % layouts.size();
            if ((scene_number + number) % share != (is_print ? share / 2 : 0)) continue;
            const fs::path& layout = layouts[number];
            const std::string theme = is_print ? "print" : "dark";
            CAPTURE(theme);
            CAPTURE(file.stem().string());
            CAPTURE(layout.stem().string());
            Overrides overrides = test::fewer_particles(file);
            overrides.insert(overrides.end(), {"film.template=" + layout.stem().string(),
                                               "film.theme=" + theme, "film.fps=1"});
            // Many bits take long, and change no words but their number; but a divider closes again
            // only behind a gas that has come home.
            const Scene scene = load_scene(file, test::resources());
            if (scene.run.bits != bits_of_double)
                overrides.emplace_back(scene.gas.box.surfaces.are_plain() ? "run.precision=128"
                                                                          : "run.precision=512");
            const test::Shot film(load_scene(file, test::resources(), overrides));
            const double unit = Grid(film.scene.film.layout, film.scene.film.size).unit();
            TextLog log;  // the ground, which the painter draws once, and what changes on it
            FramePainter painter(*film.panels);
            const std::vector<DrawnLine> ground = log.lines;
            std::size_t last = film.frames.size() - 1;
            if (const std::size_t end = last; is_card(film.frames[end].tick.phase)) {
                while (is_card(film.frames[last].tick.phase)) --last;
                log.lines.clear();  // it covers all words but those in the box
                painter.paint(film.frames[end]);
                log.lines.clear();
                painter.paint(film.frames[end]);
                check_words(log.lines, film.scene.film.size, unit);
                CHECK(!log.lines.empty());
            }
            for (const std::size_t frame : {std::size_t{0}, last / 3, last / 2, last}) {
                CAPTURE(frame);
                log.lines = ground;
                painter.paint(film.frames[frame]);
                check_words(log.lines, film.scene.film.size, unit);
                seen += static_cast<int>(log.lines.size());
            }
            // Whatever the painter has drawn before, the frame is the same.
            if (std::exchange(is_first, false)) {
                FramePainter fresh(*film.panels);
                CHECK(pixels_of(painter.paint(film.frames[last / 2])) ==
                      pixels_of(fresh.paint(film.frames[last / 2])));
            }
        }
    }
    CHECK(seen > 24000 / static_cast<int>(share));
}

TEST_CASE("disks that are drawn larger than they are say so, with their true radius") {
    const auto remark = [](const std::string& gas, const std::string& size = "[1920, 1080]") {
        const test::Shot film(
            load_scene_text("title: T\nbox: {size: [40, 30]}\ngas: " + gas +
                                "\nrun: {until: 1}\nfilm: {seconds: 0.1, size: " + size + "}\n",
                            "test", test::resources()));
        FramePainter painter(*film.panels);
        const TextLog log;
        painter.paint(film.frames.front());
        std::string found;
        for (const DrawnLine& line : log.lines)
            if (line.markup.starts_with("Disks enlarged") || line.markup.starts_with("Disks drawn"))
                found += line.markup;
        return found;
    };
    // A lecture film's box of 40 by 30 is about 770 pixels high: 1.2 pixels are a radius of 0.047.
    CHECK(remark("[{count: 20, radius: 0.06, speed: 1}]").empty());
    CHECK(remark("[{count: 20, radius: 0.02, speed: 1}]") ==
          "Disks enlarged for visibility; radius 0.0200");
    CHECK(remark("[{count: 20, radius: 0.02, drawn_radius: 0.5, speed: 1}]") ==
          "Disks enlarged for visibility; radius 0.0200");
    CHECK(remark("[{count: 20, radius: 0.5, drawn_radius: 0.5, speed: 1}]").empty());
    CHECK(remark("[{name: a, count: 9, radius: 0.1, drawn_radius: 0.5}, {name: b, count: 1, "
                 "radius: 1}]") == "Disks enlarged for visibility; radius 0.100");
    CHECK(remark("[{name: a, count: 9, radius: 0.02, speed: 1}, {name: b, count: 1, radius: 3}, "
                 "{name: c, count: 5, radius: 0.03}]") ==
          "Disks enlarged for visibility; radii 0.0200 to 0.0300");
    // By one factor for all.
    CHECK(remark("[{count: 20, radius: 0.1, speed: 1}]\nscale: {diameter: 5}") ==
          "Disks drawn 5 times as large");
    CHECK(
        remark("[{count: 20, radius: {uniform: [0.1, 0.2]}, speed: 1}]\nscale: {diameter: 2.5}") ==
        "Disks drawn 2.5 times as large");
    CHECK(remark("[{count: 20, radius: 0.1, drawn_radius: 0.2, speed: 1}]\nscale: {diameter: 5}") ==
          "Disks enlarged for visibility; radius 0.100");
    CHECK(remark("[{count: 20, radius: 0.002, speed: 1}]\nscale: {diameter: 5}") ==
          "Disks enlarged for visibility; radius 0.00200");
    CHECK(remark("[{count: 20, radius: 0.1, speed: 1}]\nscale: {diameter: 1}").empty());
    // As many that they cover a quarter of the box as they are; the box is about 130 pixels high.
    CHECK(remark("[{count: 2390, radius: 0.2, speed: 1}]", "[320, 180]").empty());
    CHECK(remark("[{count: 2390, radius: 0.199, speed: 1}]", "[320, 180]") ==
          "Disks enlarged for visibility; radius 0.199");
}

TEST_CASE("labels that are asked for and have no room say so") {
    const auto says_so = [](const std::string& box, const std::string& gas) {
        const test::Shot film(test::scene_from("title: T\nbox: " + box + "\ngas: [" + gas +
                                               "]\nrun: {until: 1}\nfilm: {seconds: 0.1, panels: "
                                               "[], labels: mass}\n"));
        const TextLog log;
        FramePainter(*film.panels).paint(film.frames.front());
        return std::ranges::any_of(log.lines, [](const DrawnLine& line) {
            return line.markup == "No room for labels on the disks" ||
                   line.markup == "no room for labels on the beads";
        });
    };
    // 770 pixels for 30: a radius of 2 is 51 pixels, one of 0.2 is 5 and less than a letter.
    CHECK(says_so("{size: [40, 30]}", "{count: 12, radius: 0.2, speed: 1}"));
    CHECK_FALSE(says_so("{size: [40, 30]}", "{count: 12, radius: 2, speed: 1}"));
    CHECK(says_so("{length: 40}", "{count: 12, radius: 0.05, drawn_radius: 0.1, speed: 1}"));
    CHECK_FALSE(says_so("{length: 40}", "{count: 6, radius: 1.5, speed: 1}"));
}

TEST_CASE("panels say what they count, compare with and put on their axes") {
    const auto words = [](const std::string& rest, const std::string& panels) {
        const test::Shot film(load_scene_text(
            "title: T\n" + rest + "\nfilm: {seconds: 4, size: [2600, 1080], panels: [" + panels +
                "]}\n",
            "test", test::resources()));
        const TextLog log;
        FramePainter painter(*film.panels);
        painter.paint(film.frames.back());
        std::string found;
        for (const DrawnLine& line : log.lines) found += "|" + line.markup;
        return found + "|";
    };
    const auto has = [](const std::string& all, const std::string& part) {
        return all.find(part) != std::string::npos;
    };
    const std::string plane =
        "box: {size: [40, 30]}\ngas: [{count: 90, radius: 0.5, speed: 2}]\nrun: {until: 5}";
    // Both components of each particle are counted.
    CHECK(has(words(plane, "velocity-histogram"), "|Distribution of velocity components<"));
    CHECK(has(words(plane, "{kind: velocity-histogram, component: y}"), "|Velocity distribution<"));
    const std::string wire =
        "box: {length: 20}\ngas: [{name: a, position: 5, velocity: 2}, "
        "{name: b, position: [10, 15], velocity: -1}]\nrun: {until: 5}";
    CHECK(has(words(wire, "velocity-histogram"), "|Velocity distribution<"));
    // N T over the area: 90 times 2 over 1200.
    CHECK(has(words(plane, "pressure"), "|ideal gas 0.150|"));
    CHECK(!has(words("box: {size: [40, 30]}\ngas: [{name: a, count: 9, speed: 1}, {name: b, count: "
                     "1, mass: infinite, "
                     "position: [20, 15], velocity: [1, 0]}]\nrun: {until: 5}",
                     "pressure"),
               "ideal gas"));
    // The only particle of its kind has a name.
    const std::string positions = words(wire, "{kind: positions, of: [0, 2]}");
    CHECK(has(positions, "|a|"));
    CHECK(has(positions, "|particle 2|"));
    // A bead at rest has the energy 0, which powers of ten have not; the other one has 50.
    const std::string resting = words(
        "box: {length: 20}\ngas: [{name: a, position: 5}, "
        "{name: b, position: 15, mass: 400, velocity: -0.5}]\nrun: {until: 40}",
        "energy-by-species");
    CHECK(has(resting, "|40|"));
    CHECK(!has(resting, "|0.1|"));
}

TEST_CASE("the temperature of a heat bath stands at the end of its wall") {
    const test::Shot shot(
        test::scene_from("title: T\nbox: {size: [40, 30], walls: {left: {temperature: 3}, top: "
                         "{temperature: 2}}}\n"
                         "gas: [{count: 9, speed: 1}]\nrun: {until: 5}\nfilm: {seconds: 1, fps: 4, "
                         "panels: [], monitors: [collisions]}\n"),
        1);
    FramePainter painter(*shot.panels);
    const TextLog log;
    painter.paint(shot.frames.front());
    const auto drawn = [&](const char* words) {
        const auto line = std::ranges::find(log.lines, words, &DrawnLine::markup);
        REQUIRE(line != log.lines.end());
        return line->ink;
    };
    const Rect left = drawn("T = 3"), top = drawn("T = 2");
    CHECK(left.right() < top.x);
    CHECK(std::abs(left.bottom() - top.bottom()) < left.height);
}
