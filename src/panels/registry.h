// The list of all kinds of panel. A new kind needs a file that declares it, and an entry in
// registry.cpp, from which the accepted keys, their check, the schema and the reference page
// follow.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "panels/panel.h"

namespace carom {

struct FixedView;

struct PanelKind;  // scene/panel_kind.h
struct PanelWork;
struct MeasuredAt;

/// All kinds, in the order in which messages and pages list them. The list lives as long as the
/// program.
std::span<const PanelKind> panel_kinds();

/// The kind of a panel of a validated scene.
const PanelKind& kind_of(const PanelSpec& spec);

/// What a panel of a validated scene does with its run, and where it measures.
PanelWork work_of(const PanelSpec& spec, const Run& run);
MeasuredAt places_of(const PanelSpec& spec);

/// The title that a scene gives a panel, or what its kind is called in the scene's language.
std::string name_of_panel(const Scene& scene, const PanelSpec& spec);

/// Makes a panel of `spec.kind`. An unknown kind is a programmer's error: the scene has been
/// validated.
std::unique_ptr<Panel> make_panel(const PanelContext& context, const PanelSpec& spec);

/// Makes the panel of the box or of the wire, as the film's camera shows it or with what is
/// `fixed`.
std::unique_ptr<Panel> make_gas_panel(const PanelContext& context, const FixedView& fixed);
std::unique_ptr<Panel> make_gas_panel(const PanelContext& context);

/// Makes the line of text under the box of run number `run` of several: its label, in the colour
/// that the run has in plots, and as many of the numbers, except the time, as there is room for in
/// the lines of all runs.
std::unique_ptr<Panel> make_run_line(const PanelContext& context,
                                     const std::vector<Monitor>& numbers,
                                     const std::vector<std::string>& labels, std::size_t run);

/// Makes the clock of a film; the line of its other numbers; and a row of numbers with their names.
std::unique_ptr<Panel> make_clock(const PanelContext& context);
std::unique_ptr<Panel> make_numbers_line(const PanelContext& context,
                                         const std::vector<Monitor>& numbers);
std::unique_ptr<Panel> make_monitors(const PanelContext& context,
                                     const std::vector<Monitor>& numbers);

/// Make panels that show a profile in rings around a point, and a pressure on gauges.
std::unique_ptr<Panel> make_radial_profile(const PanelContext& context, const PanelSpec& spec);
std::unique_ptr<Panel> make_pressure_gauge(const PanelContext& context, const PanelSpec& spec);

/// What declares one kind, in the file of its panel.
using KindDeclaration = PanelKind();
KindDeclaration speed_histogram_kind, energy_histogram_kind, velocity_histogram_kind,
    position_histogram_kind, energy_by_species_kind, speed_classes_kind, temperature_kind,
    entropy_kind, pressure_kind, thermometer_kind, stopwatch_kind, counter_kind,
    pressure_volume_kind, piston_kind, piston_histogram_kind, sides_kind, flux_kind,
    energy_account_kind, particle_speed_kind, mean_free_path_kind, halves_kind,
    mean_squared_displacement_kind, velocity_autocorrelation_kind, pair_correlation_kind,
    free_path_kind, free_time_kind, orientational_order_kind, return_distance_kind,
    run_distance_kind, profile_kind, phase_kind, positions_kind, monitors_kind,
    single_collision_kind, contact_time_kind, collision_map_kind, text_kind, sweep_kind, gas_kind;

}  // namespace carom
