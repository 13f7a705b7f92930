#include "panels/plot/plot_panel.h"

#include "panels/plot/draw_plot.h"

namespace carom {

void PlotPanel::set_axis_words(std::optional<std::string> x, std::optional<std::string> y) {
    x_words_ = std::move(x);
    y_words_ = std::move(y);
}

plot::Plot PlotPanel::shown(const PanelState* state) const {
    plot::Plot plot = this->plot(state);
    if (x_words_) {
        plot.x.title = escape_markup(*x_words_);
        plot.x.short_title = {};
    }
    if (y_words_) plot.y.title = escape_markup(*y_words_);
    plot.y.is_titled_by_scene = y_words_.has_value();
    if (units_ == UnitSystem::real) plot.units = units_;
    name_units(plot);
    return plot;
}

void PlotPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    draw_plot(canvas, dc, shown(nullptr), plot::DrawnPart::still);
}

void PlotPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const plot::Plot now = shown(&state);
    draw_plot(canvas, dc, now, plot::DrawnPart::changing);
    plot::draw_arriving_names(canvas, dc, *with_fixed_names(dc), now);
}

std::shared_ptr<const plot::Plot> PlotPanel::with_fixed_names(const DrawContext& dc) const {
    const std::array<double, 5> place{dc.area.x, dc.area.y, dc.area.width, dc.area.height, dc.unit};
    const std::scoped_lock lock(names_.access);
    if (!names_.plot || names_.place != place || names_.theme != &dc.theme) {
        names_.plot =
            std::make_shared<const plot::Plot>(plot::with_fixed_names(shown(nullptr), dc));
        names_.place = place;
        names_.theme = &dc.theme;
    }
    return names_.plot;
}

std::optional<Point> PlotPanel::place_of(const DrawContext& dc, const PanelState& state,
                                         const PlotPoint& point) const {
    return plot::place_in(dc, shown(&state), point.x, point.y);
}

Table PlotPanel::table(const PanelState& state, const Theme&) const {
    plot::Plot now = plot(&state);
    if (units_ == UnitSystem::real) now.units = units_;
    return table_of(now);
}

std::shared_ptr<const PanelState> PlotPanel::state_of_runs(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    auto all = std::make_shared<ShownState>();
    for (const auto& state : states)
        all->shown.push_back(dynamic_cast<const ShownState&>(*state).shown.front());
    return all;
}

}  // namespace carom
