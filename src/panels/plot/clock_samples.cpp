#include "panels/plot/clock_samples.h"

#include <fmt/format.h>

#include "physics/sample_times.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double most_clock_points = 100'000;

}  // namespace

void check_samples_of_bars(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!node.is_mapping()) return;
    const Node& written = *given(node, "samples");
    if (!panel.over) panel.over = Over{Over::Since::start, 0.0};
    const Over over = *panel.over;
    if (over.since == Over::Since::now) {
        reading.errors.add(written, "`samples: clock` needs a time from which samples are taken",
                           "give `over: start` or, for the last 20 units of time, `over: "
                           "{window: 20}`");
        return;
    }
    const double every = sample_interval(reading.run);
    if (over.since != Over::Since::window || over.window >= every) return;
    reading.errors.add(written,
                       fmt::format("there is no sample in a window of {}: they are {} apart",
                                   plain_number(over.window), plain_number(every)),
                       "give a longer time to `over`, or a shorter one to `run.sample_every`");
}

void check_samples_of_points(double points_in_each, const Node& node, Reading& reading) {
    if (!node.is_mapping()) return;
    const double points = points_in_each * static_cast<double>(sample_count(reading.run));
    if (points <= most_clock_points) return;
    reading.errors.add(*given(node, "samples"),
                       fmt::format("{:.0f} points are too many to be drawn", points),
                       fmt::format("choose fewer particles with `of`, or give a longer time to "
                                   "`run.sample_every`: up to {:.0f} are drawn",
                                   most_clock_points));
}

std::string with_samples(const Wording& language, const std::string& time, bool by_clock,
                         const Run& run) {
    if (!by_clock) return time;
    return say(language, "{}, sampled every {}", time,
               plain_number(language, quantities::time, sample_interval(run)));
}

}  // namespace carom
