#include "draw/formula/words.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "draw/formula/ink.h"
#include "draw/formula/text_font.h"

namespace carom {
namespace {

using formula::Box;
using formula::Piece;
using formula::Span;
using formula::Standing;
using formula::TextFont;

// The layout of a formula, cached for each thread.
const Box& box_of(const std::string& tex, const TextStyle& style, Standing standing) {
    using Key = std::tuple<std::string, int, const FontFamilies*, Standing>;
    thread_local std::map<Key, Box> known;
    if (known.size() > 200) known.clear();
    const auto [entry, is_new] = known.try_emplace({tex, style.weight, style.fonts, standing});
    if (is_new)
        entry->second =
            formula::box_of(formula::parsed(tex), TextFont(style.weight, style.fonts), standing);
    return entry->second;
}

Standing standing_of(const std::string& words) {
    return is_formula_alone(words) ? Standing::alone : Standing::in_line;
}

TextStyle without_place(TextStyle style) {
    style.align = Align::left;
    style.max_width = 0.0;
    return style;
}

// Calls `words(markup, x)` and `formula(box, x)` for the parts of a line; returns its extent.
TextExtent walk(const std::string& line, const TextStyle& style,
                const std::function<void(const std::string&, double)>& words,
                const std::function<void(const Box&, double)>& formula) {
    TextExtent extent;
    const Standing standing = standing_of(line);
    for (const Span& span : formula::spans_of(line)) {
        TextExtent its;
        if (span.is_formula) {
            const Box& box = box_of(span.text, style, standing);
            if (formula) formula(box, extent.width);
            its = {box.width * style.size, box.height * style.size, box.depth * style.size};
        } else {
            const std::string markup = escape_markup(span.text);
            if (words) words(markup, extent.width);
            its = measure_text(markup, style);
        }
        extent.width += its.width;
        extent.ascent = std::max(extent.ascent, its.ascent);
        extent.descent = std::max(extent.descent, its.descent);
    }
    return extent;
}

// The plain words, if the text contains no formula.
std::optional<std::string> plain(const std::string& words) {
    if (words.find('$') == std::string::npos) return words;
    const std::vector<Span> spans = formula::spans_of(words);
    if (spans.empty()) return "";
    if (spans.size() > 1 || spans.front().is_formula) return std::nullopt;
    return spans.front().text;
}

void draw_lines(Canvas& canvas, const Rect& rect, const Piece& piece, double thickness,
                Color color) {
    for (const std::vector<Point>& line : formula::lines_of(piece)) {
        std::vector<Point> points;
        for (const Point& point : line)
            points.push_back({rect.x + point.x * rect.width, rect.y + point.y * rect.height});
        canvas.stroke_path(points, thickness, color);
    }
}

// On a raster a rule is a whole number of pixels thick, and aligned to pixels.
void draw_rule(Canvas& canvas, Rect rect, Color color) {
    if (canvas.is_raster()) {
        const double thickness = std::max(1.0, std::round(rect.height));
        rect.y = std::round(rect.y + 0.5 * (rect.height - thickness));
        rect.height = thickness;
    }
    canvas.fill(rect, color);
}

}  // namespace

void draw_formula(Canvas& canvas, Point at, const Box& box, const TextStyle& style) {
    const TextFont font(style.weight, style.fonts);
    const double em = style.size, rule = font.common().rule * em;
    for (const Piece& piece : box.pieces) {
        const Point origin{at.x + em * piece.at.x, at.y + em * piece.at.y};
        const Rect rect{origin.x, origin.y - em * piece.height, em * piece.width,
                        em * (piece.height + piece.depth)};
        if (piece.of == Piece::Of::rule) {
            draw_rule(canvas, rect, style.color);
            continue;
        }
        if (!formula::lines_of(piece).empty()) {
            // The radical sign ends where its rule begins.
            const bool is_root = piece.of == Piece::Of::root;
            const double inset = is_root || piece.of == Piece::Of::bracket ? 0.5 * rule : 0.0;
            draw_lines(
                canvas,
                {rect.x, rect.y + inset, rect.width, rect.height - (is_root ? inset : 2.0 * inset)},
                piece, rule, style.color);
            continue;
        }
        TextStyle its = without_place(style);
        its.tabular = false;
        its.lettering = Lettering::formulas;
        its.size = em * formula::scale_of(piece.size);
        if (piece.of == Piece::Of::large) {
            its.size = em * formula::scale_of_large;
            its.weight = font.weight_of_large();
        }
        draw_text(canvas,
                  {origin.x, origin.y + its.size * formula::lowering_of(piece.letter, style.fonts)},
                  formula::markup_of(piece.letter), its);
    }
}

std::string words_of_text(const std::string& text) {
    std::string words;
    for (const char letter : text) {
        if (letter == '$') words += '\\';
        words += letter;
    }
    return words;
}

TextExtent draw_words(Canvas& canvas, Point at, const std::string& words, const TextStyle& style) {
    if (const auto text = plain(words)) return draw_text(canvas, at, escape_markup(*text), style);
    const TextExtent extent = measure_words(words, style);
    if (style.align == Align::center) at.x -= 0.5 * extent.width;
    if (style.align == Align::right) at.x -= extent.width;
    const TextStyle own = without_place(style);
    const LineInPieces one(
        {words,
         style.size,
         {at.x, at.y - extent.ascent, extent.width, extent.ascent + extent.descent}});
    return walk(
        words, own,
        [&](const std::string& markup, double x) {
            draw_text(canvas, {at.x + x, at.y}, markup, own);
        },
        [&](const Box& box, double x) {
            draw_formula(canvas, {at.x + x, at.y}, box, own);
        });
}

TextExtent measure_words(const std::string& words, const TextStyle& style) {
    if (const auto text = plain(words)) return measure_text(escape_markup(*text), style);
    return walk(words, without_place(style), {}, {});
}

LineHeight line_height_of(const std::string& words, const TextStyle& style, double usual) {
    constexpr double gap_alone = 0.3, gap_in_line = 0.1;  // above and below formulae, sizes
    LineHeight height{style.size, usual * style.size};
    if (words.find('$') == std::string::npos) return height;
    const TextExtent extent = measure_words(words, style);
    const double gap = (is_formula_alone(words) ? gap_alone : gap_in_line) * style.size;
    const double below = std::max(height.all - height.above, extent.descent + gap);
    height.above = std::max(height.above, extent.ascent + gap);
    return {height.above, height.above + below};
}

bool is_formula_alone(const std::string& words) {
    if (words.find('$') == std::string::npos) return false;
    const std::vector<Span> spans = formula::spans_of(words);
    return spans.size() == 1 && spans.front().is_formula;
}

// Puts as many whole words as fit on each line; a formula, with any text directly attached to it,
// is one word.
std::vector<std::string> wrapped_words(const std::string& words, const TextStyle& style,
                                       std::size_t most) {
    if (words.find('$') == std::string::npos) return wrapped(words, style, most);
    std::vector<std::string> chunks{""};
    bool is_formula = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool is_escaped = words[i] == '\\' && i + 1 < words.size() && words[i + 1] == '$';
        if (words[i] == ' ' && !is_formula) {
            if (!chunks.back().empty()) chunks.emplace_back();
            continue;
        }
        if (words[i] == '$') is_formula = !is_formula;
        chunks.back() += words[i];
        if (is_escaped) chunks.back() += words[++i];
    }
    const TextStyle uncut = without_place(style);
    std::vector<std::string> lines;
    for (const std::string& chunk : chunks) {
        if (chunk.empty()) continue;
        const bool fits = !lines.empty() &&
                          measure_words(lines.back() + " " + chunk, uncut).width <= style.max_width;
        if (!lines.empty() && (fits || lines.size() == most))
            lines.back() += " " + chunk;
        else
            lines.push_back(chunk);
    }
    return lines;
}

}  // namespace carom
