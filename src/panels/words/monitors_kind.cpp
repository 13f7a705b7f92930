// The kind of the panel in monitors_panel.cpp.
#include "panels/registry.h"
#include "panels/words/monitors_panel.h"
#include "scene/panel_kind.h"
#include "scene/reading/panel_reading.h"

namespace carom {
namespace {

std::vector<Binding<MonitorOptions>> monitor_keys() {
    return {
        bind_key(
            "numbers", &MonitorOptions::numbers, monitors_notation(),
            "The numbers that it shows. `all-collisions` includes those with walls; "
            "`return-distance` is the largest distance of a particle from where it was on the way "
            "out; `overlap` is the largest so far of two colliding disks, in per cent of the sum "
            "of their radii.")
            .default_text("time, collisions, mean-speed and mean-energy")};
}

std::unique_ptr<Panel> make_monitors(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<MonitorsPanel>(context, spec.options.as<MonitorOptions>().numbers,
                                           spec.title);
}

}  // namespace

PanelKind monitors_kind() {
    return {.name = "monitors",
            .words = Phrase{"monitors"},
            .shows = "Numbers: time, collisions, mean speed and others.",
            .make = make_monitors,
            .keys = option_keys(monitor_keys()),
            .has_plot = false};
}

}  // namespace carom
