#include "panels/surfaces/surface_words.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "physics/gas.h"
#include "physics/vec.h"
#include "scene/describe.h"
#include "util/overloaded.h"
#include "util/text.h"

namespace carom {
namespace {

// The speeds that are let through one way: "v > 1.2"; empty for none.
std::string label_of_speeds(Language language, const Membrane::Speeds& speeds) {
    if (!speeds.admits_some()) return "";
    const bool from = speeds.faster_than > 0.0, to = std::isfinite(speeds.slower_than);
    if (from && to)
        return fmt::format("{} < v < {}", plain_number(language, speeds.faster_than),
                           plain_number(language, speeds.slower_than));
    if (from) return "v > " + plain_number(language, speeds.faster_than);
    return to ? "v < " + plain_number(language, speeds.slower_than) : say(language, "all");
}

std::string with_held(Language language, const SurfaceState& state, const std::string& words) {
    return state.is_held ? say(language, "{}, {}", words, say(language, "held")) : words;
}

bool is_moving(const SurfaceState& state) { return state.motion && state.motion->velocity != 0.0; }

std::vector<std::string> names_of_passing(const Gas& gas, const Membrane& membrane) {
    std::vector<std::string> names;
    for (const std::int32_t k : membrane.species)
        names.push_back(gas.species[static_cast<std::size_t>(k)].name);
    return names;
}

std::string label_of_membrane(Language language, const Gas& gas, const Membrane& membrane,
                              int axis) {
    std::vector<std::string> labels;
    if (!membrane.species.empty())
        labels.push_back(
            say(language, "lets {} through", listed(language, names_of_passing(gas, membrane))));
    const std::string up = label_of_speeds(language, membrane.upward),
                      down = label_of_speeds(language, membrane.downward);
    constexpr std::array<const char*, 3> ways_up{"→ ", "↑ ", "↙ "}, ways_down{"← ", "↓ ", "↗ "};
    const auto its = static_cast<std::size_t>(axis);
    if (!up.empty()) labels.push_back(ways_up.at(its) + up);
    if (!down.empty()) labels.push_back(ways_down.at(its) + down);
    if (labels.empty()) return say(language, "lets none through");
    std::string text = labels[0];
    for (std::size_t k = 1; k < labels.size(); ++k) text += ", " + labels[k];
    return text;
}

std::string doing_of(Language language, const Gas& gas, const SurfaceState& state, int axis) {
    if (state.is_open) return say(language, "is open");
    const auto of_motion = [&] {
        return is_moving(state) ? say(language, "moves at velocity {}",
                                      three_digits(language, state.motion->velocity))
                                : say(language, "stands still");
    };
    const auto of_behaviour = [&] {
        return with_held(language, state, words_of({language}, state.behaviour, gas, axis));
    };
    return std::visit(Overloaded{[&](const Reflecting&) { return of_motion(); },
                                 [&](const Bath&) { return of_behaviour(); },
                                 [&](const Driven&) { return of_motion(); },
                                 [&](const Piston&) { return of_behaviour(); },
                                 [&](const Membrane&) { return of_behaviour(); },
                                 [&](const Diffuse&) { return of_behaviour(); }},
                      state.behaviour);
}

}  // namespace

double place_of_surface(const Box& box, std::span<const SurfaceState> states, std::size_t k) {
    if (k < states.size() && states[k].motion) return states[k].motion->place;
    return box.place_of(k);
}

std::string short_name_of_surface(Language language, const Box& box, std::size_t k) {
    constexpr std::array sides{Phrase{"left"},  Phrase{"right"}, Phrase{"below"},
                               Phrase{"above"}, Phrase{"back"},  Phrase{"front"}};
    return box.surfaces.is_side(k) ? say(language, sides.at(k)) : box.surfaces.names().at(k);
}

std::string label_of_surface(Language language, const Gas& gas, const Behaviour& behaviour,
                             int axis) {
    return std::visit(
        Overloaded{
            [](const Reflecting&) { return std::string(); },
            [&](const Bath& its) { return "T = " + plain_number(language, its.temperature); },
            [](const Driven&) { return std::string(); },
            [&](const Piston& its) {
                return "M = " + plain_number(language, its.mass) +
                       (its.force == 0.0 ? "" : ", F = " + plain_number(language, its.force));
            },
            [&](const Membrane& its) { return label_of_membrane(language, gas, its, axis); },
            [](const Diffuse&) { return std::string(); }},
        behaviour);
}

std::string table_entry_of_surface(const Gas& gas, const SurfaceState& state, std::size_t k) {
    const std::string label =
        label_of_surface(Language::english, gas, state.behaviour, gas.box.surfaces.axis_of(k));
    return gas.box.surfaces.names()[k] + (state.is_open ? ", open" : "") +
           (state.is_held ? ", held" : "") + (label.empty() ? "" : ", " + label);
}

std::string words_at_present(Language language, const Gas& gas,
                             std::span<const SurfaceState> states, bool only_changes) {
    const Surfaces& surfaces = gas.box.surfaces;
    std::string text;
    const std::size_t count = states.empty() ? 0 : surfaces.first_obstacle();
    for (std::size_t k = 0; k < count; ++k) {
        const SurfaceState& state = states[k];
        const bool is_wall = surfaces.is_side(k) && only_reflects(state.behaviour);
        if (!state.motion && (is_wall || (only_changes && !state.is_open))) continue;
        const int axis = gas.box.surfaces.axis_of(k);
        const bool has_place = !state.is_open && (!surfaces.is_side(k) || state.motion);
        const std::string doing =
            say(language, "{} {}", name_of_surface(language, static_cast<std::int32_t>(k), gas),
                doing_of(language, gas, state, axis));
        const std::string place = three_digits(language, place_of_surface(gas.box, states, k));
        const std::string where =
            has_place ? say(language, "{}, at {} = {}", doing, name_of_axis(axis), place) : doing;
        text += where + ". ";
    }
    if (!text.empty()) text.pop_back();
    return text;
}

}  // namespace carom
