#include "support/touching.h"

#include <algorithm>
#include <cmath>

namespace carom::test {
namespace {

Edges less(const Edges& box, double by) {
    return {box.left + by, box.top + by, box.right - by, box.bottom - by};
}

bool is_empty(const Edges& box) { return !(box.left < box.right && box.top < box.bottom); }

bool contains(const Edges& box, Spot p) {
    return p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom;
}

Edges common(const Edges& a, const Edges& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

// A path as straight lines.
std::vector<Spot> flattened(const Outline& outline) {
    constexpr int steps = 8;
    std::vector<Spot> corners;
    std::size_t next = 0;
    for (const char command : outline.commands) {
        if (command == 'Z') {
            if (!corners.empty()) corners.push_back(corners.front());
        } else if (command != 'C') {
            corners.push_back(outline.points[next++]);
        } else {
            const Spot a = corners.back(), b = outline.points[next], c = outline.points[next + 1],
                       d = outline.points[next + 2];
            next += 3;
            for (int i = 1; i <= steps; ++i) {
                const double t = double(i) / steps, s = 1.0 - t;
                const auto at = [&](double Spot::*x) {
                    return s * s * s * (a.*x) + 3 * s * s * t * (b.*x) + 3 * s * t * t * (c.*x) +
                           t * t * t * (d.*x);
                };
                corners.push_back({at(&Spot::x), at(&Spot::y)});
            }
        }
    }
    return corners;
}

// Whether a segment passes through the inside of a box (Liang and Barsky).
bool crosses(const Edges& box, Spot from, Spot to) {
    double first = 0.0, last = 1.0;
    const auto cut = [&](double start, double step, double low, double high) {
        if (step == 0.0) return start > low && start < high;
        const double a = (low - start) / step, b = (high - start) / step;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
        return first < last;
    };
    return cut(from.x, to.x - from.x, box.left, box.right) &&
           cut(from.y, to.y - from.y, box.top, box.bottom);
}

// Even and odd, as the pictures have no paths that overlap themselves.
bool is_inside(const std::vector<std::vector<Spot>>& pieces, Spot p) {
    bool inside = false;
    for (const std::vector<Spot>& piece : pieces)
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const Spot a = piece[i], b = piece[(i + 1) % piece.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
    return inside;
}

bool is_ground(const Paint& paint, const std::vector<Paint>& grounds) {
    constexpr double rounding = 1.5;  // levels
    if (paint[3] < 0.03) return true;
    return std::ranges::any_of(grounds, [&](const Paint& ground) {
        return std::abs(paint[0] - ground[0]) < rounding &&
               std::abs(paint[1] - ground[1]) < rounding &&
               std::abs(paint[2] - ground[2]) < rounding;
    });
}

}  // namespace

double overlap(const Edges& a, const Edges& b) {
    const Edges both = common(a, b);
    return std::min(both.width(), both.height());
}

Edges ink_of(const Shape& shape) {
    const double half = shape.is_stroke ? 0.5 * shape.width : 0.0;
    Edges all{1e300, 1e300, -1e300, -1e300};
    for (const Outline& piece : shape.pieces)
        for (const Spot p : flattened(piece))
            all = {std::min(all.left, p.x), std::min(all.top, p.y), std::max(all.right, p.x),
                   std::max(all.bottom, p.y)};
    all = less(all, -half);
    return shape.clip ? common(all, *shape.clip) : all;
}

bool reaches(const Shape& shape, const Edges& box) {
    Edges seen = less(box, least_overlap);
    if (shape.clip) seen = common(seen, *shape.clip);
    if (is_empty(seen) || is_empty(common(seen, ink_of(shape)))) return false;
    std::vector<std::vector<Spot>> pieces;
    for (const Outline& piece : shape.pieces) pieces.push_back(flattened(piece));
    if (shape.is_stroke) seen = less(seen, -0.5 * shape.width);
    for (const std::vector<Spot>& piece : pieces)
        for (std::size_t i = 0; i + 1 < piece.size(); ++i)
            if (crosses(seen, piece[i], piece[i + 1])) return true;
    return !shape.is_stroke && is_inside(pieces, seen.middle());
}

std::vector<Touching> touching(const SvgPicture& picture, const Look& look) {
    std::vector<Edges> texts;
    for (const Letters& letters : picture.texts)
        if (const Edges ink = letters.edges(); letters.paint[3] > 0.03 && !is_empty(ink))
            texts.push_back(ink);
    std::vector<Touching> found;
    for (std::size_t i = 0; i < texts.size(); ++i)
        for (std::size_t k = i + 1; k < texts.size(); ++k)
            if (overlap(texts[i], texts[k]) > least_overlap)
                found.push_back({texts[i], texts[k], true});
    const auto is_on_gas = [&](const Edges& text) {
        return std::ranges::any_of(look.gases,
                                   [&](const Edges& gas) { return contains(gas, text.middle()); });
    };
    std::erase_if(texts, is_on_gas);
    for (const Shape& shape : picture.shapes) {
        if (is_ground(shape.paint, look.grounds)) continue;
        const Edges ink = ink_of(shape);
        if (std::ranges::any_of(look.gases, [&](const Edges& gas) {
                const Edges around = less(gas, -3.0);
                return contains(around, {ink.left, ink.top}) &&
                       contains(around, {ink.right, ink.bottom});
            }))
            continue;
        for (const Edges& text : texts)
            if (reaches(shape, text)) found.push_back({text, ink, false});
    }
    return found;
}

}  // namespace carom::test
