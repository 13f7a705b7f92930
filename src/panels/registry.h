// The panel kinds a film can show: one line each in registry.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "panels/panel.h"

namespace carom {

/// Makes a panel of `spec.kind`. An unknown kind is a programmer's error: the scene has been
/// validated.
std::unique_ptr<Panel> make_panel(const PanelContext& context, const PanelSpec& spec);

/// The box of a plane, or the wire.
std::unique_ptr<Panel> make_gas_panel(const PanelContext& context);

/// The kinds that make_panel knows.
std::span<const std::string> registered_panels();

std::unique_ptr<Panel> make_speed_histogram(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_energy_histogram(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_velocity_histogram(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_energy_by_species(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_position_histogram(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_speed_classes(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_temperature(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_entropy(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_pressure(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_return_distance(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_phase(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_positions(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_monitors(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_single_collision(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_contact_time(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_collision_map(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_text(const PanelContext& context, const PanelSpec& spec);

}  // namespace carom
