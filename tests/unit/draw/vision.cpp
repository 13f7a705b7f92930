// Colours that tell things apart do so for colour-blind viewers, and scales are even.
#include "support/vision.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "draw/palette.h"
#include "draw/style.h"
#include "support/relative.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr ThemeKind all_themes[] = {ThemeKind::light, ThemeKind::dark, ThemeKind::print};

void check_apart(const std::vector<Color>& colors, double least = least_distance) {
    for (const Vision& vision : visions)
        for (std::size_t i = 0; i < colors.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                CAPTURE(vision.name);
                CAPTURE(i);
                CAPTURE(k);
                CHECK(distance(vision, colors[i], colors[k]) >= least);
            }
}

double chroma(Color color) { return std::hypot(oklab(color).a, oklab(color).b); }

// Degrees in [-180, 180].
double hue_between(Color one, Color other) {
    const auto hue = [](Color color) {
        const Oklab lab = oklab(color);
        return std::atan2(lab.b, lab.a) * 180.0 / std::numbers::pi;
    };
    return std::remainder(hue(one) - hue(other), 360.0);
}

}  // namespace

TEST_CASE("the measures of these tests agree with published values") {
    // Sharma, Wu and Dalal 2005, table 1, pairs 1, 7, 16 and 25.
    CHECK(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}) == relative(2.0425, 1e-4));
    CHECK(ciede2000({50, 0, 0}, {50, -1, 2}) == relative(2.3669, 1e-4));
    CHECK(ciede2000({50, 2.5, 0}, {50, 0, -2.5}) == relative(4.3065, 1e-4));
    CHECK(ciede2000({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}) ==
          relative(1.2644, 1e-4));
    CHECK(lightness(rgb(0xFFFFFF)) == relative(100.0, 1e-9));
    CHECK(lightness(rgb(0x777777)) == relative(50.03, 1e-3));  // known from Lab of sRGB's greys
    for (const Vision& vision : visions)
        for (const Triple& row : vision.matrix)
            CHECK(row[0] + row[1] + row[2] == relative(1.0, 2e-6));
    // A red and a green of one lightness are the textbook pair that red-green blindness confuses.
    CHECK(distance(visions[0], rgb(0xC05040), rgb(0x6E8030)) > 30.0);
    CHECK(distance(visions[2], rgb(0xC05040), rgb(0x6E8030)) < least_distance);
}

TEST_CASE("the colours of kinds differ for every viewer, in every theme") {
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        std::vector<Color> colors;
        const std::size_t kinds = kind == ThemeKind::print ? 4 : 6;
        for (std::size_t i = 0; i < kinds; ++i) colors.push_back(kind_color(i, theme(kind)));
        // In print theory is black, and dashed where a kind is.
        if (kind != ThemeKind::print) colors.push_back(theme(kind).accent);
        check_apart(colors);
    }
}

TEST_CASE(
    "no kind has the hue of the theory curve, or glares, and cold and hot are blue and warm") {
    for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
        const Theme& colors = theme(kind);
        for (std::size_t i = 0; i < 6; ++i) {
            const Color color = kind_color(i, colors);
            CAPTURE(hex_of(color));
            // Colours of a smaller chroma look grey. The middle colours of two neighbouring hue
            // names, as orange and yellow, are about 25 degrees apart.
            if (chroma(color) > 0.03) CHECK(std::abs(hue_between(color, colors.accent)) >= 25.0);
            CHECK(chroma(color) <= 0.17);  // yellow of 0.2 is what glares most
        }
        CHECK(std::abs(hue_between(kind_color(0, colors), rgb(0x0000FF))) <= 30.0);
        CHECK(std::abs(hue_between(kind_color(1, colors), rgb(0xFF0000))) <= 30.0);
        for (const std::string& name : color_map_names()) {
            CAPTURE(name);
            const ColorMap scale = color_map_on(name, colors);
            const std::vector<Color> beside = kind_colors_beside(scale.samples(), colors);
            CHECK(oklab(beside[0]).b < oklab(beside[1]).b);
        }
    }
}

TEST_CASE("a print needs no colour, and its first four kinds differ much in lightness") {
    const auto is_grey = [](Color color) {
        return color.red == color.green && color.green == color.blue;
    };
    for (std::size_t i = 0; i < 8; ++i) CHECK(is_grey(kind_color(i, theme(ThemeKind::print))));
    const Theme& print = theme(ThemeKind::print);
    for (const Color& color :
         {print.page, print.ground, print.ink, print.second, print.muted, print.grid, print.accent,
          print.bar, print.wall, print.trail, print.highlight})
        CHECK(is_grey(color));
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < i; ++k)
            CHECK(std::abs(lightness(kind_color(i, theme(ThemeKind::print))) -
                           lightness(kind_color(k, theme(ThemeKind::print)))) >= 15.0);
}

TEST_CASE("a role has the same hue on a light and on a dark page") {
    const Theme &light = theme(ThemeKind::light), &dark = theme(ThemeKind::dark);
    // Hues are named in steps of about 15 degrees; a third of that is not seen.
    for (const auto role : {&Theme::accent, &Theme::bar, &Theme::wall, &Theme::highlight}) {
        CAPTURE(hex_of(light.*role));
        CHECK(std::abs(hue_between(light.*role, dark.*role)) <= 5.0);
    }
}

TEST_CASE("words have three shades, and grid lines stay behind all of them") {
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        const Theme& colors = theme(kind);
        CHECK(contrast(colors.ink, colors.page) > 1.2 * contrast(colors.second, colors.page));
        CHECK(contrast(colors.second, colors.page) > 1.2 * contrast(colors.muted, colors.page));
        // Seen, but less than anything that carries meaning.
        for (const Color& behind : {colors.page, colors.ground}) {
            CHECK(contrast(colors.grid, behind) >= 1.25);
            CHECK(contrast(colors.grid, behind) <= 1.6);
        }
    }
}

TEST_CASE("bars, the theory curve and what is to be looked at differ for every viewer") {
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        const Theme& colors = theme(kind);
        check_apart({colors.bar, colors.accent});
        check_apart({colors.bar, colors.highlight});
        // In print both are black, and normal curves are dashed.
        if (kind != ThemeKind::print) check_apart({colors.accent, colors.highlight});
    }
}

TEST_CASE("shades stand out as they are drawn, in channels of eight bits") {
    for (const ThemeKind kind : all_themes) {
        const Theme& colors = theme(kind);
        for (int i = 0; i <= 1000; ++i) {
            const double level = i / 1000.0;
            const Color words = *parse_color(hex_of(legible({level, level, level, 1.0}, colors)));
            CAPTURE(level);
            CHECK(contrast(words, colors.page) >= 4.5);
            CHECK(contrast(words, colors.ground) >= 4.5);
        }
    }
}

TEST_CASE("the kinds' colours have an edge that stands out, and words in them can be read") {
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        const Theme& colors = theme(kind);
        for (std::size_t i = 0; i < 8; ++i) {
            CAPTURE(i);
            const Color color = kind_color(i, colors);
            for (const Color& behind : {colors.page, colors.ground}) {
                CHECK(contrast(edge_of(color, colors), behind) >= 3.0);
                CHECK(contrast(legible(color, colors), behind) >= 4.5);
                // Curves of one kind lie over bars tinted by any kind.
                for (std::size_t k = 0; k < 8; ++k) {
                    const std::array tint{mix(behind, kind_color(k, colors), 0.3)};
                    CHECK(contrast(toward_ink(color, colors, tint, 3.0), tint.front()) >= 3.0);
                }
            }
            // What stands out by itself stays as it is.
            if (contrast(color, colors.page) >= 3.0 && contrast(color, colors.ground) >= 3.0)
                CHECK(to_pixel(edge_of(color, colors)) == to_pixel(color));
        }
    }
}

TEST_CASE("letters can be read on a fill of any colour") {
    for (const ThemeKind kind : all_themes)
        for (int red = 0; red <= 255; red += 15)
            for (int green = 0; green <= 255; green += 15)
                for (int blue = 0; blue <= 255; blue += 15) {
                    const Color fill{red / 255.0, green / 255.0, blue / 255.0};
                    REQUIRE(contrast(fill, letters_on(fill, theme(kind))) >= 4.5);
                }
}

TEST_CASE("NetLogo's three colours differ for every viewer") {
    for (const bool dark : {true, false}) {
        const ColorMap map = netlogo_map(dark);
        check_apart({map.at(0.0), map.at(0.5), map.at(1.0)});
    }
}

TEST_CASE("slow, medium and fast differ for every viewer, and stand out, in every theme") {
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        const Theme& colors = theme(kind);
        std::vector<Color> classes;
        for (std::size_t k = 0; k < 3; ++k) {
            classes.push_back(speed_class_color(k, colors));
            for (const Color& behind : {colors.page, colors.ground})
                CHECK(contrast(classes.back(), behind) >= 3.0);
        }
        check_apart(classes);
    }
}

// The ends mean little and much; what has no place on a scale is of no colour on it.
TEST_CASE("the ends of every scale differ for every viewer, and what is beside it from all of it") {
    const auto check = [](const ColorMap& map, std::optional<Color> beside) {
        check_apart({map.at(0.0), map.at(1.0)});
        if (!beside) return;
        for (const Vision& vision : visions)
            for (int i = 0; i <= 256; ++i) {
                CAPTURE(vision.name);
                CAPTURE(i);
                REQUIRE(distance(vision, *beside, map.at(i / 256.0)) >= least_distance);
            }
    };
    for (const ThemeKind kind : all_themes) {
        CAPTURE(static_cast<int>(kind));
        const Theme& colors = theme(kind);
        for (const std::string& name : color_map_names()) {
            CAPTURE(name);
            check(color_map_on(name, colors), color_beside(name, colors));
            for (const Color& behind : {colors.page, colors.ground})
                CHECK(contrast(color_beside(name, colors), behind) >= 3.0);
        }
        check(netlogo_map(colors.dark), {});
    }
    check(grey_map(), theme(ThemeKind::print).ink);
}

// Lightness carries a scale when colour does not, so it has to change by even steps. The maps are
// even in CAM02-UCS; by CIEDE2000, which weighs otherwise, their parts used here are even to within
// a factor: 2 for viridis, which is the default.
TEST_CASE("the scale of a print is grey, stands out from the paper and falls by equal steps") {
    const ColorMap map = grey_map();
    constexpr int steps = 16;
    for (int i = 0; i <= steps; ++i) {
        const Color here = map.at(double(i) / steps);
        CHECK((here.red == here.green && here.green == here.blue));
        CHECK(contrast(here, theme(ThemeKind::print).page) >= 3.0);
        if (i == 0) continue;
        CHECK(lightness(map.at((i - 1.0) / steps)) - lightness(here) ==
              relative(lightness(map.at(0.0)) / steps - lightness(map.at(1.0)) / steps, 0.01));
    }
    check_apart({map.at(0.0), map.at(0.5), map.at(1.0)}, least_distance_on_scale);
}

TEST_CASE("scales stand out from their ground, and rise by even steps") {
    constexpr int steps = 16;
    for (const ThemeKind kind : all_themes)
        for (const std::string& name : color_map_names()) {
            CAPTURE(static_cast<int>(kind));
            CAPTURE(name);
            const Theme& colors = theme(kind);
            const ColorMap map = color_map_on(name, colors);
            double least = 1e9, most = 0.0, least_rise = 1e9, most_rise = 0.0;
            for (int i = 0; i <= steps; ++i) {
                const Color here = map.at(double(i) / steps);
                CHECK(contrast(here, colors.ground) >= 3.0 - 1e-9);
                CHECK(contrast(here, colors.page) >= 3.0 - 1e-9);
                if (i == 0) continue;
                const Color before = map.at((i - 1.0) / steps);
                const double step = distance(visions[0], before, here);
                const double rise =
                    (lightness(here) - lightness(before)) * (colors.dark ? 1.0 : -1.0);
                least = std::min(least, step), most = std::max(most, step);
                least_rise = std::min(least_rise, rise), most_rise = std::max(most_rise, rise);
                // Lightness survives every kind of colour vision.
                for (const Vision& vision : visions)
                    CHECK((lab_of(seen_by(vision, here))[0] - lab_of(seen_by(vision, before))[0]) *
                              (colors.dark ? 1.0 : -1.0) >
                          0.0);
            }
            CHECK(least_rise > 0.0);
            CHECK(most <= (name == "viridis" ? 2.0 : 4.0) * least);
            CHECK(most_rise <= (name == "viridis" ? 1.5 : 5.0) * least_rise);
        }
}
