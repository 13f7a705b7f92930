#include "draw/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "util/text.h"

namespace carom {
namespace {

// The step between ticks: a mantissa of two digits (in tenths, so that 2.5 is an integer) times
// 10^exponent.
struct Step {
    int tenths = 10;
    int exponent = 0;
    double size() const { return tenths * std::pow(10.0, exponent - 1); }
    bool is_half() const { return tenths == 25; }
};

// Rounding must not lose a tick that lies on the end of the range.
constexpr double slack = 1e-9;

std::pair<double, double> tick_range(double low, double high, const Step& step) {
    return {std::ceil(low / step.size() - slack), std::floor(high / step.size() + slack)};
}

Step smallest_step(double low, double high, int most, bool whole) {
    Step step{.tenths = 10, .exponent = static_cast<int>(std::floor(std::log10(high - low))) - 2};
    while (true) {
        for (const int tenths : {10, 20, 25, 50}) {
            step.tenths = tenths;
            if (whole && (step.exponent < 0 || (step.exponent == 0 && step.is_half()))) continue;
            const auto [first, last] = tick_range(low, high, step);
            if (last - first + 1 <= most) return step;
        }
        ++step.exponent;
    }
}

std::string with_decimals(double value, int decimals) {
    const double unit = std::pow(10.0, decimals);
    const double scaled = std::round(std::abs(value) * unit);
    if (scaled == 0.0) return decimals > 0 ? fmt::format("{:.{}f}", 0.0, decimals) : "0";
    const std::string sign = value < 0 ? "\u2212" : "";
    if (decimals == 0) return sign + grouped(static_cast<long long>(scaled));
    return sign + fmt::format("{:.{}f}", std::abs(value), decimals);
}

// Long labels are written with a power of ten, the same one for all.
std::string label_of(double value, const Step& step, double largest) {
    const int last_digit = step.exponent - (step.is_half() ? 1 : 0);
    const bool is_plain = last_digit >= -4 && largest < 1e6;
    if (is_plain) return with_decimals(value, std::max(0, -last_digit));
    if (value == 0.0) return "0";
    const int power = static_cast<int>(std::floor(std::log10(largest) + slack));
    return with_decimals(value / std::pow(10.0, power), std::max(0, power - last_digit)) +
           "\u2009×\u200910" + superscript(power);
}

double half_line_height(const TextStyle& style) {
    constexpr double cap_height = 0.727;  // of Inter, in ems
    return 0.5 * cap_height * style.size;
}

double gap_to_label(const AxisStyle& style) { return 0.35 * style.label.size; }

// Lines of an axis are aligned to whole pixels; otherwise they would be grey and up to three pixels
// wide.
double to_whole_width(double width) { return std::max(1.0, std::round(width)); }

void draw_level_line(Canvas& canvas, double from, double to, double y, const AxisStyle& style) {
    const double width = to_whole_width(style.line_width);
    const double left = std::round(from), right = std::round(to);
    canvas.fill({left, std::round(y - 0.5 * width), right - left, width}, style.line);
}

void draw_upright_line(Canvas& canvas, double x, double from, double to, const AxisStyle& style) {
    const double width = to_whole_width(style.line_width);
    const double top = std::round(from), bottom = std::round(to);
    canvas.fill({std::round(x - 0.5 * width), top, width, bottom - top}, style.line);
}

// With gaps for words.
void draw_grid_line(Canvas& canvas, double from, double to, double y, const AxisStyle& style) {
    AxisStyle thin = style;
    thin.line = *style.grid;
    std::vector<std::pair<double, double>> gaps;
    for (const Rect& words : style.words)
        if (y > words.y && y < words.bottom()) gaps.emplace_back(words.x, words.right());
    std::ranges::sort(gaps);
    gaps.emplace_back(to, to);
    for (const auto& [first, last] : gaps) {
        if (first > from) draw_level_line(canvas, from, std::min(first, to), y, thin);
        from = std::max(from, last);
    }
}

struct LabelSpan {
    double left, right;
};

// The horizontal span of a label under its tick; the last one is kept from reaching far beyond the
// end of the axis.
LabelSpan span_of(const TickMark& mark, const Scale& scale, const TextStyle& style) {
    constexpr double most_beyond = 0.6;  // ems
    const double width = measure_text(mark.label, style).width;
    const double end = std::max(scale.from, scale.to) + most_beyond * style.size;
    const double left = std::min(scale(mark.value) - 0.5 * width, end - width);
    return {left, left + width};
}

// Whether neighbouring labels are at least half an em apart.
bool fits(const std::vector<TickMark>& marks, const Scale& scale, const TextStyle& style) {
    for (std::size_t i = 1; i < marks.size(); ++i) {
        const double gap =
            span_of(marks[i], scale, style).left - span_of(marks[i - 1], scale, style).right;
        if (gap < 0.5 * style.size) return false;
    }
    return true;
}

std::vector<TickMark> localised(Language language, std::vector<TickMark> marks) {
    for (TickMark& mark : marks) mark.label = localised(language, std::move(mark.label));
    return marks;
}

std::vector<TickMark> fitting_x_ticks(const Scale& scale, const AxisStyle& style) {
    for (int most = 5; most > 2; --most) {
        std::vector<TickMark> marks =
            localised(style.language, ticks(scale.low, scale.high, most, style.whole));
        if (fits(marks, scale, style.label)) return marks;
    }
    // Where not even two labels have room, only the last has its own.
    std::vector<TickMark> marks =
        localised(style.language, ticks(scale.low, scale.high, 2, style.whole));
    if (!fits(marks, scale, style.label))
        for (std::size_t i = 0; i + 1 < marks.size(); ++i) marks[i].label.clear();
    return marks;
}

// Where the title ends in the row of labels: in the rightmost gap with room for it. Labels give way
// to it, the last but one first, then the last; if it is wider than the axis, all of them.
double end_of_title(std::vector<TickMark>& marks, const Scale& scale, const AxisStyle& style,
                    double width) {
    const double air = 0.6 * style.label.size, right = std::max(scale.from, scale.to);
    const auto place = [&]() -> std::optional<double> {
        double end = right;
        for (std::size_t i = marks.size(); i-- > 0;) {
            if (marks[i].label.empty()) continue;
            const auto [from, to] = span_of(marks[i], scale, style.label);
            if (end - width >= to + air) return end;
            end = std::min(end, from - air);
        }
        return {};
    };
    const auto labelled = [&] {
        std::vector<TickMark*> all;
        for (TickMark& mark : marks)
            if (!mark.label.empty()) all.push_back(&mark);
        return all;
    };
    while (true) {
        if (const auto end = place()) return *end;
        const std::vector<TickMark*> all = labelled();
        if (all.empty()) return right;
        all[all.size() > 2 ? all.size() - 2 : all.size() - 1]->label.clear();
    }
}

std::vector<TickMark> fitting_y_ticks(const Scale& scale, const AxisStyle& style) {
    const double room = std::abs(scale.to - scale.from) / (1.5 * style.label.size);
    const int most = std::clamp(static_cast<int>(room) + 1, 2, 4);
    std::vector<TickMark> marks =
        localised(style.language, style.decades ? decade_ticks(scale.low, scale.high, most)
                                                : ticks(scale.low, scale.high, most, style.whole));
    // Where not even two labels have room, marks near the one before have none.
    double before = INFINITY;
    for (TickMark& mark : marks) {
        const double y = scale(mark.value);
        if (std::abs(before - y) < 1.1 * style.label.size) mark.label.clear();
        if (!mark.label.empty()) before = y;
    }
    return marks;
}

// The number of multiples of a step from `first` to `last`.
int multiples(int first, int last, int step) {
    const auto floor_of = [&](int value) {
        return value >= 0 ? value / step : -((step - 1 - value) / step);
    };
    return floor_of(last) - floor_of(first - 1);
}

// The smallest round step that has at most `most` multiples, but at least two.
int step_of_decades(int first, int last, int most) {
    int step = 1;
    for (const int round : {2, 5, 10, 20, 25, 50, 100, 200, 250, 500, 1000}) {
        if (multiples(first, last, step) <= most || multiples(first, last, round) < 2) break;
        step = round;
    }
    return step;
}

}  // namespace

std::vector<TickMark> ticks(double low, double high, int most, bool whole) {
    if (!(std::isfinite(low) && std::isfinite(high) && low < high && most >= 2)) return {};
    const Step step = smallest_step(low, high, most, whole);
    const auto [first, last] = tick_range(low, high, step);
    const double largest = std::max(std::abs(first), std::abs(last)) * step.size();

    std::vector<TickMark> marks;
    for (int k = 0; k < most && first + k <= last; ++k) {
        const double count = first + k;  // may stay the same in a narrow range far from 0
        if (k > 0 && count == first + (k - 1)) break;
        const double value = count == 0.0 ? 0.0 : count * step.size();
        marks.push_back({value, label_of(value, step, largest)});
    }
    return marks;
}

int common_power(const std::vector<TickMark>& marks, double largest) {
    const auto has_power = [](const TickMark& mark) {
        return mark.label.find("×") != std::string::npos;
    };
    if (std::ranges::none_of(marks, has_power)) return 0;
    return static_cast<int>(std::floor(std::log10(largest) + slack));
}

std::vector<TickMark> decade_ticks(double low, double high, int most) {
    const int first = static_cast<int>(std::ceil(low - slack));
    const int last = static_cast<int>(std::floor(high + slack));
    const int step = step_of_decades(first, last, most);
    const bool is_plain = first >= -4 && last <= 5;
    std::vector<TickMark> marks;
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % step != 0) continue;
        marks.push_back({double(exponent),
                         is_plain ? with_decimals(std::pow(10.0, exponent), std::max(0, -exponent))
                                  : "10" + superscript(exponent)});
    }
    return marks;
}

double round_up_for_axis(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double round : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0})
        if (round * power >= value * (1.0 - slack)) return round * power;
    return 10.0 * power;
}

double x_axis_space(const AxisStyle& style) {
    return style.below + style.tick_length + gap_to_label(style) +
           2 * half_line_height(style.label);
}

double y_axis_space(const Scale& scale, const AxisStyle& style) {
    double widest = 0;
    for (const TickMark& mark : fitting_y_ticks(scale, style))
        widest = std::max(widest, measure_text(mark.label, style.label).width);
    return style.tick_length + gap_to_label(style) + widest;
}

void draw_x_axis(Canvas& canvas, const Rect& area, const Scale& scale, const std::string& title,
                 const AxisStyle& style) {
    const double line = area.bottom(), y = line + style.below;
    TextStyle label = style.label;
    label.align = Align::center;
    const double baseline = line + x_axis_space(style);
    draw_level_line(canvas, area.x - 0.5 * style.line_width, area.right() + 0.5 * style.line_width,
                    line, style);
    std::vector<TickMark> marks = fitting_x_ticks(scale, style);
    TextStyle words = style.title;
    words.align = Align::right;
    double end = area.right();
    if (!title.empty()) end = end_of_title(marks, scale, style, measure_text(title, words).width);
    for (const TickMark& mark : marks) {
        draw_upright_line(canvas, scale(mark.value), y, y + style.tick_length, style);
        const LabelSpan span = span_of(mark, scale, label);
        draw_text(canvas, {0.5 * (span.left + span.right), baseline}, mark.label, label);
    }
    if (!title.empty()) draw_text(canvas, {end, baseline}, title, words);
}

bool keeps_labels(const Scale& scale, const std::string& title, const AxisStyle& style) {
    std::vector<TickMark> marks = fitting_x_ticks(scale, style);
    const auto labelled = [&] {
        return std::ranges::count_if(marks,
                                     [](const TickMark& mark) { return !mark.label.empty(); });
    };
    const auto before = labelled();
    end_of_title(marks, scale, style, measure_text(title, style.title).width);
    return labelled() == before;
}

std::vector<double> grid_lines(const Rect& area, const Scale& scale, const AxisStyle& style) {
    std::vector<double> lines;
    if (!style.grid) return lines;
    for (const TickMark& mark : fitting_y_ticks(scale, style))
        if (const double y = scale(mark.value); std::abs(y - area.bottom()) > style.line_width)
            lines.push_back(y);
    return lines;
}

void draw_y_axis(Canvas& canvas, const Rect& area, const Scale& scale, const AxisStyle& style) {
    const double x = area.x;
    TextStyle label = style.label;
    label.align = Align::right;
    for (const double y : grid_lines(area, scale, style))
        draw_grid_line(canvas, x + 0.5 * style.line_width, area.right(), y, style);
    draw_upright_line(canvas, x, area.y - 0.5 * style.line_width,
                      area.bottom() + 0.5 * style.line_width, style);
    for (const TickMark& mark : fitting_y_ticks(scale, style)) {
        const double y = scale(mark.value);
        draw_level_line(canvas, x - style.tick_length, x, y, style);
        draw_text(canvas,
                  {x - style.tick_length - gap_to_label(style), y + half_line_height(label)},
                  mark.label, label);
    }
}

}  // namespace carom
