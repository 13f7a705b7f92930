// The scene keys that only the correlation panels accept, and the checks of these panels.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

std::vector<Binding<PanelSpec>> displacement_keys();
std::vector<Binding<PanelSpec>> pair_correlation_keys();
std::vector<Binding<PanelSpec>> autocorrelation_keys();
std::vector<Binding<PanelSpec>> free_flight_keys();

/// Reports a panel of displacements for which the run leaves no time to measure or to fit.
void check_displacements(PanelSpec& panel, const Node& node, Reading& reading);

/// Reports boxes with partitions or obstacles, in which the rings of g(r) have no simple area;
/// distances beyond that of the nearest periodic images; and more than two choices of particles.
void check_pair_correlation(PanelSpec& panel, const Node& node, Reading& reading);

/// Reports lags that are longer than the measured time.
void check_autocorrelation(PanelSpec& panel, const Node& node, Reading& reading);

/// Reports free flights of a single moment, in which none ends.
void check_free_flights(PanelSpec& panel, const Node& node, Reading& reading);

/// Reports a panel of hexagonal order for beads on a line, which have none.
void check_orientational_order(PanelSpec& panel, const Node& node, Reading& reading);

/// The largest distance at which g(r) is known: half of the shortest periodic side, or the longest
/// side if that is less.
double most_distance(const Box& box);

/// The longest time lag: as given in the scene, or its default.
double usual_lags(const PanelSpec& spec, const Run& run);

}  // namespace carom
