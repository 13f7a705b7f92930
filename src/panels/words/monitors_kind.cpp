// The kind of the panel in monitors_panel.cpp.
#include "panels/meters/meter.h"
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

Meter meter_of_monitors(const PanelContext& context, const PanelSpec& spec) {
    const std::vector<Monitor> numbers = or_usual(spec.options.as<MonitorOptions>().numbers);
    Meter meter{.quantity = numbers.size() == 1 ? quantity_of(numbers.front())
                                                : quantities::number.named(Phrase{"monitors"})};
    for (const Monitor number : numbers) {
        const std::string name(quantity_of(number).word.english);
        meter.lines.push_back({name, numbers.size() == 1 ? "" : name});
    }
    meter.needs_positions = false;
    meter.read = [context, numbers](const FrameInput& input) {
        const MonitorNumbers all = monitor_numbers(context, input);
        std::vector<double> now;
        for (const Monitor number : numbers) now.push_back(all.at(index_of(number)));
        return now;
    };
    return meter;
}

}  // namespace

PanelKind monitors_kind() {
    return {.name = "monitors",
            .words = Phrase{"monitors"},
            .shows = "Numbers: time, collisions, mean speed and others.",
            .make = make_monitors,
            .meter = meter_of_monitors,
            .asked = {{.name = "time", .meaning = "the time", .options = "numbers: [time]"},
                      {.name = "collisions",
                       .meaning = "the collisions between particles so far",
                       .options = "numbers: [collisions]"},
                      {.name = "all_collisions",
                       .meaning = "the collisions so far, those with walls included",
                       .options = "numbers: [all-collisions]"},
                      {.name = "mean_energy",
                       .meaning = "the mean kinetic energy of a particle",
                       .options = "numbers: [mean-energy]"}},
            .keys = option_keys(monitor_keys()),
            .has_plot = false};
}

}  // namespace carom
