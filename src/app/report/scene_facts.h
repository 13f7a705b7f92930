// What a scene is and what it will cost, told before anything is simulated.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/figures/figure_set.h"
#include "scene/scene.h"

namespace carom {

/// What the film of a scene needs, roughly: interpolated from films that were measured
/// (docs/encoding.md), for quality `standard`, on a machine like the one they were made on.
struct FilmCost {
    std::string format;    ///< as in film_formats()
    double seconds = 0.0;  ///< of work on `cores` cores
    double bytes = 0.0;
    int cores = 1;
};

struct SceneFacts {
    std::int64_t particles = 0;
    double packing_fraction = 0.0;     ///< of the area; of the length on a wire
    std::optional<double> collisions;  ///< expected from 0 to `until`; none: no theory
    int frames = 0;                    ///< of the film; 0 without
    std::vector<std::string> passes;   ///< what its run is simulated for, each time; none without
    std::vector<FilmCost> costs;       ///< in each of film_formats(); none without a film
};

/// Draws the particles, without placing them. `has_film`: whether a film can be made of it. Throws
/// SceneError (a law that gives no mass above zero).
SceneFacts facts_of(const Scene& scene, bool has_film, int cores);

/// A scene file as `carom check` found it, or the file of a figure set.
struct CheckedScene {
    std::string path;
    std::optional<Scene> scene;  ///< none: not valid, or a set
    SceneFacts facts;            ///< of a valid scene
    std::vector<Diagnostic> errors;
    bool is_set = false;
    std::optional<FigureSet> set = {};  ///< none: not valid, or a scene

    bool is_valid() const { return scene || set; }
};

}  // namespace carom
