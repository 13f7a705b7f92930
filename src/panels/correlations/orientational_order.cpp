// The hexagonal order of disks against time: the local order of each disk's neighbours, and the
// global order of the whole gas, in which crystals of different orientations cancel.
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "physics/box.h"
#include "scene/panel_kind.h"
#include "stats/pairs/bond_order.h"
#include "util/text.h"

namespace carom {
namespace {

// Beads on a line have no hexagonal order.
void check_orientational_order(PanelSpec&, const Node& node, Reading& reading) {
    if (reading.box().dimension > 1) return;
    reading.errors.add(node.is_mapping() ? *given(node, "kind") : node,
                       "beads on a line have no hexagonal order",
                       "give a box with a `size`, or another panel");
}

SeriesSubject orientational_order(const PanelContext& context, const PanelSpec&) {
    const Language language = context.language();
    const bool is_deep = context.box().dimension == 3;
    SeriesSubject subject{
        {.title = is_deep ? say(language, "Orientational order") + " <i>q</i><sub>6</sub>"
                          : say(language, "Hexagonal order"),
         .quantity = quantities::number.named(is_deep ? Phrase{"orientational order"}
                                                      : Phrase{"hexagonal order"}),
         .lines = {{"whole gas", say(language, "whole gas"), {.of = plot::Role::Of::highlight}},
                   {"neighbours of each", say(language, "local")}}}};
    subject.read = [context](const FrameInput& o) -> std::vector<double> {
        const Eigen::ArrayXXcd order =
            bond_order(context.box(), context.particles, o.sample.position);
        return {global_order(order), local_order(order)};
    };
    subject.top = 1.0;
    subject.compared_title = subject.title;
    return subject;
}

}  // namespace

PanelKind orientational_order_kind() {
    using enum Ability;
    return series_kind<orientational_order>(
        {.name = "orientational-order",
         .words = Phrase{"hexagonal order"},
         .shows =
             "The hexagonal order against time, in space the order *q*6 of Steinhardt, Nelson and "
             "Ronchetti: of each particle's neighbours, and of the whole gas.",
         .abilities = {means, comparison},
         .rule = check_orientational_order,
         .work = always(PanelWork{.finds_neighbours = true}),
         .words_in_space = Phrase{"orientational order"}});
}

}  // namespace carom
