// The keys that the panels of correlations alone take, and their checks.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

std::vector<Binding<PanelSpec>> displacement_keys();
std::vector<Binding<PanelSpec>> pair_correlation_keys();
std::vector<Binding<PanelSpec>> autocorrelation_keys();
std::vector<Binding<PanelSpec>> free_flight_keys();

/// Reports displacements of which a run leaves nothing to measure or to fit.
void check_displacements(PanelSpec& panel, const Node& node, Reading& reading);

/// Reports boxes in which the rings of g(r) have no simple area, distances beyond their nearest
/// images, and more than a pair of choices.
void check_pair_correlation(PanelSpec& panel, const Node& node, Reading& reading);

/// Reports lags that are longer than what is measured.
void check_autocorrelation(PanelSpec& panel, const Node& node, Reading& reading);

/// Reports free flights of the present alone, which has none.
void check_free_flights(PanelSpec& panel, const Node& node, Reading& reading);

/// Reports the order of beads on a line.
void check_orientational_order(PanelSpec& panel, const Node& node, Reading& reading);

/// The largest distance of which g(r) is known: half of the shortest periodic side, or the longest
/// solid one.
double most_distance(const Box& box);

/// The longest lag unless the scene says otherwise.
double usual_lags(const PanelSpec& spec, const Run& run);

}  // namespace carom
