#include "scene/feasibility/box_size.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "physics/mechanics.h"
#include "physics/particles.h"
#include "physics/theory/equation_of_state.h"
#include "physics/vec.h"
#include "scene/limits.h"

namespace carom {
namespace {

// What is known of a gas before it is drawn.
struct UndrawnGas {
    Particles particles;
    ThermalMotion thermal;
};

// One number for each particle; nothing, which is reported, for a distribution.
std::optional<Eigen::ArrayXd> each_of(const ValueRule& rule, const SpeciesDraft& species,
                                      const char* key, Errors& errors) {
    const auto count = static_cast<Eigen::Index>(species.count);
    if (const auto* one = std::get_if<double>(&rule)) return Eigen::ArrayXd::Constant(count, *one);
    const auto* list = std::get_if<std::vector<double>>(&rule);
    if (list != nullptr && std::ssize(*list) == count)
        return Eigen::Map<const Eigen::ArrayXd>(list->data(), count);
    if (list == nullptr)
        errors.add(at_key(species, key),
                   fmt::format("the `pressure` of the box needs a `{}` that is not drawn", key),
                   "give a number or a list, or the `size` of the box");
    return std::nullopt;
}

std::optional<Eigen::ArrayXd> masses_of(const SpeciesDraft& species, int dimension,
                                        const Eigen::ArrayXd& radius, Errors& errors) {
    if (const auto* mass = std::get_if<ValueRule>(&species.mass))
        return each_of(*mass, species, "mass", errors);
    if (const auto* density = std::get_if<Density>(&species.mass)) {
        auto mass = each_of(density->value, species, "density", errors);
        if (mass)
            for (Eigen::Index i = 0; i < radius.size(); ++i)
                (*mass)[i] *= content_of_ball(radius[i], dimension);
        return mass;
    }
    errors.add(at_key(species, "mass"), "a gas with infinite masses has no `pressure`",
               "give the `size` of the box");
    return std::nullopt;
}

// Twice the energy and the momentum of a species whose velocities are not drawn from a temperature;
// nothing, which is reported, if they are not known.
struct GivenMotion {
    double twice_energy = 0.0;
    Vec momentum = {};
};
std::optional<GivenMotion> motion_of(const SpeciesDraft& species, const Eigen::ArrayXd& mass,
                                     Errors& errors) {
    GivenMotion motion;
    if (const auto* speed = std::get_if<Speed>(&species.velocity)) {
        const auto each = each_of(speed->value, species, "speed", errors);
        if (!each) return std::nullopt;
        motion.twice_energy = (mass * each->square()).sum();
    }
    if (const auto* velocity = std::get_if<Velocity>(&species.velocity)) {
        const auto given = static_cast<Eigen::Index>(velocity->values.size());
        if (given != 1 && given != mass.size()) return std::nullopt;  // reported
        for (Eigen::Index i = 0; i < mass.size(); ++i) {
            const Vec& v = velocity->values[given == 1 ? 0 : static_cast<std::size_t>(i)];
            motion.twice_energy += mass[i] * dot(v, v);
            motion.momentum = motion.momentum + mass[i] * v;
        }
    }
    return motion;
}

std::optional<UndrawnGas> undrawn(const Box& box, const std::vector<SpeciesDraft>& all,
                                  Errors& errors) {
    Eigen::Index count = 0;
    for (const SpeciesDraft& species : all) {
        if (species.count <= 0 || !species.radius_known) return std::nullopt;  // reported
        count += static_cast<Eigen::Index>(species.count);
    }
    UndrawnGas gas{{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXi::Zero(count)}, {}};
    std::vector<Eigen::ArrayXd> masses;
    double mass_of_all = 0.0;
    Eigen::Index first = 0;
    for (const SpeciesDraft& species : all) {
        const auto radius = each_of(species.radius, species, "radius", errors);
        if (!radius) return std::nullopt;
        auto mass = masses_of(species, box.dimension, *radius, errors);
        if (!mass) return std::nullopt;
        gas.particles.radius.segment(first, radius->size()) = *radius;
        gas.particles.inverse_mass.segment(first, radius->size()) = mass->inverse();
        first += radius->size();
        mass_of_all += mass->sum();
        masses.push_back(std::move(*mass));
    }
    std::array<bool, 3> conserves{};
    double conserved = 0.0;
    for (int axis = 0; axis < box.dimension; ++axis) {
        conserves[static_cast<std::size_t>(axis)] = conserves_momentum(box, gas.particles, axis);
        if (conserves[static_cast<std::size_t>(axis)]) ++conserved;
    }
    Vec momentum = {};
    for (std::size_t s = 0; s < all.size(); ++s) {
        if (const auto* temperature = std::get_if<Temperature>(&all[s].velocity)) {
            const double freedoms = box.dimension * static_cast<double>(all[s].count) -
                                    conserved * masses[s].sum() / mass_of_all;
            gas.thermal.energy += 0.5 * freedoms * temperature->value;
            continue;
        }
        const auto motion = motion_of(all[s], masses[s], errors);
        if (!motion) return std::nullopt;
        gas.thermal.energy += 0.5 * motion->twice_energy;
        momentum = momentum + motion->momentum;
    }
    for (int axis = 0; axis < box.dimension; ++axis)
        if (conserves[static_cast<std::size_t>(axis)])
            gas.thermal.energy -= 0.5 * momentum[axis] * momentum[axis] / mass_of_all;
    gas.thermal.degrees_of_freedom = box.dimension * static_cast<double>(count) - conserved;
    return gas;
}

// Whether the gas has an equation of state, however dilute it is.
bool has_equation_of_state(const Box& box, const UndrawnGas& gas) {
    constexpr double dilution = 1e6;
    Box dilute = box;
    const double largest = 2.0 * gas.particles.radius.maxCoeff();
    dilute.size = (dilution * std::cbrt(static_cast<double>(gas.particles.count())) * largest /
                   box.shortest_side()) *
                  box.size;
    return pressure_of_fluid(EquationOfState::accurate, dilute, gas.particles, gas.thermal)
        .has_value();
}

}  // namespace

bool size_by_pressure(BoxDraft& box, const std::vector<SpeciesDraft>& species, Errors& errors) {
    if (!box.pressure) return true;
    const auto gas = undrawn(box, species, errors);
    if (!gas) return false;
    const auto refuse = [&](const std::string& message, const char* hint) {
        errors.add(*find(*box.node, "pressure"), message, hint);
        return false;
    };
    if (!(gas->thermal.energy > 0.0))
        return refuse("a gas at rest has no `pressure`", "give its `temperature` or `speed`");
    if (!has_equation_of_state(box, *gas))
        return refuse(fmt::format("there is no equation of state for {} of several radii",
                                  particles_of(box.dimension)),
                      "give the `size` of the box");
    const auto scale = scale_at_pressure(EquationOfState::accurate, box, gas->particles,
                                         gas->thermal, *box.pressure);
    if (!scale)
        return refuse("at this `pressure` the gas is no fluid: it would freeze",
                      "give a lower pressure, or the `size` of the box");
    const Vec size = *scale * box.size;
    if (!(longest(size, box.dimension) <= largest_quantity.value))
        return refuse("at this `pressure` the box would be too large", "give a higher pressure");
    box.size = size;
    return true;
}

}  // namespace carom
