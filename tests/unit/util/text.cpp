#include "util/text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

using namespace carom;

namespace {

// By its definition: the least of all ways from one end on.
std::size_t slow_edit_distance(std::string_view a, std::string_view b) {
    if (a.empty() || b.empty()) return a.size() + b.size();
    std::size_t least =
        std::min({1 + slow_edit_distance(a.substr(1), b), 1 + slow_edit_distance(a, b.substr(1)),
                  (a[0] == b[0] ? 0U : 1U) + slow_edit_distance(a.substr(1), b.substr(1))});
    if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0])
        least = std::min(least, 1 + slow_edit_distance(a.substr(2), b.substr(2)));
    return least;
}

}  // namespace

TEST_CASE("three significant digits read as on an axis") {
    CHECK(three_digits(0.0) == "0");
    CHECK(three_digits(0.05) == "0.0500");
    CHECK(three_digits(2.2388) == "2.24");
    CHECK(three_digits(449.97) == "450");
    CHECK(three_digits(12345.0) == "12345");
    CHECK(three_digits(-1.5) == "\u22121.50");
    CHECK(three_digits(1.234e-7) == "1.23×10⁻⁷");
    CHECK(three_digits(6.02e23) == "6.02×10²³");
    CHECK(three_digits(1.0 / 0.0) == "–");
    CHECK(three_digits(9.996) == "10.0");
    CHECK(three_digits(0.9996) == "1.00");
}

TEST_CASE("a number with its standard error has the decimals that show two digits of the error") {
    CHECK(with_error(0.12346, 0.0041) == "0.1235 ± 0.0041");
    CHECK(with_error(12.34, 3.0) == "12.3 ± 3.0");
    CHECK(with_error(1234.4, 61.7) == "1234 ± 62");
    CHECK(with_error(-1.5, 0.25) == "\u22121.50 ± 0.25");
    CHECK(with_error(-0.004, 0.25) == "0.00 ± 0.25");
    CHECK(with_error(1.5, 0.0) == "1.50");
    CHECK(with_error(1.5, std::nan("")) == "1.50");
    CHECK(with_error(2.5e7, 1e6) == "2.50×10⁷ ± 1.00×10⁶");
    CHECK(with_error(1e-8, 1e-10) == "1.00×10⁻⁸ ± 1.00×10⁻¹⁰");
}

TEST_CASE("three digits of powers that no double holds") {
    CHECK(three_digits_of_power(-2.0) == three_digits(0.01));
    CHECK(three_digits_of_power(std::log10(2.5e-51)) == "2.50×10\u207B\u2075\u00B9");
    CHECK(three_digits_of_power(-500.0 + std::log10(3.14)) == "3.14×10\u207B\u2075\u2070\u2070");
    CHECK(three_digits_of_power(-400.0 - 1e-6) == "1.00×10\u207B\u2074\u2070\u2070");
    CHECK(three_digits_of_power(400.0) == "1.00×10\u2074\u2070\u2070");
    CHECK(three_digits_of_power(-std::numeric_limits<double>::infinity()) == "0");
}

TEST_CASE("what is half-way between two digits is rounded away from 0, round-off or not") {
    // The same number on two ways: 0.7525 is not a double, and the sums end on both sides of it.
    const double below = 0.75249999999999994671, above = 0.75250000000000005773;
    CHECK(three_digits(below) == "0.753");
    CHECK(three_digits(above) == "0.753");
    CHECK(three_digits(-below) == "\u22120.753");
    CHECK(three_digits(0.752499) == "0.752");
    CHECK(off_the_tie(0.0) == 0.0);
}

TEST_CASE("UTF-8 is told from other bytes") {
    CHECK(is_utf8("Bälle N₂ 気体 🎱"));
    CHECK_FALSE(is_utf8("\xC0\xAF"));          // overlong
    CHECK_FALSE(is_utf8("\xED\xA0\x80"));      // surrogate
    CHECK_FALSE(is_utf8("\xF4\x90\x80\x80"));  // above U+10FFFF
    CHECK_FALSE(is_utf8("caf\xE9"));           // Latin-1
    CHECK(code_points("気体") == 2);
}

TEST_CASE("bytes that are not UTF-8 are replaced one by one") {
    CHECK(as_utf8("気体 N₂") == "気体 N₂");
    CHECK(as_utf8("caf\xE9, \xED\xA0\x80.") == "caf\uFFFD, \uFFFD\uFFFD\uFFFD.");
    CHECK(as_utf8("\xE6\xB0") == "\uFFFD\uFFFD");
}

TEST_CASE("what is counted is one, or several") {
    CHECK(counted(0, "frame") == "0 frames");
    CHECK(counted(1, "frame") == "1 frame");
    CHECK(counted(30, "frame") == "30 frames");
}

TEST_CASE("the nearest spelling is that of a slow search") {
    std::mt19937 random(1);
    const auto word = [&](std::size_t longest) {
        std::string text;
        for (std::size_t left = random() % (longest + 1); left > 0; --left)
            text += "abc"[random() % 3];
        return text;
    };
    for (int trial = 0; trial < 300; ++trial) {
        const std::string given = word(7);
        std::vector<std::string> candidates;
        for (int k = 0; k < 5; ++k) candidates.push_back(word(7));
        const std::string* best = nullptr;
        std::size_t least = std::max<std::size_t>(1, given.size() / 3) + 1;
        for (const std::string& one : candidates)
            if (const std::size_t its = slow_edit_distance(given, one);
                given.size() > 1 && its < least) {
                least = its;
                best = &one;
            }
        const auto nearest = nearest_spelling(given, candidates);
        CAPTURE(given);
        REQUIRE(nearest.has_value() == (best != nullptr));
        if (best != nullptr) CHECK(*nearest == *best);
    }
}

TEST_CASE("the nearest spelling is offered only when it is near") {
    const std::vector<std::string> keys{"count", "radius", "mass", "speed", "velocity"};
    CHECK(nearest_spelling("raduis", keys) == "radius");
    CHECK(nearest_spelling("sped", keys) == "speed");
    CHECK_FALSE(nearest_spelling("temperature", keys).has_value());
}

TEST_CASE("integers are grouped by thin spaces, from five digits on") {
    CHECK(grouped(999) == "999");
    CHECK(grouped(9999) == "9999");
    CHECK(grouped(10000) == "10\u2009000");
    CHECK(grouped(1234567) == "1\u2009234\u2009567");
    CHECK(grouped(-10000) == "\u221210\u2009000");
    CHECK(grouped(-1000) == "\u22121000");
}

TEST_CASE("how deep a text of JSON nests is found without its strings") {
    using carom::nests_deeper;
    CHECK(!nests_deeper("", 0));
    CHECK(!nests_deeper(R"([{"a": [1]}, [], {}, [2]])", 3));
    CHECK(nests_deeper(R"([{"a": [1]}, [], {}, [2]])", 2));
    CHECK(!nests_deeper(R"(["[[[[", "\"[[[", "\\", {}])", 2));
    CHECK(nests_deeper(R"(["\\", [[1]]])", 2));
    CHECK(nests_deeper(std::string(1 << 20, '['), 32));
}

TEST_CASE("words of strangers are made printable, all else stays") {
    using carom::printable;
    for (const char* plain : {"", "a b\tc", "é 𝛼 中 שלום", "\u2027\u202F\u2065\u206A\u200D"})
        CHECK(printable(plain) == plain);
    for (const char* odd : {"\n", "\r", "\x1b", "\x7f", "\u009b", "\x9b", "\u061C", "\u200E",
                            "\u200F", "\u2028", "\u202A", "\u202E", "\u2066", "\u2069"})
        CHECK(printable("a" + std::string(odd) + "b") == "a\uFFFDb");
}

TEST_CASE("control characters are C0, delete and C1") {
    using carom::is_control;
    CHECK(is_control("\n"));
    CHECK(is_control(std::string_view{"\0", 1}));
    CHECK(is_control("\x7F"));
    CHECK(is_control("\xC2\x80"));
    CHECK(is_control("\xC2\x9F"));
    CHECK(!is_control("\xC2\xA0"));
    CHECK(!is_control(" "));
    CHECK(!is_control("é"));
}

TEST_CASE("lists are words") {
    CHECK(listed({}).empty());
    CHECK(listed(std::vector<std::string>{"a"}) == "a");
    CHECK(listed(std::vector<std::string>{"a", "b"}, "or") == "a or b");
    CHECK(listed(std::vector<std::string>{"a", "b", "c"}, "and", "`") == "`a`, `b` and `c`");
}

TEST_CASE("words begin with a large letter, also one with an accent") {
    CHECK(capitalised("density") == "Density");
    CHECK(capitalised("écoulement suivant x") == "Écoulement suivant x");
    CHECK(capitalised("öffnen") == "Öffnen");
    CHECK(capitalised("÷ 2") == "÷ 2");
    CHECK(capitalised("x") == "X");
}

TEST_CASE("only ASCII letters become small") {
    CHECK(lower("Off, ON and É") == "off, on and É");
    CHECK(lower("").empty());
}
