// The place of walls and partitions that move, against time; for one free piston on a gas with the
// mean that it would have over an ideal gas.
#include <cmath>

#include "panels/instruments/measured_surfaces.h"
#include "panels/registry.h"
#include "panels/surfaces/surface_words.h"
#include "physics/energy_account.h"

namespace carom {
namespace {

// The mean distance of a free piston from the opposite wall, over a gas of N points with the total
// energy E: p(h) is proportional to h^N (E - F h)^((d N - 1) / 2), a beta distribution, so that the
// mean of h is (E / F) (N + 1) / (N + 1 + (d N + 1) / 2). On a line beads are as points on what
// they leave free, exactly. None where anything else acts, or changes.
std::optional<double> mean_over_ideal_gas(const PanelContext& context, std::int32_t surface,
                                          const Sample& start,
                                          const std::vector<SurfaceState>& states) {
    const Box& box = context.scene.gas.box;
    const Surfaces& surfaces = box.surfaces;
    const auto* piston = std::get_if<Piston>(&surfaces.sides.at(static_cast<std::size_t>(surface)));
    const auto opposite = static_cast<std::size_t>(surface ^ 1);
    if (piston == nullptr || !context.scene.run.events.empty() || !surfaces.partitions.empty() ||
        !surfaces.obstacles.empty() || (surfaces.gravity != 0.0).any() ||
        (context.particles.inverse_mass == 0.0).any())
        return std::nullopt;
    for (std::size_t k = 0; k < 4; ++k)
        if (k != static_cast<std::size_t>(surface) &&
            !std::holds_alternative<Reflecting>(surfaces.sides[k]))
            return std::nullopt;
    const bool is_far = Surfaces::is_far_side(surface);
    const double force = is_far ? -piston->force : piston->force;  // toward the gas
    if (!(force > 0.0)) return std::nullopt;
    const double taken = box.dimension == 1 ? 2.0 * context.particles.radius.sum() : 0.0;
    const double wall = box.place_of(opposite);
    const auto height = [&](double place) { return std::abs(place - wall) - taken; };
    const EnergyAccount now = energies(box, context.particles, start, states);
    const auto count = static_cast<double>(context.particles.count());
    const double energy =
        now.kinetic + now.pistons +
        force * height(place_of_surface(box, states, static_cast<std::size_t>(surface)));
    const double freedom = 0.5 * (box.dimension * count + 1.0);
    const double mean = energy / force * (count + 1.0) / (count + 1.0 + freedom);
    return is_far ? wall + taken + mean : wall - taken - mean;
}

}  // namespace

std::unique_ptr<Panel> make_piston(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    SeriesSubject subject{.quantity = Phrase{"position"}, .unit = reduced::length};
    name_surfaces(subject, language, context.scene.gas.box, spec.surfaces,
                  say(language, "Position"));
    const auto mean = std::make_shared<std::optional<double>>();
    subject.measure = [context, surfaces = spec.surfaces, mean,
                       is_first = true](const FrameInput& o) mutable {
        const Box& its = context.scene.gas.box;
        if (std::exchange(is_first, false) && surfaces.size() == 1 &&
            Surfaces::is_side(surfaces.front()))
            *mean = mean_over_ideal_gas(context, surfaces.front(), o.sample, o.advanced.surfaces);
        std::vector<double> places;
        for (const std::int32_t surface : surfaces)
            places.push_back(
                place_of_surface(its, o.advanced.surfaces, static_cast<std::size_t>(surface)));
        return places;
    };
    if (spec.theory)
        subject.reference = [mean]() -> std::optional<ReferenceLevel> {
            if (!*mean) return std::nullopt;
            return ReferenceLevel{"ideal gas, mean", **mean};
        };
    return std::make_unique<SeriesPanel>(context, spec, std::move(subject));
}

}  // namespace carom
