// Formulae are set as TeX sets them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draw/formula/layout.h"
#include "draw/formula/text_font.h"
#include "draw/formula/words.h"
#include "support/computer_modern.h"
#include "support/pdflatex_boxes.h"

using namespace carom;

TEST_CASE("boxes of formulae are those of pdfLaTeX, with its font") {
    const test::ComputerModern font;
    CHECK(test::pdflatex_boxes.size() > 60);
    for (const test::MeasuredFormula& one : test::pdflatex_boxes) {
        CAPTURE(std::string(one.tex));
        CAPTURE(one.stands_alone);
        const formula::Box box = formula::box_of(
            formula::parsed(one.tex), font,
            one.stands_alone ? formula::Standing::alone : formula::Standing::in_line);
        constexpr double bound = 5e-5;  // TeX rounds at every step
        CHECK(std::abs(box.width - one.width) < bound);
        CHECK(std::abs(box.height - one.height) < bound);
        CHECK(std::abs(box.depth - one.depth) < bound);
    }
}

namespace {

formula::Box box_in_inter(const std::string& tex) {
    return formula::box_of(formula::parsed(tex), formula::TextFont(400), formula::Standing::alone);
}

const formula::Piece& piece_of(const formula::Box& box, const std::string& letter) {
    const auto found = std::ranges::find_if(
        box.pieces, [&](const formula::Piece& piece) { return piece.letter.text == letter; });
    REQUIRE(found != box.pieces.end());
    return *found;
}

}  // namespace

TEST_CASE("a fraction's bar is level with a minus, and clear of what is above and below") {
    const formula::Box box = box_in_inter("-\\frac{g}{T}");
    const formula::TextFont font(400);
    const auto bar = std::ranges::find(box.pieces, formula::Piece::Of::rule, &formula::Piece::of);
    REQUIRE(bar != box.pieces.end());
    const double rule = font.common().rule;
    CHECK(std::abs(-bar->at.y + 0.5 * bar->height - font.lengths(formula::Size::text).axis) < 1e-9);
    CHECK(bar->height == doctest::Approx(rule));
    const auto& above = piece_of(box, "g");
    const auto& below = piece_of(box, "T");
    CHECK(above.at.y + above.depth < bar->at.y - bar->height - 0.1);
    CHECK(below.at.y - below.height > bar->at.y + 0.1);
    CHECK(above.at.x + 0.5 * above.width ==
          doctest::Approx(below.at.x + 0.5 * below.width).epsilon(0.05));
}

TEST_CASE("brackets and roots are as high as what they hold") {
    const formula::Box box =
        box_in_inter("\\left(\\frac{\\frac{a}{b}}{\\frac{c}{d}}\\right)\\sqrt{\\frac{x}{y}}");
    const auto& open = piece_of(box, "(");
    const auto& a = piece_of(box, "a");
    const auto& d = piece_of(box, "d");
    CHECK(open.at.y - open.height < a.at.y - 0.5 * a.height);
    CHECK(open.at.y + open.depth > d.at.y - 0.5 * d.height);
    const auto root = std::ranges::find(box.pieces, formula::Piece::Of::root, &formula::Piece::of);
    REQUIRE(root != box.pieces.end());
    const auto& y = piece_of(box, "y");
    CHECK(root->at.y + root->depth >= y.at.y + y.depth - 1e-9);
    CHECK(root->at.y - root->height < piece_of(box, "x").at.y - piece_of(box, "x").height);
}

TEST_CASE("every symbol has a picture in the declared typeface or in lines") {
    for (const std::string& name : formula::commands()) {
        const formula::Symbol* symbol = formula::symbol_of_command(name);
        if (symbol == nullptr) continue;
        CAPTURE(name);
        const formula::Piece piece{
            .letter = {symbol->letter, symbol->is_slanted}, .width = 1.0, .height = 1.0};
        const formula::Metrics m = formula::TextFont(400).letter(piece.letter, formula::Size::text);
        CHECK(m.width > 0.1);
        CHECK(m.height > 0.1);
        if (!formula::lines_of(piece).empty()) continue;
        // A letter that the typeface lacks would come from another one, with lines of its height.
        const TextStyle style{.size = 100.0};
        CHECK(measure_text(formula::markup_of(piece.letter), style).ascent ==
              doctest::Approx(measure_text("x", style).ascent));
    }
}

TEST_CASE("words with formulae are measured, broken and drawn as wholes") {
    TextStyle style{.size = 20.0, .color = {1, 1, 1, 1}, .tabular = false};
    CHECK(measure_words("costs \\$5", style).width == measure_text("costs $5", style).width);
    const TextExtent plain = measure_words("is x and", style);
    const TextExtent high = measure_words("is $\\frac{x}{y}$ and", style);
    CHECK(high.ascent > plain.ascent - 4.0);
    CHECK(high.descent > plain.descent);
    CHECK(is_formula_alone("$a b$"));
    CHECK_FALSE(is_formula_alone("a $b$"));
    CHECK_FALSE(is_formula_alone("$a$ $b$"));

    style.max_width = measure_words("one $a + b$,", style).width + 1.0;
    CHECK(wrapped_words("one $a + b$, two $c + d + e$", style, 10) ==
          std::vector<std::string>{"one $a + b$,", "two", "$c + d + e$"});
    // Words before a formula are wrapped as others: none is measured as if it were cut.
    TextStyle uncut = style;
    uncut.max_width = 0.0;
    TextStyle narrow = style;
    narrow.max_width = measure_words("the mean energy of", uncut).width + 1.0;
    const std::vector<std::string> lines =
        wrapped_words("the mean energy of the disks in a box, which we call $T$", narrow, 20);
    CHECK(lines.front() == "the mean energy of");
    CHECK(lines.size() == 3);
    for (const std::string& line : lines)
        CHECK(measure_words(line, uncut).width <= narrow.max_width);
    CHECK(wrapped_words("one $a + b$, two $c + d + e$", style, 2) ==
          std::vector<std::string>{"one $a + b$,", "two $c + d + e$"});

    // As wide as measured, in each of its alignments, and nothing is cut.
    const std::string words = "with $\\bar v = \\sqrt{\\frac{\\pi kT}{2m}}$ in all";
    for (const Align align : {Align::left, Align::center, Align::right}) {
        Canvas canvas(PixelSize{600, 100});
        style.align = align;
        TextLog log;
        const TextExtent drawn = draw_words(canvas, {300.0, 60.0}, words, style);
        CHECK(drawn.width == doctest::Approx(measure_words(words, style).width));
        REQUIRE(log.lines.size() == 1);
        CHECK(log.lines.front().markup == words);
        int left = 600, right = 0;
        const PixelView view = canvas.pixels();
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 600; ++x)
                if ((view.data[y * view.stride + x] & 0xFFU) > 64U) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                }
        const double share = align == Align::left ? 0.0 : align == Align::center ? 0.5 : 1.0;
        CHECK(std::abs(left - (300.0 - share * drawn.width)) < 3.0);
        CHECK(std::abs(right - (300.0 + (1.0 - share) * drawn.width)) < 3.0);
    }
}
