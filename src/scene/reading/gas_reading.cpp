#include "scene/reading/gas_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "physics/gas.h"
#include "physics/units/gas_table.h"
#include "physics/units/unit_table.h"
#include "scene/keys/gas_values.h"
#include "scene/lettering/word_places.h"
#include "scene/limits.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

/// The initial positions of the particles of a species, as read from the file.
struct PositionDraft {
    PositionRule rule;
    const Node* letters = nullptr;              ///< the text that the disks spell in `within`
    const Node *side = nullptr, *of = nullptr;  ///< instead of `within`: a partition's side
};

/// A species with the intermediate values that the rules between its keys need.
struct SpeciesReading : SpeciesDraft {
    std::optional<ValueRule> written_radius;  ///< none: it contains a mistake
    PositionDraft written_position;
};

KeyTable<PositionDraft> part_table(int dimension) {
    KeyTable<PositionDraft> table{
        .name = "`position`",
        .keys = {bind_key("within", &PositionDraft::rule,
                          as<PositionRule>(as<WithinRegion>(corners_of(
                              dimension, "within", "write the smaller coordinates first"))),
                          "A part of the box; the particles start entirely inside it.")}};
    if (dimension == 1) {
        table.keys.front().key.required = true;
        table.refused = {{"text", "`text` needs disks, in a box with a `size`", "give `within`"},
                         {"side", "a wire has no partitions", "give `within`"},
                         {"of", "a wire has no partitions", "give `within`"}};
    } else {
        const bool is_plane = dimension == 2;
        table.choices = {{{"within", "side"}, true}};
        table.refused = {
            {"inside", "`inside` is not a key of `position`", "did you mean `within`?"}};
        table.keys.push_back(
            bind_key("side", &PositionDraft::side, kept(word(side_names(dimension))),
                     "Instead of `within`: the part of the box on this side of a partition."));
        table.keys.push_back(bind_key("of", &PositionDraft::of, kept(text(1, most_name_letters)),
                                      "The name of that partition.")
                                 .default_text("the only one"));
        table.keys.push_back(
            bind_key("text", &PositionDraft::letters, kept(text(1, most_name_letters)),
                     fmt::format("A word written with {0}, as large as fits into `within`{1}: "
                                 "capitals, digits, . ! ? - + = ♥ ☺. Without `count`, it has as "
                                 "many {0} as fit with some space between them.",
                                 particles_of(dimension),
                                 is_plane ? "" : ", half way between its back and its front"))
                .default_text("random places"));
    }
    return table;
}

Notation<PositionDraft> position_notation(int dimension) {
    const std::string phrase =
        fmt::format("{{within: {}}}{}", corners(dimension),
                    dimension == 1 ? "" : " (and a `text`) or {side: left, of: NAME}");
    const auto anywhere = mapped(one_of<bool>({{"random", false}, {"lattice", true}})
                                     .with_elsewhere({{"grid", "did you mean `lattice`?"},
                                                      {"crystal", "did you mean `lattice`?"},
                                                      {"hexagonal", "did you mean `lattice`?"},
                                                      {"fcc", "did you mean `lattice`?"},
                                                      {"square", "did you mean `lattice`?"},
                                                      {"uniform", "did you mean `random`?"}}),
                                 [](bool on_lattice) {
                                     return on_lattice ? PositionDraft{LatticePlaces{}}
                                                       : PositionDraft{RandomPlaces{}};
                                 });
    return either(anywhere,
                  either(mapping(part_table(dimension), phrase),
                         as<PositionDraft>(as<Places>(points(dimension, quantities::length)))));
}

Notation<Temperature> temperature_notation() {
    struct Exact {
        double value = 0.0;
    };
    const KeyTable<Exact> table{
        .name = "`temperature`",
        .keys = {bind_key("exact", &Exact::value, number(not_negative, quantities::temperature),
                          "The temperature of the particles at the start, exact to the last digit.")
                     .required()}};
    return either(as<Temperature>(number(not_negative, quantities::temperature)),
                  mapped(mapping(table, "{exact: T}"), [](const Exact& its) {
                      return Temperature{its.value, true};
                  }));
}

Notation<const NamedGas*> gas_name_notation() {
    std::vector<Elsewhere> others{{"water", "did you mean `water vapour`?"},
                                  {"steam", "did you mean `water vapour`?"},
                                  {"sulfur hexafluoride", "did you mean `sulphur hexafluoride`?"}};
    for (const NamedGas& gas : named_gases())
        others.push_back({plain_symbol(gas), fmt::format("did you mean `{}`?", gas.name.english)});
    return mapped(word(names_of_gases()).with_elsewhere(std::move(others)),
                  [](const std::string& name) { return gas_named(name); });
}

std::vector<Binding<SpeciesReading>> matter_keys(int dimension) {
    const bool wire = dimension == 1, plane = dimension == 2;
    const auto mass =
        either(as<MassRule>(rule_for(positive, quantities::mass)),
               as<MassRule>(one_of<Infinite>({{"infinite", {}}})
                                .with_elsewhere({{"inf", "did you mean `infinite`?"},
                                                 {".inf", "did you mean `infinite`?"},
                                                 {"∞", "did you mean `infinite`?"},
                                                 {"fixed", "did you mean `infinite`?"}})));
    return {
        bind_key("name", &Species::name, text(1, most_name_letters),
                 "The name of the species, shown in legends.")
            .default_text("required when there are several species"),
        bind_key("gas", &SpeciesReading::named, gas_name_notation(),
                 "A gas whose `mass`, `radius` (that of hard spheres with its viscosity), `name` "
                 "and `color` the species has where it does not give them. Needs `units: real`.")
            .default_text("none"),
        bind_key("count", &Species::count, whole(1, most_particles), "The number of particles.")
            .tried_as({"n", "N", "number", "num", "amount", "particles"})
            .default_text(fmt::format("the number of positions listed, or of {} in a `text`",
                                      dimension == 3 ? "spheres" : "disks")),
        bind_key("radius", &SpeciesReading::written_radius,
                 rule_for(wire ? not_negative : positive, quantities::length),
                 wire    ? "Half the length of each bead: 0 is a point."
                 : plane ? "The radius of each disk."
                         : "The radius of each sphere.")
            .tried_as({"r", "R", "size"})
            .default_value(wire ? "0" : number_text(std::get<double>(Species{}.radius))),
        bind_key("mass", &Species::mass, mass,
                 "The mass of each particle. Collisions do not change the velocity of a "
                 "particle of mass `infinite`.")
            .tried_as({"m", "M", "weight"}),
        bind_key("density", &Species::mass,
                 as<Density>(rule_for(positive, quantities::mass / quantities::content(dimension))),
                 wire    ? "Instead of `mass`: mass = density * 2 radius."
                 : plane ? "Instead of `mass`: mass = density * pi * radius^2."
                         : "Instead of `mass`: mass = density * 4/3 * pi * radius^3."),
        bind_key("speed", &Species::velocity, as<Speed>(rule_for(not_negative, quantities::speed)),
                 fmt::format("The speed of each particle, {}. Where momentum is conserved, as "
                             "in a periodic {}, the directions are such that all momenta of "
                             "particles with a `speed` sum to zero.",
                             wire ? "to the left or to the right" : "in a random direction",
                             wire ? "wire" : "box"))
            .tried_as({"v"}),
        bind_key("velocity", &Species::velocity, as<Velocity>(points(dimension, quantities::speed)),
                 "One velocity for all particles, or a list with one for each."),
        bind_key("temperature", &Species::velocity, temperature_notation(),
                 "Velocities sampled from the Maxwell-Boltzmann distribution at this "
                 "temperature. The sample's own temperature differs from it by chance; with "
                 "{exact: T} the velocities are scaled to make it T.")
            .tried_as({"T", "temp", "energy"})
            .default_text("at rest"),
        bind_key("position", &SpeciesReading::written_position, position_notation(dimension),
                 "Where the particles start: at random, evenly spaced, in a part of the box, "
                 "or at listed positions.")
            .tried_as({"pos", "x", "place", "places", "start"})
            .default_value("random")};
}

std::vector<Binding<SpeciesLook>> look_keys(int dimension) {
    std::vector<Binding<SpeciesLook>> keys{
        bind_key(
            "color", &SpeciesLook::color, color(),
            "The colour of this species where colours distinguish species: a name or \"#rrggbb\".")
            .default_text("chosen by the film"),
        bind_key("fill", &SpeciesLook::fill, flag(),
                 "Whether disks and beads are drawn filled; otherwise they are rings."),
        bind_key("label", &SpeciesLook::label, text(0, most_name_letters),
                 "For a species of one particle: a word drawn beside it at the start of the film.")
            .default_text("its name"),
        bind_key("trail", &SpeciesLook::trail, number({0.0, most_trail_seconds}),
                 "The length of the particles' trails, in seconds of film.")
            .default_text("as the film's `trails` say")};
    if (dimension == 1)
        keys.push_back(bind_key("drawn_radius", &SpeciesLook::drawn_radius,
                                number(not_negative, quantities::length),
                                "The radius with which the beads are drawn; they are moved apart "
                                "so that they seem to touch when they collide. With 0, points are "
                                "drawn as dots where they are, and their world lines cross.")
                           .default_text("the radius, or 0.4 of the mean spacing for points"));
    else
        keys.push_back(bind_key("drawn_radius", &SpeciesLook::drawn_radius,
                                number(positive, quantities::length),
                                fmt::format("The radius with which {} are drawn that are too small "
                                            "to be seen. They overlap in the picture where they "
                                            "pass each other, and the picture gives their true "
                                            "radius.",
                                            particles_of(dimension)))
                           .default_text("the radius"));
    return keys;
}

// Returns whether a position is one place or a list of places, not a word or a region.
bool is_places(const Node& position) { return position.is_list() || number_in(position); }

// Checks that lists have one value for each particle.
void check_list_length(const Node& item, std::string_view key, std::int64_t count, int dimension,
                       Errors& errors) {
    const Node* list = given(item, key);
    if (list == nullptr) return;
    const bool vectors = key == "velocity" || key == "position";
    if (vectors && !lists_points(*list, dimension)) {
        if (key == "position" && is_places(*list) && count != 1)
            errors.add(
                *list, fmt::format("one position for {}", counted(count, "particle")),
                fmt::format("list one for each, or give `{{within: {}}}`", corners(dimension)));
        return;
    }
    if (!list->is_list()) return;
    const auto length = static_cast<std::int64_t>(list->items.size());
    if (length != count)
        errors.add(*list,
                   fmt::format("`{}` lists {} for {}", key, counted(length, "value"),
                               counted(count, "particle")),
                   "give one for each particle");
}

// Returns the number of particles of a species without `count`: that of its places; 0 if an error
// leaves it unknown.
std::int64_t counted_places(const SpeciesReading& draft, const Node& item, Errors& errors) {
    if (const auto* places = std::get_if<Places>(&draft.position))
        return static_cast<std::int64_t>(places->values.size());
    const Node* position = find(item, "position");
    const bool is_open = position != nullptr && (!position->valid || find(*position, "text"));
    if (find(item, "count") == nullptr && !is_open)
        errors.add(item, "an item of `gas` needs `count`, or a list of positions",
                   "for instance `count: 100`");
    return 0;
}

// In real units no radius or mass is usual, but those of a gas by name are filled in.
void check_matter_is_given(const Node& item, int dimension, Errors& errors) {
    if (find(item, "gas") != nullptr) return;  // it is unknown, which has been reported
    if (dimension > 1 && find(item, "radius") == nullptr)
        errors.add(item, "in real units an item of `gas` needs `radius`",
                   fmt::format("for instance `radius: {}`", unit_example(quantities::length)));
    if (find(item, "mass") == nullptr && find(item, "density") == nullptr)
        errors.add(item, "in real units an item of `gas` needs `mass` or `density`",
                   fmt::format("for instance `mass: {}`", unit_example(quantities::mass)));
}

// Applies the rules between the keys of a species.
void complete_species(SpeciesReading& draft, const Node& item, int dimension, UnitSystem units,
                      Errors& errors) {
    draft.node = &item;
    if (draft.written_radius) draft.radius = *draft.written_radius;
    const auto& [rule, letters, side, side_of] = draft.written_position;
    const auto* within = std::get_if<WithinRegion>(&rule);
    draft.side = side;
    draft.side_of = side_of;
    if (draft.side != nullptr && letters != nullptr)
        errors.add(*letters, "a `text` needs `within`, not the side of a partition",
                   "give `within` instead of `side`");
    if (draft.side == nullptr && draft.side_of != nullptr)
        errors.add(*draft.side_of, "`of` applies only to a `side`",
                   "leave it out, or give `side` instead of `within`");
    const auto* radius = std::get_if<double>(&draft.radius);
    if (dimension > 1 && draft.drawn_radius && radius != nullptr && *draft.drawn_radius < *radius)
        errors.add(*given(item, "drawn_radius"),
                   fmt::format("{} of radius {:g} cannot be drawn smaller", particles_of(dimension),
                               *radius),
                   fmt::format("leave out `drawn_radius`; it enlarges {} that are too small to be "
                               "seen",
                               particles_of(dimension)));
    if (letters == nullptr)
        draft.position = rule;
    else if (within != nullptr)
        if (const auto pattern = places_of_word(*letters, within->region, dimension, draft.radius,
                                                draft.count, errors))
            draft.position = *pattern;
    if (draft.count == 0) draft.count = counted_places(draft, item, errors);
    if (draft.named != nullptr && units == UnitSystem::reduced)
        errors.add(*given(item, "gas"), "a gas by name needs `units: real`",
                   "or give its `mass` and `radius` in units of your own");
    if (units == UnitSystem::real) check_matter_is_given(item, dimension, errors);
    if (draft.count > 0)
        for (std::string_view key : {"radius", "mass", "density", "speed", "velocity", "position"})
            check_list_length(item, key, draft.count, dimension, errors);
    draft.radius_known = draft.written_radius.has_value();
}

KeyTable<SpeciesReading> species_table(int dimension) {
    KeyTable<SpeciesReading> table{
        .name = "an item of `gas`",
        .keys = joined<SpeciesReading>(matter_keys(dimension), look_keys(dimension)),
        .choices = {{{"mass", "density"}}, {{"speed", "velocity", "temperature"}}},
        .refused = inelastic_keys(),
        .rule = [dimension](SpeciesReading& draft, const Node& item, Reading& reading) {
            complete_species(draft, item, dimension, reading.units, reading.errors);
        }};
    table.refused.push_back(
        {"diameter", "there is no `diameter`", "give `radius`, which is half of it"});
    return table;
}

void check_names(const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    std::set<std::string> names;
    for (const SpeciesDraft& draft : drafts) {
        const Node* node = find(*draft.node, "name");
        if (draft.name.empty()) {
            if (drafts.size() > 1 && node == nullptr)
                errors.add(*draft.node, "an item of `gas` needs `name` when there are several",
                           "for instance `name: light`");
            continue;
        }
        const bool number = draft.name.find_first_not_of("0123456789") == std::string::npos;
        if (draft.name == "all" || number)
            errors.add(*node,
                       fmt::format("{} cannot be the name of a species", in_quotes(draft.name)),
                       "`all` and numbers are reserved for choosing particles");
        if (!names.insert(draft.name).second)
            errors.add(
                *node,
                fmt::format("the name {} is taken by another species", in_quotes(draft.name)),
                "give each species a name of its own");
    }
}

void check_total(const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    std::int64_t total = 0;
    for (const SpeciesDraft& draft : drafts) {
        total += draft.count;
        if (static_cast<double>(total) <= most_particles.value) continue;
        errors.add(at_key(draft, "count"),
                   fmt::format("{} particles in all species up to this one", total),
                   to_text(most_particles));
        return;
    }
}

}  // namespace

std::vector<Refused> inelastic_keys() {
    std::vector<Refused> refused;
    for (const char* name : {"restitution", "elasticity", "elastic", "inelastic", "dissipation",
                             "damping", "friction"})
        refused.push_back(
            {name,
             fmt::format("there is no `{}`: all collisions are elastic and without friction, with "
                         "walls too",
                         name),
             "energy is conserved, and every collision can be undone: leave it out"});
    return refused;
}

Notation<std::vector<SpeciesDraft>> gas_notation(int dimension) {
    const auto species = as<SpeciesDraft>(mapping(species_table(dimension)));
    return mapped(
        checked(list_of(species, 1, most_species, "a list of species"),
                [](const std::vector<SpeciesDraft>& drafts, const Node&, Reading& reading) {
                    check_names(drafts, reading.errors);
                    check_total(drafts, reading.errors);
                }),
        [](std::vector<SpeciesDraft> drafts) {
            if (drafts.size() == 1 && drafts[0].name.empty()) drafts[0].name = "gas";
            return drafts;
        });
}

std::optional<std::int64_t> particles_in(const Gas& gas) {
    std::int64_t count = 0;
    for (const Species& species : gas.species) {
        if (species.count <= 0) return std::nullopt;
        count += species.count;
    }
    return gas.species.empty() ? std::nullopt : std::optional(count);
}

std::optional<std::int64_t> count_of(const Chosen& chosen, const Gas& gas) {
    if (!particles_in(gas)) return std::nullopt;
    if (chosen.particle) return 1;
    return chosen.species ? gas.species[*chosen.species].count : particles_in(gas);
}

void report_no_particle(const Node& place, const std::string& number, std::int64_t count,
                        Errors& errors) {
    errors.add(place, "there is no particle " + number,
               fmt::format("particles are numbered from 0 to {}, in the order in which `gas` lists "
                           "them",
                           count - 1));
}

void place_beside_partitions(std::vector<SpeciesDraft>& drafts, const Box& box,
                             const std::vector<std::string>& others, Errors& errors) {
    const std::vector<Partition>& partitions = box.surfaces.partitions;
    std::vector<std::string> names;
    for (const Partition& one : partitions) names.push_back(one.name);
    for (SpeciesDraft& draft : drafts) {
        if (draft.side == nullptr) continue;
        const Node& named = draft.side_of != nullptr ? *draft.side_of : *draft.side;
        auto found = partitions.begin();
        if (draft.side_of != nullptr)
            found = partitions.begin() + (std::ranges::find(names, named.text) - names.begin());
        if (found == partitions.end() || (draft.side_of == nullptr && names.size() > 1)) {
            if (draft.side_of != nullptr ? std::ranges::find(others, named.text) != others.end()
                                         : !others.empty())
                continue;
            const std::string known = "the partitions are " + listed(names, "and", "`");
            if (names.empty() || draft.side_of == nullptr)
                errors.add(named, "`side` needs a partition",
                           names.empty() ? "the scene has none" : "give its name as `of`");
            else
                errors.add(named, fmt::format("there is no partition {}", in_quotes(named.text)),
                           spelling_hint(named.text, names, known));
            continue;
        }
        const std::vector<std::string> sides = side_names(box.dimension);
        const auto side =
            static_cast<std::size_t>(std::ranges::find(sides, draft.side->text) - sides.begin());
        const auto axis = static_cast<std::size_t>(found->axis);
        if (side / 2 != axis) {
            errors.add(
                *draft.side, fmt::format("`{}` has no {} side", found->name, draft.side->text),
                fmt::format("its sides are {} and {}", sides.at(2 * axis), sides.at(2 * axis + 1)));
            continue;
        }
        if (found->at < 0.0 || found->at > box.length(found->axis)) continue;
        Region region{{}, box.size};
        (side % 2 == 0 ? region.high : region.low)[found->axis] = found->at;
        draft.position = WithinRegion{region};
    }
}

const Node& at_key(const SpeciesDraft& draft, std::string_view key) {
    const Node* node = find(*draft.node, key);
    return node != nullptr ? *node : *draft.node;
}

}  // namespace carom
