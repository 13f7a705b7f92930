// What lies over the beads of a line, or under them: marks, rings, callouts, and where the camera
// is.
#include <functional>

#include "panels/line/line_drawing.h"

namespace carom {

void LinePanel::Drawing::draw_ghosts() const {
    if (!now.ghosts) return;
    const double line = ghost_line(dc), half = rod_half_height * u;
    for (Eigen::Index i = 0; i < count(); ++i) {
        if (std::isnan(now.ghosts->place(i, 0))) continue;
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
    draw_view_map(canvas, dc, map_of(v), {left, 0.0, width, 1.0}, view_map_share(v.zoom),
                  context.language());
}

ViewMap LinePanel::Drawing::map_of(const View& view) const {
    return view_map(dc, view.plot, 0.0, view.scale);
}

Remarks LinePanel::Drawing::remarks_in(const View& view, bool has_map) const {
    Remarks remarks(dc, view.plot, has_map ? std::optional(map_of(view)) : std::nullopt);
    remarks.add(panel.flashes_.remarks());
    return remarks;
}

// Over the world lines, as their words would hide beads elsewhere, and clear of the map and of
// remarks there.
Rect LinePanel::Drawing::place_of_callout(const std::vector<Callouts::Step>& steps, Eigen::Index,
                                          const CalloutPlate& plate,
                                          std::span<const Rect> others) const {
    const View whole = panel.whole_view(dc);
    std::vector<Point> way;
    std::vector<Rect> taken(others.begin(), others.end());
    double scale_before = 0.0;
    for (const Callouts::Step& step : steps) {
        const auto view = panel.camera_.at(static_cast<std::size_t>(step.frame));
        const View then = view ? panel.part_of(whole, *view, dc) : whole;
        double x = then.x(step.at[0]) - v.plot.x;
        if (is_ring) {  // the image nearest to the middle
            const double period = then.plot.width * then.zoom;
            x -= period * std::round(x / period - 0.5 / then.zoom);
        }
        way.push_back({v.plot.x + x, v.line_y});
        if (scale_before != then.scale) remarks_in(then, view.has_value()).take_places(taken);
        scale_before = then.scale;
    }
    return free_place(dc, v.plot, plate, way, 0.0, taken);
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
