// What `carom check` finds: what scenes and figure sets are and what they will cost, before
// anything is simulated; for people and for programs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cost/film_cost.h"
#include "app/figures/figure_set.h"
#include "app/report/facts.h"
#include "scene/scene.h"
#include "util/diagnostics.h"

namespace carom {

/// A scene file as `carom check` found it, or the file of a figure set.
struct CheckedFile {
    std::string path;
    bool is_set = false;
    std::optional<Facts> facts = {};  ///< none: not valid
    std::vector<Diagnostic> errors = {};
    std::optional<std::vector<Diagnostic>> barriers = {};  ///< none: not asked for
};

/// What is wanted of the film of a checked scene.
struct CheckedFilm {
    FilmOptions options = {};              ///< its output does not count
    const OutputFormat* format = nullptr;  ///< none: all are estimated
    std::optional<FilmCost> measured = {};
    std::optional<double> collisions =
        {};  ///< of its runs, walls included; none: as in equilibrium
};

/// What a scene is and what its film will cost; without `film` none can be made of it. Draws the
/// particles, without placing them. Throws SceneError (a distribution that gives no mass above
/// zero).
Facts facts_of(const Scene& scene, const std::optional<CheckedFilm>& film);

/// What a figure set is.
Facts facts_of(const FigureSet& set);

/// A short table for each valid file, a line for each that is not; ends with a line break.
std::string check_table(std::span<const CheckedFile> files);

/// A list with one object for each file, in UTF-8; `null` for what there is none of; ends with a
/// line break.
std::string check_json(std::span<const CheckedFile> files);

}  // namespace carom
