// Position against velocity along one axis, a point for each particle.
#include <algorithm>

#include "panels/chosen.h"
#include "panels/gas/flights.h"
#include "panels/plots/points_panel.h"
#include "panels/registry.h"

namespace carom {

std::unique_ptr<Panel> make_phase(const PanelContext& context, const PanelSpec& spec) {
    const Box& box = context.scene.gas.box;
    const Eigen::Index axis = spec.component == Component::y ? 1 : 0;
    const std::string along = box.dimension == 1 ? "" : axis == 1 ? " along y" : " along x";
    const std::vector<Chosen> chosen = choices(spec);
    std::vector<std::vector<Eigen::Index>> lists;
    for (const Chosen& one : chosen) lists.push_back(members(context, one));
    std::vector<Flights> flights;  // of the first of each: of several there is no path
    for (const std::vector<Eigen::Index>& list : lists)
        flights.emplace_back(box, axis, std::vector<Eigen::Index>{list.front()});
    PointsSubject subject{
        .titles = [context, spec, chosen](const Theme& theme) -> std::vector<std::string> {
            if (spec.title) return {escape_markup(*spec.title)};
            const std::string words = "Position and velocity";
            if (spec.of.empty()) return {words};
            const std::string names =
                colored_names(context, chosen, theme, " and ", NameMark::disk);
            return {words + " of " + names, names};  // the axes say the rest
        },
        .across = "position" + along,
        .up = "velocity" + along,
        .width = {0.0, box.size[axis]},
        .height = {},
        .sets = chosen.size(),
        .points =
            [lists, axis](const FrameInput& o, std::size_t set) {
                std::vector<Point> points;
                for (const Eigen::Index i : lists[set])
                    points.push_back({o.sample.position(i, axis), o.sample.velocity(i, axis)});
                return points;
            },
        .color =
            [context, chosen](std::size_t k, const Theme& theme) {
                return chosen.size() == 1 ? theme.bar : choice_color(context, chosen[k], k, theme);
            },
        .corners =
            [flights](const FrameInput& o, std::size_t set) mutable {
                std::vector<Point> points;
                for (const Flights::Corner& corner : flights[set].see(o))
                    for (const double velocity : {corner.before[0], corner.after[0]})
                        points.push_back({corner.place[0], velocity});
                return points;
            },
        .breaks_across = 0.5 * box.size[axis],
        .columns = {column_name("position" + along, reduced::length),
                    column_name("velocity" + along, reduced::speed)}};
    if (std::ranges::none_of(lists, [](const auto& list) { return list.size() == 1; }))
        subject.corners = nullptr;
    for (const Chosen& one : chosen) subject.names.push_back(name_of(context, one));
    return std::make_unique<PointsPanel>(std::move(subject));
}

}  // namespace carom
