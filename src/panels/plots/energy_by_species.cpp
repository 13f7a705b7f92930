// The mean kinetic energy of each species against time: who gives, who takes, and where they meet.
#include "panels/plots/series_panel.h"
#include "panels/registry.h"

namespace carom {
namespace {

std::vector<double> means(const Cast& cast, const Eigen::ArrayXd& energy) {
    std::vector<double> sum(cast.scene.gas.species.size());
    std::vector<double> count(sum.size());
    for (Eigen::Index i = 0; i < energy.size(); ++i) {
        const auto species = static_cast<std::size_t>(cast.particles.species[i]);
        sum[species] += energy[i];
        count[species] += 1.0;
    }
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= std::max(1.0, count[k]);
    return sum;
}

std::string title(const Cast& cast, const PanelSpec& spec, const Theme& theme) {
    if (spec.title) return escape_markup(*spec.title);
    const std::vector<Species>& species = cast.scene.gas.species;
    if (species.size() == 1) return "Mean energy";
    std::string words;
    for (std::size_t k = 0; k < species.size(); ++k) {
        if (k > 0) words += k + 1 == species.size() ? " and " : ", ";
        const Color color = species_color(cast, k, theme);
        words += line_sample(k, color, theme) + colored(species[k].name, color, theme);
    }
    return "Mean energy: " + words;
}

}  // namespace

std::unique_ptr<Panel> make_energy_by_species(const Cast& cast, const PanelSpec& spec) {
    SeriesSubject subject{
        .measure = [cast](const Observation& o) { return means(cast, o.energy); },
        .color = [cast](std::size_t k,
                        const Theme& theme) { return species_color(cast, k, theme); },
        .title = [cast, spec](const Theme& theme) { return title(cast, spec, theme); },
        .spreads = true,
        .column = column_name("mean energy", reduced::energy)};
    for (const Species& species : cast.scene.gas.species) subject.names.push_back(species.name);
    if (cast.equilibrium && cast.scene.gas.species.size() > 1)
        subject.reference = [cast]() -> std::optional<ReferenceLevel> {
            return ReferenceLevel{"equal shares", mean_energy(*cast.equilibrium)};
        };
    return std::make_unique<SeriesPanel>(cast, std::move(subject));
}

}  // namespace carom
