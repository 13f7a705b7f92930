#include "panels/registry.h"

#include <array>
#include <cassert>

#include "panels/gas/gas_panel.h"
#include "panels/line/line_panel.h"

namespace carom {
namespace {

struct Entry {
    std::string kind;
    std::unique_ptr<Panel> (*make)(const PanelContext&, const PanelSpec&);
};

const std::array entries{
    Entry{"speed-histogram", make_speed_histogram},
    Entry{"energy-histogram", make_energy_histogram},
    Entry{"velocity-histogram", make_velocity_histogram},
    Entry{"position-histogram", make_position_histogram},
    Entry{"energy-by-species", make_energy_by_species},
    Entry{"speed-classes", make_speed_classes},
    Entry{"temperature", make_temperature},
    Entry{"entropy", make_entropy},
    Entry{"pressure", make_pressure},
    Entry{"return-distance", make_return_distance},
    Entry{"phase", make_phase},
    Entry{"positions", make_positions},
    Entry{"monitors", make_monitors},
    Entry{"single-collision", make_single_collision},
    Entry{"contact-time", make_contact_time},
    Entry{"collision-map", make_collision_map},
    Entry{"text", make_text},
};

}  // namespace

std::unique_ptr<Panel> make_gas_panel(const PanelContext& context) {
    if (context.scene.gas.box.dimension == 1) return std::make_unique<WirePanel>(context);
    return std::make_unique<GasPanel>(context);
}

std::unique_ptr<Panel> make_panel(const PanelContext& context, const PanelSpec& spec) {
    for (const Entry& entry : entries)
        if (entry.kind == spec.kind) return entry.make(context, spec);
    assert(false && "a validated scene names only registered panels");
    return nullptr;
}

std::span<const std::string> registered_panels() {
    static const std::array<std::string, entries.size()> kinds = [] {
        std::array<std::string, entries.size()> names;
        for (std::size_t i = 0; i < entries.size(); ++i) names[i] = entries[i].kind;
        return names;
    }();
    return kinds;
}

}  // namespace carom
