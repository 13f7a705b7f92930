#include "panels/precision.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "panels/panel.h"
#include "physics/collision_error.h"
#include "physics/surfaces/surface_error.h"
#include "scene/feasibility/classroom.h"
#include "scene/feasibility/feasibility.h"

namespace carom {
namespace {

// The place in the scene file of a particle's species.
const Diagnostic& place_of_particle(const Scene& scene, std::int64_t particle) {
    std::size_t species = 0;
    while (species + 1 < scene.gas.species.size() && particle >= scene.gas.species[species].count)
        particle -= scene.gas.species[species++].count;
    return scene.species_spans.at(species);
}

}  // namespace

void with_places_of_errors(const Scene& scene, const std::function<void()>& run) {
    try {
        run();
    } catch (const PrecisionError& error) {
        refuse(scene.precision_place, error.what(), error.hint());
    } catch (const PlacementError& error) {
        throw scene_error(scene, error);
    } catch (const TooManyCollisions& error) {
        const std::string hint = classroom_hint(scene);
        refuse(error.particle() ? place_of_particle(scene, *error.particle()) : scene.ceiling_place,
               error.what(), hint.empty() ? error.hint() : hint);
    } catch (const RunEventError& error) {
        refuse(scene.event_places.at(error.event()), error.what(), error.hint());
    } catch (const CollisionError& error) {
        refuse(error.particle() ? place_of_particle(scene, *error.particle()) : scene.ceiling_place,
               error.what(), error.hint());
    } catch (const SurfaceError& error) {
        const auto surface = static_cast<std::size_t>(error.surface());
        refuse(scene.surface_places.at(surface), error.what(), error.hint());
    } catch (const std::invalid_argument& error) {
        refuse(scene.surfaces_place, error.what(), "");
    }
}

StartedScene start_scene(const Scene& scene, const TrialCallback& on_progress) {
    std::optional<Simulation> simulation;
    with_places_of_errors(scene,
                          [&] { simulation = start_run(scene.gas, scene.run, on_progress); });
    StartedScene started{scene, std::move(*simulation)};
    started.scene.run.bits = started.simulation.bits();
    return started;
}

}  // namespace carom
