#include "scene/feasibility/feasibility.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "physics/placement/draws.h"
#include "physics/placement/feasibility.h"
#include "physics/placement/members.h"
#include "scene/limits.h"
#include "scene/scene.h"

namespace carom {
namespace {

using Kind = Problem::Kind;

constexpr std::string_view region = "`within`";

// Returns the species with unknown values, and lists of a wrong length, replaced by harmless ones.
// Their errors are reported elsewhere; problems found without these values are real in any case.
Species known_part(const SpeciesDraft& draft) {
    Species species = draft;
    const FittingRules fits = fitting_rules(species);
    const bool radius_known = draft.radius_known && fits.radius;
    const bool needs_radius = std::holds_alternative<Density>(species.mass);
    if (!radius_known) species.radius = 0.0;
    if (!fits.mass || (needs_radius && !radius_known)) species.mass = ValueRule{1.0};
    if (!fits.velocity) species.velocity = AtRest{};
    if (!fits.position) species.position = RandomPlaces{};
    return species;
}

// Returns the node that gives the place of particle `i` of its species.
const Node& place_of_particle(const SpeciesDraft& draft, int dimension, std::size_t i) {
    const Node& position = at_key(draft, "position");
    const bool each = position.is_list() && (dimension == 1 || position.items.front().is_list());
    return each ? position.items.at(i) : position;
}

const Node& node_of(const Problem& problem, const Gas& gas,
                    const std::vector<SpeciesDraft>& drafts) {
    const SpeciesDraft& draft = drafts[problem.species];
    switch (problem.kind) {
        case Kind::too_many:
        case Kind::too_dense:
        case Kind::saturated:
            return at_key(draft, "count");
        case Kind::not_positive:
            return at_key(draft, problem.quantity);
        case Kind::no_mass:
            return at_key(draft, "density");
        case Kind::no_temperature:
            return at_key(draft, "temperature");
        case Kind::momentum:
            return at_key(draft, "speed");
        case Kind::too_large:
            return at_key(draft, "radius");
        case Kind::region_outside:
        case Kind::region_too_narrow:
        case Kind::region_too_dense:
        case Kind::no_lattice:
        case Kind::lattice_taken:
        case Kind::no_place:
        case Kind::no_stretch:
            return at_key(draft, "position");
        case Kind::outside:
        case Kind::overlap:
        case Kind::in_surface:
        case Kind::same_place:
        case Kind::jam:
        case Kind::jam_alone:
        case Kind::squeeze:
            break;
    }
    if (!std::holds_alternative<Places>(draft.position)) return at_key(draft, "radius");
    Eigen::Index index = problem.particle;
    if (problem.kind == Kind::squeeze) index = std::max(problem.particle, problem.other);
    for (std::size_t s = 0; s < problem.species; ++s)
        index -= static_cast<Eigen::Index>(gas.species[s].count);
    return place_of_particle(draft, gas.box.dimension, static_cast<std::size_t>(index));
}

const Node& key_or(const Node& item, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        if (const Node* node = given(item, key)) return *node;
    return item;
}

// Returns the node of the last event that sets a surface in motion before it reaches something;
// null if there is none.
const Node* last_move(const SurfaceProblem& problem, const SurfaceNodes& nodes) {
    const Node* last = nullptr;
    for (std::size_t k = 0; k < nodes.run.events.size(); ++k) {
        const RunEvent& event = nodes.run.events[k];
        const auto given = given_behaviour(event);
        if (event.at < problem.value && given && given->first == problem.surface)
            last = nodes.events[k];
    }
    return last;
}

// Returns the node within the surface or the event that has the problem.
const Node& node_of(const SurfaceProblem& problem, const SurfaceNodes& nodes) {
    using Its = SurfaceProblem::Kind;
    if (problem.event) return *nodes.events.at(*problem.event);
    if (problem.kind == Its::reaches || problem.kind == Its::leaves_no_room)
        if (const Node* moved = last_move(problem, nodes)) return *moved;
    const Node& item = *nodes.surfaces.at(static_cast<std::size_t>(problem.surface));
    switch (problem.kind) {
        case Its::gap_outside:
        case Its::gaps_unordered:
        case Its::gap_empty:
        case Its::gaps_overlap:
            return given(item, "gaps")->items.at(problem.item);
        case Its::partition_outside:
            return key_or(item, {"x", "y", "z"});
        case Its::along_periodic:
        case Its::piston_gaps:
            return key_or(item, {"mass", "velocity"});
        case Its::same_corner:
            return key_or(item, {"polygon", "segment"}).items.at(problem.item);
        case Its::obstacle_outside:
        case Its::obstacle_too_wide:
        case Its::cuboid_empty:
            return key_or(item, {"disk", "rectangle", "polygon", "segment", "sphere", "cuboid"});
        default:
            return item;
    }
}

}  // namespace

void check_surfaces(const Gas& gas, const SurfaceNodes& nodes, Errors& errors) {
    const bool is_plain = gas.box.surfaces.are_plain() && nodes.run.events.empty();
    const bool is_known = gas.box.dimension > 1 && !gas.species.empty() && errors.empty();
    const double taken =
        is_known && !is_plain ? sum_of_sizes(gas.box, draw_gas(gas).first.radius) : 0.0;
    for (const SurfaceProblem& problem : surface_problems(gas.box, nodes.run, taken)) {
        const auto [message, hint] = to_text(problem, gas.box);
        errors.add(node_of(problem, nodes), message, hint);
    }
}

void check_feasibility(const Box& box, const std::vector<SpeciesDraft>& drafts, std::uint64_t seed,
                       const Run& run, Errors& errors) {
    Gas gas{box, {}, seed};
    double count = 0.0;
    for (const SpeciesDraft& draft : drafts) {
        gas.species.push_back(known_part(draft));
        count += static_cast<double>(draft.count);
    }
    if (count > most_particles.value) return;
    std::set<const Node*> words;
    const auto problems = problems_of(gas, errors.empty() ? &run : nullptr,
                                      static_cast<std::int64_t>(most_pairs_compared.value));
    for (const Problem& problem : problems) {
        const Node& node = node_of(problem, gas, drafts);
        const bool beside = drafts[problem.species].side != nullptr;
        auto [message, hint] = to_text(problem, gas, beside ? "the side" : region);
        // The letters of a word are moved as a whole.
        if (problem.kind == Kind::overlap && node.is_mapping()) {
            if (!words.insert(&node).second) continue;
            hint = "choose another `within` to move the word";
        }
        errors.add(node, message, hint);
    }
}

SceneError scene_error(const Scene& scene, const PlacementError& error) {
    const auto [message, hint] = to_text(error.problem(), scene.gas, region);
    Diagnostic diagnostic = scene.species_spans.at(error.species());
    diagnostic.message = message;
    diagnostic.hint = hint;
    return SceneError({diagnostic});
}

}  // namespace carom
