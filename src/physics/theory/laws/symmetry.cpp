#include "physics/theory/laws/symmetry.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "physics/gas.h"
#include "physics/surfaces/behaviours.h"
#include "physics/theory/equation_of_state.h"

namespace carom {
namespace {

constexpr std::int64_t least_crowd = 20;  // fewer of a species are seen one by one

// No particle is set apart from others of its species by what the scene gives it.
bool is_the_same_for_all(const ValueRule& rule) {
    const auto* each = std::get_if<std::vector<double>>(&rule);
    return each == nullptr || std::ranges::adjacent_find(*each, std::not_equal_to{}) == each->end();
}

bool is_the_same_for_all(const MassRule& rule) {
    if (const auto* value = std::get_if<ValueRule>(&rule)) return is_the_same_for_all(*value);
    const auto* density = std::get_if<Density>(&rule);
    return density != nullptr && is_the_same_for_all(density->value);
}

// A common velocity has a direction, along which only periodic sides let it pass.
bool is_even_in_velocity(const VelocityRule& rule, const Box& box, int axis) {
    if (const auto* speed = std::get_if<Speed>(&rule)) return is_the_same_for_all(speed->value);
    const auto* given = std::get_if<Velocity>(&rule);
    if (given == nullptr) return true;
    return given->values.size() == 1 &&
           (box.is_periodic(axis) || given->values.front()[axis] == 0.0);
}

bool is_even_in_place(const PositionRule& rule, const Box& box, int axis) {
    if (const auto* within = std::get_if<WithinRegion>(&rule))
        return within->region.low[axis] <= 0.0 && within->region.high[axis] >= box.length(axis);
    return !std::holds_alternative<Places>(rule);
}

bool starts_evenly(const Species& species, const Box& box, int axis) {
    return species.count == 0 ||
           (species.count >= least_crowd && is_the_same_for_all(species.radius) &&
            is_the_same_for_all(species.mass) && is_even_in_velocity(species.velocity, box, axis) &&
            is_even_in_place(species.position, box, axis));
}

bool acts_evenly(const Surfaces& surfaces, const Box& box, int axis,
                 const std::vector<std::vector<Behaviour>>& behaviours) {
    if (surfaces.gravity[axis] != 0.0 || !surfaces.obstacles.empty()) return false;
    const bool has_even_partitions =
        std::ranges::all_of(surfaces.partitions, [&](const Partition& partition) {
            return partition.axis != axis && partition.gaps.empty();
        });
    const auto first = static_cast<std::size_t>(2 * axis);
    return has_even_partitions &&
           (box.is_periodic(axis) || (std::ranges::all_of(behaviours[first], only_reflects) &&
                                      std::ranges::all_of(behaviours[first + 1], only_reflects)));
}

bool may_convect(const Box& box, const std::vector<std::vector<Behaviour>>& behaviours) {
    std::optional<double> temperature;
    bool differ = false;
    for (std::size_t k = 0; k < behaviours.size(); ++k)
        for (const Behaviour& one : behaviours[k]) {
            const auto* bath = bath_of(one);
            if (bath == nullptr || (box.surfaces.is_side(k) && box.is_periodic(k / 2))) continue;
            differ = differ || (temperature && *temperature != bath->temperature);
            temperature = bath->temperature;
        }
    return differ && box.surfaces.has_gravity();
}

// The mean area or volume of particles with radii of this rule.
double mean_size(const ValueRule& rule, int dimension) {
    const double unit = content_of_ball(1.0, dimension);
    if (const auto* value = std::get_if<double>(&rule)) return content_of_ball(*value, dimension);
    if (const auto* range = std::get_if<UniformDistribution>(&rule)) {
        const double low = range->low, high = range->high, squares = low * low + high * high;
        return unit *
               (dimension == 2 ? (squares + low * high) / 3.0 : 0.25 * (low + high) * squares);
    }
    if (const auto* normal = std::get_if<NormalDistribution>(&rule)) {
        const double mean = normal->mean, variance = normal->deviation * normal->deviation;
        return unit *
               (dimension == 2 ? mean * mean + variance : mean * (mean * mean + 3.0 * variance));
    }
    const auto& each = std::get<std::vector<double>>(rule);
    double sum = 0.0;
    for (const double radius : each) sum += content_of_ball(radius, dimension);
    return each.empty() ? 0.0 : sum / static_cast<double>(each.size());
}

bool may_freeze(const Gas& gas) {
    double covered = 0.0;
    for (const Species& species : gas.species)
        covered +=
            static_cast<double>(species.count) * mean_size(species.radius, gas.box.dimension);
    return covered > largest_packing_of_fluid(gas.box.dimension) * gas.box.content();
}

}  // namespace

std::array<bool, 3> even_axes(const Gas& gas, const std::vector<RunEvent>& events) {
    const Box& box = gas.box;
    Run run;
    run.events = events;
    const auto behaviours = behaviours_in_time(box.surfaces, run);
    if (box.dimension == 1 || may_freeze(gas) || may_convect(box, behaviours)) return {};
    std::array<bool, 3> even{};
    for (int axis = 0; axis < box.dimension; ++axis)
        even.at(static_cast<std::size_t>(axis)) =
            acts_evenly(box.surfaces, box, axis, behaviours) &&
            std::ranges::all_of(gas.species, [&](const Species& species) {
                return starts_evenly(species, box, axis);
            });
    return even;
}

}  // namespace carom
