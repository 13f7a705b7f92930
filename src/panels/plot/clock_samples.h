// What `samples: clock` means for histograms and for points: the samples of the run alone, at the
// times of run.sample_every, as a measurement by a clock gives them.
#pragma once

#include <string>
#include <vector>

#include "physics/units/number_text.h"
#include "scene/keys/binding.h"
#include "scene/panel_spec.h"

namespace carom {

/// The key `samples` of a kind whose options have this field.
template <class T>
Binding<T> samples_key(bool T::*by_clock) {
    return bind_key(
        "samples", by_clock, one_of<bool>({{"none", false}, {"clock", true}}),
        "With `clock`, values at the samples of the run (`run.sample_every`) alone, as a "
        "measurement by a clock gives them: a histogram counts them, and points stay where they "
        "were. With `none`, a histogram over a time counts each value by the time for which it "
        "lasts, and points show the present.");
}

/// Report samples by the clock that cannot be shown: of a histogram without a time to take them
/// from, and of so many points in each sample that all are too many to be drawn.
void check_samples_of_bars(PanelSpec& panel, const Node& node, Reading& reading);
void check_samples_of_points(double points_in_each, const Node& node, Reading& reading);

/// A text like "until time 400, samples every 1" from the words for the time; with `samples: none`
/// these words alone.
std::string with_samples(const Wording& language, const std::string& time, bool by_clock,
                         const Run& run);

}  // namespace carom
