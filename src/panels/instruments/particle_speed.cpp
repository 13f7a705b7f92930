// The speed against time: of one particle, or the mean of several.
#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"

namespace carom {
namespace {

Meter particle_speed(const PanelContext& context, const PanelSpec& spec) {
    Meter meter = meter_of_choices(context, spec, Phrase{"Speed"}, quantities::speed);
    meter.over = spec.over;
    meter.needs_positions = false;
    meter.read = [of = Members(context, choices(spec))](const FrameInput& now) mutable {
        std::vector<double> means;
        for (const std::vector<Eigen::Index>& list : of.at(now.sample))
            means.push_back(list.empty() ? NAN : now.speed(list).mean());
        return means;
    };
    return meter;
}

}  // namespace

PanelKind particle_speed_kind() {
    using enum Ability;
    return series_kind<particle_speed>(
        {.name = "particle-speed",
         .words = Phrase{"speed"},
         .shows = "The speed of a particle that `of` names, or the mean speed of several.",
         .abilities = {of, over, means, comparison, any_space},
         .asked = {{"mean_speed", "the mean speed"},
                   {"speed", "the speed of a particle, or the mean speed"}},
         .shows_units = true});
}

}  // namespace carom
