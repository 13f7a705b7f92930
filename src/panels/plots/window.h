// The time that a panel's numbers are taken over, and what it is called in a picture.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "util/language.h"

namespace carom {

/// The time before the present that a mean is over, 0 for the present alone; none: all.
std::optional<double> window_of(const Over& over);

/// When a mean that is shown at a time begins, no earlier than the run; none for what is of the
/// present alone.
std::optional<double> start_of_mean(const Over& over, double at);

/// "mean since the start", "mean over the last 5"; `alone` for what is of the present alone.
std::string words_of_window(Language language, const Over& over, Phrase alone);

/// The same of what is of a moment where it is no mean: "now", of a figure "at time 20".
std::string words_of_moments(Language language, const PanelSpec& spec, const Over& over);

/// In a title, of a film or of a figure at its time: "now", "at time 20", "time 18 to 20". Of runs
/// that end at different times: "at the end".
std::string time_words(Language language, const PanelSpec& spec);

}  // namespace carom
