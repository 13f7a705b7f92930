#include "panels/field/color_bar.h"

#include <algorithm>
#include <cmath>

#include "stats/histogram.h"
#include "util/text.h"

namespace carom {

void fix_top(ColorScale& scale, std::vector<double>& values, double share_above) {
    const double top = quantile(values, 1.0 - share_above);
    const double highest = std::ranges::max(values);
    scale.top = round_up_for_axis(top > 0.0 ? top : highest);
    scale.is_exceeded = highest > scale.top * (1.0 + 1e-9);
}

std::vector<TickMark> marks_of(const ColorScale& scale) {
    std::vector<TickMark> marks = ticks(0.0, scale.top, 4);
    if (std::abs(marks.back().value - scale.top) > 1e-9 * scale.top)
        marks = ticks(0.0, scale.top, 5);
    if (scale.is_exceeded) marks.back().label = "≥ " + marks.back().label;
    return marks;
}

std::vector<TickMark> marks_with_room(const ColorScale& scale, double height, double line) {
    const std::vector<TickMark> all = marks_of(scale);
    const std::size_t last = all.size() - 1;
    std::size_t step = 1;
    while (step < last && height * static_cast<double>(step) < line * static_cast<double>(last))
        ++step;
    std::vector<TickMark> marks;
    for (std::size_t i = 0; i <= last; ++i)
        if ((last - i) % step == 0) marks.push_back(all[i]);
    return marks;
}

void draw_color_bar(Canvas& canvas, const DrawContext& dc, const ColorMap& map,
                    const ColorScale& scale, double opacity) {
    constexpr int steps = 256;
    const double u = dc.unit, line_of_power = 1.35 * u;
    // The numbers share a power of ten, which is written once: there is little room beside the bar.
    const int power = common_power(marks_of(scale), scale.top);
    ColorScale shown = scale;
    shown.top *= std::pow(10.0, -power);
    const double head = 1.8 * u + (power == 0 ? 0.0 : line_of_power);
    const Rect bar{dc.area.x, dc.area.y + head, 0.8 * u, dc.area.height - head};
    for (int i = 0; i < steps; ++i) {
        const double top = bar.bottom() - bar.height * (i + 1) / steps;
        canvas.fill({bar.x, std::floor(top), bar.width, std::ceil(bar.height / steps) + 1.0},
                    mix(dc.theme.ground, map.at(i / (steps - 1.0)), opacity));
    }
    TextStyle style = label_style(dc);
    style.max_width = dc.area.width;
    const std::string title = escape_markup(scale.title);
    const bool fits =
        scale.symbol.empty() || measure_text(title, label_style(dc)).width <= dc.area.width;
    draw_text(canvas, {dc.area.x, dc.area.y + 0.9 * u}, fits ? title : scale.symbol, style);
    if (power != 0)
        draw_text(canvas, {dc.area.x, dc.area.y + 0.9 * u + line_of_power},
                  "/\u200910" + superscript(power), style);
    const Scale up{0.0, shown.top, bar.bottom(), bar.y};
    const double line = 1.65 * u;  // those at the ends are moved inwards
    for (const TickMark& mark : marks_with_room(shown, bar.height, line))
        draw_text(canvas,
                  {bar.right() + 0.4 * u,
                   std::min(std::max(up(mark.value) + 0.36 * u, bar.y + 0.72 * u), bar.bottom())},
                  localised(scale.language, mark.label), label_style(dc));
}

}  // namespace carom
