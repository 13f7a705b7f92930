// The options of the panels of correlations, and how far those that have a longest lag or distance
// go.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/run.h"
#include "scene/keys/binding.h"

namespace carom {

/// Of displacements.
struct DisplacementOptions {
    double from = 0.0;                    ///< the time from which they are measured
    std::optional<double> fit_from = {};  ///< start of their line; none: usual
    bool all_origins = false;             ///< averaged over all starting times
    std::optional<double> lags = {};      ///< then: the longest time lag; none: usual
};

/// Of velocities.
struct AutocorrelationOptions {
    double from = 0.0;                ///< the time from which they are compared
    std::optional<double> lags = {};  ///< the longest time lag; none: usual
};

struct PairCorrelationOptions {
    std::optional<double> to = {};  ///< the largest distance; none: usual
};

struct FreeFlightOptions {
    bool logarithmic = false;    ///< whether the vertical axis is logarithmic
    bool ends_at_walls = false;  ///< whether walls and partitions end a flight, too
};

/// The keys `from` and `lags` of kinds whose options have these fields.
Binding<double> from_key();
Binding<std::optional<double>> lags_key();

/// Reports a time at or after the end of the run; returns whether it did.
bool is_late(const Node* key, double time, Reading& reading);

/// Reports lags that are longer than the time from `from` to the end of the run.
void check_lags(std::optional<double> lags, double from, const Node& node, Reading& reading);

/// The longest time lag: as given in the scene, or its default.
double longest_lag(const DisplacementOptions& options, const Run& run);
double longest_lag(const AutocorrelationOptions& options, const Run& run);

}  // namespace carom
