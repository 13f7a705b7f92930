#include "panels/instruments/measured_surfaces.h"

#include <algorithm>
#include <array>
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
    constexpr std::array walls{Phrase{"left wall"}, Phrase{"right wall"}, Phrase{"bottom wall"},
                               Phrase{"top wall"},  Phrase{"back wall"},  Phrase{"front wall"}};
    const auto k = static_cast<std::size_t>(surface);
    return box.surfaces.is_side(surface) ? say(language, walls.at(k)) : box.surfaces.names()[k];
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

double size_of_surface(const Box& box, const std::vector<SurfaceState>& states,
                       std::int32_t surface) {
    const int own = box.surfaces.axis_of(surface);
    // What a part encloses whose ends along an axis are known: that of the other axes.
    const auto size_of = [&](const auto& length_along) {
        double size = 1.0;
        std::size_t k = 0;
        for (int axis = 0; axis < box.dimension; ++axis)
            if (axis != own) size *= length_along(axis, k++);
        return size;
    };
    double size = size_of([&](int axis, std::size_t) { return width_along(box, states, axis); });
    const Partition* partition = box.surfaces.partition(surface);
    if (partition == nullptr) return size;
    for (const Gap& gap : partition->gaps)
        size -= size_of([&](int axis, std::size_t k) {
            // One that reaches a wall goes on beyond it, where the wall may be now.
            const auto [low, high] = ends_along(box, states, axis);
            const double begin = gap.low.at(k) > 0.0 ? std::max(gap.low.at(k), low) : low;
            const double end =
                gap.high.at(k) < box.length(axis) ? std::min(gap.high.at(k), high) : high;
            return std::max(0.0, end - begin);
        });
    return size;
}

double push_on_surface(const AdvanceResult& advanced, const Box& box, std::int32_t surface) {
    const auto k = static_cast<std::size_t>(surface);
    if (advanced.surfaces.empty()) return advanced.impulses.wall.at(k);
    const double push = advanced.surfaces[k].impulse[box.surfaces.axis_of(surface)];
    return box.surfaces.is_side(surface) && !box.surfaces.is_far_side(surface) ? -push : push;
}

double enclosed_content(const Box& box, const std::vector<SurfaceState>& states) {
    double content = 1.0;
    for (int axis = 0; axis < box.dimension; ++axis) content *= width_along(box, states, axis);
    return content;
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
