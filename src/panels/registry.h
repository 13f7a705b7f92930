// The panel kinds a film can show: one line each in registry.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "panels/panel.h"

namespace carom {

/// Makes a panel of `spec.kind`. An unknown kind is a programmer's error: the scene has been
/// validated.
std::unique_ptr<Panel> make_panel(const Cast& cast, const PanelSpec& spec);

/// The box of a plane, or the wire.
std::unique_ptr<Panel> make_gas_panel(const Cast& cast);

/// The kinds that make_panel knows.
std::span<const std::string> registered_panels();

std::unique_ptr<Panel> make_speed_histogram(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_energy_histogram(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_velocity_histogram(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_energy_by_species(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_position_histogram(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_speed_classes(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_temperature(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_entropy(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_pressure(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_return_distance(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_phase(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_positions(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_monitors(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_single_collision(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_contact_time(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_collision_map(const Cast& cast, const PanelSpec& spec);
std::unique_ptr<Panel> make_text(const Cast& cast, const PanelSpec& spec);

}  // namespace carom
