// Styles: the themes that they make, what is drawn in them, and the faults of their colours.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "draw/palette.h"
#include "draw/text.h"
#include "panels/frame.h"
#include "panels/gas/gas_colors.h"
#include "panels/plot/plot.h"
#include "panels/theme/style_faults.h"
#include "scene/figure_spec.h"
#include "scene/style/style.h"
#include "support/pixels.h"
#include "support/resources.h"
#include "support/shot.h"
#include "support/vision.h"

using namespace carom;
using test::Shot;

namespace {

Scene styled(const std::string& style, const std::string& film = "") {
    SceneResources resources = test::resources();
    resources.files["house.yaml"] = style;
    return load_scene_text(
        "title: A title\nbox: {size: [40, 30]}\n"
        "gas: [{name: a, count: 8, radius: 1, speed: 1}, {name: b, count: 8, radius: 1, speed: "
        "2}]\n"
        "run: {until: 4}\nstyle: house.yaml\nfilm: {seconds: 4, fps: 5, size: [640, 360], "
        "panels: [speed-histogram]" +
            film + "}\n",
        "scene.yaml", resources);
}

std::map<std::uint32_t, int> colors_in(const Scene& scene) {
    const Shot shot(scene, 1);
    FramePainter painter(*shot.panels);
    std::map<std::uint32_t, int> found;
    for (const std::uint32_t pixel : test::pixels_of(painter.paint(shot.frames.front())))
        ++found[pixel & 0xFFFFFF];
    return found;
}

bool same(Color a, Color b) { return to_pixel(a) == to_pixel(b); }

const std::string inks = R"(base: light
colors: {page: "#fff8e7", ink: "#102030", theory: "#aa0000", grid: "#cccccc", wall: "#123456",
         series: ["#0b7285", "#b85c00"], slow: "#2b8cc3", fast: "#5b0a5b"}
)";

std::vector<std::string> messages(const std::string& style) {
    std::vector<std::string> all;
    for (const Diagnostic& fault : faults_of(*styled(style).film.style))
        all.push_back(std::to_string(fault.span.line) + ": " + fault.message);
    return all;
}

}  // namespace

TEST_CASE("a theme of a style has its colours, and those of the base for the rest") {
    const Film film = styled(inks).film;
    const Theme& made = theme_of(film);
    CHECK(same(made.page, rgb(0xFFF8E7)));
    CHECK(same(made.ground, rgb(0xFFF8E7)));  // follows the page
    CHECK(same(made.accent, rgb(0xAA0000)));
    CHECK(same(made.wall, rgb(0x123456)));
    CHECK(contrast(made.bar, made.page) < contrast(made.muted, made.page));  // the ink, paler
    CHECK(contrast(made.bar, made.page) > least_contrast_of_marks);
    CHECK(same(made.highlight, theme(ThemeKind::light).highlight));
    CHECK(contrast(made.second, made.page) > contrast(made.muted, made.page));
    CHECK(same(kind_color(0, made), rgb(0x0B7285)));
    CHECK(same(kind_color(1, made), rgb(0xB85C00)));
    CHECK(same(kind_in(film, 1, made), rgb(0xB85C00)));
    // The series goes on with colours of the base that differ from those given.
    for (std::size_t k = 2; k < 6; ++k)
        for (std::size_t i = 0; i < k; ++i)
            CHECK(difference(kind_color(i, made), kind_color(k, made)) > 0.05);
    const ColorMap map = scale_colors(film, made);
    CHECK(same(map.at(0.0), rgb(0x2B8CC3)));
    CHECK(same(map.at(1.0), rgb(0x5B0A5B)));
    CHECK(same(speed_class_color(0, made), rgb(0x2B8CC3)));
    // Even steps of Oklab.
    const Oklab from = oklab(map.at(0.0)), middle = oklab(map.at(0.5)), to = oklab(map.at(1.0));
    CHECK(middle.lightness ==
          doctest::Approx(0.5 * (from.lightness + to.lightness)).epsilon(0.002));
}

TEST_CASE("a style gives the same theme each time, and other themes only its fonts") {
    const std::string fonts = "font: DejaVu Serif\n";
    const Film one = styled(inks + fonts).film, other = styled(inks + fonts).film;
    CHECK(&theme_of(one) == &theme_of(other));
    CHECK(&theme_of(one) != &theme_of(styled(inks).film));
    const Theme& dark = theme_of(one, ThemeName::dark);
    CHECK(same(dark.page, theme(ThemeKind::dark).page));
    CHECK(dark.series.empty());
    CHECK(dark.fonts->text == "DejaVu Serif");
    CHECK(dark.fonts->numbers == "DejaVu Serif");
}

TEST_CASE("compared runs have the colours that a figure gives them") {
    FigureSpec figure;
    figure.compare = {{"a", {}}, {"b", {}}, {"c", {}}};
    figure.compare[1].color = "#aa0000";
    figure.compare[2].color = "#ffff00";
    for (const ThemeName name : {ThemeName::light, ThemeName::print}) {
        figure.theme = name;
        const Theme& theme = theme_of(figure);
        const auto of_run = [&](std::size_t k) {
            return to_pixel(color_of(plot::stroke_of_run(k), theme));
        };
        CHECK(of_run(0) == to_pixel(color_of(plot::stroke_of_run(0), theme_of(name))));
        CHECK(of_run(1) == 0xFFAA0000);
        CHECK(of_run(2) != 0xFFFFFF00);  // not to be seen on white
        CHECK(contrast(color_of(plot::stroke_of_run(2), theme), theme.page) >= 3.0);
    }
    CHECK(&theme_of(FigureSpec{}) == &theme(ThemeKind::light));
}

TEST_CASE("an sRGB colour is the same after Oklab and back") {
    for (const std::uint32_t hex : {0x000000U, 0xFFFFFFU, 0x123456U, 0xFF0000U, 0x0B7285U})
        CHECK(same(from_oklab(oklab(rgb(hex))), rgb(hex)));
}

TEST_CASE("films are drawn in the colours of their style") {
    const auto found = colors_in(styled(inks));
    CHECK(found.at(0xFFF8E7) > 100'000);
    CHECK(found.contains(0x123456));  // the wall
    CHECK(found.contains(0x102030));  // the title
    CHECK(!found.contains(0xFFFFFF));
    const auto named = colors_in(styled(inks, ", palette: viridis"));
    CHECK(!named.contains(0x5B0A5B));
}

TEST_CASE("text is set in the fonts of the style, and as large") {
    const FontFamilies serif{"DejaVu Serif", "Inter", "DejaVu Serif"};
    const auto width = [&](const FontFamilies* fonts, Lettering lettering) {
        return measure_text("0123 mill", {.size = 100, .fonts = fonts, .lettering = lettering})
            .width;
    };
    CHECK(width(&serif, Lettering::text) > 1.05 * width(nullptr, Lettering::text));
    CHECK(width(&serif, Lettering::numbers) == width(nullptr, Lettering::text));
    const Scene usual = styled("base: light\n"),
                large = styled("base: light\nsizes: {film: {text: 1.25}}\n");
    CHECK(Grid(large.film).unit() == doctest::Approx(1.25 * Grid(usual.film).unit()));
    CHECK(Grid(large.film).place({1, 2, 3, 4}).width == Grid(usual.film).place({1, 2, 3, 4}).width);
}

TEST_CASE("colours that viewers cannot see or tell apart are named with their keys") {
    CHECK(messages(inks).empty());
    CHECK(messages("base: light\n").empty());
    CHECK(messages("base: dark\n").empty());
    CHECK(messages("base: print\n").empty());
    // Contrasts by the formula of WCAG: #999999 on white has 2.85, #777777 has 4.48.
    const auto pale = messages("base: light\ncolors:\n  muted: \"#777777\"\n  wall: \"#999999\"\n");
    REQUIRE(pale.size() == 2);
    CHECK(pale[0] == "3: the contrast of `muted` with `page` is 4.48, and words need 4.5");
    CHECK(pale[1].starts_with("4: the contrast of `wall` with `page` is 2.85"));
    // A page without an ink that suits it.
    const auto dark = messages("base: light\ncolors:\n  page: \"#202020\"\n");
    CHECK(dark.size() > 3);
    for (const std::string& one : dark) CHECK(one.starts_with("3: "));
    // Red and green of one lightness: 20 or more apart to most viewers, alike to some.
    const auto alike = messages(
        "base: light\ncolors:\n  theory: \"#000080\"\n  series: [\"#c04040\", \"#6f7a2a\"]\n");
    REQUIRE(alike.size() == 1);
    CHECK(
        alike[0].starts_with("4: colour 2 of `series` and colour 1 of `series` look alike to "
                             "viewers with "));
    CHECK(test::distance(test::visions[0], rgb(0xC04040), rgb(0x6F7A2A)) > 20.0);
    const auto scale = messages("base: light\ncolors:\n  slow: \"#303030\"\n  fast: \"#404040\"\n");
    REQUIRE(scale.size() == 1);
    CHECK(scale[0].starts_with("3: `slow` and `fast` look alike: "));
}
