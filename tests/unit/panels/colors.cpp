// What colours of disks, bars and words tell can be told by every viewer, and read on what is
// behind.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>

#include "draw/palette.h"
#include "panels/frame.h"
#include "panels/gas/gas_colors.h"
#include "panels/plot/layers.h"
#include "scene/load.h"
#include "support/files.h"
#include "support/first_frame.h"
#include "support/library.h"
#include "support/pixels.h"
#include "support/resources.h"
#include "support/scene_text.h"
#include "support/share_of_cases.h"
#include "support/shot.h"
#include "support/test_root.h"
#include "support/vision.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr ThemeKind all_themes[] = {ThemeKind::light, ThemeKind::dark, ThemeKind::print};

Scene scene_of(const std::string& gas, const std::string& film,
               const std::string& box = "size: [40, 40]") {
    return test::scene_from("title: T\nbox: {" + box + "}\ngas: [" + gas +
                            "]\nrun: {until: 4}\nfilm: {seconds: 1, size: [1920, 1080], " + film +
                            "}\n");
}

// The first frame of a scene.
struct Picture : test::FirstFrame {
    using FirstFrame::FirstFrame;

    Color at(double x, double y) const {
        return rgb(view.data[std::lround(y) * view.stride + std::lround(x)] & 0xFFFFFF);
    }

    double unit() const { return Grid(scene.film.layout, scene.film.size).unit(); }

    // Where the last panel has its data, and the numbers of its axes.
    Rect area_of_last_plot() const {
        DiskPainter disks;
        const Grid grid(scene.film.layout, scene.film.size);
        const Slot& slot = panels.panels().back().slot;
        return plot_area({grid.place(slot), grid.unit(), theme_of(scene.film.theme), disks});
    }

    // The pixels along a line from the centre of the box to the right.
    std::vector<Color> row() const {
        const Rect rect = box();
        std::vector<Color> colors;
        for (double x = rect.x + rect.width / 2; x < rect.right() - 2; x += 1.0)
            colors.push_back(at(x, rect.y + rect.height / 2));
        return colors;
    }
};

bool same(Color a, Color b) { return to_pixel(a) == to_pixel(b); }

// Cairo rounds a colour otherwise than the painter of disks.
bool nearly_same(Color a, Color b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green),
                     std::abs(a.blue - b.blue)}) < 1.5 / 255.0;
}

const char* name_of_theme(ThemeKind kind) {
    return kind == ThemeKind::light ? "light" : kind == ThemeKind::dark ? "dark" : "print";
}

}  // namespace

// Whatever scale a film has.
TEST_CASE("disks of a class of speed have its colour, and species beside them none of the three") {
    for (const std::string palette : {"", "viridis", "plasma", "netlogo"})
        for (const ThemeKind kind : all_themes) {
            CAPTURE(palette);
            CAPTURE(static_cast<int>(kind));
            Scene scene = scene_of("{name: a, count: 2}, {name: b, count: 1}",
                                   "panels: [], color_by: speed-class");
            if (!palette.empty()) scene.film.palette = palette;
            const Particles particles{Eigen::ArrayXd::Constant(3, 0.5), Eigen::ArrayXd::Ones(3),
                                      Eigen::ArrayXi{{0, 0, 1}}};
            const BoxedGas none;
            GasColors colors({scene, particles, 1, none});
            colors.fix_scale();
            for (std::size_t k = 0; k < 3; ++k) {
                const double speed = std::array{0.3, 1.0, 2.0}[k];
                const Color seen =
                    colors.of_shades(theme(kind)).at(colors.shade(0, {speed, {speed, 0.0}, 1.0}));
                CHECK(same(seen, speed_class_color(k, theme(kind))));
                if (kind != ThemeKind::print)
                    CHECK(distance(visions[0], kind_in(scene.film, 0, theme(kind)), seen) >=
                          least_distance_on_scale);
            }
        }
}

// Words are drawn in the ink, muted or what is to be looked at, or in a colour of their own, which
// their markup says.
TEST_CASE("all words that are drawn can be read, in every theme") {
    constexpr double least = 4.5;
    const std::regex own("foreground=\"(#[0-9a-fA-F]{6})\"");
    // What stands before words in print, and is none.
    const std::regex sample("<span [^>]*>(●|○|—|- -|···|–·–)</span>");
    for (const ThemeKind kind : all_themes) {
        const Theme& colors = theme(kind);
        for (const Color& behind : {colors.page, colors.ground})
            for (const Color& word : {colors.ink, colors.muted, colors.highlight})
                CHECK(contrast(word, behind) >= least);
        for (const char* name : {"mixed-masses", "heat-flow", "slow-crowd", "reversal-precision",
                                 "circular-particles", "gas-under-a-weight"}) {
            const Shot film(load_scene(test::library_file(name), resources(),
                                       {"film.fps=1", "run.precision=double",
                                        std::string("film.theme=") + name_of_theme(kind)}));
            FramePainter(*film.panels).paint(film.frames.front());
            const TextLog log;
            FramePainter painter(*film.panels);
            painter.paint(film.frames[film.frames.size() / 2]);
            for (const DrawnLine& line : log.lines) {
                const std::string words = std::regex_replace(line.markup, sample, "");
                for (std::sregex_iterator match(words.begin(), words.end(), own), end; match != end;
                     ++match) {
                    CAPTURE(name);
                    CAPTURE(line.markup);
                    const Color word = *parse_color((*match)[1].str());
                    CHECK(contrast(word, colors.page) >= least);
                    CHECK(contrast(word, colors.ground) >= least);
                }
            }
        }
    }
}

// The disk's colour may be any; some ring of it stands out from the ground.
TEST_CASE("disks of any colour have a rim that stands out from the ground") {
    for (const ThemeKind kind : all_themes)
        for (const std::string color : {"#f0e442", "#56b4e9", "#e69f00", "#ffffff", "#14181d"})
            for (const std::string fill : {"true", "false"}) {
                CAPTURE(static_cast<int>(kind));
                CAPTURE(color);
                CAPTURE(fill);
                const Picture picture(
                    scene_of("{count: 1, radius: 8, position: [20, 20], color: \"" + color +
                                 "\", fill: " + fill + "}",
                             std::string("color_by: species, theme: ") + name_of_theme(kind)));
                const Theme& colors = theme(kind);
                const Color own = *parse_color(color);
                const std::vector<Color> row = picture.row();
                CHECK(same(row.front(), fill == "true" ? own : colors.ground));
                int rim = 0;
                for (const Color& pixel : row) rim += same(pixel, edge_of(own, colors));
                CHECK(rim >= 1);
            }
}

// Beside the gas nothing else has the edge's colour: words in the same colour are darker still.
TEST_CASE("points of panels, beads and rods in a pale colour have an edge too") {
    const Theme& colors = theme(ThemeKind::light);
    const Color pale = rgb(0xF0E442), edge = edge_of(pale, colors);
    const auto edges = [&](const std::string& film, const std::string& box, double radius,
                           bool of_panels) {
        const std::string gas =
            "{count: 1, position: " + std::string(box == "length: 40" ? "20" : "[20, 20]") +
            ", color: \"#f0e442\", radius: " + std::to_string(radius) + "}";
        const Picture picture(scene_of(gas, "color_by: species, theme: light, " + film, box));
        int count = 0;
        for (int y = 0; y < picture.view.height; ++y)
            for (int x = 0; x < picture.view.width; ++x)
                count += (x > 1200) == of_panels && nearly_same(picture.at(x, y), edge);
        return count;
    };
    CHECK(edges("panels: [energy-by-species]", "size: [40, 40]", 1.0, true) > 10);
    // A bead, with its swatch; a rod.
    const int swatch = edges("panels: []", "size: [40, 40]", 0.001, false);
    CHECK(edges("panels: [energy-by-species]", "length: 40", 0.5, false) > swatch + 20);
    CHECK(edges("panels: [energy-by-species]", "length: 40", 8.0, false) > swatch + 200);
}

TEST_CASE("infinite masses have a colour of their own, and hatching, and a word") {
    const std::string finite =
        "{name: a, count: 5, mass: 3, radius: 1}, {name: b, count: 1, radius: 8, ";
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        const Theme& colors = theme(kind);
        const Color own = kind == ThemeKind::print ? colors.ink : color_beside("viridis", colors);
        const auto film = std::string("color_by: mass, theme: ") + name_of_theme(kind);
        const TextLog log;
        const Picture infinite(
            scene_of(finite + "position: [20, 20], mass: infinite, speed: 0}", film));
        CHECK(std::ranges::count(log.lines, "infinite", &DrawnLine::markup) == 1);
        const Picture heavy(scene_of(finite + "position: [20, 20], mass: 12, speed: 0}", film));
        int fill = 0, hatching = 0;
        const double radius = 8.0 * infinite.box().width / 40.0;
        for (std::size_t i = 0; double(i) < radius - 3.0; ++i) {
            fill += same(infinite.row()[i], own);
            hatching += same(infinite.row()[i], colors.ground);
            CHECK_FALSE(same(heavy.row()[i], own));
        }
        CHECK(fill > radius / 2);
        CHECK(hatching > radius / 12);

        // In the key, before the scale, its colour is found only where there is such a mass.
        const auto found_in_key = [&](const Picture& picture) {
            const Film& its = picture.scene.film;
            const Rect key = Grid(its.layout, its.size).place(its.layout.color_bar);
            int count = 0;
            for (double y = key.y; y < key.bottom(); ++y)
                for (double x = key.x; x < key.right(); ++x) count += same(picture.at(x, y), own);
            return count;
        };
        CHECK(found_in_key(infinite) > 80);
        CHECK(found_in_key(heavy) == 0);
    }
}

// Both the bars and the curve over them stand out from the page, but hardly from one another.
TEST_CASE("a casing parts a curve from the bars behind it, whatever colours these have") {
    for (const char* colored : {"species", "speed"})  // all alike, or as the disks
        for (const ThemeKind kind : all_themes) {
            CAPTURE(colored);
            CAPTURE(static_cast<int>(kind));
            const Theme& colors = theme(kind);
            const Picture picture(
                scene_of("{count: 300, radius: 0.3, temperature: 1}",
                         std::string("template: lecture, panels: [{kind: speed-histogram, "
                                     "mean_start: false, mean_now: false}], theme: ") +
                             name_of_theme(kind) + ", color_by: " + colored));
            const Rect plot = picture.area_of_last_plot();
            const double from = plot.bottom() - 1.2 * picture.unit();  // over axis and ramp
            // Up a column: bar, casing, curve, casing, bar. Rows of pixels are not all casing: 2 is
            // less than half of the contrast of bar and curve, which have 4.5 at least.
            int cased = 0, bare = 0;
            for (double x = plot.x + 3; x < plot.right() - 3; x += 1.0) {
                const Color bar = picture.at(x, from);
                if (same(bar, colors.accent)) continue;
                std::string seen;
                for (double y = from; y > plot.y; y -= 1.0) {
                    const Color pixel = picture.at(x, y);
                    const char what = same(pixel, colors.accent)           ? 'c'
                                      : contrast(pixel, colors.page) < 2.0 ? 'p'
                                      : same(pixel, bar)                   ? 'b'
                                                                           : ' ';
                    if (what != ' ' && (seen.empty() || seen.back() != what)) seen += what;
                }
                cased += seen.starts_with("bpcpb");
                bare += seen.starts_with("bcb");
            }
            CHECK(cased > 100);
            CHECK(bare == 0);
        }
}

TEST_CASE("a casing does not hide low bars, nor the feet of others") {
    const Picture picture(scene_of("{count: 300, radius: 0.3, temperature: 1}",
                                   "template: lecture, panels: [{kind: energy-histogram, "
                                   "mean_start: false, mean_now: false}], theme: dark"));
    const Theme& colors = theme(ThemeKind::dark);
    const Rect plot = picture.area_of_last_plot();
    // Up from the axis, as far as a bar goes, there is bar and curve, but no page.
    int low = 0, parted = 0;
    for (double x = plot.x + 0.3 * plot.width; x < plot.right() - 2; x += 1.0) {
        int height = 0, pages = 0, pages_within = 0;
        for (int up = 3; up < 0.6 * picture.unit(); ++up) {
            const Color pixel = picture.at(x, plot.bottom() - up);
            pages += same(pixel, colors.page);
            if (!same(pixel, colors.bar)) continue;
            height = up;
            pages_within = pages;
        }
        low += height > 0;
        parted += pages_within > 0;
    }
    CHECK(low > 100);
    CHECK(parted == 0);
}

TEST_CASE("words on plates, and on captions, can be read over anything that moves behind") {
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        const Theme& colors = theme(kind);
        for (const Color& behind : {colors.bar, colors.accent, colors.ink, colors.muted})
            for (const Color& paper : {colors.page, colors.ground})
                for (const Color& words : {colors.ink, colors.muted})
                    CHECK(contrast(words, mix(behind, paper, plate_alpha)) >= 4.5);
        CHECK(contrast(colors.bar, colors.page) >= 4.5);  // words about bars have their colour
        CHECK(contrast(colors.accent, colors.page) >= 4.5);
    }
}

TEST_CASE("a print of a scene that names no colours has none") {
    int scenes = 0, number = 0;
    const int share = test::every_nth(1, 8);
    for (const std::filesystem::path& file : test::library_files()) {
        if (++number % share != 0) continue;
        CAPTURE(file.stem().string());
        Overrides overrides = test::fewer_particles(file);
        overrides.insert(overrides.end(), {"film.theme=print", "film.fps=1"});
        Scene scene = load_scene(file, test::resources(), overrides);
        const bool has_own =
            scene.film.palette || std::ranges::any_of(scene.looks, [](const SpeciesLook& look) {
                return look.color.has_value();
            });
        if (has_own) continue;
        ++scenes;
        const Shot film(std::move(scene));
        FramePainter painter(*film.panels);
        int coloured = 0;
        for (const std::size_t frame : {film.frames.size() / 3, film.frames.size() - 2})
            for (const std::uint32_t pixel : pixels_of(painter.paint(film.frames[frame]))) {
                const int red = (pixel >> 16) & 0xFF, green = (pixel >> 8) & 0xFF,
                          blue = pixel & 0xFF;
                coloured += std::max({red, green, blue}) - std::min({red, green, blue}) > 2;
            }
        CHECK(coloured == 0);
    }
    CHECK(scenes >= 10 / share);
}

TEST_CASE("lines and disks of a print are told apart without colour, and words show how") {
    Scene scene = scene_of(
        "{name: a, count: 3, radius: 1}, {name: b, count: 3, radius: 1}, "
        "{name: c, count: 3, radius: 1}, {name: d, count: 3, radius: 1}",
        "theme: print, template: data, panels: [energy-by-species]");
    const FirstFrame picture(scene);
    const Theme& print = theme(ThemeKind::print);
    DiskPainter disks;
    const DrawContext dc{{0, 0, 100, 100}, 20.0, print, disks};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(plot::dashes_in_print(i, 1).empty());
        CHECK_FALSE(line_swatch(i, print.ink, print).empty());
        for (std::size_t k = 0; k < i; ++k) {
            CHECK(plot::dashes_in_print(i, 4) != plot::dashes_in_print(k, 4));
            CHECK(line_swatch(i, print.ink, print) != line_swatch(k, print.ink, print));
        }
    }
    for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
        const DrawContext other{{0, 0, 100, 100}, 20.0, theme(kind), disks};
        const plot::Stroke stroke{.print_dashes = plot::dashes_in_print(1, 4)};
        CHECK(plot::dashes_of(stroke, other).empty());
        CHECK_FALSE(plot::dashes_of(stroke, dc).empty());
        CHECK(line_swatch(1, theme(kind).ink, theme(kind)).empty());
        CHECK(disk_swatch(theme(kind).ink, theme(kind)).empty());
    }
    CHECK(disk_swatch(kind_color(0, print), print).find("●") != std::string::npos);
    CHECK(disk_swatch(kind_color(1, print), print).find("○") != std::string::npos);
    TextLog log;
    FramePainter(picture.panels).paint(picture.frame);
    // Each name stands at its line, after its swatch; also here, where all lines lie on the axis.
    const double axis = Picture(scene).area_of_last_plot().bottom();
    for (const auto& [name, sample] : {std::pair{"a", "—"}, std::pair{"b", "- -"},
                                       std::pair{"c", "···"}, std::pair{"d", "–·–"}}) {
        CAPTURE(name);
        const auto is_named = [&](const DrawnLine& line) {
            const std::size_t at = line.markup.find(std::string(sample) + "<");
            return at != std::string::npos &&
                   line.markup.find(std::string(name) + "<", at) != std::string::npos;
        };
        const auto line = std::ranges::find_if(log.lines, is_named);
        REQUIRE(line != log.lines.end());
        CHECK(line->ink.bottom() <= axis);
    }
}

TEST_CASE("a direction has its own colour for every viewer, and what rests has none but a rim") {
    const Scene scene = scene_of("{count: 1}", "panels: [], color_by: direction");
    const Particles particles{Eigen::ArrayXd::Constant(1, 0.5), Eigen::ArrayXd::Ones(1),
                              Eigen::ArrayXi::Zero(1)};
    const BoxedGas none;
    GasColors colors({scene, particles, 1, none});
    colors.fix_scale();
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        const auto seen = [&](double x, double y) {
            const auto shade = colors.shade(0, {std::hypot(x, y), {x, y}, 1.0});
            return colors.of_shades(theme(kind)).at(shade);
        };
        const std::array all{seen(1, 0), seen(0, 1), seen(-1, 0), seen(0, -1), seen(0, 0)};
        // Five greys from black to white have no room for more than 17.
        const double least = kind == ThemeKind::print ? 17.0 : least_distance;
        for (const Vision& vision : visions) {
            CAPTURE(vision.name);
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    CHECK(distance(vision, all[i], all[k]) >= least);
            CHECK(distance(vision, all[0], all[2]) >= least_distance);
        }
        CHECK(same(all[4], theme(kind).ground));
        CHECK(same(seen(3, 3), seen(0.1, 0.1)));
        CHECK(distance(visions[0], seen(1, 1e-9), seen(1, -1e-9)) < 1.0);  // the circle is closed
    }
}

TEST_CASE("a colour that a species has in its scene is that of its disks, whatever others tell") {
    for (const std::string by :
         {"speed", "energy", "mass", "direction", "speed-class", "species"}) {
        CAPTURE(by);
        const Scene scene = scene_of("{name: a, count: 3}, {name: b, count: 1, color: red}",
                                     "panels: [], color_by: " + by);
        const Particles particles{Eigen::ArrayXd::Constant(4, 0.5), Eigen::ArrayXd::Ones(4),
                                  Eigen::ArrayXi{{0, 0, 0, 1}}};
        const BoxedGas none;
        GasColors colors({scene, particles, 1, none});
        colors.fix_scale();
        const auto seen = [&](Eigen::Index i, double speed) {
            return colors.of_shades(theme(ThemeKind::dark))
                .at(colors.shade(i, {speed, {speed, 0.0}, 1.0}));
        };
        const Color red = *parse_color(*scene.looks[1].color);
        for (const double speed : {0.0, 1.0, 7.0}) {
            CHECK(same(seen(3, speed), red));
            CHECK_FALSE(same(seen(0, speed), red));
        }
    }
}

// Yellow is not fast in the box and a species beside it.
TEST_CASE("where colours of the gas are a scale, kinds in panels have none of them") {
    for (const std::string palette : {"viridis", "cividis", "plasma", "inferno", "magma"})
        for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
            CAPTURE(palette);
            CAPTURE(static_cast<int>(kind));
            const Scene scene =
                scene_of("{name: a, count: 3}, {name: b, count: 1}", "palette: " + palette);
            const ColorMap map = color_map_on(palette, theme(kind));
            for (std::size_t k = 0; k < 2; ++k)
                for (int i = 0; i <= 100; ++i)
                    CHECK(distance(visions[0], kind_in(scene.film, k, theme(kind)),
                                   map.at(i / 100.0)) >= least_distance_on_scale);
        }
    const Scene by_species = scene_of("{count: 3}", "color_by: species");
    CHECK(same(kind_in(by_species.film, 0, theme(ThemeKind::dark)),
               kind_color(0, theme(ThemeKind::dark))));
}

TEST_CASE("runs beside each other differ for every viewer, and from the theory curve") {
    for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
        CAPTURE(name_of_theme(kind));
        const Theme& colors = theme(kind);
        std::vector<Color> all{colors.accent};
        for (std::size_t run = 0; run < 6; ++run)
            all.push_back(plot::color_of(plot::Role{plot::Role::Of::run, run}, colors));
        for (const Vision& vision : visions)
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t k = 0; k < i; ++k) {
                    CAPTURE(vision.name);
                    CAPTURE(i);
                    CAPTURE(k);
                    CHECK(distance(vision, all[i], all[k]) >= least_distance);
                }
    }
}

TEST_CASE("whether there are infinite masses is found once, not for every disk") {
    const Scene scene = scene_of("{name: a, count: 3}, {name: b, count: 1, mass: infinite}",
                                 "panels: [], color_by: mass");
    Particles particles{Eigen::ArrayXd::Constant(4, 0.5), Eigen::ArrayXd{{1.0, 1.0, 1.0, 0.0}},
                        Eigen::ArrayXi{{0, 0, 0, 1}}};
    const BoxedGas none;
    GasColors colors({scene, particles, 1, none});
    particles.inverse_mass[3] = 1.0;  // a look at all masses now would find none
    CHECK(colors.tells_infinite());
    colors.fix_scale();
    particles.inverse_mass[3] = 0.0;
    CHECK(colors.shade(3, {0.0, {0.0, 0.0}, 1.0}) == 256);
    CHECK(colors.shade(0, {0.0, {0.0, 0.0}, 1.0}) < 256);
}

// Many at speed 1, a twentieth at 2, one at 30: the scale is for the many, and says so.
TEST_CASE(
    "the scale of speeds ends where a twentieth is faster, and says so; of few at the fastest") {
    const auto scale_in = [](const std::string& gas) {
        FirstFrame first(scene_of(gas, "panels: []"));
        const PanelContext context{first.scene, first.simulation.particles(), 1, {}};
        GasColors colors(context);
        const Sample& sample = first.simulation.sample();
        const Eigen::ArrayXd speed = speeds(sample);
        colors.survey({Tick{}, sample, speed, speed, {}});
        colors.fix_scale();
        return colors.scale();
    };
    const ColorScale many = scale_in(
        "{name: slow, count: 100, radius: 0.1, speed: 1.1}, "
        "{name: fast, count: 1, radius: 0.1, speed: 30}");
    CHECK(many.top == 1.5);
    REQUIRE(many.is_exceeded);
    CHECK(marks_of(many).back().label == "≥ 1.5");
    CHECK(marks_of(many).front().label == "0.0");
    const ColorScale even = scale_in("{count: 100, radius: 0.1, speed: 1.1}");
    CHECK(!even.is_exceeded);
    CHECK(marks_of(even).back().label == "1.5");
    const ColorScale few = scale_in(
        "{name: slow, count: 8, radius: 0.1, speed: 1.1}, "
        "{name: fast, count: 1, radius: 0.1, speed: 30}");
    CHECK(few.top == 30.0);
    CHECK(!few.is_exceeded);
    for (const double top : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0}) {
        CAPTURE(top);
        CHECK(marks_of({"", top, true}).back().value == doctest::Approx(top));
    }
}

TEST_CASE("beside a short scale there are fewer numbers, and always the highest") {
    const ColorScale scale{"", 0.8, true};
    const auto labels = [&](double height) {
        std::string all;
        for (const TickMark& mark : marks_with_room(scale, height, 10.0)) all += mark.label + " ";
        return all;
    };
    CHECK(labels(40.0) == "0.0 0.2 0.4 0.6 ≥ 0.8 ");
    CHECK(labels(39.0) == "0.0 0.4 ≥ 0.8 ");
    CHECK(labels(19.0) == "0.2 ≥ 0.8 ");
    CHECK(labels(13.0) == "0.0 ≥ 0.8 ");
    CHECK(labels(5.0) == "0.0 ≥ 0.8 ");
}
