#include "panels/surfaces/surface_words.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "scene/describe.h"
#include "util/text.h"

namespace carom {
namespace {

// The speeds that are let through one way: "v > 1.2"; empty for none.
std::string speeds_mark(const Membrane::Speeds& speeds) {
    if (!speeds.admits_some()) return "";
    const bool from = speeds.faster_than > 0.0, to = std::isfinite(speeds.slower_than);
    if (from && to)
        return fmt::format("{} < v < {}", plain_number(speeds.faster_than),
                           plain_number(speeds.slower_than));
    if (from) return "v > " + plain_number(speeds.faster_than);
    return to ? "v < " + plain_number(speeds.slower_than) : "all";
}

std::vector<std::string> names_of_passing(const Gas& gas, const Membrane& membrane) {
    std::vector<std::string> names;
    for (const std::int32_t k : membrane.species)
        names.push_back(gas.species[static_cast<std::size_t>(k)].name);
    return names;
}

std::string membrane_mark(const Gas& gas, const Membrane& membrane, int axis) {
    std::vector<std::string> marks;
    if (!membrane.species.empty())
        marks.push_back("passes " + listed(names_of_passing(gas, membrane)));
    const std::string up = speeds_mark(membrane.upward), down = speeds_mark(membrane.downward);
    if (!up.empty()) marks.push_back((axis == 0 ? "→ " : "↑ ") + up);
    if (!down.empty()) marks.push_back((axis == 0 ? "← " : "↓ ") + down);
    if (marks.empty()) return "passes none";
    std::string text = marks[0];
    for (std::size_t k = 1; k < marks.size(); ++k) text += ", " + marks[k];
    return text;
}

std::string doing_of(const Gas& gas, const SurfaceState& state, int axis) {
    if (state.is_open) return "is open";
    const bool reflects = std::holds_alternative<Reflecting>(state.behaviour);
    if (!reflects && !std::holds_alternative<Driven>(state.behaviour))
        return words_of(state.behaviour, gas, axis) + (state.is_held ? ", held" : "");
    const bool moves = state.motion && state.motion->velocity != 0.0;
    return moves ? "moves at " + three_digits(state.motion->velocity) : "stands";
}

}  // namespace

double place_of_surface(const Box& box, std::span<const SurfaceState> states, std::size_t k) {
    if (k < states.size() && states[k].motion) return states[k].motion->place;
    return box.place_of(k);
}

std::string mark_of_surface(const Gas& gas, const Behaviour& behaviour, int axis) {
    if (const auto* bath = std::get_if<Bath>(&behaviour))
        return "T = " + plain_number(bath->temperature);
    if (const auto* membrane = std::get_if<Membrane>(&behaviour))
        return membrane_mark(gas, *membrane, axis);
    const auto* piston = std::get_if<Piston>(&behaviour);
    if (piston == nullptr) return "";
    return "M = " + plain_number(piston->mass) +
           (piston->force == 0.0 ? "" : ", F = " + plain_number(piston->force));
}

std::string surface_label(const Gas& gas, const SurfaceState& state, std::size_t k) {
    const std::string mark = mark_of_surface(gas, state.behaviour, gas.box.surfaces.axis_of(k));
    return gas.box.surfaces.names()[k] + (state.is_open ? ", open" : "") +
           (state.is_held ? ", held" : "") + (mark.empty() ? "" : ", " + mark);
}

std::string words_at_present(const Gas& gas, std::span<const SurfaceState> states,
                             bool only_changes) {
    const Surfaces& surfaces = gas.box.surfaces;
    std::string text;
    const std::size_t count = states.empty() ? 0 : surfaces.first_obstacle();
    for (std::size_t k = 0; k < count; ++k) {
        const SurfaceState& state = states[k];
        const bool is_wall =
            Surfaces::is_side(k) && std::holds_alternative<Reflecting>(state.behaviour);
        if (!state.motion && (is_wall || (only_changes && !state.is_open))) continue;
        const int axis = gas.box.surfaces.axis_of(k);
        const bool has_place = !state.is_open && (!Surfaces::is_side(k) || state.motion);
        const std::string place =
            has_place ? fmt::format(" at {} = {}", axis == 0 ? "x" : "y",
                                    three_digits(place_of_surface(gas.box, states, k)))
                      : "";
        const std::string doing = doing_of(gas, state, axis);
        text += fmt::format("{} {}{}{}. ", name_of_surface(static_cast<std::int32_t>(k), gas),
                            doing, place.empty() || doing == "stands" ? "" : ",", place);
    }
    if (!text.empty()) text.pop_back();
    return text;
}

}  // namespace carom
