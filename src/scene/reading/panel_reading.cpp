#include "scene/reading/panel_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "scene/limits.h"
#include "scene/mixing.h"
#include "scene/reading/gas_reading.h"
#include "scene/time/timeline.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

std::optional<Chosen> chosen_particle(const Node& node, double number, const Gas& gas,
                                      Errors& errors) {
    const auto count = particles_in(gas);
    if (!count) return std::nullopt;
    if (number >= 0.0 && number < static_cast<double>(*count) && number == std::floor(number))
        return Chosen{{}, static_cast<std::int64_t>(number)};
    errors.add(node, fmt::format("there is no particle {}", in_quotes(node.text)),
               fmt::format("particles are numbered from 0 to {}, in the order in which `gas` lists "
                           "them",
                           *count - 1));
    return std::nullopt;
}

std::optional<Chosen> read_chosen(const Node& node, const Gas& gas, Errors& errors) {
    if (node.text == "all") return Chosen{};
    if (const auto number = number_in(node)) return chosen_particle(node, *number, gas, errors);
    std::vector<std::string> names;
    for (const Species& species : gas.species) {
        if (species.name == node.text) return Chosen{names.size(), {}};
        names.push_back(species.name);
    }
    const auto near = nearest_spelling(node.text, names);
    errors.add(node, fmt::format("there is no species {}", in_quotes(node.text)),
               near ? fmt::format("did you mean `{}`?", *near)
                    : "`of` takes `all`, the name of a species in `gas`, or a particle's number");
    return std::nullopt;
}

Over read_over(const Fields& fields, const Node& node) {
    if (!node.is_mapping())
        return {node.text == "start" ? Over::Since::start : Over::Since::now, 0.0};
    const auto window = Fields{node, section_of(fields.section(), "over")}.number("window");
    return {Over::Since::window, window.value_or(0.0)};
}

std::optional<Component> read_component(const Fields& fields, const std::string& kind,
                                        const Gas& gas, Errors& errors) {
    const Node* node = fields.given("component");
    if (node == nullptr) return std::nullopt;
    if (gas.box.dimension == 1)
        errors.add(*node, "on a wire there is one direction only: `component` has no meaning");
    else if (node->text == "both" && kind != "velocity-histogram")
        errors.add(*node,
                   "expected `x` or `y` for `component` where positions are shown, found `both`",
                   "the axes of a box have lengths of their own");
    if (node->text == "both") return Component::both;
    return node->text == "y" ? Component::y : Component::x;
}

// Of species the masses of which are infinite; `particle` is one of theirs.
bool is_infinite(const Gas& gas, std::int64_t particle) {
    for (const Species& species : gas.species) {
        if (particle < species.count) return std::holds_alternative<Infinite>(species.mass);
        particle -= species.count;
    }
    return false;
}

bool shows_meeting(const std::string& kind) {
    return kind == "single-collision" || kind == "contact-time" || kind == "collision-map";
}

// One particle's position is shown against another's, or how two particles meet.
void check_two_particles(const Node& place, const PanelSpec& panel, const Gas& gas,
                         Errors& errors) {
    const bool may_be_none = shows_meeting(panel.kind);
    if (panel.kind != "positions" && !may_be_none) return;
    if (may_be_none && panel.of.empty()) return;
    const bool particles =
        std::ranges::all_of(panel.of, [](const Chosen& one) { return one.particle.has_value(); });
    if (panel.of.size() != 2 || !particles) {
        errors.add(
            place,
            fmt::format("a panel of kind `{}` needs `of` with the numbers of two particles",
                        panel.kind),
            fmt::format("for instance {{kind: {}, of: [0, 1]}}{}", panel.kind,
                        may_be_none ? "; without `of` it shows the first that collide" : ""));
        return;
    }
    if (!may_be_none) return;
    const std::int64_t first = *panel.of[0].particle, second = *panel.of[1].particle;
    if (first == second)
        errors.add(place, fmt::format("particle {} cannot collide with itself", first),
                   "`of` takes the numbers of two particles");
    else if (is_infinite(gas, first) && is_infinite(gas, second))
        errors.add(place,
                   fmt::format("particles {} and {} have infinite masses: they do not collide",
                               first, second),
                   "give a pair of which one can be moved");
}

std::optional<GivenPair> read_given_pair(const Fields& fields, Errors& errors) {
    const Node *masses = fields.given("masses"), *velocities = fields.given("velocities");
    const bool both = fields.mentions("masses") && fields.mentions("velocities");
    for (const Node* alone : {masses, velocities})
        if (alone != nullptr && !both)
            errors.add(*alone, "`masses` and `velocities` of a pair go together",
                       "for instance {kind: collision-map, masses: [1, 3], velocities: [1, 0]}; "
                       "without them it shows a pair of the scene");
    for (const char* of_the_run : {"of", "walk"})
        if (const Node* other = fields.given(of_the_run); other != nullptr && both)
            errors.add(
                *other,
                fmt::format("`{}` is of beads of the scene, `masses` are of others", of_the_run),
                "leave out one of them");
    if (masses == nullptr || velocities == nullptr) return std::nullopt;
    GivenPair pair{.inverse_mass = {}, .velocity = carom::pair(*velocities)};
    for (Eigen::Index k = 0; k < 2; ++k) {
        const auto mass = number_in(masses->items[static_cast<std::size_t>(k)]);
        pair.inverse_mass[k] = mass ? 1.0 / *mass : 0.0;
    }
    if (!(pair.inverse_mass.sum() > 0.0))
        errors.add(*masses, "two infinite masses do not collide", "give one that can be moved");
    if (pair.velocity[0] == pair.velocity[1])
        errors.add(*velocities, "two beads of equal velocities never meet");
    return pair;
}

// The plane of two velocities is all there is on a wire only.
void check_wire(const Node& kind, const std::string& name, const Gas& gas, Errors& errors) {
    if (name != "collision-map" || gas.box.dimension == 1) return;
    errors.add(kind, "`collision-map` shows beads on a wire, and this gas is in a plane",
               "disks have two components of velocity each: use `single-collision`, or give the "
               "box a `length` instead of a `size`");
}

void check_words(const Node& place, const Fields* fields, const PanelSpec& panel, Errors& errors) {
    if (panel.kind == "text" && (fields == nullptr || !fields->mentions("words")))
        errors.add(place, "a panel of kind `text` needs `words`",
                   "for instance {kind: text, words: \"Watch the red disk.\"}");
}

std::pair<double, double> read_range(const Node& range, const std::string& kind, Errors& errors) {
    const Eigen::Array2d ends = pair(range);
    const bool never_negative = kind == "speed-histogram" || kind == "energy-histogram";
    if (ends[0] >= ends[1])
        errors.add(range, "expected [low, high] with low < high for `range`");
    else if (never_negative && ends[0] < 0.0)
        errors.add(range,
                   fmt::format("expected [low, high] from 0 on for `range`, found {}",
                               in_quotes(range.items[0].text)),
                   "speeds and energies are never negative");
    return {ends[0], ends[1]};
}

// Whether all particles have one radius and one mass, as far as the scene says it in one number.
bool are_equal(const Gas& gas) {
    const auto one_number = [](const Species& species) -> std::optional<std::array<double, 2>> {
        const auto* radius = std::get_if<double>(&species.radius);
        const auto* density = std::get_if<Density>(&species.mass);
        const auto* mass =
            density != nullptr ? &density->value : std::get_if<Quantity>(&species.mass);
        const double* number = mass != nullptr ? std::get_if<double>(mass) : nullptr;
        if (radius == nullptr || number == nullptr) return std::nullopt;
        return std::array{*radius, density != nullptr ? -*number : *number};
    };
    const auto first = one_number(gas.species.front());
    return first && std::ranges::all_of(gas.species, [&](const Species& species) {
               return one_number(species) == first;
           });
}

void check_law(const Node& asked, const Gas& gas, Errors& errors) {
    const std::string hint = "leave out `theory`, and the curve is drawn where there is one";
    if (gas.box.dimension == 1)
        errors.add(asked, "there is no growth law for beads on a wire: neighbours part too slowly",
                   hint);
    else if (!are_equal(gas))
        errors.add(asked,
                   "there is no growth law for this gas: it is known for disks of one radius and "
                   "one finite mass",
                   hint);
}

// A curve that is asked for is missed; where it is only the default, it is left out.
void check_theory(const Fields& fields, const Gas& gas, Errors& errors) {
    const Node* asked = fields.given("theory");
    if (asked == nullptr || fields.flag("theory") != true || gas.species.empty()) return;
    if (asked->source->origin == Origin::template_file) return;
    if (fields.text("kind") == "return-distance") return check_law(*asked, gas, errors);
    if (const auto reason = why_no_equilibrium(gas))
        errors.add(*asked, "there is no equilibrium curve for this gas: " + *reason,
                   "leave out `theory`, and the curve is drawn where there is one");
}

// The way home begins with a reversal, and is kept in memory.
void check_way_home(const Node& place, const Shown& shown, Errors& errors) {
    if (branch_count(shown.run) < 2)
        errors.add(place, "`return-distance` is measured from a reversal on, and this run has none",
                   "give one in `run`: events: [{at: TIME, reverse: velocities}]");
    const std::int64_t count = particles_in(shown.gas).value_or(0);
    if (count > static_cast<std::int64_t>(most_returning.count()))
        errors.add(
            place, fmt::format("`return-distance` of {} particles", count),
            fmt::format("the ceiling is {:.0f} {}", most_returning.value, most_returning.meaning));
}

}  // namespace

PanelSpec read_panel(const Fields& fields, const Shown& shown, Errors& errors) {
    const Gas& gas = shown.gas;
    PanelSpec panel;
    panel.kind = fields.text("kind").value_or("");
    panel.place = place_of(fields.node());
    panel.title = fields.text("title");
    const Node* of = fields.given("of");
    if (of != nullptr) panel.of = read_of(*of, gas, errors);
    const bool all_read =
        of == nullptr || panel.of.size() == (of->is_list() ? of->items.size() : 1);
    if (all_read && (of != nullptr || !fields.mentions("of")))
        check_two_particles(of != nullptr ? *of : fields.node(), panel, gas, errors);
    if (const Node* kind = fields.given("kind")) check_wire(*kind, panel.kind, gas, errors);
    panel.given = read_given_pair(fields, errors);
    panel.walk = fields.flag("walk").value_or(false);
    panel.scaled = fields.flag("scaled");
    panel.component = read_component(fields, panel.kind, gas, errors);
    if (const auto bins = fields.integer("bins")) panel.bins = static_cast<int>(*bins);
    if (const Node* range = fields.given("range"))
        panel.range = read_range(*range, panel.kind, errors);
    panel.theory = fields.flag("theory").value_or(true);
    check_theory(fields, gas, errors);
    panel.fit = fields.flag("fit").value_or(false);
    panel.mean_now = fields.flag("mean_now");
    panel.mean_start = fields.flag("mean_start");
    panel.reference_initial = fields.text("reference") == "initial";
    panel.against_collisions = fields.text("against") == "collisions";
    panel.numbers = read_monitors(fields.given("numbers"), shown, errors);
    panel.words = fields.text("words").value_or("");
    check_words(fields.node(), &fields, panel, errors);
    if (panel.kind == "return-distance")
        check_way_home(*find(fields.node(), "kind"), shown, errors);
    return panel;
}

std::vector<Chosen> read_of(const Node& node, const Gas& gas, Errors& errors) {
    std::vector<Chosen> all;
    const std::vector<Node> single{node};
    for (const Node& item : node.is_list() ? node.items : single)
        if (const auto chosen = read_chosen(item, gas, errors)) all.push_back(*chosen);
    return all;
}

std::vector<Monitor> read_monitors(const Node* list, const Shown& shown, Errors& errors) {
    static const std::map<std::string, Monitor> numbers{
        {"time", Monitor::time},
        {"collisions", Monitor::collisions},
        {"mean-speed", Monitor::mean_speed},
        {"mean-energy", Monitor::mean_energy},
        {"slow", Monitor::slow},
        {"medium", Monitor::medium},
        {"fast", Monitor::fast},
        {"all-collisions", Monitor::all_collisions},
        {"return-distance", Monitor::return_distance}};
    std::vector<Monitor> monitors;
    if (list == nullptr) return monitors;
    for (const Node& item : list->items) {
        monitors.push_back(numbers.at(item.text));
        if (monitors.back() == Monitor::return_distance) check_way_home(item, shown, errors);
    }
    return monitors;
}

std::vector<PanelSpec> read_panels(const Fields& film, const Shown& shown, Errors& errors) {
    std::vector<PanelSpec> panels;
    const Node* list = film.given("panels");
    if (list == nullptr) return panels;
    const Section& section = section_of(film.section(), "panels");
    for (const Node& item : list->items) {
        if (!item.valid) continue;
        if (item.is_mapping()) {
            const Fields fields{item, section};
            panels.push_back(read_panel(fields, shown, errors));
            if (const Node* over = fields.given("over"))
                panels.back().over = read_over(fields, *over);
        } else {
            panels.push_back({});
            panels.back().kind = item.text;
            panels.back().place = place_of(item);
            check_two_particles(item, panels.back(), shown.gas, errors);
            check_wire(item, item.text, shown.gas, errors);
            check_words(item, nullptr, panels.back(), errors);
            if (item.text == "return-distance") check_way_home(item, shown, errors);
        }
    }
    return panels;
}

}  // namespace carom
