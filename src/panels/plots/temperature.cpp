// The temperature against time, of all particles or of those chosen: 2/d of the mean kinetic
// energy of a particle.
#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "stats/mechanics.h"

namespace carom {
namespace {

// Of all particles without the drift that nothing stops; NaN where masses are infinite.
double temperature_of(const PanelContext& context, const Chosen& chosen,
                      const std::vector<Eigen::Index>& members, const FrameInput& o) {
    const Box& box = context.scene.gas.box;
    if (!chosen.species && !chosen.particle)
        return temperature(box, context.particles,
                           thermal_energy(box, context.particles, o.sample));
    double sum = 0.0, count = 0.0;
    for (const Eigen::Index i : members) {
        if (!(context.particles.inverse_mass[i] > 0.0)) continue;
        sum += o.energy[i];
        count += 1.0;
    }
    return 2.0 * sum / (box.dimension * count);
}

}  // namespace

std::unique_ptr<Panel> make_temperature(const PanelContext& context, const PanelSpec& spec) {
    const std::vector<Chosen> chosen = choices(spec);
    std::vector<std::vector<Eigen::Index>> lists;
    for (const Chosen& one : chosen) lists.push_back(members(context, one));
    SeriesSubject subject{
        .measure =
            [context, chosen, lists](const FrameInput& o) {
                std::vector<double> now;
                for (std::size_t k = 0; k < chosen.size(); ++k)
                    now.push_back(temperature_of(context, chosen[k], lists[k], o));
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
