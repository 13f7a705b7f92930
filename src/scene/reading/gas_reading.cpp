#include "scene/reading/gas_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/limits.h"
#include "scene/reading/word_pattern.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

Wall wall(const std::string& word) { return word == "periodic" ? Wall::periodic : Wall::solid; }

Wall opposite_walls(const Fields& walls, std::string_view first, std::string_view second,
                    Errors& errors) {
    const std::string a = walls.text(first).value_or("solid");
    const std::string b = walls.text(second).value_or("solid");
    if (a != b)
        errors.add(walls.node(), fmt::format("`{}` is {} but `{}` is {}", first, a, second, b),
                   "a periodic wall leads to the opposite one: make both periodic");
    return wall(a);
}

// Whether these are places, and not a word or a part of the box.
bool is_places(const Node& position) { return position.is_list() || number_in(position); }

// Lists give one value for each particle.
void check_list_length(const Fields& item, std::string_view key, std::int64_t count, int dimension,
                       Errors& errors) {
    const Node* list = item.given(key);
    if (list == nullptr) return;
    const bool vectors = key == "velocity" || key == "position";
    if (vectors && !lists_points(*list, dimension)) {
        if (key == "position" && is_places(*list) && count != 1)
            errors.add(*list, fmt::format("one point for {}", counted(count, "particle")),
                       fmt::format("list a point for each, or give `{{within: {}}}`",
                                   dimension == 1 ? "[x0, x1]" : "[x0, y0, x1, y1]"));
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

std::int64_t listed_positions(const Fields& item, int dimension) {
    const Node* position = item.given("position");
    if (position == nullptr || !is_places(*position)) return 0;
    return lists_points(*position, dimension) ? static_cast<std::int64_t>(position->items.size())
                                              : 1;
}

// The letters of a pattern, if the places are one.
const Node* word_in(const Fields& item) {
    const Node* position = item.given("position");
    return position != nullptr && position->is_mapping() ? find(*position, "text") : nullptr;
}

// 0 when it is not known; `pattern` are the places of a word, if there is one.
std::int64_t read_count(const Fields& item, int dimension, const std::optional<Places>& pattern,
                        Errors& errors) {
    if (const auto count = item.integer("count")) return *count;
    if (pattern) return static_cast<std::int64_t>(pattern->values.size());
    const std::int64_t listed = listed_positions(item, dimension);
    if (listed == 0 && !item.mentions("count") && word_in(item) == nullptr &&
        (item.given("position") || !item.mentions("position")))
        errors.add(item.node(), "an item of `gas` needs `count`, or a list of positions");
    return listed;
}

std::optional<Quantity> read_quantity(const Fields& item, std::string_view key, Errors& errors) {
    const Node* node = item.value(key);
    if (node == nullptr) return std::nullopt;
    const Key& entry = item.section().keys.at(item.section().index(key));
    return quantity_in(*node, entry.forms.front().range, errors);
}

MassRule read_mass(const Fields& item, Errors& errors) {
    if (item.given("density"))
        if (auto density = read_quantity(item, "density", errors)) return Density{*density};
    if (item.text("mass") == "infinite") return Infinite{};
    if (const auto mass = read_quantity(item, "mass", errors)) return *mass;
    return Quantity{1.0};
}

VelocityRule read_velocity(const Fields& item, int dimension, Errors& errors) {
    if (const Node* velocity = item.given("velocity"))
        return Velocity{points(*velocity, dimension)};
    if (const auto temperature = item.number("temperature")) return Temperature{*temperature};
    if (const auto speed = read_quantity(item, "speed", errors)) return Speed{*speed};
    return AtRest{};
}

std::optional<Region> region_in(const std::vector<double>& ends, const Node& within, int dimension,
                                Errors& errors) {
    if (dimension == 1 && ends[0] < ends[1]) return Region{{ends[0], 0.0}, {ends[1], 0.0}};
    if (dimension == 2 && ends[0] < ends[2] && ends[1] < ends[3])
        return Region{{ends[0], ends[1]}, {ends[2], ends[3]}};
    errors.add(within, dimension == 1
                           ? "expected [x0, x1] with x0 < x1 for `within`"
                           : "expected [x0, y0, x1, y1] with x0 < x1 and y0 < y1 for `within`");
    return std::nullopt;
}

// Nothing for a normal law, which has no largest value.
std::optional<double> largest_of(const Quantity& quantity) {
    if (const auto* number = std::get_if<double>(&quantity)) return *number;
    if (const auto* law = std::get_if<UniformLaw>(&quantity)) return law->high;
    const auto* list = std::get_if<std::vector<double>>(&quantity);
    return list != nullptr ? std::optional(std::ranges::max(*list)) : std::nullopt;
}

// Of disks that touch: the most of them across a cell of a word.
int most_across(double cell, double radius) {
    const double most = cell / (2.0 * radius) * (1.0 + 1e-12);
    return static_cast<int>(std::min(most, std::sqrt(most_particles.value)));
}

bool check_word(const Node& word, const WordShape& shape, Errors& errors) {
    const std::vector<std::string> without = letters_without_shape(word.text);
    if (!without.empty())
        errors.add(word, fmt::format("no pattern for {}", listed(without, "and", "`")),
                   fmt::format("there is one for {}", letters_with_shape));
    else if (shape.cells.empty())
        errors.add(word, "expected at least one letter for `text`");
    return without.empty() && !shape.cells.empty();
}

// The places of a word's disks: so many across a cell that there are `count`, or as many as leave a
// quarter of their diameter between them.
std::optional<Places> read_word(const Fields& item, int dimension, const Quantity& radius,
                                Errors& errors) {
    const Node* word = dimension == 2 ? word_in(item) : nullptr;
    const Node* within =
        word != nullptr && word->valid ? find(*item.given("position"), "within") : nullptr;
    if (within == nullptr || !within->valid) return std::nullopt;
    const WordShape shape = word_shape(word->text);
    const auto largest = largest_of(radius);
    if (!check_word(*word, shape, errors)) return std::nullopt;
    if (!largest) {
        errors.add(*word, "a `text` needs radii that have a largest one, not a normal law");
        return std::nullopt;
    }
    Errors told_later;  // by read_position()
    const auto region = region_in(numbers(*within), *within, dimension, told_later);
    if (!region) return std::nullopt;
    const double cell = shape.cell_in(*region);
    const auto cells = static_cast<double>(shape.cells.size());
    const int most = most_across(cell, *largest);
    const auto count = item.integer("count");
    const int across = count
                           ? static_cast<int>(std::ceil(std::sqrt(double(*count) / cells)))
                           : std::clamp(most_across(cell, 1.25 * *largest), 1,
                                        static_cast<int>(std::sqrt(most_particles.value / cells)));
    if (across > most) {
        const double room = cells * most * most;
        errors.add(*word,
                   most == 0 ? fmt::format("disks of radius {} are wider than the strokes of the "
                                           "letters, which are {:.4g} wide",
                                           *largest, cell)
                             : fmt::format("{} disks of radius {} do not fit into the letters, "
                                           "which have room for {:.0f}",
                                           *count, *largest, room),
                   most == 0 ? "smaller disks or a larger `within` make room"
                             : "fewer or smaller disks or a larger `within` make room");
        return std::nullopt;
    }
    return Places{places_of(shape, *region, across,
                            count.value_or(static_cast<std::int64_t>(cells) * across * across))};
}

std::optional<PositionRule> read_position(const Fields& item, int dimension,
                                          const std::optional<Places>& pattern, Errors& errors) {
    const Node* position = item.value("position");
    if (is_places(*position)) return Places{points(*position, dimension)};
    if (position->text == "lattice") return LatticePlaces{};
    if (!position->is_mapping()) return RandomPlaces{};
    const Node* within = find(*position, "within");
    if (within == nullptr || !within->valid) return std::nullopt;
    const auto region = region_in(numbers(*within), *within, dimension, errors);
    if (!region) return std::nullopt;
    if (pattern) return *pattern;
    if (find(*position, "text") != nullptr) return std::nullopt;
    return WithinRegion{*region};
}

SpeciesLook read_look(const Fields& item, int dimension) {
    SpeciesLook look;
    if (const auto color = item.text("color")) look.color = color_hex(*color);
    look.fill = item.flag("fill").value_or(true);
    look.label = item.text("label").value_or("");
    look.trail = item.number("trail");
    if (dimension == 1) look.drawn_radius = item.number("drawn_radius");
    return look;
}

SpeciesDraft read_item(const Fields& item, int dimension, Errors& errors) {
    SpeciesDraft draft;
    draft.node = &item.node();
    Species& species = draft.species;
    species.name = item.text("name").value_or("");
    const auto radius = read_quantity(item, "radius", errors);
    species.radius = radius.value_or(Quantity{dimension == 1 ? 0.0 : 0.5});
    const auto pattern = read_word(item, dimension, species.radius, errors);
    species.count = read_count(item, dimension, pattern, errors);
    if (species.count > 0)
        for (std::string_view key : {"radius", "mass", "density", "speed", "velocity", "position"})
            check_list_length(item, key, species.count, dimension, errors);
    draft.radius_known = radius.has_value() && (item.given("radius") || !item.mentions("radius"));
    species.mass = read_mass(item, errors);
    species.velocity = read_velocity(item, dimension, errors);
    const auto position = read_position(item, dimension, pattern, errors);
    draft.position_known =
        position.has_value() && (item.given("position") || !item.mentions("position"));
    if (position) species.position = *position;
    draft.look = read_look(item, dimension);
    return draft;
}

void check_name(const SpeciesDraft& draft, Errors& errors) {
    const std::string& name = draft.species.name;
    const bool number = name.find_first_not_of("0123456789") == std::string::npos;
    if (name != "all" && !number) return;
    errors.add(*find(*draft.node, "name"),
               fmt::format("{} cannot be the name of a species", in_quotes(name)),
               "`all` and numbers have a meaning of their own where particles are chosen");
}

void check_names(const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
        const SpeciesDraft& draft = drafts[i];
        if (draft.species.name.empty()) {
            if (drafts.size() > 1 && find(*draft.node, "name") == nullptr)
                errors.add(*draft.node, "an item of `gas` needs `name` when there are several");
            continue;
        }
        check_name(draft, errors);
        if (!first.emplace(draft.species.name, i).second)
            errors.add(*find(*draft.node, "name"),
                       fmt::format("the name {} is taken by another species",
                                   in_quotes(draft.species.name)));
    }
}

void check_total(const std::vector<SpeciesDraft>& drafts, Errors& errors) {
    std::int64_t total = 0;
    for (const SpeciesDraft& draft : drafts) {
        total += draft.species.count;
        if (static_cast<double>(total) <= most_particles.value) continue;
        const Node* count = find(*draft.node, "count");
        errors.add(
            count != nullptr ? *count : *draft.node, fmt::format("{} particles up to here", total),
            fmt::format("the ceiling is {} {}", most_particles.value, most_particles.meaning));
        return;
    }
}

}  // namespace

std::optional<Box> read_box(const Fields& scene, int dimension, Errors& errors) {
    const auto fields = scene.inner("box");
    if (!fields) return std::nullopt;
    Box box;
    box.dimension = dimension;
    if (const auto walls = fields->inner("walls")) {
        box.walls[0] = opposite_walls(*walls, "left", "right", errors);
        if (dimension == 2) box.walls[1] = opposite_walls(*walls, "bottom", "top", errors);
    } else {
        const Wall all = wall(fields->text("walls").value_or("solid"));
        box.walls = {all, dimension == 2 ? all : Wall::solid};
    }
    const Node* extent = fields->given(dimension == 2 ? "size" : "length");
    if (extent == nullptr) return std::nullopt;
    box.size = points(*extent, dimension).front();
    return box;
}

std::vector<SpeciesDraft> read_species(const Fields& scene, int dimension, Errors& errors) {
    std::vector<SpeciesDraft> drafts;
    const Node* gas = scene.given("gas");
    if (gas == nullptr) return drafts;
    const Section& section = section_of(scene.section(), "gas");
    for (const Node& item : gas->items)
        if (item.is_mapping()) drafts.push_back(read_item({item, section}, dimension, errors));
    check_names(drafts, errors);
    check_total(drafts, errors);
    if (drafts.size() == 1 && drafts[0].species.name.empty()) drafts[0].species.name = "gas";
    return drafts;
}

std::optional<std::int64_t> particles_in(const Gas& gas) {
    std::int64_t count = 0;
    for (const Species& species : gas.species) {
        if (species.count <= 0) return std::nullopt;
        count += species.count;
    }
    return gas.species.empty() ? std::nullopt : std::optional(count);
}

const Node& at_key(const SpeciesDraft& draft, std::string_view key) {
    const Node* node = find(*draft.node, key);
    return node != nullptr ? *node : *draft.node;
}

std::string called(const SpeciesDraft& draft, std::size_t particle) {
    const std::string& name = draft.species.name;
    return name.empty() ? fmt::format("particle {}", particle)
                        : fmt::format("particle {} ({})", particle, name);
}

double number_of(const Quantity& quantity, std::size_t i) {
    if (const auto* one = std::get_if<double>(&quantity)) return *one;
    const auto* list = std::get_if<std::vector<double>>(&quantity);
    return list != nullptr && i < list->size() ? (*list)[i] : 0.0;
}

}  // namespace carom
