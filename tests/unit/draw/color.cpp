#include "draw/color.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "draw/palette.h"
#include "draw/style.h"
#include "support/relative.h"

using namespace carom;
using test::relative;

TEST_CASE("contrast agrees with known pairs of WCAG") {
    CHECK(contrast(rgb(0x000000), rgb(0xFFFFFF)) == relative(21.0, 1e-12));
    CHECK(contrast(rgb(0x777777), rgb(0x777777)) == relative(1.0, 1e-12));
    // #767676 is the lightest grey with 4.5 on white, #949494 the lightest with 3 (WebAIM's
    // checker).
    CHECK(contrast(rgb(0x767676), rgb(0xFFFFFF)) == relative(4.54, 0.002));
    CHECK(contrast(rgb(0xFFFFFF), rgb(0x949494)) == relative(3.03, 0.002));
    CHECK(contrast(rgb(0xFF0000), rgb(0xFFFFFF)) == relative(4.00, 0.002));
    CHECK(relative_luminance(rgb(0x00FF00)) == relative(0.7152, 1e-12));
}

TEST_CASE("colours are read and written as hexadecimal") {
    REQUIRE(parse_color("#1b1F24"));
    CHECK(to_pixel(*parse_color("#1b1F24")) == 0xFF1B1F24U);
    for (const char* wrong :
         {"", "#", "1b1f24", "#1b1f2", "#1b1f244", "#1b1g24", "#-b1f24", "#+12345"})
        CHECK_FALSE(parse_color(wrong));
    CHECK(to_pixel({2.0, -1.0, 0.5, 0.1}) == 0xFFFF0080U);
    CHECK(to_pixel(mix(rgb(0x000000), rgb(0x6496C8), 0.5)) == 0xFF324B64U);
}

namespace {

// Colours of matplotlib 3.6.3 (`matplotlib.colormaps[name](index, bytes=True)`).
struct KnownColor {
    const char* map;
    int index;
    std::uint32_t color;
};
constexpr KnownColor known_colors[] = {
    {"viridis", 0, 0x440154},   {"viridis", 64, 0x3B528B},  {"viridis", 128, 0x21918C},
    {"viridis", 201, 0x73D056}, {"viridis", 255, 0xFDE725}, {"cividis", 0, 0x00224E},
    {"cividis", 64, 0x434E6C},  {"cividis", 128, 0x7D7C78}, {"cividis", 201, 0xC5B568},
    {"cividis", 255, 0xFEE838}, {"plasma", 0, 0x0D0887},    {"plasma", 64, 0x7E03A8},
    {"plasma", 128, 0xCC4778},  {"plasma", 201, 0xFBA238},  {"plasma", 255, 0xF0F921},
    {"inferno", 0, 0x000004},   {"inferno", 64, 0x57106E},  {"inferno", 128, 0xBC3754},
    {"inferno", 201, 0xFC9F07}, {"inferno", 255, 0xFCFFA4}, {"magma", 0, 0x000004},
    {"magma", 64, 0x51127C},    {"magma", 128, 0xB73779},   {"magma", 201, 0xFD9A6A},
    {"magma", 255, 0xFCFDBF}};

int largest_difference(Color a, Color b) {
    const auto byte = [](double channel) { return static_cast<int>(channel * 255.0 + 0.5); };
    return std::max({std::abs(byte(a.red) - byte(b.red)), std::abs(byte(a.green) - byte(b.green)),
                     std::abs(byte(a.blue) - byte(b.blue))});
}

}  // namespace

TEST_CASE("colour maps are those of matplotlib") {
    for (const KnownColor& known : known_colors) {
        CAPTURE(known.map);
        CAPTURE(known.index);
        // A third of the table is kept: straight lines between are at most 2.5/255 off.
        CHECK(largest_difference(color_map(known.map).at(known.index / 255.0), rgb(known.color)) <=
              2);
    }
}

TEST_CASE("lightness grows along every colour map") {
    CHECK(color_map_names().size() == 5);
    for (const std::string& name : color_map_names()) {
        CAPTURE(name);
        const ColorMap map = color_map(name);
        for (int i = 0; i < 64; ++i) {
            const double slower = relative_luminance(map.at(i / 64.0));
            // plasma's first steps are flat to within the rounding of its bytes.
            CHECK(relative_luminance(map.at((i + 1) / 64.0)) > slower - 1e-3);
        }
    }
}

TEST_CASE("a colour map can be cut, turned and asked outside of its range") {
    const ColorMap whole = color_map("viridis");
    const ColorMap cut = color_map("viridis", 0.9, 0.2);
    CHECK(largest_difference(cut.at(0), whole.at(0.9)) == 0);
    CHECK(largest_difference(cut.at(1), whole.at(0.2)) == 0);
    CHECK(largest_difference(cut.at(0.5), whole.at(0.55)) <= 1);
    CHECK(largest_difference(whole.at(-3), whole.at(0)) == 0);
    CHECK(largest_difference(whole.at(7), whole.at(1)) == 0);
    CHECK_THROWS_AS(color_map("jet"), std::invalid_argument);
}

TEST_CASE("the first colours of kinds stand out from their ground") {
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(i);
        CHECK(contrast(kind_color(i, theme(ThemeKind::dark)), theme(ThemeKind::dark).ground) >=
              3.0);
        CHECK(contrast(kind_color(i, theme(ThemeKind::light)), theme(ThemeKind::light).page) >=
              3.0);
        for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark, ThemeKind::print})
            CHECK(to_pixel(kind_color(i + (kind == ThemeKind::print ? 4 : 6), theme(kind))) ==
                  to_pixel(kind_color(i, theme(kind))));
    }
}

TEST_CASE("paper is white") {
    for (const ThemeKind kind : {ThemeKind::light, ThemeKind::print})
        CHECK(to_pixel(theme(kind).page) == 0xFFFFFFFFU);
}

TEST_CASE("every theme is legible") {
    for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark, ThemeKind::print}) {
        CAPTURE(static_cast<int>(kind));
        const Theme& colors = theme(kind);
        for (const Color& behind : {colors.page, colors.ground}) {
            for (const Color& text : {colors.ink, colors.second, colors.muted, colors.highlight})
                CHECK(contrast(text, behind) >= 4.5);
            for (const Color& mark : {colors.accent, colors.bar, colors.wall, colors.trail})
                CHECK(contrast(mark, behind) >= 3.0);
        }
        CHECK(colors.dark == (relative_luminance(colors.ground) < 0.18));
    }
}
