// One particle's position against another's along one axis, with the path so far.
#include "panels/chosen.h"
#include "panels/gas/flights.h"
#include "panels/plot/clock_samples.h"
#include "panels/plots/points_panel.h"
#include "panels/registry.h"
#include "panels/surfaces/side_extent.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

// The name of the only particle of its kind says more than its number.
std::string name_on_axis(const PanelContext& context, const Chosen& chosen) {
    const std::string single = single_name(context, static_cast<Eigen::Index>(*chosen.particle));
    return escape_markup(single.empty() ? name_of(context.scene, chosen) : single);
}

void check_positions(PanelSpec& panel, const Node& node, Reading& reading) {
    if (panel.options.as<PointOptions>().by_clock) check_samples_of_points(1.0, node, reading);
}

std::unique_ptr<Panel> make_positions(const PanelContext& context, const PanelSpec& spec) {
    const Box& box = context.box();
    const Eigen::Index axis = axis_of(spec);
    const Phrase title = box.dimension == 1 ? Phrase{"Positions of two particles"}
                         : axis == 0        ? Phrase{"Positions of two particles along x"}
                         : axis == 1        ? Phrase{"Positions of two particles along y"}
                                            : Phrase{"Positions of two particles along z"};
    const auto first = static_cast<Eigen::Index>(spec.of.at(0).particle.value());
    const auto second = static_cast<Eigen::Index>(spec.of.at(1).particle.value());
    const double length = box.size[axis];
    PointsSubject subject{
        .titles = {spec.title ? escape_markup(*spec.title) : say(context.language(), title)},
        .language = context.language(),
        .across = name_on_axis(context, spec.of[0]),
        .up = name_on_axis(context, spec.of[1]),
        .width = {0.0, length},
        .widen =
            [box, axis](PointsSubject& its, const FrameInput& o) {
                widen_to_sides(its.width, box, axis, o);
                widen_to_sides(*its.height, box, axis, o);
            },
        .height = std::pair{0.0, length},
        .sets = {{"both"}},
        .points =
            [first, second, axis](const FrameInput& o, std::size_t) {
                if (!is_present(o.sample, first) || !is_present(o.sample, second))
                    return std::vector<Point>{};
                return std::vector<Point>{
                    {o.sample.position(first, axis), o.sample.position(second, axis)}};
            },
        .corners =
            [flights = Flights(box, context.run(), axis, {first, second}), first, second](
                const FrameInput& o, std::size_t) mutable {
                std::vector<Point> points;
                const std::vector<Flights::Corner> corners = flights.see(o);
                if (!is_present(o.sample, first) || !is_present(o.sample, second)) return points;
                for (const Flights::Corner& corner : corners)
                    points.push_back({corner.place[0], corner.place[1]});
                return points;
            },
        .never_equal = box.dimension == 1 && !box.is_periodic(0),  // they keep their order
        .breaks_across = 0.5 * length,
        .breaks_up = 0.5 * length,
        .columns = {{"position of " + column_name_of(context.scene, spec.of[0]),
                     quantities::length},
                    {"position of " + column_name_of(context.scene, spec.of[1]),
                     quantities::length}}};
    show_samples(context, spec, subject);
    return std::make_unique<PointsPanel>(std::move(subject));
}

}  // namespace

PanelKind positions_kind() {
    using enum Ability;
    return {.name = "positions",
            .words = Phrase{"positions"},
            .shows = "The position of one particle against that of another, with the path so far.",
            .make = make_positions,
            .abilities = {of, two, component},
            .keys = point_keys(),
            .rule = check_positions,
            .draws_particles = true};
}

}  // namespace carom
