// Position against velocity along one axis, a point for each particle.
#include <algorithm>

#include "panels/chosen.h"
#include "panels/gas/flights.h"
#include "panels/plot/clock_samples.h"
#include "panels/plots/points_panel.h"
#include "panels/registry.h"
#include "panels/surfaces/side_extent.h"
#include "physics/gas.h"
#include "scene/panel_kind.h"
#include "scene/reading/gas_reading.h"

namespace carom {
namespace {

std::vector<plot::Text> titles(const PanelContext& context, const PanelSpec& spec,
                               const std::vector<Chosen>& chosen) {
    if (spec.title) return {escape_markup(*spec.title)};
    const std::string words = say(context.language(), "Position and velocity");
    if (spec.of.empty()) return {words};
    return {shown_of(context, words, chosen, plot::Swatch::disk),
            names_of(context, chosen, plot::Swatch::disk)};  // the axes say the rest
}

// The number of points in a sample; 0 if it is not known yet.
double points_in_each(const PanelSpec& panel, const Gas& gas) {
    const auto all = static_cast<double>(particles_in(gas).value_or(0));
    double sum = panel.of.empty() ? all : 0.0;
    for (const Chosen& one : panel.of) {
        if (one.particle)
            sum += 1.0;
        else if (one.species)
            sum += static_cast<double>(gas.species[*one.species].count);
        else
            sum += all;
    }
    return sum;
}

void check_phase(PanelSpec& panel, const Node& node, Reading& reading) {
    if (panel.options.as<PointOptions>().by_clock)
        check_samples_of_points(points_in_each(panel, reading.gas), node, reading);
}

std::unique_ptr<Panel> make_phase(const PanelContext& context, const PanelSpec& spec) {
    const Box& box = context.box();
    const Eigen::Index axis = axis_of(spec);
    const auto along = [&](Phrase alone, Phrase x, Phrase y, Phrase z) {
        return box.dimension == 1 ? alone : axis == 0 ? x : axis == 1 ? y : z;
    };
    const Quantity position =
        quantities::length.named(along(Phrase{"position"}, Phrase{"position along x"},
                                       Phrase{"position along y"}, Phrase{"position along z"}));
    const Quantity velocity =
        quantities::velocity.named(along(Phrase{"velocity"}, Phrase{"velocity along x"},
                                         Phrase{"velocity along y"}, Phrase{"velocity along z"}));
    const std::vector<Chosen> chosen = choices(spec);
    const std::vector<std::vector<Eigen::Index>> lists = members(context, chosen);
    std::vector<Flights> flights;  // of the first of each: of several there is no path
    for (const std::vector<Eigen::Index>& list : lists)
        flights.emplace_back(box, context.run(), axis, std::vector<Eigen::Index>{list.front()});
    PointsSubject subject{
        .titles = titles(context, spec, chosen),
        .language = context.language(),
        .across = say(context.language(), position.word),
        .up = say(context.language(), velocity.word),
        .width = {0.0, box.size[axis]},
        .widen = [box, axis](PointsSubject& its,
                             const FrameInput& o) { widen_to_sides(its.width, box, axis, o); },
        .height = {},
        .sets = {},
        .points =
            [of = Members(context, chosen), axis](const FrameInput& o, std::size_t set) mutable {
                std::vector<Point> points;
                for (const Eigen::Index i : of.at(o.sample)[set])
                    points.push_back({o.sample.position(i, axis), o.sample.velocity(i, axis)});
                return points;
            },
        .corners =
            [flights, lists, of = Members(context, chosen)](const FrameInput& o,
                                                            std::size_t set) mutable {
                std::vector<Point> points;
                const std::vector<Flights::Corner> corners = flights[set].see(o);
                if (of.at(o.sample)[set] != lists[set]) return points;
                for (const Flights::Corner& corner : corners)
                    for (const double up : {corner.before[0], corner.after[0]})
                        points.push_back({corner.place[0], up});
                return points;
            },
        .fades = true,
        .breaks_across = 0.5 * box.size[axis],
        .columns = {position, velocity}};
    if (std::ranges::none_of(lists, [](const auto& list) { return list.size() == 1; }))
        subject.corners = nullptr;
    for (std::size_t k = 0; k < chosen.size(); ++k)
        subject.sets.push_back(
            {column_name_of(context.scene, chosen[k]), role_among(context, chosen, k)});
    show_samples(context, spec, subject);
    return std::make_unique<PointsPanel>(std::move(subject));
}

}  // namespace

PanelKind phase_kind() {
    using enum Ability;
    return {.name = "phase",
            .words = Phrase{"phase space"},
            .shows =
                "Position and velocity along one axis, a point for each particle; a single "
                "particle leaves a path that fades with age.",
            .make = make_phase,
            .abilities = {of, component},
            .keys = point_keys(),
            .rule = check_phase,
            .suits = [](const Gas& gas, const Run&) { return gas.box.dimension == 1; },
            .draws_particles = true};
}

}  // namespace carom
