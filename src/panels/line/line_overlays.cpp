// What lies over the beads of a line, or under them: marks, rings, callouts, and where the camera
// is.
#include <functional>

#include "panels/line/line_drawing.h"

namespace carom {

void LinePanel::Drawing::draw_ghosts() const {
    if (!now.ghosts) return;
    const double line = ghost_line(dc), half = rod_half_height * u;
    for (Eigen::Index i = 0; i < count(); ++i) {
        const double radius = shown_radius(i);
        for (const Point& at : seen_at(static_cast<double>(now.ghosts->place(i, 0)), radius))
            if (is_rod(i))
                canvas.stroke_rect({at.x - radius, at.y - half, 2.0 * radius, 2.0 * half}, line,
                                   dc.theme.muted);
            else
                canvas.stroke_circle(at, radius, line, dc.theme.muted);
    }
}

void LinePanel::Drawing::draw_rings() const {
    for (const Spotlights::Ring& ring : now.rings)
        for (const Point& at : seen_at(place(ring.particle), shown_radius(ring.particle)))
            if (!is_rod(ring.particle))
                canvas.stroke_circle(at, shown_radius(ring.particle) + 0.07 * u, 0.14 * u,
                                     with_alpha(dc.theme.ink, ring.share));
}

// In the picture of the world lines.
void LinePanel::Drawing::draw_where_it_is() const {
    const double width = 1.0 / v.zoom;
    const double left = (v.low + panel.ends_.before()) / panel.drawn_length();
    const double share = std::clamp(std::log(v.zoom) / std::log(1.3), 0.0, 1.0);
    draw_where(canvas, dc, {v.plot.x, v.plot.y, v.plot.width, v.plot.height},
               {left, 0.0, width, 1.0}, 0.0, v.scale, share, context.language());
}

// Over the world lines, as their words would hide beads elsewhere.
Rect LinePanel::Drawing::place_of_callout(const std::vector<Callouts::Step>& steps, Eigen::Index,
                                          const CalloutPlate& plate,
                                          std::span<const Rect> others) const {
    const View whole = panel.whole_view(dc);
    std::vector<Point> way;
    for (const Callouts::Step& step : steps) {
        const auto view = panel.camera_.at(static_cast<std::size_t>(step.frame));
        const View then = view ? panel.part_of(whole, *view, dc) : whole;
        double x = then.x(step.x) - v.plot.x;
        if (is_ring) {  // the image nearest to the middle
            const double period = then.plot.width * then.zoom;
            x -= period * std::round(x / period - 0.5 / then.zoom);
        }
        way.push_back({v.plot.x + x, v.line_y});
    }
    return free_place(dc, v.plot, plate, way, 0.0, others);
}

void LinePanel::Drawing::draw_callouts() const {
    const auto place = std::bind_front(&Drawing::place_of_callout, this);
    std::vector<DrawnCallout> drawn;
    for (const Callouts::Standing& its : panel.callouts_.standing(
             now.callouts, dc, std::min(17.0 * u, 0.5 * v.plot.width), place)) {
        const Eigen::Index i = its.callout.particle;
        const std::vector<Point> seen = seen_at(this->place(i), shown_radius(i));
        if (!seen.empty())
            drawn.push_back(
                {its.place, its.plate, seen.front(), half_height(i), its.callout.share});
    }
    carom::draw_callouts(canvas, dc, drawn);
}

}  // namespace carom
