// The temperature against time, of all particles or of those chosen.
#include <vector>

#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/plots/suits.h"
#include "panels/registry.h"
#include "physics/mechanics.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

SeriesSubject temperature(const PanelContext& context, const PanelSpec& spec) {
    SeriesSubject subject =
        subject_of_choices(context, spec, Phrase{"Temperature"}, quantities::temperature);
    subject.read = [context, of = Members(context, choices(spec))](const FrameInput& o) mutable {
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : of.at(o.sample))
            now.push_back(
                thermal_motion(context.box(), context.particles, o.sample, list).temperature());
        return now;
    };
    if (const Law bath = law(context.gas, LawOf::bath))
        subject.levels = [bath] { return ReferenceLevels{ReferenceLevel{"bath", bath.value}}; };
    subject.over = spec.over;
    subject.needs_positions = false;
    return subject;
}

}  // namespace

PanelKind temperature_kind() {
    using enum Ability;
    return series_kind<temperature>(
        {.name = "temperature",
         .words = Phrase{"temperature"},
         .shows = "The temperature against time, of all particles or of those that `of` names.",
         .abilities = {of, over, means, comparison, any_space},
         .asked = {{"temperature", "the temperature"}},
         .shows_units = true,
         .suits = acts_on_gas});
}

}  // namespace carom
