// What `samples: clock` means for histograms and for points: the samples of the run alone, at the
// times of run.sample_every, as a measurement by a clock gives them.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"
#include "util/language.h"

namespace carom {

/// The key `samples` of histograms and of points.
std::vector<Binding<PanelSpec>> samples_key();

/// Report samples that cannot be shown: of a histogram without a time to take them from, and of
/// points that are too many to be drawn.
void check_samples_of_bars(PanelSpec& panel, const Node& node, Reading& reading);
void check_samples_of_points(PanelSpec& panel, const Node& node, Reading& reading);

/// A text like "until time 400, samples every 1" from the words for the time; with `samples: none`
/// these words alone.
std::string with_samples(Language language, const std::string& time, const PanelSpec& spec,
                         const Run& run);

}  // namespace carom
