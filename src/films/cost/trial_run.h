// The trial run of `carom check`: the beginning of a run, which shows most errors that would end it
// later, and counts what the run calculates.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/advance_result.h"
#include "scene/figure_spec.h"

namespace carom {

struct Scene;

/// How fast the particles of each species are at a time of a run, on average.
struct MeanSpeeds {
    double time = 0.0;
    std::vector<double> of_species;
};

/// What a run calculates, counted on its beginning: the same on every machine.
struct RunCounts {
    std::optional<double> collisions = {};  ///< from time 0 to the end, those with walls included,
                                            ///< even if they exceed the limit of the run; none: the
                                            ///< trial came to too few to tell
    double events = 0.0;  ///< collisions, crossings of cells and others, from time 0 to the end
    int bits = 53;        ///< of the numbers that it calculates with
    std::optional<Ties> ties = {};  ///< from time 0; none: the trial did not come so far
    bool is_cut = false;            ///< they are those of the beginning only
    std::vector<MeanSpeeds> speeds =
        {};  ///< in order of time, from the start as far as it was tried
};

/// Runs a scene up to a number of collisions that takes a fraction of a second, and extrapolates
/// from the rate so far if that does not reach its end. `panels` see the run: those of a collision,
/// and tests of histograms. `share`: of the usual length of a trial, where many are made. Returns
/// nothing if the run is not tried (too many particles, fixed time steps). Throws SceneError for
/// errors that end the trial and, if it reaches the end, for panels of a collision that does not
/// happen and for impossible tests; Interrupted.
std::optional<RunCounts> try_run(const Scene& scene, std::span<const PanelSpec> panels = {},
                                 double share = 1.0);

/// The same for every scene: what cannot be tried is expected by kinetic theory, or counted in time
/// steps.
RunCounts counts_of(const Scene& scene, std::span<const PanelSpec> panels = {}, double share = 1.0);

/// The panels of a scene's film, and those of its figures of its own run, that may find only in a
/// run that they have nothing to show.
std::vector<PanelSpec> panels_to_try(const std::vector<PanelSpec>& film);
std::vector<PanelSpec> panels_to_try(const std::vector<FigureSpec>& figures);

}  // namespace carom
