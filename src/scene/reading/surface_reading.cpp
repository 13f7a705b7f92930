#include "scene/reading/surface_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "physics/gas.h"
#include "scene/limits.h"
#include "scene/reading/gas_reading.h"
#include "util/text.h"

namespace carom {
namespace {

// ------------------------------------------------------------------------------------ partitions

/// The speeds at which a demon lets particles through to one side.
struct SpeedsDraft {
    std::optional<double> faster_than, slower_than;
};

Notation<Membrane::Speeds> speeds_notation() {
    const KeyTable<SpeedsDraft> table{
        .name = "the speeds of a demon",
        .keys = {
            bind_key("faster_than", &SpeedsDraft::faster_than,
                     number(not_negative, quantities::speed), "Particles faster than this pass."),
            bind_key("slower_than", &SpeedsDraft::slower_than, number(positive, quantities::speed),
                     "Particles slower than this pass; with both keys, those in between.")}};
    return parsed(mapping(table, "{faster_than: u} or {slower_than: u}"),
                  [](const SpeedsDraft& draft, const Node& node,
                     Reading& reading) -> std::optional<Membrane::Speeds> {
                      Membrane::Speeds speeds;
                      if (!draft.faster_than && !draft.slower_than) {
                          if (node.keys.empty())
                              reading.errors.add(node,
                                                 "a demon needs `faster_than` or `slower_than`",
                                                 "`{faster_than: 0}` lets all through");
                          return std::nullopt;
                      }
                      speeds.faster_than = draft.faster_than.value_or(0.0);
                      if (draft.slower_than) speeds.slower_than = *draft.slower_than;
                      if (speeds.faster_than < speeds.slower_than) return speeds;
                      reading.errors.add(node,
                                         fmt::format("no speed is above {} and below {}",
                                                     speeds.faster_than, speeds.slower_than),
                                         "`faster_than` is the lower bound");
                      return std::nullopt;
                  });
}

/// The speeds of a demon, for each side to which it lets particles through.
struct DemonDraft {
    std::optional<Membrane::Speeds> to_right, to_left, to_top, to_bottom, to_front, to_back;
};

KeyTable<DemonDraft> demon_table(int dimension) {
    const Notation<Membrane::Speeds> speeds = speeds_notation();
    KeyTable<DemonDraft> table{
        .name = "`passes`",
        .keys = {bind_key("to_right", &DemonDraft::to_right, speeds,
                          "The speeds that it lets through to the right."),
                 bind_key("to_left", &DemonDraft::to_left, speeds,
                          "The speeds that it lets through to the left."),
                 bind_key("to_top", &DemonDraft::to_top, speeds,
                          "The speeds that it lets through upwards, if it lies at a `y`."),
                 bind_key("to_bottom", &DemonDraft::to_bottom, speeds,
                          "The speeds that it lets through downwards, if it lies at a `y`.")}};
    if (dimension == 2) return table;
    table.keys.push_back(bind_key("to_front", &DemonDraft::to_front, speeds,
                                  "The speeds that it lets through to the front, toward the "
                                  "viewer, if it lies at a `z`."));
    table.keys.push_back(bind_key("to_back", &DemonDraft::to_back, speeds,
                                  "The speeds that it lets through to the back, if it lies at a "
                                  "`z`."));
    return table;
}

Notation<PassesDraft> passes_notation(int dimension) {
    const auto demon = parsed(
        mapping(demon_table(dimension), "{to_right: {faster_than: u}, to_left: {slower_than: u}}"),
        [dimension](const DemonDraft& draft, const Node& node, Reading& reading) {
            if (node.keys.empty())
                reading.errors.add(
                    node, "`passes` needs a direction",
                    fmt::format("give `to_right` or `to_left`, at a `y` `to_top` or `to_bottom`{}; "
                                "or a list of the species that pass",
                                dimension == 2 ? "" : ", at a `z` `to_front` or `to_back`"));
            const auto first_of = [](const auto&... given) {
                Membrane::Speeds speeds;
                ((given ? (speeds = *given, true) : false) || ...);
                return speeds;
            };
            return std::optional(
                PassesDraft{.upward = first_of(draft.to_right, draft.to_top, draft.to_front),
                            .downward = first_of(draft.to_left, draft.to_bottom, draft.to_back),
                            .node = &node});
        });
    const auto names =
        parsed(list_of(placed(text(1, most_name_letters)), 1, most_species, "a list of species"),
               [](std::vector<Placed<std::string>> species, const Node& node, Reading&) {
                   return std::optional(PassesDraft{.species = std::move(species), .node = &node});
               });
    return either(names, demon);
}

// Particles pass a demon only across its partition: reports directions along it.
void check_directions(const PartitionDraft& draft, Errors& errors) {
    const Node* passes = draft.passes.node;
    if (passes == nullptr || !passes->is_mapping()) return;
    static constexpr std::array across{std::array{"to_right", "to_left"},
                                       std::array{"to_top", "to_bottom"},
                                       std::array{"to_front", "to_back"}};
    static constexpr std::array places{"an `x`", "a `y`", "a `z`"};
    const auto axis = static_cast<std::size_t>(draft.axis);
    for (const Node& key : passes->keys)
        if (std::ranges::find(across.at(axis), key.text) == across.at(axis).end())
            errors.add(key,
                       fmt::format("`{}` is not a direction through a partition at {}", key.text,
                                   places.at(axis)),
                       fmt::format("particles pass it `{}` and `{}`", across.at(axis)[0],
                                   across.at(axis)[1]));
}

void complete_partition(PartitionDraft& draft, const Node& node, Reading& reading) {
    draft.node = &node;
    const std::array along{draft.x, draft.y, draft.z};
    const auto given_one =
        std::ranges::find_if(along, [](const auto& at) { return at.has_value(); });
    const bool has_place = given_one != along.end();
    if (has_place) {
        draft.axis = static_cast<int>(given_one - along.begin());
        draft.at = **given_one;
        check_directions(draft, reading.errors);
    }
    const auto behaviour = behaviour_of(draft, node, reading.errors);
    if (behaviour) draft.behaviour = *behaviour;
    if (draft.passes.node != nullptr)
        draft.behaviour = Membrane{{}, draft.passes.upward, draft.passes.downward};
    draft.is_known = behaviour && has_place &&
                     (given(node, "gaps") != nullptr) == (find(node, "gaps") != nullptr);
}

// A gap in a plane has two ends, one in space two corners.
Notation<Gap> gap_notation(int dimension) {
    if (dimension == 2)
        return mapped(pair_of(number(any_number, quantities::length), "[from, to]"),
                      [](const TwoNumbers& ends) { return Gap(ends[0], ends[1]); });
    const auto rectangle =
        list_of(number(any_number, quantities::length), 4, {4}, "[a0, b0, a1, b1]")
            .with_list_hint(
                "a gap is a rectangle: the coordinates of its lower corner, then those "
                "of its upper one, without that of the partition's own axis, for "
                "instance `[8, 8, 14, 14]`");
    return parsed(rectangle,
                  [](const std::vector<double>& ends, const Node& node,
                     Reading& reading) -> std::optional<Gap> {
                      if (const auto part = region_of(2, ends))
                          return Gap({part->low[0], part->low[1]}, {part->high[0], part->high[1]});
                      reading.errors.add(
                          node, "expected [a0, b0, a1, b1] with a0 < a1 and b0 < b1 for `gaps`",
                          "write the smaller coordinates first");
                      return std::nullopt;
                  });
}

std::vector<Binding<PartitionDraft>> place_keys(int dimension) {
    if (dimension == 2)
        return {bind_key("x", &PartitionDraft::x, number(any_number, quantities::length),
                         "The x coordinate of a partition that goes from bottom to top."),
                bind_key("y", &PartitionDraft::y, number(any_number, quantities::length),
                         "The y coordinate of a partition that goes from left to right.")};
    return {bind_key("x", &PartitionDraft::x, number(any_number, quantities::length),
                     "The x coordinate of a partition between left and right."),
            bind_key("y", &PartitionDraft::y, number(any_number, quantities::length),
                     "The y coordinate of a partition between bottom and top."),
            bind_key("z", &PartitionDraft::z, number(any_number, quantities::length),
                     "The z coordinate of a partition between back and front.")};
}

KeyTable<PartitionDraft> partition_table(int dimension) {
    const bool is_plane = dimension == 2;
    std::vector<Choice> choices = acting_choices(true);
    choices.insert(choices.begin(), {is_plane ? std::vector<std::string>{"x", "y"}
                                              : std::vector<std::string>{"x", "y", "z"},
                                     true});
    choices.push_back({{"passes", "temperature"}});
    choices.push_back({{"passes", "mass"}});
    choices.push_back({{"passes", "velocity"}});
    choices.push_back({{"passes", "diffuse"}});
    return {
        .name = "an item of `partitions`",
        .keys = joined<PartitionDraft>(
            std::vector<Binding<Partition>>{bind_key("name", &Partition::name,
                                                     text(1, most_name_letters),
                                                     "The name by which events refer to it.")
                                                .default_text("partition 1, partition 2, ...")},
            place_keys(dimension),
            std::vector<Binding<Partition>>{
                bind_key("gaps", &Partition::gaps,
                         list_of(gap_notation(dimension), 1, most_gaps,
                                 is_plane ? "a list of [from, to]" : "a list of [a0, b0, a1, b1]"),
                         is_plane ? "Holes, each given by its two ends along the partition."
                                  : "Rectangular holes, each given by its lower and its upper "
                                    "corner: coordinates in the order x, y, z without the "
                                    "partition's own axis. They do not overlap."),
                bind_key("open", &Partition::is_open, flag(),
                         "Whether it is open at the start: particles pass as if it were absent.")},
            std::vector<Binding<PartitionDraft>>{
                bind_key("passes", &PartitionDraft::passes, passes_notation(dimension),
                         "What it lets through: the species listed or, like Maxwell's demon, "
                         "particles of certain speeds to each side.")
                    .default_text("nothing")},
            acting_keys(), std::vector<Binding<ActingDraft>>{diffuse_key()}),
        .choices = std::move(choices),
        .refused = inelastic_keys(),
        .rule = complete_partition};
}

// ------------------------------------------------------------------------------------- obstacles

void complete_obstacle(ObstacleDraft& draft, const Node& node, int dimension, Reading& reading) {
    draft.node = &node;
    const bool is_plane = dimension == 2;
    const char* round = is_plane ? "disk" : "sphere";
    if (draft.center && find(node, "radius") == nullptr)
        reading.errors.add(node, fmt::format("a `{}` needs `radius`", round),
                           is_plane ? "for instance `{disk: [10, 10], radius: 2}`"
                                    : "for instance `{sphere: [10, 10, 10], radius: 2}`");
    const bool is_round = find(node, "disk") != nullptr || find(node, "sphere") != nullptr;
    if (!draft.center && draft.radius && !is_round)
        reading.errors.add(*given(node, "radius"),
                           fmt::format("`radius` applies only to a `{}`", round), "leave it out");
    if (draft.center && draft.radius) {
        draft.shape = Obstacle::Ball{*draft.center, *draft.radius};
    } else if (draft.block && is_plane) {
        const auto& [low, high] = *draft.block;
        draft.shape = Obstacle::Lines{{low, {high[0], low[1]}, high, {low[0], high[1]}}, true};
    } else if (draft.block) {
        draft.shape = Obstacle::Cuboid{draft.block->low, draft.block->high};
    } else if (!draft.polygon.empty()) {
        draft.shape = Obstacle::Lines{draft.polygon, true};
    } else if (!draft.segment.empty()) {
        draft.shape = Obstacle::Lines{draft.segment, false};
    } else {
        draft.is_known = false;
    }
}

// The shapes of a plane.
std::vector<Binding<ObstacleDraft>> flat_keys() {
    const auto point = vector_of(2, any_number, quantities::length);
    return {bind_key("disk", &ObstacleDraft::center, point, "The centre of a disk."),
            bind_key("radius", &ObstacleDraft::radius, number(positive, quantities::length),
                     "The radius of the disk."),
            bind_key("rectangle", &ObstacleDraft::block,
                     corners_of(2, "rectangle", "write the lower left corner first"),
                     "A block from x0 to x1 and from y0 to y1."),
            bind_key("polygon", &ObstacleDraft::polygon,
                     list_of(point, 3, most_corners, "a list of three or more [x, y]"),
                     "A block with these corners, listed in order around it."),
            bind_key("segment", &ObstacleDraft::segment,
                     list_of(point, 2, most_corners, "a list of two or more [x, y]"),
                     "A thin wall through these points, which reflects on both sides.")};
}

// The shapes of space.
std::vector<Binding<ObstacleDraft>> solid_keys() {
    return {bind_key("sphere", &ObstacleDraft::center, vector_of(3, any_number, quantities::length),
                     "The centre of a sphere.")
                .tried_as({"ball"}),
            bind_key("radius", &ObstacleDraft::radius, number(positive, quantities::length),
                     "The radius of the sphere."),
            bind_key("cuboid", &ObstacleDraft::block,
                     corners_of(3, "cuboid", "write the lower left corner at the back first"),
                     "A block from x0 to x1, from y0 to y1 and from z0 to z1.")
                .tried_as({"box", "block", "cube"})};
}

KeyTable<ObstacleDraft> obstacle_table(int dimension) {
    const bool is_plane = dimension == 2;
    std::vector<Refused> refused = inelastic_keys();
    if (is_plane) {
        const char* flat = "in a box with two lengths obstacles are flat";
        refused.push_back({"sphere", flat, "write `disk: [x, y]`, with its `radius`"});
        refused.push_back({"cuboid", flat, "write `rectangle: [x0, y0, x1, y1]`"});
    } else {
        const char* shapes = "in a box with three lengths obstacles are spheres and cuboids";
        refused.push_back({"disk", shapes, "write `sphere: [x, y, z]`, with its `radius`"});
        for (const char* name : {"rectangle", "polygon", "segment"})
            refused.push_back({name, shapes, "write `cuboid: [x0, y0, z0, x1, y1, z1]`"});
    }
    const std::vector<std::string> shapes =
        is_plane ? std::vector<std::string>{"disk", "rectangle", "polygon", "segment"}
                 : std::vector<std::string>{"sphere", "cuboid"};
    return {.name = "an item of `obstacles`",
            .keys = joined<ObstacleDraft>(
                std::vector<Binding<Obstacle>>{
                    bind_key("name", &Obstacle::name, text(1, most_name_letters), "Its name.")
                        .default_text("obstacle 1, obstacle 2, ...")},
                is_plane ? flat_keys() : solid_keys()),
            .choices = {{shapes, true}},
            .refused = std::move(refused),
            .rule = [dimension](ObstacleDraft& draft, const Node& node, Reading& reading) {
                complete_obstacle(draft, node, dimension, reading);
            }};
}

// ----------------------------------------------------------------------------------------- names

class Names {
  public:
    Names(std::vector<std::string> sides, Errors& errors)
        : sides_(std::move(sides)), taken_(sides_.begin(), sides_.end()), errors_(errors) {}

    // Returns the name that is written, or the default name for its kind; reports a name that is
    // already taken.
    std::string of(const std::string& written, const char* kind, std::size_t index,
                   const Node& item) {
        std::string name = written.empty() ? fmt::format("{} {}", kind, index + 1) : written;
        const Node* node = find(item, "name");
        if (!taken_.insert(name).second)
            errors_.add(node != nullptr ? *node : item,
                        fmt::format("the name {} is taken by {}", in_quotes(name),
                                    is_side(name) ? "a side of the box" : "another surface"),
                        is_side(name) ? fmt::format("{} are its sides", listed(sides_, "and"))
                                      : "give one of them another name");
        return name;
    }

  private:
    bool is_side(const std::string& name) const {
        return std::ranges::find(sides_, name) != sides_.end();
    }

    std::vector<std::string> sides_;
    std::set<std::string> taken_;
    Errors& errors_;
};

}  // namespace

Notation<std::vector<PartitionDraft>> partitions_notation(int dimension) {
    return list_of(mapping(partition_table(dimension)), 0, most_partitions, "a list of partitions");
}

Notation<std::vector<ObstacleDraft>> obstacles_notation(int dimension) {
    return list_of(mapping(obstacle_table(dimension)), 0, most_obstacles, "a list of obstacles");
}

std::optional<std::int32_t> species_named(const Node& name, const std::vector<std::string>& species,
                                          Errors& errors) {
    const auto found = std::ranges::find(species, name.text);
    if (found != species.end()) return static_cast<std::int32_t>(found - species.begin());
    errors.add(name, fmt::format("there is no species {}", in_quotes(name.text)),
               spelling_hint(name.text, species, "the species are " + listed(species, "and", "`")));
    return std::nullopt;
}

PlacedSurfaces surfaces_of(int dimension, const SidesDraft& sides, const SurfacesDraft& draft,
                           const std::vector<std::string>& species, Errors& errors) {
    PlacedSurfaces all;
    if (dimension == 3) all.surfaces.side_count = 6;
    all.surfaces.gravity = draft.gravity.value;
    for (std::size_t k = 0; k < all.surfaces.numbered_sides().size(); ++k) {
        all.surfaces.sides[k] = sides[k].behaviour;
        all.nodes.push_back(sides[k].node);
    }
    Names names(all.surfaces.names(), errors);
    for (std::size_t k = 0; k < draft.partitions.size(); ++k) {
        const PartitionDraft& one = draft.partitions[k];
        Partition partition = one;
        partition.name = names.of(one.name, "partition", k, *one.node);
        if (const auto* without_names = membrane_of(one.behaviour)) {
            Membrane membrane = *without_names;
            for (const Placed<std::string>& name : one.passes.species)
                if (const auto s = species_named(*name.node, species, errors))
                    membrane.species.push_back(*s);
            partition.behaviour = membrane;
        }
        if (!one.is_known) {
            all.others.push_back(partition.name);
            continue;
        }
        all.surfaces.partitions.push_back(std::move(partition));
        all.nodes.push_back(one.node);
    }
    for (std::size_t k = 0; k < draft.obstacles.size(); ++k) {
        const ObstacleDraft& one = draft.obstacles[k];
        Obstacle obstacle = one;
        obstacle.name = names.of(one.name, "obstacle", k, *one.node);
        if (!one.is_known) {
            all.others.push_back(obstacle.name);
            continue;
        }
        all.surfaces.obstacles.push_back(std::move(obstacle));
        all.nodes.push_back(one.node);
    }
    return all;
}

}  // namespace carom
