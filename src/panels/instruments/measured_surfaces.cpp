#include "panels/instruments/measured_surfaces.h"

#include <algorithm>
#include <utility>

#include "panels/surfaces/surface_words.h"
#include "scene/instruments/instrument_reading.h"

namespace carom {
namespace {

// From side to side along an axis.
std::pair<double, double> ends_along(const Box& box, const std::vector<SurfaceState>& states,
                                     int axis) {
    const auto low = static_cast<std::size_t>(2 * axis);
    return {place_of_surface(box, states, low), place_of_surface(box, states, low + 1)};
}

double width_along(const Box& box, const std::vector<SurfaceState>& states, int axis) {
    const auto [low, high] = ends_along(box, states, axis);
    return high - low;
}

}  // namespace

std::string short_name(Language language, const Box& box, std::int32_t surface) {
    switch (surface) {
        case 0:
            return say(language, "left wall");
        case 1:
            return say(language, "right wall");
        case 2:
            return say(language, "bottom wall");
        case 3:
            return say(language, "top wall");
        default:
            return box.surfaces.names()[static_cast<std::size_t>(surface)];
    }
}

std::vector<MeterLine> lines_of_surfaces(Language language, const Box& box,
                                         const std::vector<std::int32_t>& surfaces) {
    const std::vector<std::string> columns = box.surfaces.names();
    std::vector<MeterLine> lines;
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        lines.push_back({columns[static_cast<std::size_t>(surfaces[k])],
                         short_name(language, box, surfaces[k]), surface_role(k, surfaces.size())});
    return lines;
}

double length_of_surface(const Box& box, const std::vector<SurfaceState>& states,
                         std::int32_t surface) {
    if (box.dimension == 1) return 1.0;
    const int along = 1 - box.surfaces.axis_of(surface);
    const auto [low, high] = ends_along(box, states, along);
    double length = high - low;
    const Partition* line = box.surfaces.partition(surface);
    if (line == nullptr) return length;
    for (const Gap& gap : line->gaps) {
        // One that reaches a wall goes on beyond it, where the wall may be now.
        const double begin = gap.from() > 0.0 ? std::max(gap.from(), low) : low;
        const double end = gap.to() < box.length(along) ? std::min(gap.to(), high) : high;
        length -= std::max(0.0, end - begin);
    }
    return length;
}

double push_on_surface(const AdvanceResult& advanced, const Box& box, std::int32_t surface) {
    const auto k = static_cast<std::size_t>(surface);
    if (advanced.surfaces.empty()) return advanced.impulses.wall.at(k);
    const double push = advanced.surfaces[k].impulse[box.surfaces.axis_of(surface)];
    return box.surfaces.is_side(surface) && !box.surfaces.is_far_side(surface) ? -push : push;
}

double enclosed_area(const Box& box, const std::vector<SurfaceState>& states) {
    const double along = width_along(box, states, 0);
    return box.dimension == 1 ? along : along * width_along(box, states, 1);
}

std::vector<Binding<PanelSpec>> moving_keys() {
    return option_keys(std::vector{bind_within(&MovingOptions::surfaces, surfaces_key())});
}

void check_moving(PanelSpec& panel, const Node& node, Reading& reading) {
    keep_suitable(panel, panel.options.change<MovingOptions>().surfaces,
                  {[&](std::int32_t surface) { return may_move(reading, surface); },
                   "a wall or a partition that moves",
                   "give it a `mass` or a `velocity`, or an event of the run that moves it"},
                  node, reading);
}

}  // namespace carom
