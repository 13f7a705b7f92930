// The kinds of panel, all in one list. A new kind is a file that makes it and an entry in
// registry.cpp: the keys that it takes, their check, the schema and the reference page follow from
// the entry.
#pragma once

#include <memory>
#include <span>

#include "panels/panel.h"

namespace carom {

struct PanelKind;  // scene/panel_kind.h

/// All kinds, in the order in which messages and pages list them. The list lives as long as the
/// program.
std::span<const PanelKind> panel_kinds();

/// Makes a panel of `spec.kind`. An unknown kind is a programmer's error: the scene has been
/// validated.
std::unique_ptr<Panel> make_panel(const PanelContext& context, const PanelSpec& spec);

/// The box of a plane, or the wire.
std::unique_ptr<Panel> make_gas_panel(const PanelContext& context);

std::unique_ptr<Panel> make_speed_histogram(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_energy_histogram(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_velocity_histogram(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_energy_by_species(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_position_histogram(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_speed_classes(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_temperature(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_entropy(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_pressure(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_mean_squared_displacement(const PanelContext& context,
                                                      const PanelSpec& spec);
std::unique_ptr<Panel> make_return_distance(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_phase(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_positions(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_monitors(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_single_collision(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_contact_time(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_collision_map(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_text(const PanelContext& context, const PanelSpec& spec);

}  // namespace carom
