// The hexagonal order of disks against time: the local order of each disk's neighbours, and the
// global order of the whole gas, in which crystals of different orientations cancel.
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "physics/box.h"
#include "scene/panel_kind.h"
#include "stats/paths/bond_order.h"
#include "util/text.h"

namespace carom {
namespace {

// Beads on a line have no hexagonal order.
void check_orientational_order(PanelSpec&, const Node& node, Reading& reading) {
    if (reading.box().dimension == 2) return;
    reading.errors.add(node.is_mapping() ? *given(node, "kind") : node,
                       "beads on a line have no hexagonal order",
                       "give a box with a `size`, or another panel");
}

std::unique_ptr<Panel> make_orientational_order(const PanelContext& context,
                                                const PanelSpec& spec) {
    const Language language = context.language();
    SeriesSubject subject{.measure = [context](const FrameInput& o) -> std::vector<double> {
                              const Eigen::ArrayXcd order =
                                  bond_order(context.box(), context.particles, o.sample.position);
                              return {std::abs(order.mean()), order.abs().mean()};
                          },
                          .lines = {{"whole gas", {.of = plot::Role::Of::highlight}},
                                    {"neighbours of each", {.of = plot::Role::Of::bar}}},
                          .titles = {},
                          .top = 1.0,
                          .quantity = quantities::number.named(Phrase{"hexagonal order"})};
    const std::string title = say(language, "Hexagonal order");
    subject.names = {say(language, "whole gas"), say(language, "local")};
    title_with_names(subject, language, title);
    subject.compared_title = title;
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace

PanelKind orientational_order_kind() {
    using enum Ability;
    return {
        .name = "orientational-order",
        .words = Phrase{"hexagonal order"},
        .shows =
            "The hexagonal order against time: of each disk's neighbours, and of the whole gas.",
        .make = make_orientational_order,
        .abilities = {means, comparison},
        .rule = check_orientational_order,
        .work = always(PanelWork{.finds_neighbours = true})};
}

}  // namespace carom
