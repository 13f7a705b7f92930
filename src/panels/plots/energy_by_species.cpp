// The mean kinetic energy of each species against time: who gives, who takes, and where they meet.
#include "panels/plots/series_panel.h"
#include "panels/registry.h"

namespace carom {
namespace {

std::vector<double> means(const PanelContext& context, const Eigen::ArrayXd& energy) {
    std::vector<double> sum(context.scene.gas.species.size());
    std::vector<double> count(sum.size());
    for (Eigen::Index i = 0; i < energy.size(); ++i) {
        const auto species = static_cast<std::size_t>(context.particles.species[i]);
        sum[species] += energy[i];
        count[species] += 1.0;
    }
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= std::max(1.0, count[k]);
    return sum;
}

std::string title(const PanelContext& context, const PanelSpec& spec, const Theme& theme) {
    if (spec.title) return escape_markup(*spec.title);
    const std::vector<Species>& species = context.scene.gas.species;
    if (species.size() == 1) return "Mean energy";
    std::string words;
    for (std::size_t k = 0; k < species.size(); ++k) {
        if (k > 0) words += k + 1 == species.size() ? " and " : ", ";
        const Color color = species_color(context, k, theme);
        words += line_sample(k, color, theme) + colored(species[k].name, color, theme);
    }
    return "Mean energy: " + words;
}

}  // namespace

std::unique_ptr<Panel> make_energy_by_species(const PanelContext& context, const PanelSpec& spec) {
    SeriesSubject subject{
        .measure = [context](const FrameInput& o) { return means(context, o.energy); },
        .color = [context](std::size_t k,
                           const Theme& theme) { return species_color(context, k, theme); },
        .title = [context, spec](const Theme& theme) { return title(context, spec, theme); },
        .spreads = true,
        .column = column_name("mean energy", reduced::energy)};
    for (const Species& species : context.scene.gas.species) subject.names.push_back(species.name);
    if (context.equilibrium && context.scene.gas.species.size() > 1)
        subject.reference = [context]() -> std::optional<ReferenceLevel> {
            return ReferenceLevel{"equal shares", mean_energy(*context.equilibrium)};
        };
    return std::make_unique<SeriesPanel>(context, std::move(subject));
}

}  // namespace carom
