// Where a point of a plot is on the canvas.
#include <algorithm>
#include <cmath>

#include "panels/plot/draw_plot.h"
#include "panels/plot/layers.h"

namespace carom::plot {
namespace {

using Height = std::optional<double>;

Height highest(Height a, Height b) {
    if (!a || !b) return a ? a : b;
    return std::max(*a, *b);
}

Height height_at(const Bars& bars, double x) {
    for (std::size_t i = 0; i < bars.value.size(); ++i)
        if (bars.from[i] <= x && x < bars.to[i]) return bars.value[i];
    return {};
}

// Interpolates between the points on either side.
Height height_at(const Line& line, double x) {
    Height highest_there;
    const std::size_t end = std::min(line.shown.end, line.x.size());
    for (std::size_t i = line.shown.first + 1; i < end; ++i) {
        const double a = line.x[i - 1], b = line.x[i];
        if (x < std::min(a, b) || x > std::max(a, b)) continue;
        const double share = a == b ? 1.0 : (x - a) / (b - a);
        const double y = line.y[i - 1] + share * (line.y[i] - line.y[i - 1]);
        if (std::isfinite(y)) highest_there = highest(highest_there, y);
    }
    return highest_there;
}

// Bars take precedence over lines: a theoretical curve over them is not the measurement.
Height top_at(const Plot& plot, double x) {
    Height bars, lines;
    for (const AnyLayer& layer : plot.layers) {
        if (const auto* its = std::get_if<Bars>(&layer)) bars = highest(bars, height_at(*its, x));
        if (const auto* its = std::get_if<Line>(&layer)) lines = highest(lines, height_at(*its, x));
    }
    return bars ? bars : lines;
}

bool is_within(double value, double a, double b) {
    return value >= std::min(a, b) - 1.0 && value <= std::max(a, b) + 1.0;
}

}  // namespace

std::optional<Point> place_in(const DrawContext& dc, const Plot& plot, double x,
                              std::optional<double> y) {
    LabelPlacer placer(Rect{});
    const Frame frame = frame_of(plot, dc, placer);
    const double across = frame.x(plot.x.kind == Axis::Kind::logarithmic ? std::log10(x) : x);
    if (!is_within(across, frame.area.x, frame.area.right())) return std::nullopt;
    if (!y) y = top_at(plot, x);
    const double up = y ? frame.y(*y) : frame.area.y + 0.5 * frame.area.height;
    return Point{across, std::clamp(up, frame.area.y, frame.area.bottom())};
}

}  // namespace carom::plot
