#include "panels/chosen.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "panels/gas/gas_colors.h"
#include "physics/archived.h"
#include "scene/scene.h"
#include "util/archive.h"

namespace carom {

std::vector<Chosen> choices(const PanelSpec& spec) {
    return spec.of.empty() ? std::vector<Chosen>{{}} : spec.of;
}

namespace {

// `membership`: null for that of the start.
std::vector<Eigen::Index> members_in(const Particles& particles, const Membership* membership,
                                     const Chosen& chosen) {
    const Eigen::ArrayXi& species = species_in(membership, particles);
    std::vector<Eigen::Index> found;
    const auto add = [&](Eigen::Index i) {
        if (is_present(membership, i)) found.push_back(i);
    };
    if (chosen.particle) {
        add(static_cast<Eigen::Index>(*chosen.particle));
        return found;
    }
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (!chosen.species || species[i] == static_cast<int>(*chosen.species)) add(i);
    return found;
}

}  // namespace

std::vector<Eigen::Index> members(const PanelContext& context, const Chosen& chosen) {
    return members_in(context.particles, nullptr, chosen);
}

std::vector<std::vector<Eigen::Index>> members(const PanelContext& context,
                                               const std::vector<Chosen>& chosen) {
    std::vector<std::vector<Eigen::Index>> lists;
    for (const Chosen& one : chosen) lists.push_back(members(context, one));
    return lists;
}

std::vector<std::vector<Eigen::Index>> members_that_collide(const PanelContext& context,
                                                            const std::vector<Chosen>& chosen) {
    const auto is_infinite = [&](Eigen::Index i) {
        return context.particles.inverse_mass[i] == 0.0;
    };
    std::vector<std::vector<Eigen::Index>> lists = members(context, chosen);
    for (std::vector<Eigen::Index>& list : lists)
        if (!std::ranges::all_of(list, is_infinite)) std::erase_if(list, is_infinite);
    return lists;
}

Members::Members(const PanelContext& context, std::vector<Chosen> chosen)
    : particles_(&context.particles), chosen_(std::move(chosen)) {
    find();
}

void Members::find() {
    lists_.clear();
    for (const Chosen& one : chosen_)
        lists_.push_back(members_in(*particles_, membership_.last().get(), one));
}

bool Members::see(const Sample& sample) {
    if (!membership_.see(sample, *particles_)) return false;
    find();
    return true;
}

std::vector<bool> Members::flags(std::size_t choice) const {
    const std::vector<Eigen::Index>& list = lists_[choice];
    if (std::cmp_equal(list.size(), particles_->count())) return {};
    std::vector<bool> all(static_cast<std::size_t>(particles_->count()));
    for (const Eigen::Index i : list) all[static_cast<std::size_t>(i)] = true;
    return all;
}

void Members::archive(Archive& archive) {
    membership_.archive(archive, *particles_);
    if (archive.is_reading()) find();
}

std::optional<double> asked_trail(const Scene& scene, const Particles& particles,
                                  Eigen::Index particle) {
    const auto species = static_cast<std::size_t>(particles.species[particle]);
    if (const std::optional<double>& own = scene.looks[species].trail) return own;
    const Trails& trails = scene.film.trails;
    const bool among = std::ranges::any_of(trails.of, [&](const Chosen& chosen) {
        if (chosen.particle) return *chosen.particle == particle;
        return !chosen.species || *chosen.species == species;
    });
    return among ? std::optional(trails.seconds) : std::nullopt;
}

bool is_single_among_many(const Scene& scene, const Particles& particles, Eigen::Index particle) {
    constexpr Eigen::Index few_disks = 10, few_beads = 4;
    const auto species = static_cast<std::size_t>(particles.species[particle]);
    return scene.gas.species[species].count == 1 &&
           particles.count() > (scene.gas.box.dimension == 1 ? few_beads : few_disks);
}

namespace {

std::string name_in(Language language, const Scene& scene, const Chosen& chosen) {
    if (chosen.particle) return say(language, "particle {}", *chosen.particle);
    if (chosen.species) return scene.gas.species[*chosen.species].name;
    return say(language, "all");
}

}  // namespace

std::string name_of(const Scene& scene, const Chosen& chosen) {
    return name_in(scene.film.language, scene, chosen);
}

std::string column_name_of(const Scene& scene, const Chosen& chosen) {
    return name_in(Language::english, scene, chosen);
}

namespace {

plot::Role kind_role(const PanelContext& context, std::size_t index) {
    return plot::own_role(themes_of(context.film()), [&](const Theme& theme) {
        return kind_in(context.film(), index, theme);
    });
}

}  // namespace

plot::Role species_role(const PanelContext& context, std::size_t species) {
    if (context.run_in_box) return plot::stroke_of_run(*context.run_in_box).role;
    const std::optional<std::string>& own = context.looks()[species].color;
    if (own)
        if (const std::optional<Color> parsed = parse_color(*own))
            return {.of = plot::Role::Of::own, .own = {*parsed, *parsed, *parsed}};
    return kind_role(context, species);
}

plot::Role choice_role(const PanelContext& context, const Chosen& chosen, std::size_t place) {
    if (chosen.species) return species_role(context, *chosen.species);
    return kind_role(context, context.species().size() + place);
}

plot::Role role_among(const PanelContext& context, const std::vector<Chosen>& chosen,
                      std::size_t place) {
    if (chosen.size() == 1) return {.of = plot::Role::Of::bar};
    return choice_role(context, chosen[place], place);
}

plot::Text joined(Language language, const std::vector<plot::Text>& texts, Joint joint) {
    const std::string last = " " + say(language, "and") + " ";
    plot::Text all;
    for (std::size_t k = 0; k < texts.size(); ++k) {
        if (k > 0) all += k + 1 < texts.size() || joint == Joint::commas ? ", " : last;
        all += texts[k];
    }
    return all;
}

namespace {

bool are_numbers(const std::vector<Chosen>& chosen) {
    return std::ranges::all_of(chosen, [](const Chosen& one) { return one.particle.has_value(); });
}

// Of particles their numbers only.
plot::Text bare_names(const PanelContext& context, const std::vector<Chosen>& chosen,
                      plot::Swatch swatch, Joint joint) {
    std::vector<plot::Text> names;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        const std::string name = are_numbers(chosen) ? std::to_string(*chosen[k].particle)
                                                     : name_of(context.scene, chosen[k]);
        names.push_back(chosen.size() == 1
                            ? plot::Text(escape_markup(name))
                            : plot::named(name, choice_role(context, chosen[k], k), swatch, k));
    }
    return joined(context.language(), names, joint);
}

}  // namespace

plot::Text names_of(const PanelContext& context, const std::vector<Chosen>& chosen,
                    plot::Swatch swatch, Joint joint) {
    if (chosen.size() == 1) return escape_markup(name_of(context.scene, chosen.front()));
    const plot::Text names = bare_names(context, chosen, swatch, joint);
    return are_numbers(chosen) ? plot::text_of(context.language(), Phrase{"particles {}"}, {names})
                               : names;
}

plot::Text shown_of(const PanelContext& context, const plot::Text& what,
                    const std::vector<Chosen>& chosen, plot::Swatch swatch) {
    const Phrase phrase = !are_numbers(chosen) ? Phrase{"{} of {}"}
                          : chosen.size() == 1 ? Phrase{"{} of particle {}"}
                                               : Phrase{"{} of particles {}"};
    return plot::text_of(context.language(), phrase,
                         {what, bare_names(context, chosen, swatch, Joint::last_by_and)});
}

std::string single_name(const PanelContext& context, Eigen::Index particle) {
    const auto species = static_cast<std::size_t>(context.particles.species[particle]);
    if (context.species()[species].count > 1) return "";
    const std::string& label = context.looks()[species].label;
    return label.empty() ? context.species()[species].name : label;
}

double name_alpha(const PanelContext& context, const Tick& tick) {
    constexpr double seconds = 3.0, fading = 0.5;
    return context.in_film ? std::clamp((seconds - tick.seconds) / fading, 0.0, 1.0) : 1.0;
}

}  // namespace carom
