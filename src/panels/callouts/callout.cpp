#include "panels/callouts/callout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "draw/formula/words.h"
#include "panels/callouts/scrim.h"

namespace carom {
namespace {

constexpr double across = 0.7, above = 0.5;  // around the words, units
constexpr double thin_margin = 0.4;          // share of that, where nothing is near
constexpr double line_height = 1.35;         // of the size of the words
constexpr double callout_line = 0.08;        // units
constexpr double dimmed = 0.82;              // share of the page's colour under the words
constexpr double feather = 0.5;              // of that, units
constexpr double clear = 1.6;                // units, from a target to its plate
constexpr double clear_in_plot = 0.3;        // the same in a plot
constexpr int columns = 9, rows = 9;         // of places that are tried
constexpr std::size_t most_lines = 6;

Point nearest_in(const Rect& rect, Point at) {
    return {std::clamp(at.x, rect.x, rect.right()), std::clamp(at.y, rect.y, rect.bottom())};
}

double distance(const Rect& rect, Point at) {
    const Point nearest = nearest_in(rect, at);
    return std::hypot(at.x - nearest.x, at.y - nearest.y);
}

bool meet(const Rect& a, const Rect& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool meet(const Showing& a, const Showing& b) { return a.first <= b.last && b.first <= a.last; }

TextStyle words_style(const DrawContext& dc) {
    TextStyle style = title_style(dc);
    style.tabular = false;
    return style;
}

}  // namespace

CalloutPlate callout_plate(const DrawContext& dc, const std::string& words, double most_width,
                           PlateMargin margin) {
    const double share = margin == PlateMargin::thin ? thin_margin : 1.0;
    CalloutPlate plate;
    plate.across = share * across * dc.unit;
    plate.above = share * above * dc.unit;
    TextStyle style = words_style(dc);
    style.max_width = std::max(6.0 * dc.unit, most_width - 2.0 * plate.across);
    plate.lines = wrapped_words(words, style, most_lines);
    for (const std::string& line : plate.lines)
        plate.width = std::max(plate.width, measure_words(line, style).width);
    plate.width += 2.0 * plate.across;
    plate.height = 2.0 * plate.above;
    for (const std::string& line : plate.lines)
        plate.height += line_height_of(line, style, line_height).all;
    return plate;
}

Rect free_place(const DrawContext& dc, const Rect& area, const CalloutPlate& plate,
                std::span<const Point> way, double reach, std::span<const Rect> others) {
    const double margin = 0.5 * dc.unit, apart = reach + clear * dc.unit;
    const double wide = std::max(0.0, area.width - plate.width - 2.0 * margin);
    const double high = std::max(0.0, area.height - plate.height - 2.0 * margin);
    Rect best{area.x + margin, area.y + margin, plate.width, plate.height};
    double least = std::numeric_limits<double>::infinity();
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Rect place{area.x + margin + wide * column / (columns - 1),
                             area.y + margin + high * row / (rows - 1), plate.width, plate.height};
            double cost = 0.0, nearest = std::numeric_limits<double>::infinity();
            for (const Point& at : way) {
                const double off = distance(place, at);
                cost += off / static_cast<double>(way.size());
                nearest = std::min(nearest, off);
            }
            if (nearest < apart) cost += 100.0 * (apart - nearest) + area.width;
            for (const Rect& other : others)
                if (meet(place, other)) cost += 1000.0 * area.width;
            if (cost >= least) continue;
            least = cost;
            best = place;
        }
    return best;
}

std::vector<std::optional<Rect>> places_in_time(
    std::span<const Showing> times, std::span<const std::size_t> seen,
    const std::function<std::optional<Rect>(std::size_t, std::span<const Rect>)>& place_of) {
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return times[k].first; });
    std::vector<bool> counts(times.size(), false);
    for (const std::size_t k : seen) counts[k] = true;
    for (std::size_t later = order.size(); later-- > 0;)
        for (std::size_t i = 0; i < later && counts[order[later]]; ++i)
            if (meet(times[order[i]], times[order[later]])) counts[order[i]] = true;
    std::vector<std::optional<Rect>> places(times.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t k = order[i];
        if (!counts[k]) continue;
        std::vector<Rect> others;
        for (const std::size_t first : std::span(order).first(i))
            if (places[first] && meet(times[first], times[k])) others.push_back(*places[first]);
        places[k] = place_of(k, others);
    }
    return places;
}

Rect place_beside(const DrawContext& dc, const Rect& area, const CalloutPlate& plate, double x,
                  std::span<const Rect> others) {
    const double apart = clear * dc.unit;
    const double most = std::max(area.x, area.right() - plate.width);
    const double high = std::max(0.0, area.height - plate.height);
    const bool is_right = area.right() - x > x - area.x;
    Rect best{0.0, 0.0, plate.width, plate.height};
    double least = std::numeric_limits<double>::infinity();
    for (const bool right : {is_right, !is_right})
        for (int row = 0; row < rows; ++row) {
            const double left = right ? x + apart : x - apart - plate.width;
            const Rect place{std::clamp(left, area.x, most), area.y + high * row / (rows - 1),
                             plate.width, plate.height};
            double cost = std::abs(place.y - area.y - 0.5 * high);
            if (right != is_right) cost += area.height;
            for (const Rect& other : others)
                if (meet(place, other)) cost += 1000.0 * area.height;
            if (cost >= least) continue;
            least = cost;
            best = place;
        }
    return best;
}

std::optional<Rect> place_in_room(
    const DrawContext& dc, const Rect& area, const CalloutPlate& plate, Point target,
    const std::function<bool(const Rect& place, const Point& end)>& is_free) {
    constexpr int places_across = 41, places_up = 41;
    const double wide = area.width - plate.width, high = area.height - plate.height;
    if (wide < 0.0 || high < 0.0) return {};
    std::optional<Rect> best;
    double least = std::numeric_limits<double>::infinity();
    for (int row = 0; row < places_up; ++row)
        for (int column = 0; column < places_across; ++column) {
            const Rect place{area.x + wide * column / (places_across - 1),
                             area.y + high * row / (places_up - 1), plate.width, plate.height};
            const double off = distance(place, target);
            if (off >= least || off < clear_in_plot * dc.unit ||
                !is_free(place, nearest_in(place, target)))
                continue;
            least = off;
            best = place;
        }
    return best;
}

namespace {

void draw_line_of(Canvas& canvas, const DrawContext& dc, const DrawnCallout& callout) {
    const auto& [place, plate, target, reach, alpha] = callout;
    const double u = dc.unit, line = callout_line * u;
    const Point from = nearest_in(place, target);
    const double length = std::hypot(target.x - from.x, target.y - from.y);
    const double gap = reach + 0.2 * u;
    if (length <= gap) return;
    const double share = (length - gap) / length;
    const Point to{from.x + share * (target.x - from.x), from.y + share * (target.y - from.y)};
    canvas.stroke_line(from, to, line + 0.16 * u, with_alpha(dc.theme.page, 0.7 * alpha));
    canvas.stroke_line(from, to, line, with_alpha(dc.theme.ink, alpha));
}

void draw_words_of(Canvas& canvas, const DrawContext& dc, const DrawnCallout& callout) {
    const double u = dc.unit;
    const Rect& place = callout.place;
    draw_scrim(canvas, place, feather * u, with_alpha(dc.theme.page, dimmed * callout.alpha));
    TextStyle style = words_style(dc);
    style.color = with_alpha(dc.theme.ink, callout.alpha);
    style.max_width = place.width - 2.0 * callout.plate.across + 1.0;
    double top = place.y + callout.plate.above;
    for (const std::string& words : callout.plate.lines) {
        const LineHeight height = line_height_of(words, style, line_height);
        draw_words(canvas, {place.x + callout.plate.across, top + height.above}, words, style);
        top += height.all;
    }
}

}  // namespace

void draw_callouts(Canvas& canvas, const DrawContext& dc, std::span<const DrawnCallout> callouts) {
    for (const DrawnCallout& one : callouts) draw_line_of(canvas, dc, one);
    for (const DrawnCallout& one : callouts) draw_words_of(canvas, dc, one);
}

}  // namespace carom
