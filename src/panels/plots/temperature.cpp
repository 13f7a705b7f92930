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
        .color =
            [context, chosen](std::size_t k, const Theme& theme) {
                return chosen.size() == 1 ? theme.bar : choice_color(context, chosen[k], k, theme);
            },
        .title =
            [context, chosen, spec](const Theme& theme) {
                if (spec.title) return escape_markup(*spec.title);
                if (spec.of.empty()) return std::string("Temperature");
                return "Temperature of " + colored_names(context, chosen, theme);
            },
        .column = column_name("temperature", reduced::energy)};
    for (const Chosen& one : chosen) subject.names.push_back(name_of(context, one));
    return std::make_unique<SeriesPanel>(context, std::move(subject));
}

}  // namespace carom
