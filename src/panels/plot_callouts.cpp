#include "panels/plot_callouts.h"

#include <fmt/format.h>

#include "panels/callouts/callout.h"
#include "scene/time/captions.h"

namespace carom {

PlotCallouts::PlotCallouts(const PanelSet& panels)
    : panels_(panels), grid_(panels.scene().film.layout, panels.scene().film.size) {
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
            theme_of(panels_.scene().film.theme), disks_};
}

// Over the plate of a panel that lies over the box, where there is no room in the plot.
Rect PlotCallouts::area_of(const One& one) {
    constexpr double height = 9.5, gap = 0.3;  // units
    const DrawContext dc = context_of(one);
    if (!panels_.panels()[one.panel].is_over_box()) return plot_area(dc);
    const double bottom = dc.area.y - (plate_margin + gap) * dc.unit;
    return {dc.area.x, bottom - height * dc.unit, dc.area.width, height * dc.unit};
}

std::optional<Point> PlotCallouts::place_of(const One& one, const FrameData& frame) {
    return panels_.panels()[one.panel].panel->place_of(context_of(one), *frame.states[one.panel],
                                                       std::get<PlotPoint>(one.callout->on));
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
            const DrawContext dc = context_of(callouts_[k]);
            plates[k] = callout_plate(dc, callouts_[k].callout->words, 0.55 * dc.area.width);
            return place_beside(dc, area_of(callouts_[k]), plates[k], targets[k]->x, others);
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
