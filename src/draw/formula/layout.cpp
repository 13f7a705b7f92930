#include "draw/formula/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "util/text.h"

namespace carom::formula {
namespace {

// TeX's styles: display, text, script and scriptscript, each with a cramped form.
struct Style {
    int level = 0;
    bool is_cramped = false;
};
constexpr int display = 0, text = 1, script = 2, second_script = 3;

Size size_of(Style style) {
    if (style.level <= text) return Size::text;
    return style.level == script ? Size::script : Size::second_script;
}
Style cramped(Style style) { return {style.level, true}; }
Style raised(Style style) {
    return {style.level <= text ? script : second_script, style.is_cramped};
}
Style lowered(Style style) { return cramped(raised(style)); }
Style numerator(Style style) {
    return {std::min(style.level + 1, second_script), style.is_cramped};
}
Style denominator(Style style) { return cramped(numerator(style)); }

void put(Box& box, const Box& inner, double x, double down) {
    box.height = std::max(box.height, inner.height - down);
    box.depth = std::max(box.depth, inner.depth + down);
    for (const Piece& piece : inner.pieces) {
        box.pieces.push_back(piece);
        box.pieces.back().at.x += x;
        box.pieces.back().at.y += down;
    }
}

Box in_width(const Box& inner, double width) {
    Box box{.width = width};
    put(box, inner, 0.5 * (width - inner.width), 0.0);
    return box;
}

Box shifted(const Box& inner, double down) {
    Box box{.width = inner.width, .height = inner.height - down, .depth = inner.depth + down};
    for (const Piece& piece : inner.pieces) {
        box.pieces.push_back(piece);
        box.pieces.back().at.y += down;
    }
    return box;
}

Box box_of(const Piece& piece) { return {piece.width, piece.height, piece.depth, {piece}}; }

// The letter of a part that consists of a single letter, otherwise none.
std::optional<Letter> letter_of(const Part& part) {
    if (part.of == Part::Of::symbol) return Letter{part.symbol->letter, part.symbol->is_slanted};
    if (part.of == Part::Of::upright && part.kind == Class::ordinary &&
        code_points(part.words) == 1)
        return Letter{part.words, false};
    return std::nullopt;
}

// Whether the indices of a part are set below and above it (as limits).
bool has_limits(const Part& part, Style style) {
    return part.of == Part::Of::symbol && part.symbol->tex == "sum" && style.level == display;
}

// The space between neighbours: none, thin, medium or thick; medium and thick ones (and those
// marked with 4) are not in indices. Rows and columns: ordinary, operation, binary, relation,
// opening, closing, punctuation, inner (The TeXbook, chapter 18).
constexpr std::array<std::string_view, 8> space_table{
    "01230004", "1103000a", "22002002", "33003003", "00000000", "01230004", "44044444", "41234044"};

double space_between(Class left, Class right, Style style) {
    const char kind =
        space_table.at(static_cast<std::size_t>(left)).at(static_cast<std::size_t>(right));
    const bool is_index = style.level >= script;
    switch (kind) {
        case '1':
            return 3.0;
        case '2':
            return is_index ? 0.0 : 4.0;
        case '3':
            return is_index ? 0.0 : 5.0;
        case '4':
        case 'a':
            return is_index ? 0.0 : 3.0;
        default:
            return 0.0;
    }
}

// The class of each part; signs with nothing to join on their left or right are ordinary.
std::vector<Class> classes_of(const Parts& parts) {
    std::vector<Class> kinds;
    std::optional<std::size_t> last;
    for (const Part& part : parts) {
        kinds.push_back(part.kind);
        if (part.of == Part::Of::space) continue;
        Class& kind = kinds.back();
        const bool joins = last && kinds[*last] != Class::binary &&
                           kinds[*last] != Class::operation && kinds[*last] != Class::relation &&
                           kinds[*last] != Class::opening && kinds[*last] != Class::punctuation;
        if (kind == Class::binary && !joins) kind = Class::ordinary;
        const bool ends =
            kind == Class::relation || kind == Class::closing || kind == Class::punctuation;
        if (ends && last && kinds[*last] == Class::binary) kinds[*last] = Class::ordinary;
        last = kinds.size() - 1;
    }
    if (last && kinds[*last] == Class::binary) kinds[*last] = Class::ordinary;
    return kinds;
}

class Setter {
  public:
    explicit Setter(const Font& font) : font_(font), common_(font.common()) {}

    Box list(const Parts& parts, Style style, const Part* fence = nullptr) const {
        const std::vector<Class> kinds = classes_of(parts);
        std::vector<Box> boxes;
        double height = 0.0, depth = 0.0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const bool has_next = i + 1 < parts.size() && kinds[i] == Class::ordinary;
            boxes.push_back(part(parts[i], has_next ? &parts[i + 1] : nullptr, style));
            height = std::max(height, boxes.back().height);
            depth = std::max(depth, boxes.back().depth);
        }
        Box box;
        std::optional<Class> last;
        const auto add = [&](const Box& inner, Class kind) {
            if (last) box.width += space_between(*last, kind, style) / 18.0 * quad(style);
            put(box, inner, box.width, 0.0);
            box.width += inner.width;
            last = kind;
        };
        if (fence != nullptr) add(side(fence->left, height, depth, style), Class::opening);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (parts[i].of == Part::Of::space)
                box.width += parts[i].width / 18.0 * quad(style);
            else
                add(boxes[i], kinds[i]);
        }
        if (fence != nullptr) add(side(fence->right, height, depth, style), Class::closing);
        return box;
    }

  private:
    double quad(Style style) const { return font_.lengths(size_of(style)).quad; }

    Box part(const Part& part, const Part* next, Style style) const {
        if (part.kind == Class::operation && part.of == Part::Of::symbol)
            return operation(part, style);
        if (const auto letter = letter_of(part)) return single(part, *letter, next, style);
        if (part.of == Part::Of::accent) return accent(part, style);
        return with_indices(nucleus(part, style), part, 0.0, false, style);
    }

    Box nucleus(const Part& part, Style style) const {
        switch (part.of) {
            case Part::Of::group:
                return list(part.body, style);
            case Part::Of::fraction:
                return fraction(part, style);
            case Part::Of::root:
                return root(part, style);
            case Part::Of::fenced:
                return list(part.body, style, &part);
            case Part::Of::upright:
                return upright(part.words, style);
            default:
                return {};
        }
    }

    // Rules 14 and 17.
    Box single(const Part& part, const Letter& letter, const Part* next, Style style) const {
        const Size size = size_of(style);
        const Metrics m = font_.letter(letter, size);
        double kern = 0.0;
        bool is_text = false;
        const auto follower = next != nullptr ? letter_of(*next) : std::nullopt;
        if (follower && !part.has_indices() && next->kind != Class::inner) {
            const auto between = font_.kern(letter, *follower, size);
            kern = between.value_or(0.0);
            is_text = between.has_value() && m.is_text;
        }
        const double lean = is_text ? 0.0 : m.italic;
        Box box = box_of(Piece{.letter = letter,
                               .size = size,
                               .width = m.width,
                               .height = m.height,
                               .depth = m.depth});
        const bool is_lowered = !part.below_index.empty();
        if (!is_lowered) box.width += lean;
        box = with_indices(std::move(box), part, is_lowered ? lean : 0.0, true, style);
        box.width += kern;
        return box;
    }

    Box upright(const std::string& words, Style style) const {
        Box box;
        const Size size = size_of(style);
        std::optional<Letter> last;
        Metrics m;
        for (std::size_t i = 0; i < words.size();) {
            const std::size_t end = next_code_point(words, i);
            const Letter letter{words.substr(i, end - i), false};
            if (last) box.width += font_.kern(*last, letter, size).value_or(0.0);
            m = font_.letter(letter, size);
            put(box,
                box_of(Piece{.letter = letter,
                             .size = size,
                             .width = m.width,
                             .height = m.height,
                             .depth = m.depth}),
                box.width, 0.0);
            box.width += m.width;
            last = letter;
            i = end;
        }
        box.width += m.italic;
        return box;
    }

    // Rule 18. `delta` is the distance by which a superscript is further right than a subscript.
    Box with_indices(Box nucleus, const Part& part, double delta, bool is_letter,
                     Style style) const {
        if (!part.has_indices()) return nucleus;
        const Lengths at = font_.lengths(size_of(style));
        double up = 0.0, down = 0.0;
        if (!is_letter) {
            const Lengths small = font_.lengths(size_of(raised(style)));
            up = nucleus.height - small.sup_drop;
            down = nucleus.depth + small.sub_drop;
        }
        Box above, below;
        if (!part.above_index.empty()) {
            above = list(part.above_index, raised(style));
            const double least = style.is_cramped         ? at.sup3
                                 : style.level == display ? at.sup1
                                                          : at.sup2;
            up = std::max({up, least, above.depth + 0.25 * at.x_height});
        }
        if (!part.below_index.empty()) {
            below = list(part.below_index, lowered(style));
            if (part.above_index.empty()) {
                down = std::max({down, at.sub1, below.height - 0.8 * at.x_height});
            } else {
                down = std::max(down, at.sub2);
                const double missing =
                    4.0 * common_.gap - ((up - above.depth) - (below.height - down));
                if (missing > 0.0) {
                    down += missing;
                    const double rise = 0.8 * at.x_height - (up - above.depth);
                    if (rise > 0.0) {
                        up += rise;
                        down -= rise;
                    }
                }
            }
        }
        const double start = nucleus.width;
        if (!part.above_index.empty()) {
            put(nucleus, above, start + delta, -up);
            nucleus.width = start + delta + above.width + common_.script_space;
        }
        if (!part.below_index.empty()) {
            put(nucleus, below, start, down);
            nucleus.width = std::max(nucleus.width, start + below.width + common_.script_space);
        }
        return nucleus;
    }

    Box rule(double width, double height) const {
        return box_of(Piece{.of = Piece::Of::rule, .width = width, .height = height});
    }

    // Rule 15.
    Box fraction(const Part& part, Style style) const {
        const Lengths at = font_.lengths(size_of(style));
        Box above = list(part.body, numerator(style)), below = list(part.below, denominator(style));
        const double width = std::max(above.width, below.width);
        above = in_width(above, width);
        below = in_width(below, width);
        const bool is_large = style.level == display;
        double up = is_large ? at.num1 : at.num2, down = is_large ? at.denom1 : at.denom2;
        const double gap = (is_large ? 3.0 : 1.0) * common_.gap, half = 0.5 * common_.rule;
        up = std::max(up, gap + above.depth + at.axis + half);
        down = std::max(down, gap + below.height - at.axis + half);
        Box box{.width = width + 2.0 * common_.no_bracket};
        put(box, above, common_.no_bracket, -up);
        put(box, rule(width, common_.rule), common_.no_bracket, -(at.axis - half));
        put(box, below, common_.no_bracket, down);
        return box;
    }

    // Rule 11.
    Box root(const Part& part, Style style) const {
        const Box inner = list(part.body, cramped(style));
        double gap = common_.gap;
        gap += 0.25 * (style.level == display ? font_.lengths(size_of(style)).x_height : gap);
        const Metrics sign =
            font_.root(inner.height + inner.depth + gap + common_.rule, size_of(style));
        const double more = sign.depth - (inner.height + inner.depth + gap);
        if (more > 0.0) gap += 0.5 * more;
        const double thickness = sign.height, up = inner.height + gap;
        Box box{.width = sign.width + inner.width, .height = up + 2.0 * thickness};
        put(box,
            box_of(Piece{.of = Piece::Of::root,
                         .size = size_of(style),
                         .width = sign.width,
                         .height = sign.height,
                         .depth = sign.depth}),
            0.0, -up);
        put(box, rule(inner.width, thickness), sign.width, -up);
        put(box, inner, sign.width, 0.0);
        return box;
    }

    // Rule 12.
    Box accent(const Part& part, Style style) const {
        const Size size = size_of(style);
        const bool is_one = part.body.size() == 1 && !part.body.front().has_indices();
        const auto letter = is_one ? letter_of(part.body.front()) : std::nullopt;
        Box base = list(part.body, cramped(style));
        const double skew = letter ? font_.letter(*letter, size).skew : 0.0;
        const double width = base.width;
        double drop = std::min(base.height, font_.accent_base(part.symbol->tex, size));
        bool has_rest = part.has_indices();
        if (has_rest && letter) {
            Part inner = part.body.front();
            inner.above_index = part.above_index;
            inner.below_index = part.below_index;
            const double height = base.height;
            base = list({inner}, style);
            drop += base.height - height;
            has_rest = false;
        }
        const Metrics m = font_.accent(part.symbol->tex, size);
        const Piece sign{.of = Piece::Of::accent,
                         .letter = {part.symbol->tex, false},
                         .size = size,
                         .width = m.width + m.italic,
                         .height = m.height,
                         .depth = m.depth};
        Box box = base;
        put(box, box_of(sign), skew + 0.5 * (width - sign.width), -(base.height - drop + m.depth));
        return has_rest ? with_indices(std::move(box), part, 0.0, false, style) : box;
    }

    // Rule 13.
    Box operation(const Part& part, Style style) const {
        const Letter letter{part.symbol->letter, false};
        const bool is_large = style.level == display;
        const Metrics m = is_large ? font_.large(letter) : font_.letter(letter, size_of(style));
        const bool limits = has_limits(part, style);
        const bool keeps_lean = part.below_index.empty() || limits;
        Box box = box_of(Piece{.of = is_large ? Piece::Of::large : Piece::Of::letter,
                               .letter = letter,
                               .size = size_of(style),
                               .width = m.width + (keeps_lean ? m.italic : 0.0),
                               .height = m.height,
                               .depth = m.depth});
        const double axis = font_.lengths(size_of(style)).axis;
        box = shifted(box, 0.5 * (m.height - m.depth) - axis);
        if (!limits)
            return with_indices(std::move(box), part, keeps_lean ? 0.0 : m.italic, false, style);

        const Box above = list(part.above_index, raised(style)),
                  below = list(part.below_index, lowered(style));
        const double* gap = static_cast<const double*>(common_.limit_gap);
        Box all{.width = std::max({box.width, above.width, below.width}),
                .height = box.height,
                .depth = box.depth};
        const auto middle = [&](const Box& one) { return 0.5 * (all.width - one.width); };
        put(all, box, middle(box), 0.0);
        if (!part.above_index.empty()) {
            const double up = std::max(gap[0], gap[2] - above.depth);
            const double baseline = box.height + up + above.depth;
            put(all, above, middle(above) + 0.5 * m.italic, -baseline);
            all.height = baseline + above.height + gap[4];
        }
        if (!part.below_index.empty()) {
            const double down = std::max(gap[1], gap[3] - below.height);
            const double baseline = box.depth + down + below.height;
            put(all, below, middle(below) - 0.5 * m.italic, baseline);
            all.depth = baseline + below.depth + gap[4];
        }
        return all;
    }

    // Rule 19.
    Box side(const Symbol* bracket, double height, double depth, Style style) const {
        if (bracket == nullptr) return {.width = common_.no_bracket};
        const double axis = font_.lengths(size_of(style)).axis;
        const double reach = std::max(height - axis, depth + axis);
        const double least =
            std::max(2.0 * reach * common_.bracket_share, 2.0 * reach - common_.bracket_shortfall);
        const Letter letter{bracket->letter, false};
        const Metrics m = font_.bracket(letter, least, size_of(style));
        const Box box = box_of(Piece{.of = Piece::Of::bracket,
                                     .letter = letter,
                                     .size = size_of(style),
                                     .width = m.width + m.italic,
                                     .height = m.height,
                                     .depth = m.depth});
        return shifted(box, 0.5 * (m.height - m.depth) - axis);
    }

    const Font& font_;
    CommonLengths common_;
};

}  // namespace

Box box_of(const Parts& formula, const Font& font, Standing standing) {
    return Setter(font).list(formula, {standing == Standing::alone ? display : text, false});
}

}  // namespace carom::formula
