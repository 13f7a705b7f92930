#include "scene/reading/panel_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "physics/gas.h"
#include "scene/keys/made_once.h"
#include "scene/limits.h"
#include "scene/reading/gas_reading.h"
#include "scene/reading/overlay_reading.h"
#include "scene/time/timeline.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

std::optional<Chosen> chosen_particle(const Node& node, double number, Reading& reading) {
    const auto count = particles_in(reading.gas);
    if (!count) return std::nullopt;
    if (number >= 0.0 && number < static_cast<double>(*count) && number == std::floor(number))
        return Chosen{{}, static_cast<std::int64_t>(number)};
    report_no_particle(node, in_quotes(node.text), *count, reading.errors);
    return std::nullopt;
}

std::optional<Chosen> chosen(const std::string&, const Node& node, Reading& reading) {
    if (node.text == "all") return Chosen{};
    if (const auto number = number_in(node)) return chosen_particle(node, *number, reading);
    std::vector<std::string> names;
    for (const Species& species : reading.gas.species) {
        if (species.name == node.text) return Chosen{names.size(), {}};
        names.push_back(species.name);
    }
    constexpr std::size_t most_listed = 12;
    const auto count = particles_in(reading.gas);
    const std::string species =
        names.size() > most_listed || names.empty()
            ? "give the name of a species in `gas`"
            : fmt::format("the species {} {}", names.size() == 1 ? "is" : "are",
                          listed(names, "and", "`"));
    const std::string numbers =
        count ? fmt::format("; a particle has a number, 0 to {}", *count - 1) : "";
    reading.errors.add(node, fmt::format("there is no species {}", in_quotes(node.text)),
                       spelling_hint(node.text, names, species + numbers));
    return std::nullopt;
}

using OwnKeys = std::vector<Binding<PanelSpec>> PanelKind::*;

// A key that several kinds have, each for its own options. For a kind that does not take it, which
// is reported, its value is checked in itself.
class ReaderOfKinds {
  public:
    void add(const std::string& kind, const Binding<PanelSpec>& key) {
        readers_.push_back({kind, key});
    }
    void operator()(void* into, const Node& node, Reading& reading) const {
        auto& panel = *static_cast<PanelSpec*>(into);
        for (const auto& [kind, key] : readers_)
            if (kind == panel.kind) return key.read(panel, node, reading);
        PanelSpec other{.kind = readers_.front().first};
        readers_.front().second.read(other, node, reading);
    }

  private:
    std::vector<std::pair<std::string, Binding<PanelSpec>>> readers_;
};

// Keys that are specific to certain kinds; several kinds may have keys of the same name.
std::vector<Binding<PanelSpec>> own_keys(PanelKinds kinds, OwnKeys keys_of_kind) {
    std::vector<Binding<PanelSpec>> keys;
    std::vector<ReaderOfKinds> readers;
    for (const PanelKind& kind : kinds)
        for (const Binding<PanelSpec>& own : kind.*keys_of_kind) {
            const auto other = std::ranges::find_if(
                keys, [&](const Binding<PanelSpec>& key) { return key.key.name == own.key.name; });
            const auto place = static_cast<std::size_t>(other - keys.begin());
            if (other == keys.end()) {
                keys.push_back(Binding(own).only_with({kind.name}));
                readers.emplace_back();
            } else {
                other->key.kinds.push_back(kind.name);
            }
            readers[place].add(kind.name, own);
        }
    for (std::size_t k = 0; k < keys.size(); ++k) {
        keys[k].read_part = std::move(readers[k]);
        keys[k].offset = 0;
    }
    return keys;
}

// Names that users may try for kinds, and the kinds that they may mean: "`a`, or `b`".
std::map<std::string, std::string> tried_kinds(PanelKinds kinds) {
    std::map<std::string, std::string> meant;
    for (const PanelKind& kind : kinds)
        for (const std::string& name : kind.tried_as) {
            std::string& all = meant[name];
            all += (all.empty() ? "`" : ", or `") + kind.name + "`";
        }
    return meant;
}

Notation<std::string> film_kinds(PanelKinds kinds) {
    std::vector<std::string> names;
    std::vector<Elsewhere> elsewhere;
    for (const PanelKind& kind : kinds)
        if (kind.in_films_instead.empty())
            names.push_back(kind.name);
        else
            elsewhere.push_back({kind.name, kind.in_films_instead});
    elsewhere.push_back(
        {"wire", "the wire with its beads is in every film; the template says where"});
    for (const auto& [tried, meant] : tried_kinds(kinds))
        elsewhere.push_back({tried, fmt::format("did you mean {}?", meant)});
    elsewhere.push_back({"world-lines", "they are under the wire in every film of one dimension"});
    return word(names).with_elsewhere(std::move(elsewhere));
}

void check_component(const PanelSpec& panel, const Node& node, PanelKinds kinds,
                     const PanelKind& kind, Reading& reading) {
    const Node* written = given(node, "component");
    if (written == nullptr) return;
    const int dimension = reading.box().dimension;
    const bool is_plane = dimension == 2;
    const bool has_two = panel.component == Component::xy || panel.component == Component::xz ||
                         panel.component == Component::yz;
    if (dimension == 1)
        reading.errors.add(*written,
                           "on a wire there is one direction only: `component` has no meaning",
                           "leave it out");
    else if (has_two && (is_plane || !kind.can(Ability::two_axes)))
        reading.errors.add(
            *written,
            fmt::format("two axes together are for {} in a box with three lengths",
                        listed(kinds_that_can(kinds, Ability::two_axes), "and", "`")),
            is_plane ? "leave it out, or write `component: x` or `component: y`"
                     : "write `component: x`, `component: y` or `component: z`");
    else if (is_plane && panel.component == Component::z)
        reading.errors.add(*written, "a box with two lengths has no z: `component` is `x` or `y`",
                           "write `component: x` or `component: y`");
    else if (panel.component == Component::both && !kind.can(Ability::both))
        reading.errors.add(
            *written,
            fmt::format("expected {} for `component` where positions are shown, found `{}`",
                        is_plane ? "`x` or `y`" : "`x`, `y` or `z`", written->text),
            "give a panel for each axis");
    else if (panel.component == Component::both && (written->text == "both") != is_plane)
        reading.errors.add(*written,
                           fmt::format("a box with {} lengths has {} components",
                                       is_plane ? "two" : "three", is_plane ? "two" : "three"),
                           fmt::format("write `component: {}`", is_plane ? "both" : "all"));
}

// Refuses a panel that has no meaning in a box with three lengths.
void check_space(const Node& node, const PanelKind& kind, Reading& reading) {
    if (reading.box().dimension == 3 && !kind.in_space_instead.empty())
        reading.errors.add(
            node.is_mapping() ? *given(node, "kind") : node,
            fmt::format("a panel of kind `{}` has no meaning in a box with three lengths",
                        kind.name),
            kind.in_space_instead);
}

// Returns whether the particle belongs to a species with infinite masses.
bool is_infinite(const Gas& gas, std::int64_t particle) {
    for (const Species& species : gas.species) {
        if (particle < species.count) return std::holds_alternative<Infinite>(species.mass);
        particle -= species.count;
    }
    return false;
}

void check_pair(const Node& place, const PanelSpec& panel, Reading& reading) {
    const std::int64_t first = *panel.of[0].particle, second = *panel.of[1].particle;
    if (first == second)
        reading.errors.add(place, fmt::format("particle {} cannot collide with itself", first),
                           "`of` takes the numbers of two particles");
    else if (is_infinite(reading.gas, first) && is_infinite(reading.gas, second))
        reading.errors.add(
            place,
            fmt::format("particles {} and {} have infinite masses: they do not collide", first,
                        second),
            "give a pair with at least one finite mass");
}

// Checks that `of` has two particles, for kinds that show one particle's position against
// another's, or how two particles collide.
void check_two_particles(const PanelSpec& panel, const Node& node, const PanelKind& kind,
                         Reading& reading) {
    const bool is_pair = kind.can(Ability::pair);
    if (!is_pair && !kind.can(Ability::two)) return;
    const Node* of = given(node, "of");
    if (of == nullptr && (is_pair || find(node, "of") != nullptr)) return;
    if (of != nullptr && panel.of.size() != (of->is_list() ? of->items.size() : 1))
        return;  // there is a mistake in it
    const Node& place = of != nullptr ? *of : node;
    const bool particles =
        std::ranges::all_of(panel.of, [](const Chosen& one) { return one.particle.has_value(); });
    if (panel.of.size() != 2 || !particles)
        reading.errors.add(
            place,
            fmt::format("a panel of kind `{}` needs `of` with the numbers of two particles",
                        panel.kind),
            fmt::format("for instance {{kind: {}, of: [0, 1]}}{}", panel.kind,
                        is_pair ? "; without `of` it shows the first that collide" : ""));
    else if (is_pair)
        check_pair(place, panel, reading);
}

}  // namespace

Notation<ThemeName> theme_notation() {
    return one_of<ThemeName>().with_elsewhere({{"black", "did you mean `dark`?"},
                                               {"white", "did you mean `light`?"},
                                               {"bright", "did you mean `light`?"},
                                               {"default", "did you mean `dark`?"},
                                               {"paper", "did you mean `print`?"}});
}

std::vector<std::string> kinds_that_can(PanelKinds kinds, Ability ability) {
    std::vector<std::string> names;
    for (const PanelKind& kind : kinds)
        if (kind.can(ability)) names.push_back(kind.name);
    return names;
}

// Read as a text, because the name of a species may be any text.
Notation<std::vector<Chosen>> chosen_notation() {
    auto name = text(1, most_name_letters).called("`all`, a species or the number of a particle");
    name.forms.front().words = {"0"};
    const auto one = parsed(name, chosen);
    Notation<std::vector<Chosen>> all =
        one_or_list(one, most_chosen, "a list of species and particles");
    all.write = [](const std::vector<Chosen>& of) { return std::string(of.empty() ? "all" : ""); };
    return all;
}

Notation<std::vector<Monitor>> monitors_notation() {
    const auto check = [](Monitor monitor, const Node& node, Reading& reading) {
        if (monitor == Monitor::return_distance) check_reversal(node, reading);
    };
    return list_of(checked(one_of<Monitor>(), check), 1, most_monitors,
                   "a list of numbers to show");
}

Notation<Over> over_notation() {
    const auto word =
        one_of<Over::Since>({{"now", Over::Since::now}, {"start", Over::Since::start}});
    const KeyTable<Over> window{
        .name = "`over`",
        .keys = {bind_key("window", &Over::window, number(positive, quantities::time),
                          "The length of the window before the present, in simulated time.")
                     .required()},
        .rule = [](Over& over, const Node&, Reading&) { over.since = Over::Since::window; }};
    return either(mapped(word,
                         [](Over::Since since) {
                             return Over{since, 0.0};
                         }),
                  mapping(window, "{window: time}"));
}

Binding<PanelSpec> kind_key(const Notation<std::string>& words) {
    return bind_key("kind", &PanelSpec::kind, words, "What the panel shows.")
        .required()
        .tried_as({"type", "panel", "plot"});
}

namespace {

std::vector<std::string> kinds_with_axes(PanelKinds kinds) {
    std::vector<std::string> names;
    for (const PanelKind& kind : kinds)
        if (kind.has_plot && !kind.draws_box) names.push_back(kind.name);
    return names;
}

}  // namespace

std::vector<Binding<PanelSpec>> panel_keys(PanelKinds kinds, const Binding<PanelSpec>& kind,
                                           const std::vector<Binding<PanelSpec>>& over) {
    const std::vector what{
        kind,
        bind_key("title", &PanelSpec::title, text(1, most_title_letters),
                 "The words above the panel.")
            .tried_as({"label", "caption", "heading"})
            .default_text("by kind"),
        bind_key("of", &PanelSpec::of, chosen_notation(),
                 "Which particles: all, a species, one by its number, or several of these drawn "
                 "together. For a pair, two numbers; if omitted, the first pair that collides.")
            .tried_as({"particles", "particle", "which"})
            .only_with(kinds_that_can(kinds, Ability::of))};
    const std::vector axes{bind_key("x_title", &PanelSpec::x_title, text(0, most_name_letters),
                                    "The words at the horizontal axis; empty: none.")
                               .tried_as({"x_label", "xlabel", "xtitle"})
                               .default_text("by kind")
                               .only_with(kinds_with_axes(kinds)),
                           bind_key("y_title", &PanelSpec::y_title, text(0, most_name_letters),
                                    "The words over the vertical axis; empty: none.")
                               .tried_as({"y_label", "ylabel", "ytitle"})
                               .default_text("by kind")
                               .only_with(kinds_with_axes(kinds))};
    const std::vector component{
        bind_key(
            "component", &PanelSpec::component, one_of<Component>(),
            "The axis; `both`, in space `all`, counts all components of each particle. Of speeds "
            "it is the part along one axis or, in space, along two: `xy`.")
            .default_text("all for speeds and velocities, x for positions")
            .only_with(kinds_that_can(kinds, Ability::component))};
    const std::vector theory{
        bind_key("theory", &PanelSpec::theory, flag(),
                 "Whether to draw the equilibrium curve of this finite mixture, if it has an "
                 "equilibrium; `true` is an error if it has none. For return distances, the law by "
                 "which they grow for equal disks; for a density in gravity, that of an ideal gas "
                 "of as many particles; for correlations, free flights and displacements, the "
                 "theoretical curve or value.")
            .only_with(kinds_that_can(kinds, Ability::theory))};
    return joined<PanelSpec>(what, axes, over, component, own_keys(kinds, &PanelKind::bar_keys),
                             theory, own_keys(kinds, &PanelKind::keys));
}

void complete_panel(PanelSpec& panel, const Node& node, PanelKinds kinds, Reading& reading) {
    panel.place = place_of(node);
    const PanelKind* kind = kind_of(kinds, panel.kind);
    if (kind == nullptr) return;  // reported
    check_space(node, *kind, reading);
    check_two_particles(panel, node, *kind, reading);
    check_component(panel, node, kinds, *kind, reading);
    if (kind->rule) kind->rule(panel, node, reading);
}

void check_units(const PanelSpec& panel, const Node& node, PanelKinds kinds, Reading& reading) {
    const PanelKind* kind = kind_of(kinds, panel.kind);
    const bool is_chosen_later = node.source->origin == Origin::template_file;
    if (reading.units != UnitSystem::real || is_chosen_later || kind == nullptr ||
        kind->shows_units)
        return;
    std::vector<std::string> others;
    for (const PanelKind& other : kinds)
        if (other.shows_units) others.push_back(other.name);
    const Node* name = node.is_mapping() ? given(node, "kind") : &node;
    reading.errors.add(
        name != nullptr ? *name : node,
        fmt::format("`{}` does not show the units of a scene with `units: real`", panel.kind),
        "these do: " + listed(others, "and", "`"));
}

// A histogram of a few particles at one time would consist of a few bars of height one. Counted
// since the start, they form a distribution, so that this is the default for few particles.
void complete_over(PanelSpec& panel, PanelKinds kinds, const Gas& gas) {
    constexpr std::int64_t few = 10;
    const PanelKind* kind = kind_of(kinds, panel.kind);
    if (panel.over || kind == nullptr || !kind->can(Ability::bars)) return;
    std::int64_t count = panel.of.empty() ? count_of({}, gas).value_or(few) : 0;
    for (const Chosen& chosen : panel.of) count += count_of(chosen, gas).value_or(few);
    if (count < few) panel.over = Over{Over::Since::start, 0.0};
}

Notation<std::vector<PanelSpec>> panels_notation(PanelKinds kinds) {
    const Notation<std::string> names = film_kinds(kinds);
    const Binding<PanelSpec> over =
        bind_key("over", &PanelSpec::over, over_notation(),
                 "What is shown: present values, their mean since time 0, or their mean over a "
                 "time before the present.")
            .default_text(
                "now; since the start for the pressure, pair correlations and free flights, and "
                "for histograms of fewer than ten particles; a tenth of the run for profiles, a "
                "twentieth for gauges, thermometers, `flux` and `pressure-volume`")
            .only_with(kinds_that_can(kinds, Ability::over));
    const Binding<PanelSpec> show =
        bind_key("show", &PanelSpec::show, show_notation(),
                 "When the panel is shown. It appears and disappears within half a second; while "
                 "it is not shown, its place stays empty.")
            .default_text("throughout the film");
    const KeyTable<PanelSpec> table{
        .name = "a panel",
        .keys = panel_keys(kinds, kind_key(names), {over, show}),
        .rule = [kinds](PanelSpec& panel, const Node& node, Reading& reading) {
            complete_panel(panel, node, kinds, reading);
            check_units(panel, node, kinds, reading);
            complete_over(panel, kinds, reading.gas);
        }};
    const auto alone = [kinds](std::string name, const Node& node, Reading& reading) {
        PanelSpec panel{.kind = std::move(name)};
        complete_panel(panel, node, kinds, reading);
        check_units(panel, node, kinds, reading);
        complete_over(panel, kinds, reading.gas);
        return std::optional(std::move(panel));
    };
    return list_of(either(parsed(names, alone), mapping(table)), 0, most_panels,
                   "a list of panels");
}

namespace {

PanelKinds kinds_with_meters(PanelKinds kinds) {
    static MadeOnce<std::vector<PanelKind>> lists;
    return lists.of(kinds, [&] {
        std::vector<PanelKind> some;
        std::ranges::copy_if(kinds, std::back_inserter(some),
                             [](const PanelKind& kind) { return kind.meter != nullptr; });
        return some;
    });
}

Notation<std::vector<PanelSpec>> new_measure_notation(PanelKinds all) {
    const PanelKinds kinds = kinds_with_meters(all);
    std::vector<std::string> names;
    std::vector<Elsewhere> elsewhere;
    for (const PanelKind& kind : kinds) names.push_back(kind.name);
    for (const PanelKind& kind : all)
        if (kind.meter == nullptr)
            elsewhere.push_back({kind.name, "it reads no single numbers: show it in a figure"});
    for (const auto& [tried, meant] : tried_kinds(kinds))
        elsewhere.push_back({tried, fmt::format("did you mean {}?", meant)});
    const Notation<std::string> name = word(names).with_elsewhere(std::move(elsewhere));
    const Binding<PanelSpec> over =
        bind_key("over", &PanelSpec::over, over_notation(),
                 "What is read at the end: the last value, the mean since time 0, or the mean "
                 "over a time before the end.")
            .default_text("as in a panel of the kind")
            .only_with(kinds_that_can(kinds, Ability::over));
    const KeyTable<PanelSpec> table{
        .name = "an instrument",
        .keys = panel_keys(kinds, kind_key(name), {over}),
        .rule = [kinds](PanelSpec& panel, const Node& node, Reading& reading) {
            complete_panel(panel, node, kinds, reading);
        }};
    const auto alone = [kinds](std::string kind, const Node& node, Reading& reading) {
        PanelSpec panel{.kind = std::move(kind)};
        complete_panel(panel, node, kinds, reading);
        return std::optional(std::move(panel));
    };
    return list_of(either(parsed(name, alone), mapping(table)), 0, most_panels,
                   "a list of instruments");
}

}  // namespace

const Notation<std::vector<PanelSpec>>& measure_notation(PanelKinds kinds) {
    static MadeOnce<Notation<std::vector<PanelSpec>>> notations;
    return notations.of(kinds, [&] { return new_measure_notation(kinds); });
}

void check_reversal(const Node& place, Reading& reading) {
    const double until = reading.run.until;
    if (branch_count(reading.run) < 2)
        reading.errors.add(place,
                           "`return-distance` is measured after a reversal, and this run has none",
                           fmt::format("add to `events` of `run`: {{at: {}, reverse: velocities}}",
                                       until > 0.0 ? fmt::format("{}", 0.5 * until) : "TIME"));
    const std::int64_t count = particles_in(reading.gas).value_or(0);
    if (count > static_cast<std::int64_t>(most_returning.count()))
        reading.errors.add(place, fmt::format("`return-distance` of {} particles", count),
                           to_text(most_returning));
}

}  // namespace carom
