// The title, the subtitle and the captions of a frame.
#include <algorithm>
#include <cmath>

#include "draw/formula/words.h"
#include "panels/frame.h"
#include "scene/scene.h"

namespace carom {
namespace {

constexpr double title_line = 1.2;       // of the size of its letters
constexpr double above_baseline = 0.9;   // likewise
constexpr double subtitle_line = 1.35;   // units
constexpr double line_of_caption = 1.2;  // of the size of its letters

}  // namespace

// The title as far as `end`. It is set in one line, smaller if necessary; if that does not suffice,
// in two lines as large as the place allows.
PlacedWords FramePainter::title_place(double end) const {
    constexpr double largest = 1.73, smallest_in_one = 1.3, smallest = 1.0;  // units
    Rect area = grid_.place(scene_.film.layout.title);
    area.width = end - area.x;
    TextStyle style{.size = largest * unit_,
                    .weight = 600,
                    .color = theme_.ink,
                    .tabular = false,
                    .max_width = area.width,
                    .fonts = theme_.fonts};
    const auto from_top = [&](const std::vector<std::string>& lines) {
        PlacedWords title{{}, style};
        double y = area.y + above_baseline * style.size;
        for (const std::string& line : lines) {
            title.lines.push_back({words_of_text(line), {area.x, y}});
            y += title_line * style.size;
        }
        return title;
    };
    const double share =
        area.width /
        measure_text(escape_markup(scene_.title),
                     {.size = style.size, .weight = style.weight, .fonts = style.fonts})
            .width;
    if (share >= smallest_in_one / largest) {
        style.size *= std::min(1.0, share);
        style.max_width *= 1.0 + 1e-3;  // letters are set at whole sizes
        return from_top({scene_.title});
    }
    const double room = area.height - (has_subtitle_in_title() ? subtitle_line * unit_ : 0.0);
    for (style.size = std::min(style.size, room / (2.0 * title_line));; style.size *= 0.95) {
        const bool is_smallest = style.size <= smallest * unit_;
        if (is_smallest) style.size = smallest * unit_;
        const std::vector<std::string> lines = wrapped(scene_.title, style, 2);
        const double width =
            measure_text(escape_markup(lines.back()),
                         {.size = style.size, .weight = style.weight, .fonts = style.fonts})
                .width;
        if (is_smallest || width <= area.width) return from_top(lines);
    }
}

// Draws the title as far as `end`, and the subtitle in the lines that the title leaves.
void FramePainter::draw_title(Canvas& canvas, double end, bool has_title) const {
    const PlacedWords title = title_place(end);
    if (has_title) draw_placed(canvas, title, 1.0);
    if (!has_subtitle_in_title()) return;
    Rect area = grid_.place(scene_.film.layout.title);
    area.width = end - area.x;
    double y = title.lines.back().at.y + (title_line - above_baseline) * title.style.size;
    const TextStyle style{.size = 1.05 * unit_,
                          .weight = 400,
                          .color = theme_.muted,
                          .tabular = false,
                          .max_width = area.width,
                          .fonts = theme_.fonts};
    const double line = subtitle_line * unit_;
    const auto most = static_cast<std::size_t>(std::max(0.0, area.bottom() - y) / line + 1e-6);
    for (const std::string& words :
         wrapped(scene_.subtitle, style, std::max<std::size_t>(1, most))) {
        draw_text(canvas, {area.x, y + style.size}, escape_markup(words), style);
        y += line;
    }
}

// As the title leaves its card, those of the first frame appear, but for the subtitle, which is on
// the card, too.
void FramePainter::draw_captions(Canvas& canvas, const Tick& tick, bool still) const {
    const bool is_before = tick.phase == Phase::title_card;
    const int frame = is_before ? card_frames(scene_.film).title : tick.frame;
    if (subtitle_ && !is_before) {
        const double alpha = opacity(*subtitle_, scene_.film, frame, caption_fade_seconds);
        if (alpha > 0.0) draw_caption(canvas, words_of_text(scene_.subtitle), still ? 1.0 : alpha);
    }
    for (const CaptionSpan& caption : captions_) {
        double alpha = opacity(caption, scene_.film, frame, caption_fade_seconds);
        if (is_before) alpha *= std::max(0.0, 2.0 * Cards::way_of_title(scene_.film, tick) - 1.0);
        if (alpha > 0.0 && !caption.words.empty())
            draw_caption(canvas, caption.words, still ? 1.0 : alpha);
    }
}

// As large as the place allows.
PlacedWords FramePainter::lines_of_caption(const std::string& words, const Rect& place,
                                           TextStyle style) const {
    style.max_width = place.width * (1.0 + 1e-3);
    for (;; style.size *= 0.95) {
        const bool is_smallest = style.size <= unit_;
        if (is_smallest) style.size = unit_;
        const auto most = static_cast<std::size_t>(
            std::max(1.0, std::floor(place.height / (line_of_caption * style.size) + 1e-6)));
        const std::vector<std::string> lines = wrapped_words(words, style, most);
        TextStyle whole = style;
        whole.max_width = 0.0;
        if (!is_smallest && measure_words(lines.back(), whole).width > place.width) continue;
        PlacedWords caption{{}, style};
        double y = place.y;
        for (const std::string& line : lines) {
            const auto [above, height] = line_height_of(line, style, line_of_caption);
            caption.lines.push_back({line, {place.x, y + above}});
            y += height;
        }
        return caption;
    }
}

// A caption begins at the left, in as many lines as its place has room for, smaller if that avoids
// cutting it.
PlacedWords FramePainter::caption_place(const std::string& words) const {
    constexpr double largest = 1.47, smallest = 1.0;  // units
    constexpr double least_of_larger_lines = 3.0;     // units: lower places have a single such line
    const Rect place = before_numbers(grid_.place(*scene_.film.layout.caption));
    TextStyle style{.size = largest * unit_,
                    .weight = 500,
                    .color = theme_.ink,
                    .tabular = false,
                    .fonts = theme_.fonts};
    const double in_one = place.width / measure_words(words, style).width * style.size;
    const bool has_more_lines = place.height >= 2.0 * line_of_caption * smallest * unit_;
    const bool may_be_large = place.height > least_of_larger_lines * unit_;
    if (has_more_lines && in_one < (may_be_large ? largest : smallest) * unit_)
        return lines_of_caption(words, place, style);
    const TextExtent whole = measure_words(words, style);
    const bool has_formula = words.find('$') != std::string::npos;
    const double share =
        std::min(place.width / whole.width,
                 has_formula ? place.height / (whole.ascent + whole.descent) : 1.0);
    style.size = std::max(unit_, std::min(1.0, share) * style.size);
    style.max_width = place.width * (1.0 + 1e-3);  // letters are set at whole sizes
    const TextExtent extent = measure_words(words, style);
    const double below_middle =
        has_formula ? 0.5 * (extent.ascent - extent.descent) : 0.36 * style.size;
    return {{{words, {place.x, place.y + 0.5 * place.height + below_middle}}}, style};
}

void FramePainter::draw_caption(Canvas& canvas, const std::string& words, double alpha) const {
    draw_placed(canvas, caption_place(words), alpha);
}

}  // namespace carom
