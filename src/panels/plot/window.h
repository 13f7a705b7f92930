// The time window over which a panel averages, and its name in a picture.
#pragma once

#include <optional>
#include <string>

#include "physics/units/number_text.h"
#include "scene/panel_spec.h"

namespace carom {

/// The length of the averaging window before the present: 0 for the present alone; none: since the
/// start.
std::optional<double> window_of(const Over& over);

/// The start of the mean that is shown at a time, not before the start of the run; none if only the
/// present is shown.
std::optional<double> start_of_mean(const Over& over, double at);

/// "mean since the start", "mean over the last 5"; `alone` if only the present is shown.
std::string words_of_window(const Wording& language, const Over& over, Phrase alone);

/// The same for a quantity of a single moment: without a mean, "now" or, in a figure, "at time 20".
std::string words_of_moments(const Wording& language, const PanelSpec& spec, const Over& over);

/// The window in the title of a film or of a figure: "now", "at time 20", "time 18 to 20"; for runs
/// that end at different times, "at the end".
std::string time_words(const Wording& language, const PanelSpec& spec);

}  // namespace carom
