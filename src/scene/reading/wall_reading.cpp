#include "scene/reading/wall_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/limits.h"
#include "scene/reading/gas_reading.h"

namespace carom {
namespace {

/// The walls of a box by their sides.
struct SidesByName {
    SideDraft left, right, bottom, top, back, front;
};

std::string_view kind_of(const SideDraft& side) {
    return only_reflects(side.behaviour) ? word_of(side.wall) : "a wall";
}

void check_opposite(const Node& sides, const SideDraft& first, const SideDraft& second,
                    const char* names[2], Errors& errors) {
    if (first.wall != second.wall)
        errors.add(sides,
                   fmt::format("`{}` is {} but `{}` is {}", names[0], kind_of(first), names[1],
                               kind_of(second)),
                   "a periodic wall leads to the opposite one: make both periodic");
}

constexpr const char* diffuse_word = "diffuse";

// The words for a wall at rest, or for none at all.
Notation<SideDraft> plain_walls() {
    std::vector<Elsewhere> words;
    for (const char* word : {"reflecting", "reflective", "hard", "elastic", "closed", "wall"})
        words.push_back({word, "did you mean `solid`?"});
    for (const char* word : {"open", "none", "wrap", "pbc", "torus"})
        words.push_back({word,
                         "did you mean `periodic`? What leaves on one side enters on the "
                         "other"});
    for (const char* word : {"rough", "lambert", "cosine", "scattering", "diffusive"})
        words.push_back({word, "did you mean `diffuse`?"});
    std::vector<std::string> names;
    for (const EnumWord<Wall>& wall : enum_words<Wall>) names.emplace_back(wall.word);
    names.emplace_back(diffuse_word);
    return parsed(word(names).with_elsewhere(words),
                  [](const std::string& name, const Node& node, Reading&) {
                      SideDraft side{Wall::solid, Reflecting{}, &node};
                      if (name == diffuse_word) side.behaviour = Diffuse{};
                      for (const EnumWord<Wall>& wall : enum_words<Wall>)
                          if (name == wall.word) side.wall = wall.value;
                      return std::optional(side);
                  });
}

Notation<SideDraft> side_notation() {
    std::vector<Refused> refused = inelastic_keys();
    refused.push_back({diffuse_word, "`diffuse` is a word for the whole wall, not a key",
                       "for instance `left: diffuse`"});
    const KeyTable<ActingDraft> table{.name = "a wall that acts",
                                      .keys = acting_keys(),
                                      .choices = acting_choices(false),
                                      .refused = std::move(refused)};
    const auto acting =
        parsed(mapping(table, "{temperature: T}, {mass: m, force: F} or {velocity: u}"),
               [](const ActingDraft& draft, const Node& node, Reading& reading) {
                   std::optional<SideDraft> side;
                   const auto behaviour = behaviour_of(draft, node, reading.errors);
                   if (behaviour) side = SideDraft{Wall::solid, *behaviour, &node};
                   if (!behaviour || !only_reflects(*behaviour)) return side;
                   if (find(node, diffuse_word) == nullptr)
                       reading.errors.add(
                           node, "a wall that acts needs `temperature`, `mass` or `velocity`",
                           "a wall that only reflects is `solid`");
                   side.reset();
                   return side;
               });
    return either(plain_walls(), acting);
}

KeyTable<SidesByName> sides_table(int dimension) {
    const Notation<SideDraft> side = side_notation();
    KeyTable<SidesByName> table{
        .name = "`walls`",
        .keys = {bind_key("left", &SidesByName::left, side, "The wall at x = 0.")
                     .default_text("`solid`"),
                 bind_key("right", &SidesByName::right, side,
                          "The wall at the largest x; periodic if, and only if, the left one is.")
                     .default_text("`solid`")},
        .refused = inelastic_keys(),
        .rule = [](SidesByName& sides, const Node& node, Reading& reading) {
            const char* across[] = {"left", "right"};
            const char* up[] = {"bottom", "top"};
            const char* deep[] = {"back", "front"};
            check_opposite(node, sides.left, sides.right, across, reading.errors);
            check_opposite(node, sides.bottom, sides.top, up, reading.errors);
            check_opposite(node, sides.back, sides.front, deep, reading.errors);
        }};
    const std::vector further{
        bind_key("bottom", &SidesByName::bottom, side, "The wall at y = 0."),
        bind_key("top", &SidesByName::top, side,
                 "The wall at y = height; periodic if, and only if, the bottom one is."),
        bind_key("back", &SidesByName::back, side,
                 "The wall at z = 0, which is the farthest from the viewer."),
        bind_key("front", &SidesByName::front, side,
                 "The wall at z = depth; periodic if, and only if, the back one is.")};
    const std::size_t count = 2 * static_cast<std::size_t>(dimension - 1);
    for (std::size_t k = 0; k < count; ++k)
        table.keys.push_back(Binding(further[k]).default_text("`solid`"));
    if (dimension == 2)
        for (const char* name : {"back", "front"})
            table.refused.push_back({name, fmt::format("a plane has no `{}`", name),
                                     "its sides are `left`, `right`, `bottom` and `top`; with a "
                                     "third length in `size` a box has both"});
    if (dimension == 1)
        for (const char* name : {"bottom", "top"})
            table.refused.push_back(
                {name, fmt::format("a wire has no `{}`", name), "its ends are `left` and `right`"});
    return table;
}

Notation<Vec> shape_notation(int dimension) {
    const int axes = std::max(2, dimension);
    return mapped(
        list_of(number(positive), static_cast<std::size_t>(axes), {static_cast<double>(axes)},
                axes == 2 ? "[width, height]" : "[width, height, depth]"),
        [](const std::vector<double>& along) {
            return Vec(along.at(0), along.at(1), along.size() == 3 ? along[2] : 0.0);
        });
}

KeyTable<BoxDraft> box_table(int dimension) {
    const bool is_space = dimension == 3;
    const auto plane = vector_of(2, positive, quantities::length, "[width, height]")
                           .with_list_hint("a box has a width and a height, and in space a depth");
    return {
        .name = "`box`",
        .keys =
            {bind_key(
                 "size", &Box::size,
                 is_space ? vector_of(3, positive, quantities::length, "[width, height, depth]")
                          : plane,
                 is_space ? "Width, height and depth of the box; x goes to the right, y up, "
                            "and z toward the viewer, each from 0."
                          : "Width and height of the box; x goes from 0 to the width, y from 0 to "
                            "the height. With a third length, the depth, it is a box in space.")
                 .tried_as({"width", "height", "dimensions", "dims", "L"}),
             bind_key("shape", &Box::size, shape_notation(dimension),
                      "Instead of `size`, with `pressure`: the ratio of width to height, and in "
                      "space to depth.")
                 .tried_as({"aspect", "ratio", "proportions"}),
             bind_key("pressure", &BoxDraft::pressure,
                      number(positive, quantities::pressure(dimension)),
                      "With `shape`: the box has the size that gives the gas this pressure in "
                      "equilibrium, by its equation of state (docs/physics.md).")
                 .tried_as({"p", "P"}),
             bind_key("length", &Box::size, vector_of(1, positive, quantities::length),
                      "Instead of `size`: the length of a wire; x goes from 0 to the length."),
             bind_key(
                 "walls", &BoxDraft::sides, sides_notation(dimension),
                 "What is at the edges of the box: walls or periodic boundaries. A `diffuse` wall "
                 "reflects particles at their own speed in random directions, by the "
                 "cosine law.")
                 .tried_as({"boundary", "boundaries", "edges", "periodic"})},
        .choices = {{{"size", "shape", "length"}, true}},
        .refused = inelastic_keys(),
        .rule = [](BoxDraft& box, const Node& node, Reading& reading) {
            const Node *shape = given(node, "shape"), *pressure = given(node, "pressure");
            if (shape != nullptr && find(node, "pressure") == nullptr)
                reading.errors.add(*shape, "`shape` needs the `pressure` of the gas",
                                   "the size of the box follows from both; or give `size`");
            if (pressure == nullptr || shape != nullptr) return;
            // A size on the command line takes the place of both.
            if (find(node, "shape") != nullptr) return box.pressure.reset();
            reading.errors.add(*pressure, "`pressure` needs the `shape` of the box",
                               "the size of the box follows from both; give no other");
        }};
}

}  // namespace

std::vector<Binding<ActingDraft>> acting_keys() {
    return {
        bind_key("temperature", &ActingDraft::temperature,
                 number(positive, quantities::temperature),
                 "Makes it a heat bath: particles leave it as if they came from a gas of this "
                 "temperature."),
        bind_key("mass", &ActingDraft::mass, number(positive, quantities::mass),
                 "Makes it a piston of this mass, which moves freely along its normal."),
        bind_key("force", &ActingDraft::force, number(any_number, quantities::force),
                 "A constant force on a piston, along its normal.")
            .default_text("0"),
        bind_key("velocity", &ActingDraft::velocity, number(any_number, quantities::speed),
                 "Its velocity along its normal, which collisions do not change; for a piston, the "
                 "velocity at the start."),
        bind_key("until", &ActingDraft::until, number(positive, quantities::time),
                 "The simulated time at which a surface with a given velocity stops.")
            .default_text("never")};
}

Binding<ActingDraft> diffuse_key() {
    return bind_key(diffuse_word, &ActingDraft::is_diffuse, flag(),
                    "Makes it reflect diffusely, as a `diffuse` side of the box does.");
}

std::vector<Choice> acting_choices(bool with_diffuse) {
    std::vector<Choice> choices{{{"temperature", "mass"}}, {{"temperature", "velocity"}}};
    for (const char* key : {"temperature", "mass", "velocity"})
        if (with_diffuse) choices.push_back({{diffuse_word, key}});
    return choices;
}

std::optional<Behaviour> behaviour_of(const ActingDraft& draft, const Node& node, Errors& errors) {
    for (const char* key : {"temperature", "mass", "force", "velocity", "until"})
        if (find(node, key) != nullptr && given(node, key) == nullptr) return std::nullopt;
    if (draft.force && !draft.mass) {
        errors.add(*given(node, "force"), "`force` applies only to a piston",
                   "give its `mass` as well");
        return std::nullopt;
    }
    if (draft.until && (!draft.velocity || draft.mass)) {
        errors.add(*given(node, "until"),
                   draft.mass ? "`until` does not apply to a piston, which moves freely"
                              : "`until` needs a `velocity`",
                   draft.mass ? "an event `hold` stops it" : "for instance `velocity: -1`");
        return std::nullopt;
    }
    if (draft.is_diffuse) return Diffuse{};
    if (draft.temperature) return Bath{*draft.temperature};
    if (draft.mass)
        return Piston{*draft.mass, draft.force.value_or(0.0), draft.velocity.value_or(0.0)};
    Driven driven{draft.velocity.value_or(0.0)};
    if (draft.until) driven.until = *draft.until;
    return draft.velocity ? Behaviour(driven) : Behaviour(Reflecting{});
}

std::vector<std::string> side_names(int dimension) {
    return Surfaces{.side_count = 2 * dimension}.names();
}

Notation<SidesDraft> sides_notation(int dimension) {
    const auto all = [dimension](const SideDraft& side, const Node&, Reading&) {
        SidesDraft sides;
        for (std::size_t k = 0; k < 2 * static_cast<std::size_t>(dimension); ++k) sides[k] = side;
        return std::optional(sides);
    };
    const auto by_side = [](const SidesByName& sides) {
        return SidesDraft{sides.left, sides.right, sides.bottom,
                          sides.top,  sides.back,  sides.front};
    };
    Notation<SidesDraft> sides =
        either(parsed(plain_walls(), all), mapped(mapping(sides_table(dimension)), by_side));
    sides.write = [](const SidesDraft& alike) { return std::string(word_of(alike[0].wall)); };
    return sides;
}

Notation<BoxDraft> box_notation(int dimension) {
    return parsed(mapping(box_table(dimension)),
                  [dimension](BoxDraft box, const Node& node, Reading&) -> std::optional<BoxDraft> {
                      // Not known; or a length where a plane is asked for.
                      if (!on_each_axis(dimension, [&](int axis) { return box.size[axis] > 0.0; }))
                          return std::nullopt;
                      box.dimension = dimension;
                      const auto both = [&](std::size_t first) {
                          return box.sides[first].wall == box.sides[first + 1].wall
                                     ? box.sides[first].wall
                                     : Wall::solid;
                      };
                      for (std::size_t axis = 0; axis < box.walls.size(); ++axis)
                          box.walls[axis] = both(2 * axis);
                      box.node = &node;
                      return box;
                  });
}

}  // namespace carom
