#include "draw/text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "support/pixels.h"

using namespace carom;
using test::pixels_of;

namespace {

constexpr Color white = rgb(0xFFFFFF);

struct Ink {
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;  ///< of pixels more than half white
    double amount = 0;
};

Ink ink_of(const Canvas& canvas) {
    const PixelView pixels = canvas.pixels();
    Ink ink;
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            const std::uint32_t level = pixels.data[y * pixels.stride + x] & 0xFF;
            ink.amount += level / 255.0;
            if (level <= 127) continue;
            ink.left = std::min(ink.left, x);
            ink.right = std::max(ink.right, x + 1);
            ink.top = std::min(ink.top, y);
            ink.bottom = std::max(ink.bottom, y + 1);
        }
    return ink;
}

Canvas drawn(const std::string& markup, const TextStyle& style, Point at = {50, 150}) {
    Canvas canvas({900, 220});
    draw_text(canvas, at, markup, style);
    return canvas;
}

TextStyle style_of(double size, int weight = 400) {
    TextStyle style;
    style.size = size;
    style.weight = weight;
    style.color = white;
    return style;
}

}  // namespace

TEST_CASE("letters are Inter's, of the asked size, on the baseline") {
    // Inter 4: capital height 1490 of 2048 units, H fits its baseline exactly.
    const Ink ink = ink_of(drawn("H", style_of(100)));
    CHECK(ink.bottom == 150);
    CHECK(ink.bottom - ink.top == doctest::Approx(100 * 1490.0 / 2048).epsilon(0.015));
    CHECK(ink_of(drawn("H", style_of(100, 600))).amount > 1.3 * ink.amount);
}

TEST_CASE("figures are of equal width unless that is switched off") {
    TextStyle style = style_of(37, 500);
    const double zero = measure_text("0", style).width;
    for (const char* digit : {"1", "2", "3", "4", "5", "6", "7", "8", "9"})
        // Inter's medium weight has digits that differ by one or two of 2048 units.
        CHECK(measure_text(digit, style).width == doctest::Approx(zero).epsilon(0.002));
    CHECK(measure_text("1234567890", style).width == doctest::Approx(10 * zero).epsilon(0.001));
    style.tabular = false;
    CHECK(measure_text("1", style).width < 0.8 * measure_text("0", style).width);
}

TEST_CASE("a longer text is wider, a larger one in proportion") {
    const std::string text = "Mean energy of light and heavy disks";
    double before = 0;
    for (std::size_t length = 1; length <= text.size(); ++length) {
        const double width = measure_text(text.substr(0, length), style_of(24)).width;
        CHECK(width > before);
        before = width;
    }
    CHECK(measure_text(text, style_of(48)).width == doctest::Approx(2 * before).epsilon(0.005));
    const TextExtent extent = measure_text(text, style_of(24));
    CHECK(extent.ascent > 24 * 0.727);
    CHECK(extent.descent > 0);
    CHECK(draw_text(*std::make_unique<Canvas>(PixelSize{9, 9}), {0, 5}, text, style_of(24)).width ==
          extent.width);
}

TEST_CASE("alignment is about the given point") {
    TextStyle style = style_of(40);
    const Ink left = ink_of(drawn("HHH", style, {400, 150}));
    style.align = Align::right;
    const Ink right = ink_of(drawn("HHH", style, {400, 150}));
    style.align = Align::center;
    const Ink center = ink_of(drawn("HHH", style, {400, 150}));
    CHECK(left.left >= 400);
    CHECK(left.left < 410);
    CHECK(right.right <= 400);
    CHECK(right.right > 390);
    CHECK(std::abs(center.left + center.right - 800) <= 2);
}

TEST_CASE("text moves by parts of a pixel along the line") {
    const auto center_of = [](const Canvas& canvas) {
        const PixelView pixels = canvas.pixels();
        double sum = 0, weight = 0;
        for (int y = 0; y < pixels.height; ++y)
            for (int x = 0; x < pixels.width; ++x) {
                const double level = pixels.data[y * pixels.stride + x] & 0xFF;
                sum += level * x;
                weight += level;
            }
        return sum / weight;
    };
    const double start = center_of(drawn("lilt", style_of(24), {50, 150}));
    for (const double shift : {0.25, 0.4, 0.61, 1.3})
        // Letters lie on eighths of a pixel.
        CHECK(center_of(drawn("lilt", style_of(24), {50 + shift, 150})) - start ==
              doctest::Approx(shift).epsilon(0.0).scale(1.0).epsilon(0.08));
}

TEST_CASE("markup is followed, and drawn as it stands where it is ill-formed") {
    const TextStyle style = style_of(30);
    CHECK(pixels_of(drawn("a < b & c", style)) == pixels_of(drawn("a &lt; b &amp; c", style)));
    CHECK(pixels_of(drawn("<b>x", style)) == pixels_of(drawn("&lt;b&gt;x", style)));
    CHECK(measure_text("v<sup>2</sup>", style).width < measure_text("v2", style).width);
    CHECK(ink_of(drawn("<span foreground='#000000'>x</span>", style)).amount == 0);
    const std::string awkward = R"(<a href="x">'&'</a>)";
    CHECK(pixels_of(drawn(escape_markup(awkward), style)) != pixels_of(drawn("", style)));
    CHECK(measure_text(escape_markup("<i>&</i>"), style).width >
          measure_text("<i>&amp;</i>", style).width);
}

TEST_CASE("a line too long for its place ends in an ellipsis") {
    TextStyle style = style_of(24);
    const std::string text = "A very long title that goes on and on beyond its place";
    style.max_width = 300;
    CHECK(measure_text(text, style).width <= 300);
    CHECK(measure_text(text, style).width > 250);
    CHECK(measure_text("short", style).width == measure_text("short", style_of(24)).width);
}

TEST_CASE("letters that Inter lacks, empty and broken text do no harm") {
    const TextStyle style = style_of(24);
    CHECK(measure_text("气体 العربية हिन्दी 🎱", style).width > 50);
    drawn("气体 العربية हिन्दी 🎱", style);
    CHECK(ink_of(drawn("", style)).amount == 0);
    CHECK(ink_of(drawn("one\ntwo", style)).bottom <= 160);
    drawn("\xFF\xC0 broken \xE2\x82", style);
    CHECK(measure_text(std::string(2000, 'm'), style).width > 20000);
}

TEST_CASE("text is the same in every thread") {
    const auto picture = [] {
        Canvas canvas({900, 400});
        for (int i = 0; i < 40; ++i)
            draw_text(
                canvas, {7.3 * i, 20 + 9.0 * i},
                "mean <i>energy</i> ⟨E⟩ " + std::to_string(i * 1237) + (i % 9 == 0 ? "气" : ""),
                style_of(14 + i % 5 * 7, 300 + 100 * (i % 5)));
        return pixels_of(canvas);
    };
    const std::vector<std::uint32_t> expected = picture();
    std::vector<std::vector<std::uint32_t>> found(4);
    std::vector<std::thread> threads;
    for (auto& pixels : found)
        threads.emplace_back([&pixels, &picture] {
            picture();
            pixels = picture();
        });
    for (std::thread& thread : threads) thread.join();
    for (const auto& pixels : found) CHECK(pixels == expected);
}

TEST_CASE("what is remembered does not show") {
    const std::vector<std::uint32_t> before = pixels_of(drawn("12 345", style_of(37)));
    for (int i = 0; i < 700; ++i) drawn(std::to_string(i), style_of(10 + i % 90));
    CHECK(pixels_of(drawn("12 345", style_of(37))) == before);
}

TEST_CASE("words are broken where their script allows it, no line is too long, and none is lost") {
    TextStyle style;
    style.size = 20;
    style.max_width = 150;
    const auto joined = [&](const std::string& words, const std::string& with) {
        TextStyle whole = style;
        whole.max_width = 0;
        std::string all;
        for (const std::string& line : wrapped(words, style, 99)) {
            CHECK(measure_text(escape_markup(line), whole).width <= 150);
            all += (all.empty() ? "" : with) + line;
        }
        return all;
    };
    const std::string english = "Light & heavy disks share energy, not speed";
    CHECK(wrapped(english, style, 9).size() > 2);
    CHECK(joined(english, " ") == english);
    CHECK(wrapped(english, style, 1) == std::vector<std::string>{english});
    CHECK(wrapped(english, style, 2).size() == 2);
    const std::string arabic = "الغاز المثالي وتوزيع السرعات عند الاتزان";
    CHECK(wrapped(arabic, style, 9).size() > 2);
    CHECK(joined(arabic, " ") == arabic);
    // No spaces: Chinese breaks between letters, a word that is too long within it.
    const std::string chinese = "一个热粒子在许多冷粒子之间一个热粒子";
    CHECK(wrapped(chinese, style, 9).size() > 1);
    CHECK(joined(chinese, "") == chinese);
    CHECK(joined("Unbreakablewordlongerthanitsline", "") == "Unbreakablewordlongerthanitsline");
    CHECK(wrapped("", style, 3).empty());
}

TEST_CASE("letters that no font has are found") {
    CHECK(missing_letters("Gas: ⟨v²⟩ < 3 & π 'ä' \"Ω\"").empty());
    CHECK(missing_letters("الغاز المثالي").empty());  // DejaVu Sans has them, Inter does not
    // U+2FE0 is no letter and never will be one that fonts have.
    CHECK(missing_letters("a\u2fe0b\u2fe0") == std::vector<std::string>{"\u2fe0"});
}

TEST_CASE("words that are left out are noted without their markup, whatever letters they have") {
    const TextLog log;
    leave_out("<i>D</i> = " + escape_markup("3 < 4 & the piston's \"own\""));
    CHECK(log.left_out == std::vector<std::string>{"D = 3 < 4 & the piston's \"own\""});
}

TEST_CASE("a halo parts letters from what is behind them, and ends there") {
    TextStyle style = style_of(100);
    style.halo = 6.0;
    Canvas canvas({900, 220});
    canvas.fill_all(white);
    draw_text(canvas, {50, 150}, "H", style);
    const Ink letter = ink_of(drawn("H", style_of(100)));
    const PixelView pixels = canvas.pixels();
    const auto level = [&](int x, int y) { return pixels.data[y * pixels.stride + x] & 0xFF; };
    const int middle = (letter.top + letter.bottom) / 2;
    CHECK(level(letter.left + 3, middle) == 0xFF);  // white on white, but for
    CHECK(level(letter.left - 3, middle) == 0x00);
    CHECK(level(letter.left - 9, middle) == 0xFF);
    CHECK(level((letter.left + letter.right) / 2, letter.top) == 0xFF);  // no plate
}
