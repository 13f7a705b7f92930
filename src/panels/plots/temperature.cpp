// The temperature against time, of all particles or of those chosen.
#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "physics/theory/mechanics.h"

namespace carom {

std::unique_ptr<Panel> make_temperature(const PanelContext& context, const PanelSpec& spec) {
    SeriesSubject subject = subject_of_choices(context, spec, "Temperature");
    subject.measure = [context, of = members(context, choices(spec))](const FrameInput& o) {
        std::vector<double> now;
        for (const std::vector<Eigen::Index>& list : of)
            now.push_back(thermal_motion(context.scene.gas.box, context.particles, o.sample, list)
                              .temperature());
        return now;
    };
    subject.quantity = "temperature";
    subject.unit = reduced::energy;
    return std::make_unique<SeriesPanel>(context, std::move(subject));
}

}  // namespace carom
