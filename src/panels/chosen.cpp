#include "panels/chosen.h"

#include <fmt/format.h>

#include <algorithm>

#include "panels/gas/gas_colors.h"

namespace carom {

std::vector<Chosen> choices(const PanelSpec& spec) {
    return spec.of.empty() ? std::vector<Chosen>{{}} : spec.of;
}

std::vector<Eigen::Index> members(const PanelContext& context, const Chosen& chosen) {
    if (chosen.particle) return {static_cast<Eigen::Index>(*chosen.particle)};
    std::vector<Eigen::Index> found;
    for (Eigen::Index i = 0; i < context.particles.count(); ++i)
        if (!chosen.species || context.particles.species[i] == static_cast<int>(*chosen.species))
            found.push_back(i);
    return found;
}

std::vector<std::vector<Eigen::Index>> members(const PanelContext& context,
                                               const std::vector<Chosen>& chosen) {
    std::vector<std::vector<Eigen::Index>> lists;
    for (const Chosen& one : chosen) lists.push_back(members(context, one));
    return lists;
}

std::optional<double> asked_trail(const PanelContext& context, Eigen::Index particle) {
    const auto species = static_cast<std::size_t>(context.particles.species[particle]);
    if (const std::optional<double>& own = context.scene.looks[species].trail) return own;
    const Trails& trails = context.scene.film.trails;
    const bool among = std::ranges::any_of(trails.of, [&](const Chosen& chosen) {
        if (chosen.particle) return *chosen.particle == particle;
        return !chosen.species || *chosen.species == species;
    });
    return among ? std::optional(trails.seconds) : std::nullopt;
}

std::string name_of(const Scene& scene, const Chosen& chosen) {
    if (chosen.particle) return fmt::format("particle {}", *chosen.particle);
    return chosen.species ? scene.gas.species[*chosen.species].name : "all";
}

namespace {

plot::Role kind_role(const PanelContext& context, std::size_t index) {
    return plot::own_role([&](const Theme& theme) { return kind_in(context.scene, index, theme); });
}

}  // namespace

plot::Role species_role(const PanelContext& context, std::size_t species) {
    const std::optional<std::string>& own = context.scene.looks[species].color;
    if (own)
        if (const std::optional<Color> parsed = parse_color(*own))
            return {.of = plot::Role::Of::own, .own = {*parsed, *parsed, *parsed}};
    return kind_role(context, species);
}

plot::Role choice_role(const PanelContext& context, const Chosen& chosen, std::size_t place) {
    if (chosen.species) return species_role(context, *chosen.species);
    return kind_role(context, context.scene.gas.species.size() + place);
}

plot::Role role_among(const PanelContext& context, const std::vector<Chosen>& chosen,
                      std::size_t place) {
    if (chosen.size() == 1) return {.of = plot::Role::Of::bar};
    return choice_role(context, chosen[place], place);
}

plot::Text names_of(const PanelContext& context, const std::vector<Chosen>& chosen,
                    plot::Sample sample, const std::string& last) {
    if (chosen.size() == 1) return escape_markup(name_of(context.scene, chosen.front()));
    const bool numbers =
        std::ranges::all_of(chosen, [](const Chosen& one) { return one.particle.has_value(); });
    plot::Text words(numbers ? "particles " : "");
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        if (k > 0) words += k + 1 == chosen.size() ? last : ", ";
        const std::string name =
            numbers ? std::to_string(*chosen[k].particle) : name_of(context.scene, chosen[k]);
        words += plot::named(name, choice_role(context, chosen[k], k), sample, k);
    }
    return words;
}

std::string single_name(const PanelContext& context, Eigen::Index particle) {
    const auto species = static_cast<std::size_t>(context.particles.species[particle]);
    if (context.scene.gas.species[species].count > 1) return "";
    const std::string& label = context.scene.looks[species].label;
    return label.empty() ? context.scene.gas.species[species].name : label;
}

double name_alpha(const PanelContext& context, const Tick& tick) {
    constexpr double seconds = 3.0, fading = 0.5;
    return context.in_film ? std::clamp((seconds - tick.seconds) / fading, 0.0, 1.0) : 1.0;
}

}  // namespace carom
