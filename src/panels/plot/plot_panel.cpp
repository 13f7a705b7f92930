#include "panels/plot/plot_panel.h"

#include "panels/plot/draw_plot.h"

namespace carom {

void PlotPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    draw_plot(canvas, dc, plot(nullptr), plot::Part::still);
}

void PlotPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const plot::Plot now = plot(&state);
    draw_plot(canvas, dc, now, plot::Part::changing);
    plot::draw_arriving_names(canvas, dc, plot(nullptr), now);
}

std::optional<Point> PlotPanel::place_of(const DrawContext& dc, const PanelState& state,
                                         const PlotPoint& point) const {
    return plot::place_in(dc, plot(&state), point.x, point.y);
}

Table PlotPanel::table(const PanelState& state, const Theme&) const {
    return table_of(plot(&state));
}

std::shared_ptr<const PanelState> PlotPanel::state_of_runs(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    auto all = std::make_shared<ShownState>();
    for (const auto& state : states)
        all->shown.push_back(dynamic_cast<const ShownState&>(*state).shown.front());
    return all;
}

}  // namespace carom
