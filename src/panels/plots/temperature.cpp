// The temperature against time, of all particles or of those chosen.
#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "physics/mechanics.h"
#include "physics/surfaces/behaviours.h"

namespace carom {
namespace {

// The temperature of the baths of the run, if all have the same.
std::optional<double> only_bath(const Scene& scene) {
    std::vector<double> all;
    for (const auto& list : behaviours_in_time(scene.gas.box.surfaces, scene.run))
        for (const Behaviour& behaviour : list)
            if (const auto* bath = std::get_if<Bath>(&behaviour)) all.push_back(bath->temperature);
    const bool is_one = !all.empty() && std::ranges::count(all, all.front()) == std::ssize(all);
    return is_one ? std::optional(all.front()) : std::nullopt;
}

}  // namespace

std::unique_ptr<Panel> make_temperature(const PanelContext& context, const PanelSpec& spec) {
    SeriesSubject subject = subject_of_choices(context, spec, Phrase{"Temperature"});
    subject.measure = [context, of = members(context, choices(spec))](const FrameInput& o) {
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : of)
            now.push_back(thermal_motion(context.scene.gas.box, context.particles, o.sample, list)
                              .temperature());
        return now;
    };
    if (const std::optional<double> bath = only_bath(context.scene))
        subject.references = [bath] { return ReferenceLevels{ReferenceLevel{"bath", *bath}}; };
    subject.quantity = Phrase{"temperature"};
    subject.unit = reduced::energy;
    subject.needs_positions = false;
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace carom
