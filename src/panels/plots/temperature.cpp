// The temperature against time, of all particles or of those chosen: 2/d of the mean kinetic
// energy of a particle.
#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "stats/mechanics.h"

namespace carom {
namespace {

// Of all particles without the drift that nothing stops; NaN where masses are infinite.
double temperature_of(const Cast& cast, const Chosen& chosen,
                      const std::vector<Eigen::Index>& members, const Observation& o) {
    const Box& box = cast.scene.gas.box;
    if (!chosen.species && !chosen.particle)
        return temperature(box, cast.particles, thermal_energy(box, cast.particles, o.sample));
    double sum = 0.0, count = 0.0;
    for (const Eigen::Index i : members) {
        if (!(cast.particles.inverse_mass[i] > 0.0)) continue;
        sum += o.energy[i];
        count += 1.0;
    }
    return 2.0 * sum / (box.dimension * count);
}

}  // namespace

std::unique_ptr<Panel> make_temperature(const Cast& cast, const PanelSpec& spec) {
    const std::vector<Chosen> chosen = choices(spec);
    std::vector<std::vector<Eigen::Index>> lists;
    for (const Chosen& one : chosen) lists.push_back(members(cast, one));
    SeriesSubject subject{
        .measure =
            [cast, chosen, lists](const Observation& o) {
                std::vector<double> now;
                for (std::size_t k = 0; k < chosen.size(); ++k)
                    now.push_back(temperature_of(cast, chosen[k], lists[k], o));
                return now;
            },
        .color =
            [cast, chosen](std::size_t k, const Theme& theme) {
                return chosen.size() == 1 ? theme.bar : choice_color(cast, chosen[k], k, theme);
            },
        .title =
            [cast, chosen, spec](const Theme& theme) {
                if (spec.title) return escape_markup(*spec.title);
                if (spec.of.empty()) return std::string("Temperature");
                return "Temperature of " + colored_names(cast, chosen, theme);
            },
        .column = column_name("temperature", reduced::energy)};
    for (const Chosen& one : chosen) subject.names.push_back(name_of(cast, one));
    return std::make_unique<SeriesPanel>(cast, std::move(subject));
}

}  // namespace carom
