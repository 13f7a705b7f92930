// Tests the reader of SVG, with the notation of each version of Cairo, and the reading of numbers
// in labels.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "readback/alphabet.h"
#include "support/svg_picture.h"

using namespace carom::test;

namespace {

const std::string head =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="90px" height="50px">)svg";

// A bar, a translated line and a letter.
const std::string cairo_1_16 = head + R"svg(<defs><g><symbol overflow="visible" id="glyph0-1">
<path style="stroke:none;" d="M 0 0 L 2 0 L 2 -4 Z M 0 0 "/></symbol></g></defs><g id="surface1">
<path style=" stroke:none;fill-rule:nonzero;fill:rgb(100%,0%,20%);fill-opacity:0.5;" d="M 10 20 L 14 20 L 14 30 L 10 30 Z M 10 20 "/>
<path style="fill:none;stroke-width:1.5;stroke:rgb(0%,0%,0%);stroke-opacity:1;" d="M 1 2 L 3 4 " transform="matrix(1,0,0,1,5,0)"/>
<g style="fill:rgb(0%,0%,0%);fill-opacity:1;"><use xlink:href="#glyph0-1" x="7" y="9"/></g></g></svg>)svg";
const std::string cairo_1_18 = head + R"svg(<defs><g><g id="glyph-0-1">
<path d="M 0 0 L 2 0 L 2 -4 Z M 0 0 "/></g></g></defs>
<path fill-rule="nonzero" fill="rgb(100%, 0%, 20%)" fill-opacity="0.5" d="M 10 20 L 14 20 L 14 30 L 10 30 Z M 10 20 "/>
<path fill="none" stroke-width="1.5" stroke="rgb(0%, 0%, 0%)" stroke-opacity="1" d="M 1 2 L 3 4 " transform="matrix(1, 0, 0, 1, 5, 0)"/>
<g fill="rgb(0%, 0%, 0%)" fill-opacity="1"><use xlink:href="#glyph-0-1" x="7" y="9"/></g></svg>)svg";

}  // namespace

TEST_CASE("shapes and letters are read in the spelling of each Cairo") {
    for (const std::string& document : {cairo_1_16, cairo_1_18}) {
        const SvgPicture picture = svg_picture(document);
        CHECK(picture.width == 90.0);
        REQUIRE(picture.shapes.size() == 2);
        const auto bar = picture.shapes[0].rectangle();
        REQUIRE(bar);
        CHECK(bar->left == 10.0);
        CHECK(bar->bottom == 30.0);
        CHECK(picture.shapes[0].paint == Paint{255.0, 0.0, 51.0, 0.5});
        CHECK(picture.shapes[1].is_stroke);
        CHECK(picture.shapes[1].width == 1.5);
        CHECK(picture.shapes[1].corners().at(1).x == 8.0);
        REQUIRE(picture.texts.size() == 1);
        CHECK(picture.texts[0].edges().right == 9.0);
        CHECK(picture.texts[0].edges().top == 5.0);
    }
}

TEST_CASE("what the reader of SVG does not know is refused") {
    CHECK_THROWS_AS(
        svg_picture(head + R"svg(<path fill="rgb(0,0,0)" d = "M 1 1 Q 2 2 3 3" / > </ svg>) "),
        std::runtime_error);
    CHECK_THROWS_AS(svg_picture(head + R"svg(<g transform="rotate(3)"/></svg>)svg"),
        std::runtime_error);
    CHECK_THROWS_AS(svg_picture(head + R"svg(<image width="3"/></svg>)svg"), std::runtime_error);
}

TEST_CASE("labels are read as numbers") {
    CHECK(number_in("0.25") == 0.25);
    CHECK(number_in("−12 500") == -12500.0);
    CHECK(std::abs(*number_in("10⁻¹²") / 1e-12 - 1.0) < 1e-12);
    CHECK(std::abs(*number_in("2.5 × 10³") / 2500.0 - 1.0) < 1e-12);
    for (const std::string words : {"", "t", "3 disks", "−", "10 × x"}) CHECK(!number_in(words));
    CHECK(rounding_of("0.25") == doctest::Approx(0.005));
    CHECK(rounding_of("12") == 0.5);
}
