// The mean kinetic energy of each species against time: which one loses, which one gains, and where
// they meet.
#include <algorithm>
#include <cmath>

#include "panels/chosen.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "physics/gas.h"
#include "scene/panel_kind.h"
#include "util/text.h"

namespace carom {
namespace {

std::vector<double> means(const PanelContext& context, const FrameInput& o) {
    const Eigen::ArrayXd& energy = o.energy;
    const Eigen::ArrayXi& all = species_at(o.sample, context.particles);
    std::vector<double> sum(context.species().size());
    std::vector<double> count(sum.size());
    for (Eigen::Index i = 0; i < energy.size(); ++i) {
        if (!is_present(o.sample, i)) continue;
        const auto species = static_cast<std::size_t>(all[i]);
        sum[species] += energy[i];
        count[species] += 1.0;
    }
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= std::max(1.0, count[k]);
    return sum;
}

// The mean energy of each species in equilibrium: the same for all, but where momentum is conserved
// lower for heavy particles.
ReferenceLevels levels(const PanelContext& context) {
    constexpr double rounding = 1e-12;
    ReferenceLevels all;
    for (std::size_t k = 0; k < context.species().size(); ++k) {
        const Law found =
            law(context.gas, LawOf::mean_energy, {.of = members(context, Chosen{.species = k})});
        if (found) all.push_back(ReferenceLevel{"equilibrium", found.value, 0.0, k});
    }
    const bool are_same = std::ranges::all_of(all, [&](const ReferenceLevel& level) {
        return std::abs(level.value - all.front().value) <= rounding * all.front().value;
    });
    if (!are_same || all.empty()) return all;
    return {ReferenceLevel{"equipartition", all.front().value}};
}

std::vector<plot::Text> titles(const PanelContext& context) {
    const std::size_t count = context.species().size();
    const Language language = context.language();
    const std::string title = say(language, "Mean energy");
    if (count == 1) return {title};
    std::vector<Chosen> all;
    for (std::size_t k = 0; k < count; ++k) all.push_back({.species = k});
    const auto named = [&](const std::string& what, Joint joint) {
        return plot::text_of(language, Phrase{"{}: {}"},
                             {what, names_of(context, all, plot::Swatch::line, joint)});
    };
    return {named(title, Joint::last_by_and),
            named(capitalised(say(language, "energy")), Joint::commas), title};
}

SeriesSubject energy_by_species(const PanelContext& context, const PanelSpec& spec) {
    SeriesSubject subject{{.title = say(context.language(), "Mean energy"),
                           .quantity = quantities::mean_energy,
                           .read = [context](const FrameInput& o) { return means(context, o); },
                           .over = spec.over,
                           .needs_positions = false}};
    subject.titles = titles(context);
    subject.spreads = true;
    const std::vector<Species>& species = context.species();
    for (std::size_t k = 0; k < species.size(); ++k)
        subject.lines.push_back({species[k].name, species[k].name, species_role(context, k)});
    if (species.size() > 1) subject.levels = [context] { return levels(context); };
    return subject;
}

}  // namespace

PanelKind energy_by_species_kind() {
    using enum Ability;
    return series_kind<energy_by_species>(
        {.name = "energy-by-species",
         .words = Phrase{"energy by species"},
         .shows = "The mean kinetic energy of each species against time.",
         .abilities = {over, means},
         .asked = {{.name = "mean_energy",
                    .meaning = "the mean kinetic energy of a particle",
                    .is_by_line = true}},
         .tried_as = {"energy"},
         .suits = [](const Gas& gas, const Run&) { return gas.species.size() > 1; },
         .laws =
             [](const PanelSpec&, const Gas& gas) {
                 return gas.species.size() < 2 ? std::vector<LawOf>{}
                                               : std::vector{LawOf::mean_energy};
             }});
}

}  // namespace carom
