#include "app/report/trial_run.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "panels/panel_set.h"
#include "panels/precision.h"
#include "panels/registry.h"
#include "physics/collision_error.h"
#include "scene/panel_kind.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

constexpr std::int64_t most_particles_tried = 20'000;

// Arithmetic with more bits than a double is some hundred times slower.
std::int64_t collisions_tried(const Run& run) {
    return run.bits == bits_of_double ? 300'000 : 5'000;
}

std::vector<PanelSpec> panels_of_collisions(const Scene& scene) {
    std::vector<PanelSpec> specs = scene.film.panels;
    for (const FigureSpec& figure : scene.figures) specs.push_back(figure.panel);
    std::erase_if(specs, [](const PanelSpec& spec) {
        const PanelKind* kind = kind_of(panel_kinds(), spec.kind);
        return kind == nullptr || !kind->can(Ability::pair);
    });
    return specs;
}

// Thrown to end a trial without collisions, in which particles only fly from cell to cell.
struct TooManyFlights {};

// Advances in steps, so that the collisions of a long run do not accumulate in memory.
double survey(PanelSet& panels, Simulation& simulation, double until) {
    constexpr int steps = 64;
    constexpr int most_looks = 10'000;  // one call per some thousand events: seconds in all
    int looks = 0;
    const auto look = [&](double) {
        if (++looks > most_looks) throw TooManyFlights{};
    };
    CollisionCounts counts;
    for (int k = 0; k <= steps; ++k) {
        const Tick tick{.frame = k, .time = until * k / steps};
        const AdvanceResult advanced = simulation.advance_to(tick.time, look);
        panels.survey(tick, simulation.sample(), advanced);
        counts = advanced.counts;
    }
    return static_cast<double>(counts.particle + counts.wall);
}

double try_whole_run(const Scene& scene, const std::vector<PanelSpec>& specs) {
    Simulation simulation = start_run(scene.gas, scene.run);
    simulation.record_collisions(!specs.empty());
    const Particles particles = simulation.particles();
    PanelSet panels(scene, particles, simulation.sample(), 1, specs);
    const double collisions = survey(panels, simulation, scene.run.until);
    all_made(panels.panels(), [](const PanelSet::Placed& placed) {
        placed.panel->fix_axes();
        return true;
    });
    return collisions;
}

// The collisions of the whole run at the rate until it was cut, limited to the allowed number.
double extrapolated(const CollisionsSeen& seen, const Run& run, std::int64_t ceiling) {
    const double tried = seen.begin + run.equilibrate;
    const auto most = static_cast<double>(ceiling), count = static_cast<double>(seen.most);
    return tried > 0.0 ? std::min(most, count * run.until / tried) : most;
}

}  // namespace

std::optional<double> try_run(const Scene& scene, bool has_film) {
    Scene tried = scene;
    std::int64_t particles = 0;
    for (const Species& species : scene.gas.species) particles += species.count;
    if (particles > most_particles_tried || scene.run.time_step) return std::nullopt;
    const std::int64_t ceiling = collision_ceiling(scene.run, particles);
    tried.run.most_collisions = std::min(ceiling, collisions_tried(scene.run));
    const bool is_cut = tried.run.most_collisions < ceiling;
    std::optional<double> collisions;
    with_places_of_errors(scene, [&] {
        try {
            collisions = try_whole_run(
                tried, has_film ? panels_of_collisions(scene) : std::vector<PanelSpec>{});
        } catch (const TooManyCollisions& error) {
            if (!is_cut) throw;
            collisions = extrapolated(error.seen(), tried.run, ceiling);
        } catch (const TooManyFlights&) {
            collisions.reset();
        }
    });
    if (collisions && has_film && scene.film.beside && scene.film.beside->scene)
        *collisions += try_run(*scene.film.beside->scene, false).value_or(*collisions);
    return collisions;
}

}  // namespace carom
