#include "panels/field/key_row.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/plot/layers.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double between_parts = 1.2, before_ramp = 0.5;  // units
constexpr double ramp_width = 10.6, ramp_height = 0.45;   // units
constexpr double short_ramp = 8.0;                        // the same, beside two lines
constexpr double ramp_top = 0.1, ramp_numbers = 1.82;     // units, from the top
constexpr double only_words = 1.35;                       // the same, to the baseline

}  // namespace

void KeyRow::add(double width, DrawPart draw) { parts_.push_back({width, std::move(draw)}); }

void KeyRow::add_words(const std::string& words) {
    const std::string markup = escape_markup(words);
    const TextStyle style = label_style(dc_);
    add(measure_text(markup, style).width,
        [markup, style](Canvas& canvas, Point at) { draw_text(canvas, at, markup, style); });
}

// In one line or, with the words for a mean, in two of nearly equal length.
std::vector<std::string> KeyRow::title_of_ramp(const ColorScale& scale, double most) const {
    const std::string all =
        scale.mean.empty() ? scale.title : say(scale.language, "{}, {}", scale.title, scale.mean);
    TextStyle style = label_style(dc_);
    const double whole = measure_text(escape_markup(all), style).width;
    for (const double share : {0.5, 0.55, 0.6, 0.65}) {
        style.max_width = share * whole;
        if (scale.mean.empty() || style.max_width > most) break;
        const std::vector<std::string> lines = wrapped(all, style, 3);
        if (lines.size() == 2) return {escape_markup(lines[0]), escape_markup(lines[1])};
    }
    return {escape_markup(scale.title)};
}

void KeyRow::add_ramp(const ColorMap& map, const ColorScale& scale, double opacity) {
    const double u = dc_.unit;
    const TextStyle style = label_style(dc_);
    const std::string last = localised(scale.language, marks_of(scale).back().label);
    const double past_end = 0.5 * measure_text(last, style).width;
    double free = dc_.area.width;
    for (const Part& part : parts_) free -= part.width + between_parts * u;
    const std::vector<std::string> title =
        title_of_ramp(scale, free - (before_ramp + short_ramp) * u - 2.0 * past_end);
    double name = measure_text(title.front(), style).width + before_ramp * u;
    if (title.size() > 1) {  // beside the first number
        const std::string zero = localised(scale.language, marks_of(scale).front().label);
        name = std::max(name, measure_text(title.back(), style).width + before_ramp * u +
                                  0.5 * measure_text(zero, style).width);
    }
    const double width = title.size() == 1
                             ? ramp_width * u
                             : std::clamp(free - name - past_end, short_ramp * u, ramp_width * u);
    const auto draw = [=, dc = dc_](Canvas& canvas, Point at) {
        const double top = dc.area.y + ramp_top * u;
        draw_text(canvas, {at.x, top + 0.7 * u}, title.front(), style);
        if (title.size() > 1)
            draw_text(canvas, {at.x, dc.area.y + ramp_numbers * u}, title.back(), style);
        const double left = at.x + name;
        plot::draw_strip(canvas, {left, top, width, ramp_height * u}, [&](double share) {
            return mix(dc.theme.ground, map.at(share), opacity);
        });
        const Scale along{0.0, scale.top, left, left + width};
        TextStyle numbers = style;
        numbers.align = Align::center;
        double end = 0.0;
        for (const TickMark& mark : marks_of(scale)) {
            const std::string words = localised(scale.language, mark.label);
            const double half = 0.5 * measure_text(words, style).width;
            const double x = along(mark.value);
            if (end > 0.0 && x - half < end + 0.4 * u) continue;
            draw_text(canvas, {x, dc.area.y + ramp_numbers * u}, words, numbers);
            end = x + half;
        }
    };
    add(name + width + past_end, draw);
}

// As many parts as have room, and the width of all of them.
std::pair<std::size_t, double> KeyRow::shown() const {
    double width = 0.0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const double more = parts_[i].width + (i > 0 ? between_parts * dc_.unit : 0.0);
        if (width + more > dc_.area.width) return {i, width};
        width += more;
    }
    return {parts_.size(), width};
}

Rect KeyRow::place() const {
    const double width = shown().second;
    return {dc_.area.right() - width, dc_.area.y, width, dc_.area.height};
}

void KeyRow::draw(Canvas& canvas) const {
    const auto [count, width] = shown();
    Point at{dc_.area.right() - width, dc_.area.y + only_words * dc_.unit};
    for (std::size_t i = 0; i < count; ++i) {
        parts_[i].draw(canvas, at);
        at.x += parts_[i].width + between_parts * dc_.unit;
    }
}

}  // namespace carom
