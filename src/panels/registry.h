// The list of all kinds of panel. A new kind needs a file that makes it and an entry in
// registry.cpp, from which the accepted keys, their check, the schema and the reference page
// follow.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "panels/panel.h"

namespace carom {

struct PanelKind;  // scene/panel_kind.h

/// All kinds, in the order in which messages and pages list them. The list lives as long as the
/// program.
std::span<const PanelKind> panel_kinds();

/// The title that a scene gives a panel, or what its kind is called in a language.
std::string name_of_panel(Language language, const PanelSpec& spec);

/// Makes a panel of `spec.kind`. An unknown kind is a programmer's error: the scene has been
/// validated.
std::unique_ptr<Panel> make_panel(const PanelContext& context, const PanelSpec& spec);

/// Makes the panel of the box (2-D) or of the wire (1-D), either with a constant `view` or with
/// that of the film's camera.
std::unique_ptr<Panel> make_gas_panel(const PanelContext& context,
                                      const std::optional<View>& view = {});

/// Makes the line of text under the box of run number `run` of two: its label, in the colour that
/// the run has in plots, and as many of the numbers of `spec`, except the time, as there is room
/// for in the lines of both runs.
std::unique_ptr<Panel> make_run_line(const PanelContext& context, const PanelSpec& spec,
                                     const std::array<std::string, 2>& labels, std::size_t run);

/// Makes the clock of a film, and the line of its other numbers, with the names `numbers`.
std::unique_ptr<Panel> make_clock(const PanelContext& context);
std::unique_ptr<Panel> make_numbers_line(const PanelContext& context,
                                         const std::vector<Monitor>& numbers);

/// What makes a panel of one kind.
using PanelMaker = std::unique_ptr<Panel>(const PanelContext& context, const PanelSpec& spec);
PanelMaker make_speed_histogram, make_energy_histogram, make_velocity_histogram,
    make_energy_by_species, make_position_histogram, make_speed_classes, make_temperature,
    make_entropy, make_pressure, make_mean_squared_displacement, make_return_distance, make_phase,
    make_pair_correlation, make_velocity_autocorrelation, make_free_path, make_free_time,
    make_orientational_order, make_profile, make_radial_profile, make_positions, make_monitors,
    make_single_collision, make_contact_time, make_collision_map, make_text, make_sides,
    make_piston, make_piston_histogram, make_pressure_volume, make_energy_account,
    make_pressure_gauge, make_run_distance, make_thermometer, make_stopwatch, make_counter,
    make_flux, make_sweep;

}  // namespace carom
