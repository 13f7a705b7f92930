#include "scene/mixing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace carom {
namespace {

bool is_fixed(const Species& species) { return std::holds_alternative<Infinite>(species.mass); }

bool is_joined(const Box& box, int axis) {
    return box.walls[static_cast<std::size_t>(axis)] == Wall::periodic;
}

/// The value of each particle; nothing if it is drawn by a law.
std::optional<std::vector<double>> values_of(const Quantity& quantity, std::int64_t count) {
    if (const auto* one = std::get_if<double>(&quantity))
        return std::vector<double>(static_cast<std::size_t>(count), *one);
    if (const auto* list = std::get_if<std::vector<double>>(&quantity)) return *list;
    return std::nullopt;
}

std::optional<std::vector<double>> masses_of(const Species& species, int dimension) {
    if (const auto* quantity = std::get_if<Quantity>(&species.mass))
        return values_of(*quantity, species.count);
    const auto* density = std::get_if<Density>(&species.mass);
    if (density == nullptr) return std::nullopt;
    auto masses = values_of(density->value, species.count);
    const auto radii = values_of(species.radius, species.count);
    if (!masses || !radii || masses->size() != radii->size()) return std::nullopt;
    for (std::size_t i = 0; i < masses->size(); ++i) {
        const double r = (*radii)[i];
        (*masses)[i] *= dimension == 1 ? 2.0 * r : std::numbers::pi * r * r;
    }
    return masses;
}

bool are_all_zero(const Quantity& quantity) {
    const auto values = values_of(quantity, 1);
    return values && std::ranges::all_of(*values, [](double value) { return value == 0.0; });
}

bool moves(const Species& species) {
    if (const auto* speed = std::get_if<Speed>(&species.velocity))
        return !are_all_zero(speed->value);
    if (const auto* temperature = std::get_if<Temperature>(&species.velocity))
        return temperature->value > 0.0 && !is_fixed(species);
    const auto* velocity = std::get_if<Velocity>(&species.velocity);
    return velocity != nullptr &&
           std::ranges::any_of(velocity->values,
                               [](const Eigen::Array2d& v) { return (v != 0.0).any(); });
}

// Drawn velocities have no momentum where it would stay; given ones have what they have. Nothing
// where masses are drawn.
std::optional<Eigen::Array2d> momentum_of(const Gas& gas) {
    Eigen::Array2d sum{0.0, 0.0};
    for (const Species& species : gas.species) {
        const auto* velocity = std::get_if<Velocity>(&species.velocity);
        if (velocity == nullptr) continue;
        const auto masses = masses_of(species, gas.box.dimension);
        if (!masses) return std::nullopt;
        const bool one = velocity->values.size() == 1;
        if (!one && velocity->values.size() != masses->size()) return std::nullopt;
        for (std::size_t i = 0; i < masses->size(); ++i)
            sum += (*masses)[i] * velocity->values[one ? 0 : i];
    }
    return sum;
}

// A part of the largest sum of masses times speeds that round-off may leave.
bool drifts(const Gas& gas) {
    constexpr double rounding = 1e-9;
    double size = 0.0;
    for (const Species& species : gas.species) {
        const auto* velocity = std::get_if<Velocity>(&species.velocity);
        const auto masses = masses_of(species, gas.box.dimension);
        if (velocity == nullptr || !masses || velocity->values.empty()) continue;
        for (std::size_t i = 0; i < masses->size(); ++i)
            size += (*masses)[i] * velocity->values[i % velocity->values.size()].abs().sum();
    }
    const auto momentum = momentum_of(gas);
    return momentum && momentum->abs().maxCoeff() > rounding * size;
}

bool masses_are_equal(const Gas& gas) {
    std::optional<double> first;
    for (const Species& species : gas.species) {
        if (is_fixed(species)) continue;
        const auto masses = masses_of(species, gas.box.dimension);
        if (!masses) return false;
        for (const double mass : *masses) {
            if (!first) first = mass;
            if (mass != *first) return false;
        }
    }
    return first.has_value();
}

// Whether beads that never move part those that do; places that are drawn are not looked at.
bool are_parted(const Gas& gas) {
    std::vector<std::pair<double, bool>> beads;  // place, whether it moves
    for (const Species& species : gas.species) {
        const auto* places = std::get_if<Places>(&species.position);
        if (places == nullptr) return false;
        for (const Eigen::Array2d& place : places->values)
            beads.emplace_back(place[0], !is_fixed(species));
    }
    std::ranges::stable_sort(beads, {}, &std::pair<double, bool>::first);
    if (beads.empty()) return false;
    const bool goes_round = is_joined(gas.box, 0) && beads.back().second;
    int stretches = beads.front().second && !goes_round ? 1 : 0;
    for (std::size_t k = 1; k < beads.size(); ++k)
        stretches += beads[k].second && !beads[k - 1].second;
    return stretches > 1;
}

std::string called(const Species& species) {
    return species.name.empty() ? "a particle of infinite mass"
                                : fmt::format("`{}` has infinite mass and", species.name);
}

std::optional<std::string> why_no_mixing_on_wire(const Gas& gas, std::int64_t finite,
                                                 bool momentum) {
    if (masses_are_equal(gas))
        return "on a wire particles of equal mass only exchange their velocities";
    if (finite < (momentum ? 4 : 3))
        return momentum ? "on a ring fewer than four beads need not come near all their states"
                        : "between walls fewer than three beads need not come near all their "
                          "states";
    if (are_parted(gas)) return "beads that never move part those that do";
    return std::nullopt;
}

}  // namespace

std::optional<std::string> why_no_equilibrium(const Gas& gas) {
    std::int64_t finite = 0, all = 0;
    bool any_moves = false;
    for (const Species& species : gas.species) {
        all += species.count;
        if (is_fixed(species) && moves(species))
            return called(species) + " moves, so that energy is not conserved";
        if (is_fixed(species)) continue;
        finite += species.count;
        any_moves = any_moves || moves(species);
    }
    const bool free = finite == all;
    const bool along_x = is_joined(gas.box, 0), along_y = is_joined(gas.box, 1);
    if (gas.box.dimension == 2 && free && along_x != along_y)
        return fmt::format(
            "the box is periodic along {} only, so that momentum is conserved along "
            "one axis and not along the other",
            along_x ? "x" : "y");
    if (finite == 0) return "no particle has a finite mass";
    const bool momentum = free && along_x;
    if (finite == 1) return "a single particle has nothing to share its energy with";
    if (momentum && finite == 2)
        return "in a periodic box two particles keep the energy that they have between them";
    if (!any_moves) return "all particles are at rest";
    if (momentum && drifts(gas))
        return "it moves as a whole; the momentum of the given velocities is not zero";
    if (gas.box.dimension == 1) return why_no_mixing_on_wire(gas, finite, momentum);
    return std::nullopt;
}

}  // namespace carom
