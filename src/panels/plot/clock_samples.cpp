#include "panels/plot/clock_samples.h"

#include <fmt/format.h>

#include "physics/sample_times.h"
#include "scene/reading/gas_reading.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double most_clock_points = 100'000;

// The number of particles that the points are of; 0 if it is not known yet.
double particles_of(const PanelSpec& panel, const Gas& gas) {
    const auto all = static_cast<double>(particles_in(gas).value_or(0));
    double sum = panel.of.empty() ? all : 0.0;
    for (const Chosen& one : panel.of) {
        if (one.particle)
            sum += 1.0;
        else if (one.species)
            sum += static_cast<double>(gas.species[*one.species].count);
        else
            sum += all;
    }
    return sum;
}

}  // namespace

std::vector<Binding<PanelSpec>> samples_key() {
    return {
        bind_key("samples", &PanelSpec::by_clock, one_of<bool>({{"none", false}, {"clock", true}}),
                 "With `clock`, values at the samples of the run (`run.sample_every`) alone, as "
                 "a measurement by a clock gives them: a histogram counts them, and points stay "
                 "where they were. With `none`, a histogram over a time counts each value by "
                 "the time for which it lasts, and points show the present.")};
}

void check_samples_of_bars(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!panel.by_clock || !node.is_mapping()) return;
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

void check_samples_of_points(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!panel.by_clock || !node.is_mapping()) return;
    const double particles = panel.kind == "positions" ? 1.0 : particles_of(panel, reading.gas);
    const double points = particles * static_cast<double>(sample_count(reading.run));
    if (points <= most_clock_points) return;
    reading.errors.add(*given(node, "samples"),
                       fmt::format("{:.0f} points are too many to be drawn", points),
                       fmt::format("choose fewer particles with `of`, or give a longer time to "
                                   "`run.sample_every`: up to {:.0f} are drawn",
                                   most_clock_points));
}

std::string with_samples(Language language, const std::string& time, const PanelSpec& spec,
                         const Run& run) {
    if (!spec.by_clock) return time;
    return say(language, "{}, sampled every {}", time,
               plain_number(language, sample_interval(run)));
}

}  // namespace carom
