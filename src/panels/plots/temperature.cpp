// The temperature against time, of all particles or of those chosen.
#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "physics/theory/mechanics.h"

namespace carom {

std::unique_ptr<Panel> make_temperature(const PanelContext& context, const PanelSpec& spec) {
    const std::vector<Chosen> chosen = choices(spec);
    std::vector<std::vector<Eigen::Index>> lists;
    for (const Chosen& one : chosen) lists.push_back(members(context, one));
    SeriesSubject subject{
        .measure =
            [context, lists](const FrameInput& o) {
                std::vector<double> now;
                for (const std::vector<Eigen::Index>& list : lists)
                    now.push_back(
                        thermal_motion(context.scene.gas.box, context.particles, o.sample, list)
                            .temperature());
                return now;
            },
        .lines = {},
        .titles = {spec.title ? plot::Text(escape_markup(*spec.title))
                   : spec.of.empty()
                       ? plot::Text("Temperature")
                       : "Temperature of " + names_of(context, chosen, plot::Sample::line)},
        .quantity = "temperature",
        .unit = reduced::energy};
    for (std::size_t k = 0; k < chosen.size(); ++k)
        subject.lines.push_back({name_of(context, chosen[k]), role_among(context, chosen, k)});
    return std::make_unique<SeriesPanel>(context, std::move(subject));
}

}  // namespace carom
