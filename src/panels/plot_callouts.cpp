#include "panels/plot_callouts.h"

#include <fmt/format.h>

#include <algorithm>

#include "panels/plot/draw_plot.h"
#include "panels/plot/plot_panel.h"
#include "scene/scene.h"
#include "scene/time/captions.h"

namespace carom {

PlotCallouts::PlotCallouts(const PanelSet& panels) : panels_(panels), grid_(panels.scene().film) {
    const Film& film = panels.scene().film;
    if (film.callouts.empty()) return;
    const std::size_t first = panels.panels().size() - film.panels.size();
    const std::vector<Tick> ticks = timeline(panels.scene());
    for (const Callout& callout : film.callouts) {
        const auto* point = std::get_if<PlotPoint>(&callout.on);
        if (point == nullptr) continue;
        callouts_.push_back({&callout, first + point->panel});
        times_.push_back(showing(ticks, film, {callout.at, {}}, callout.seconds));
    }
}

double PlotCallouts::alpha(std::size_t k, const FrameData& frame) const {
    if (frame.states.empty()) return 0.0;
    return opacity(times_[k], panels_.scene().film, frame.tick.frame, caption_fade_seconds);
}

DrawContext PlotCallouts::context_of(const One& one) {
    return {grid_.place(panels_.panels()[one.panel].slot), grid_.unit(),
            theme_of(panels_.scene().film), disks_};
}

std::optional<Point> PlotCallouts::place_of(const One& one, const FrameData& frame) {
    return panels_.panels()[one.panel].panel->place_of(context_of(one), *frame.states[one.panel],
                                                       std::get<PlotPoint>(one.callout->on));
}

// Where the plot is free in the whole film, so that the words stand still, in as many lines as this
// takes; otherwise over the box around a panel that lies over it, or over the plot.
PlotCallouts::Stand PlotCallouts::stand(const One& one, Point target,
                                        std::span<const Rect> others) {
    constexpr double widest = 0.55, usual_beside = 16.0, reach = 9.5;  // share; units
    const DrawContext dc = context_of(one);
    const PanelSet::Placed& placed = panels_.panels()[one.panel];
    const auto plate_in = [&](double width, PlateMargin margin = PlateMargin::usual) {
        return callout_plate(dc, one.callout->words, width, margin);
    };
    if (const auto* panel = dynamic_cast<const PlotPanel*>(placed.panel.get())) {
        const plot::FreeRoom room = plot::free_room(dc, panel->plot(nullptr));
        if (!std::get<PlotPoint>(one.callout->on).y) target.y = room.top_at(target.x);
        const auto is_clear = [&](const Rect& place, const Point& end) {
            return room.is_free(end, target) &&
                   std::ranges::none_of(
                       others, [&](const Rect& other) { return plot::overlap(place, other); });
        };
        const auto is_free = [&](const Rect& place, const Point& end) {
            return room.is_free(place) && is_clear(place, end);
        };
        for (const double share : {widest, 0.4, 0.3, 0.22}) {
            CalloutPlate plate = plate_in(share * dc.area.width, PlateMargin::thin);
            if (const auto place = place_in_room(dc, room.area, plate, target, is_free))
                return {*place, std::move(plate)};
        }
        if (placed.is_over_box()) {
            const double out = plate_margin * dc.unit, far = reach * dc.unit;
            const Rect own{dc.area.x - out, dc.area.y - out, dc.area.width + 2.0 * out,
                           dc.area.height + 2.0 * out};
            const double wide = std::min(usual_beside * dc.unit, own.x);
            const auto is_beside = [&](const Rect& place, const Point& end) {
                return !plot::overlap(place, own) && is_clear(place, end);
            };
            CalloutPlate plate = plate_in(widest * dc.area.width);
            if (const auto place = place_in_room(
                    dc, {own.x - wide, own.y - far, own.width + wide, own.height + far}, plate,
                    target, is_beside))
                return {*place, std::move(plate)};
        }
    }
    CalloutPlate plate = plate_in(widest * dc.area.width);
    return {place_beside(dc, plot_area(dc), plate, target.x, others), std::move(plate)};
}

void PlotCallouts::draw(Canvas& canvas, const FrameData& frame,
                        const std::vector<double>& opacities, bool still) {
    std::vector<std::size_t> seen;
    for (std::size_t k = 0; k < callouts_.size(); ++k)
        if (alpha(k, frame) > 0.0) seen.push_back(k);
    if (seen.empty()) return;
    std::vector<std::optional<Point>> targets(callouts_.size());
    std::vector<CalloutPlate> plates(callouts_.size());
    const auto places = places_in_time(
        times_, seen, [&](std::size_t k, std::span<const Rect> others) -> std::optional<Rect> {
            targets[k] = place_of(callouts_[k], frame);
            if (!targets[k]) return std::nullopt;
            std::optional<Stand>& its = callouts_[k].stand;
            if (!its) its = stand(callouts_[k], *targets[k], others);
            plates[k] = its->plate;
            return its->place;
        });
    std::vector<DrawnCallout> drawn;
    for (const std::size_t k : seen) {
        const double its = opacities[callouts_[k].panel] * (still ? 1.0 : alpha(k, frame));
        if (places[k] && its > 0.0) drawn.push_back({*places[k], plates[k], *targets[k], 0.0, its});
    }
    draw_callouts(canvas, context_of(callouts_[seen.front()]), drawn);
}

void PlotCallouts::see(const FrameData& frame) {
    for (std::size_t k = 0; k < callouts_.size(); ++k) {
        One& one = callouts_[k];
        if (one.is_shown || alpha(k, frame) <= 0.0 ||
            panels_.panels()[one.panel].opacity(panels_.scene().film, frame.tick) <= 0.0)
            continue;
        one.is_due = true;
        one.is_shown = place_of(one, frame).has_value();
    }
}

std::vector<std::string> PlotCallouts::never_shown() const {
    std::vector<std::string> all;
    for (const One& one : callouts_)
        if (one.is_due && !one.is_shown) all.push_back(fmt::format("“{}”", one.callout->words));
    return all;
}

}  // namespace carom
