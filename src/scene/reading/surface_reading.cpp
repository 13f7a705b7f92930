#include "scene/reading/surface_reading.h"

#include <fmt/format.h>

#include <algorithm>
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
        .keys = {bind_key("faster_than", &SpeedsDraft::faster_than, number(not_negative),
                          "Particles faster than this pass."),
                 bind_key("slower_than", &SpeedsDraft::slower_than, number(positive),
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
    std::optional<Membrane::Speeds> to_right, to_left, to_top, to_bottom;
};

Notation<PassesDraft> passes_notation() {
    const Notation<Membrane::Speeds> speeds = speeds_notation();
    const KeyTable<DemonDraft> table{
        .name = "`passes`",
        .keys = {bind_key("to_right", &DemonDraft::to_right, speeds,
                          "The speeds that it lets through to the right."),
                 bind_key("to_left", &DemonDraft::to_left, speeds,
                          "The speeds that it lets through to the left."),
                 bind_key("to_top", &DemonDraft::to_top, speeds,
                          "The speeds that it lets through upwards, if it lies at a `y`."),
                 bind_key("to_bottom", &DemonDraft::to_bottom, speeds,
                          "The speeds that it lets through downwards, if it lies at a `y`.")}};
    const auto demon = parsed(
        mapping(table, "{to_right: {faster_than: u}, to_left: {slower_than: u}}"),
        [](const DemonDraft& draft, const Node& node, Reading& reading) {
            if (node.keys.empty())
                reading.errors.add(node, "`passes` needs a direction",
                                   "give `to_right` or `to_left`, at a `y` `to_top` or "
                                   "`to_bottom`; or a list of the species that pass");
            const auto either_of = [](const auto& one, const auto& other) {
                return one ? *one : other.value_or(Membrane::Speeds{});
            };
            return std::optional(PassesDraft{.upward = either_of(draft.to_right, draft.to_top),
                                             .downward = either_of(draft.to_left, draft.to_bottom),
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
    for (const Node& key : passes->keys) {
        const bool upright = key.text == "to_top" || key.text == "to_bottom";
        if (upright == draft.y.has_value()) continue;
        errors.add(key,
                   fmt::format("`{}` is not a direction through a partition at {}", key.text,
                               draft.x ? "an `x`" : "a `y`"),
                   draft.x ? "particles pass it `to_right` and `to_left`"
                           : "particles pass it `to_top` and `to_bottom`");
    }
}

void complete_partition(PartitionDraft& draft, const Node& node, Reading& reading) {
    draft.node = &node;
    draft.axis = draft.x ? 0 : 1;
    draft.at = draft.x ? *draft.x : draft.y.value_or(0.0);
    check_directions(draft, reading.errors);
    const auto behaviour = behaviour_of(draft, node, reading.errors);
    if (behaviour) draft.behaviour = *behaviour;
    if (draft.passes.node != nullptr)
        draft.behaviour = Membrane{{}, draft.passes.upward, draft.passes.downward};
    draft.is_known = behaviour && (draft.x || draft.y) &&
                     (given(node, "gaps") != nullptr) == (find(node, "gaps") != nullptr);
}

KeyTable<PartitionDraft> partition_table() {
    const auto gap = mapped(pair_of(any_number, "[from, to]"),
                            [](const TwoNumbers& ends) { return Gap(ends[0], ends[1]); });
    std::vector<Choice> choices = acting_choices(true);
    choices.insert(choices.begin(), {{"x", "y"}, true});
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
            std::vector<Binding<PartitionDraft>>{
                bind_key("x", &PartitionDraft::x, number(any_number),
                         "The x coordinate of a partition that goes from bottom to top."),
                bind_key("y", &PartitionDraft::y, number(any_number),
                         "The y coordinate of a partition that goes from left to right.")},
            std::vector<Binding<Partition>>{
                bind_key("gaps", &Partition::gaps,
                         list_of(gap, 1, most_gaps, "a list of [from, to]"),
                         "Holes, each given by its two ends along the partition."),
                bind_key("open", &Partition::is_open, flag(),
                         "Whether it is open at the start: particles pass as if it were absent.")},
            std::vector<Binding<PartitionDraft>>{
                bind_key("passes", &PartitionDraft::passes, passes_notation(),
                         "What it lets through: the species listed or, like Maxwell's demon, "
                         "particles of certain speeds to each side.")
                    .default_text("nothing")},
            acting_keys(), std::vector<Binding<ActingDraft>>{diffuse_key()}),
        .choices = std::move(choices),
        .refused = inelastic_keys(),
        .rule = complete_partition};
}

// ------------------------------------------------------------------------------------- obstacles

void complete_obstacle(ObstacleDraft& draft, const Node& node, Reading& reading) {
    draft.node = &node;
    if (draft.disk && find(node, "radius") == nullptr)
        reading.errors.add(node, "a `disk` needs `radius`",
                           "for instance `{disk: [10, 10], radius: 2}`");
    if (!draft.disk && draft.radius && find(node, "disk") == nullptr)
        reading.errors.add(*given(node, "radius"), "`radius` applies only to a `disk`",
                           "leave it out");
    if (draft.disk && draft.radius) {
        draft.shape = Obstacle::Ball{*draft.disk, *draft.radius};
    } else if (draft.rectangle) {
        const auto [x0, y0, x1, y1] = *draft.rectangle;
        draft.shape = Obstacle::Lines{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, true};
    } else if (!draft.polygon.empty()) {
        draft.shape = Obstacle::Lines{draft.polygon, true};
    } else if (!draft.segment.empty()) {
        draft.shape = Obstacle::Lines{draft.segment, false};
    } else {
        draft.is_known = false;
    }
}

KeyTable<ObstacleDraft> obstacle_table() {
    const auto point = plane_vector(any_number);
    const auto rectangle =
        parsed(list_of(number(any_number), 4, {4}, "[x0, y0, x1, y1]"),
               [](const std::vector<double>& ends, const Node& node,
                  Reading& reading) -> std::optional<std::array<double, 4>> {
                   if (ends[0] < ends[2] && ends[1] < ends[3])
                       return std::array{ends[0], ends[1], ends[2], ends[3]};
                   reading.errors.add(
                       node, "expected [x0, y0, x1, y1] with x0 < x1 and y0 < y1 for `rectangle`",
                       "write the lower left corner first");
                   return std::nullopt;
               });
    return {.name = "an item of `obstacles`",
            .keys = joined<ObstacleDraft>(
                std::vector<Binding<Obstacle>>{
                    bind_key("name", &Obstacle::name, text(1, most_name_letters), "Its name.")
                        .default_text("obstacle 1, obstacle 2, ...")},
                std::vector<Binding<ObstacleDraft>>{
                    bind_key("disk", &ObstacleDraft::disk, point, "The centre of a disk."),
                    bind_key("radius", &ObstacleDraft::radius, number(positive),
                             "The radius of the disk."),
                    bind_key("rectangle", &ObstacleDraft::rectangle, rectangle,
                             "A block from x0 to x1 and from y0 to y1."),
                    bind_key("polygon", &ObstacleDraft::polygon,
                             list_of(point, 3, most_corners, "a list of three or more [x, y]"),
                             "A block with these corners, listed in order around it."),
                    bind_key("segment", &ObstacleDraft::segment,
                             list_of(point, 2, most_corners, "a list of two or more [x, y]"),
                             "A thin wall through these points, which reflects on both sides.")}),
            .choices = {{{"disk", "rectangle", "polygon", "segment"}, true}},
            .refused = inelastic_keys(),
            .rule = complete_obstacle};
}

// ----------------------------------------------------------------------------------------- names

class Names {
  public:
    explicit Names(Errors& errors) : errors_(errors) {}

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
                        is_side(name) ? "left, right, bottom and top are its sides"
                                      : "give one of them another name");
        return name;
    }

  private:
    bool is_side(const std::string& name) const {
        return std::ranges::find(sides_, name) != sides_.end();
    }

    std::vector<std::string> sides_ = Surfaces{}.names();
    std::set<std::string> taken_{sides_.begin(), sides_.end()};
    Errors& errors_;
};

}  // namespace

Notation<std::vector<PartitionDraft>> partitions_notation() {
    return list_of(mapping(partition_table()), 0, most_partitions, "a list of partitions");
}

Notation<std::vector<ObstacleDraft>> obstacles_notation() {
    return list_of(mapping(obstacle_table()), 0, most_obstacles, "a list of obstacles");
}

Notation<Vec> gravity_notation(int dimension) {
    if (dimension == 2) return plane_vector(any_number);
    return mapped(number(any_number), [](double g) { return Vec(g, 0.0); });
}

std::optional<std::int32_t> species_named(const Node& name, const std::vector<std::string>& species,
                                          Errors& errors) {
    const auto found = std::ranges::find(species, name.text);
    if (found != species.end()) return static_cast<std::int32_t>(found - species.begin());
    errors.add(name, fmt::format("there is no species {}", in_quotes(name.text)),
               spelling_hint(name.text, species, "the species are " + listed(species, "and", "`")));
    return std::nullopt;
}

PlacedSurfaces surfaces_of(const SidesDraft& sides, const SurfacesDraft& draft,
                           const std::vector<std::string>& species, Errors& errors) {
    PlacedSurfaces all;
    all.surfaces.gravity = draft.gravity.value;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        all.surfaces.sides[k] = sides[k].behaviour;
        all.nodes.push_back(sides[k].node);
    }
    Names names(errors);
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
