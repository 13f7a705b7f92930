#include "draw/formula/text_font.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <tuple>

#include "draw/formula/ink.h"
#include "draw/text.h"

namespace carom::formula {
namespace {

constexpr double lean = 0.165;  // horizontal over vertical, of slanted letters

// The ink of a line of markup at an em of 1. Each thread caches those that it has measured.
const Ink& ink_at_one(const std::string& markup, int weight, const FontFamilies* fonts) {
    thread_local std::map<std::tuple<std::string, int, const FontFamilies*>, Ink> known;
    const auto [entry, is_new] = known.try_emplace({markup, weight, fonts});
    if (is_new) {
        constexpr double size = 1000.0;
        const Ink ink = ink_of(markup, {.size = size,
                                        .weight = weight,
                                        .tabular = false,
                                        .fonts = fonts,
                                        .lettering = Lettering::formulas});
        entry->second = {
            ink.advance / size,
            {ink.rect.x / size, ink.rect.y / size, ink.rect.width / size, ink.rect.height / size}};
    }
    return entry->second;
}

Metrics scaled(Metrics m, double by) {
    for (double* length : {&m.width, &m.height, &m.depth, &m.italic, &m.skew}) *length *= by;
    return m;
}

// A sign that the typeface lacks: its width, and its extent above and below the axis.
struct Drawn {
    double width, half_height;
};

std::optional<Drawn> drawn_sign(std::string_view text) {
    if (text == "⟨" || text == "⟩") return Drawn{0.34, 0.48};
    if (text == "≡") return Drawn{0.66, 0.2};
    if (text == "≪" || text == "≫") return Drawn{0.86, 0.24};
    if (text == "∝") return Drawn{0.72, 0.19};
    return std::nullopt;
}

std::vector<Point> arc(double from_x, double to_x, double power) {
    std::vector<Point> points;
    constexpr int steps = 24;
    for (int i = 0; i <= steps; ++i) {
        const double t = 2.0 * i / steps - 1.0;
        points.push_back({to_x + (from_x - to_x) * std::pow(std::abs(t), power), 0.5 * (1.0 + t)});
    }
    return points;
}

std::vector<Point> loop() {
    std::vector<Point> points;
    constexpr int steps = 40;
    constexpr double open = 0.62;
    for (int i = 0; i <= steps; ++i) {
        const double t = open + (2.0 * std::numbers::pi - 2.0 * open) * i / steps;
        points.push_back({0.5 + 0.42 * std::cos(t), 0.5 - std::sin(t) * std::cos(t)});
    }
    return points;
}

using Lines = std::vector<std::vector<Point>>;

Lines sign_lines(std::string_view text, double tall) {
    const double power = tall > 1.6 ? 3.0 : 2.0;
    if (text == "(") return {arc(0.8, 0.25, power)};
    if (text == ")") return {arc(0.2, 0.75, power)};
    if (text == "[") return {{{0.8, 0.0}, {0.35, 0.0}, {0.35, 1.0}, {0.8, 1.0}}};
    if (text == "]") return {{{0.2, 0.0}, {0.65, 0.0}, {0.65, 1.0}, {0.2, 1.0}}};
    if (text == "|") return {{{0.5, 0.0}, {0.5, 1.0}}};
    if (text == "⟨") return {{{0.8, 0.0}, {0.25, 0.5}, {0.8, 1.0}}};
    if (text == "⟩") return {{{0.2, 0.0}, {0.75, 0.5}, {0.2, 1.0}}};
    if (text == "≡")
        return {{{0.1, 0.0}, {0.9, 0.0}}, {{0.1, 0.5}, {0.9, 0.5}}, {{0.1, 1.0}, {0.9, 1.0}}};
    if (text == "≪")
        return {{{0.5, 0.0}, {0.08, 0.5}, {0.5, 1.0}}, {{0.92, 0.0}, {0.5, 0.5}, {0.92, 1.0}}};
    if (text == "≫")
        return {{{0.08, 0.0}, {0.5, 0.5}, {0.08, 1.0}}, {{0.5, 0.0}, {0.92, 0.5}, {0.5, 1.0}}};
    if (text == "∝") return {loop()};
    return {};
}

// The width of an accent, and its vertical extent above the height of the letters that it is made
// for.
struct AccentShape {
    double width, from, to;
};

AccentShape accent_shape(std::string_view name) {
    if (name == "bar") return {0.44, 0.13, 0.13};
    if (name == "hat") return {0.40, 0.11, 0.25};
    if (name == "vec") return {0.54, 0.09, 0.25};
    return {0.09, 0.16, 0.16};
}

Lines accent_lines(std::string_view name) {
    if (name == "bar") return {{{0.0, 0.0}, {1.0, 0.0}}};
    if (name == "hat") return {{{0.0, 1.0}, {0.5, 0.0}, {1.0, 1.0}}};
    if (name == "vec") return {{{0.0, 0.5}, {1.0, 0.5}}, {{0.72, 0.0}, {1.0, 0.5}, {0.72, 1.0}}};
    return {{{0.0, 0.0}, {0.01, 0.0}}};
}

}  // namespace

double scale_of(Size size) { return size == Size::text ? 1.0 : size == Size::script ? 0.72 : 0.6; }

std::string markup_of(const Letter& letter) {
    const std::string text = letter.text == "∼" ? "~" : letter.text;
    return letter.is_slanted ? "<i>" + escape_markup(text) + "</i>" : escape_markup(text);
}

double lowering_of(const Letter& letter, const FontFamilies* fonts) {
    if (letter.text != "′") return 0.0;
    const Rect ink = ink_at_one(letter.text, 400, fonts).rect;
    return -(ink.y + ink.height);
}

TextFont::TextFont(int weight, const FontFamilies* fonts) : weight_(weight), fonts_(fonts) {
    const auto ink = [&](const char* letter) { return ink_at_one(letter, weight, fonts).rect; };
    x_height_ = -ink("x").y;
    digit_height_ = -ink("1").y;
    const Rect minus = ink("−");
    axis_ = -(minus.y + 0.5 * minus.height);
    rule_ = 0.8 * minus.height;
}

// TeX's values fit Computer Modern; these have the same ratio to Inter's larger letters as TeX's to
// those of Computer Modern.
Lengths TextFont::lengths(Size size) const {
    const double s = scale_of(size), up = x_height_ / 0.430555 * s;
    constexpr double script = 0.72;
    return {.x_height = s * x_height_,
            .quad = s,
            .num1 = s * (axis_ + 0.42),
            .num2 = s * (axis_ + 0.18),
            .denom1 = s * (digit_height_ + 0.26 - axis_),
            .denom2 = s * (script * digit_height_ + 0.15 - axis_),
            .sup1 = 0.413 * up,
            .sup2 = 0.363 * up,
            .sup3 = 0.289 * up,
            .sub1 = 0.15 * up,
            .sub2 = 0.247 * up,
            .sup_drop = 0.386 * s,
            .sub_drop = 0.05 * s,
            .axis = s * axis_};
}

CommonLengths TextFont::common() const {
    return {.rule = rule_,
            .gap = 0.045,
            .limit_gap = {0.11, 0.17, 0.2, 0.6, 0.06},
            .script_space = 0.05,
            .no_bracket = 0.1};
}

Metrics TextFont::letter(const Letter& letter, Size size) const {
    const double s = scale_of(size);
    if (const auto drawn = drawn_sign(letter.text))
        return {s * drawn->width, s * (axis_ + drawn->half_height),
                s * (drawn->half_height - axis_)};
    const Ink& ink = ink_at_one(markup_of(letter), weight_, fonts_);
    const double low = lowering_of(letter, fonts_);
    Metrics m{.width = ink.advance,
              .height = -ink.rect.y - low,
              .depth = std::max(0.0, ink.rect.y + ink.rect.height + low)};
    if (letter.is_slanted) {
        m.italic = std::max(0.0, ink.rect.x + ink.rect.width - ink.advance + 0.02);
        m.skew = 0.5 * lean * m.height;
    }
    return scaled(m, s);
}

std::optional<double> TextFont::kern(const Letter& first, const Letter& second, Size size) const {
    if (first.is_slanted != second.is_slanted || drawn_sign(first.text) ||
        drawn_sign(second.text) || first.text == "′")
        return std::nullopt;
    const auto advance = [&](const std::string& text) {
        return ink_at_one(markup_of({text, first.is_slanted}), weight_, fonts_).advance;
    };
    return scale_of(size) *
           (advance(first.text + second.text) - advance(first.text) - advance(second.text));
}

int TextFont::weight_of_large() const {
    return std::max(100, static_cast<int>(std::lround(weight_ / scale_of_large / 100.0)) * 100);
}

Metrics TextFont::large(const Letter& operation) const {
    const Ink& ink = ink_at_one(markup_of(operation), weight_of_large(), fonts_);
    return scaled({.width = ink.advance,
                   .height = -ink.rect.y,
                   .depth = ink.rect.y + ink.rect.height,
                   .italic = operation.text == "∫" ? 0.08 : 0.0},
                  scale_of_large);
}

Metrics TextFont::bracket(const Letter& bracket, double least, Size size) const {
    const double s = scale_of(size), total = std::max(least, 0.96 * s);
    double width = 0.34 * s + 0.05 * std::min(total, 3.0);
    if (bracket.text == "|") width = 0.28 * s;
    if (bracket.text == "[" || bracket.text == "]") width = 0.38 * s;
    return {.width = width, .height = total};
}

Metrics TextFont::root(double least, Size size) const {
    return {.width = scale_of(size) * 0.52 + 0.06 * std::min(least, 3.0),
            .height = rule_,
            .depth = least - rule_};
}

Metrics TextFont::accent(const std::string& name, Size size) const {
    const AccentShape shape = accent_shape(name);
    return scaled({.width = shape.width, .height = x_height_ + shape.to + 0.5 * rule_},
                  scale_of(size));
}

double TextFont::accent_base(const std::string&, Size size) const {
    return scale_of(size) * x_height_;
}

Lines lines_of(const Piece& piece) {
    if (piece.of == Piece::Of::root) return {{{0.08, 0.62}, {0.26, 0.55}, {0.5, 1.0}, {1.0, 0.0}}};
    if (piece.of == Piece::Of::accent) {
        const AccentShape shape = accent_shape(piece.letter.text);
        const double s = scale_of(piece.size), share = s * (shape.to - shape.from) / piece.height;
        Lines lines = accent_lines(piece.letter.text);
        for (auto& line : lines)
            for (Point& point : line) point.y *= share;
        return lines;
    }
    if (piece.of == Piece::Of::bracket || drawn_sign(piece.letter.text))
        return sign_lines(piece.letter.text, piece.height + piece.depth);
    return {};
}

}  // namespace carom::formula
