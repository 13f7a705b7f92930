#include "panels/collision/collision_map_keys.h"

#include <fmt/format.h>

#include <limits>

#include "physics/box.h"

namespace carom {
namespace {

GivenPair& given_pair(CollisionMapOptions& options) {
    return options.given ? *options.given : options.given.emplace();
}

// Two velocities describe the motion completely on a wire only.
void check_wire(const Node& kind, Reading& reading) {
    if (reading.box().dimension == 2)
        reading.errors.add(kind,
                           "`collision-map` shows beads on a wire, and this gas is in a plane",
                           "disks have two components of velocity each: use `single-collision`, "
                           "or give the box a `length` instead of a `size`");
}

// Reports a pair that is given twice, or of which only half is given.
void check_given(const Node& node, Errors& errors) {
    const bool both = find(node, "masses") != nullptr && find(node, "velocities") != nullptr;
    for (const char* key : {"masses", "velocities"})
        if (const Node* alone = given(node, key); alone != nullptr && !both)
            errors.add(*alone, "`masses` and `velocities` of a pair must be given together",
                       "for instance {kind: collision-map, masses: [1, 3], velocities: [1, 0]}; "
                       "without them it shows a pair of the scene");
    for (const char* of_the_run : {"of", "walk"})
        if (const Node* other = given(node, of_the_run); other != nullptr && both)
            errors.add(*other,
                       fmt::format("`{}` names beads of the scene, but `masses` describes others",
                                   of_the_run),
                       "leave out one of them");
}

}  // namespace

std::vector<Binding<CollisionMapOptions>> collision_map_keys() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto mass =
        either(number(positive, quantities::mass), one_of<double>({{"infinite", infinity}}));
    const auto fill_masses = [](CollisionMapOptions& options, const std::vector<double>& masses) {
        given_pair(options).inverse_mass = {1.0 / masses.at(0), 1.0 / masses.at(1)};
    };
    const auto fill_velocities = [](CollisionMapOptions& options, const TwoNumbers& velocity) {
        given_pair(options).velocity = {velocity[0], velocity[1]};
    };
    return {
        bind_with<CollisionMapOptions>("masses", fill_masses, list_of(mass, 2, {2}, "[mass, mass]"),
                                       "The masses of a pair that need not be in the scene, with "
                                       "`velocities`; one mass may be `infinite`.")
            .default_text("those of the pair in the scene"),
        bind_with<CollisionMapOptions>(
            "velocities", fill_velocities,
            pair_of(number(any_number, quantities::speed), "[velocity, velocity]"),
            "The velocities before the collision of the given `masses`.")
            .default_text("those of the pair in the scene"),
        bind_key("walk", &CollisionMapOptions::walk, flag(),
                 "All collisions of the pair so far, with each other and with walls, as a walk "
                 "on the ellipse of their energy; otherwise only the first collision."),
        bind_key("scaled", &CollisionMapOptions::scaled, flag(),
                 "Multiplies each velocity by the square root of the mass: the ellipse becomes "
                 "a circle, a collision a reflection.")
            .default_text("the value of `walk`")};
}

void check_collision_map(PanelSpec& panel, const Node& node, Reading& reading) {
    check_wire(node.is_mapping() ? *given(node, "kind") : node, reading);
    check_given(node, reading.errors);
    const Node *masses = given(node, "masses"), *velocities = given(node, "velocities");
    auto& given_pair = panel.options.change<CollisionMapOptions>().given;
    if (masses == nullptr || velocities == nullptr) return given_pair.reset();
    if (!(given_pair->inverse_mass.sum() > 0.0))
        reading.errors.add(*masses, "two infinite masses do not collide",
                           "give at least one finite mass");
    if (given_pair->velocity[0] == given_pair->velocity[1])
        reading.errors.add(*velocities, "two beads of equal velocities never collide",
                           "the left bead must be the faster one");
}

}  // namespace carom
