// What `carom check` reports of the film of a scene: its frames, passes, costs, and words that do
// not fit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/facts.h"
#include "films/cost/film_cost.h"
#include "physics/particles.h"

namespace carom {

struct Scene;

/// The film of a checked scene whose cost is reported.
struct CheckedFilm {
    FilmOptions options = {};                       ///< the output path is ignored
    std::vector<const OutputFormat*> formats = {};  ///< whose costs are estimated; at least one
    std::optional<FilmCost> measured = {};
    SceneCounts counts = {};                ///< of its runs; empty: not counted
    std::vector<std::string> cut = {};      ///< words_left_out() of its last frame
    std::vector<std::string> in_keys = {};  ///< words_in_keys() of it
    std::optional<double> collisions =
        {};  ///< in all its runs, including those with walls; none: estimated as in equilibrium
};

/// The formats whose costs are reported, in their order.
std::vector<const OutputFormat*> formats_with_costs();

/// The rows of a film. `drawn` and `start` are its particles, drawn and not placed; `expected` are
/// the collisions of its own run in equilibrium.
Facts film_facts(const Scene& scene, const CheckedFilm& checked, const Particles& drawn,
                 const Sample& start, double expected);

}  // namespace carom
