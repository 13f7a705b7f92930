// The report of `carom check`, for people and for programs: what scenes and figure sets contain and
// what they will cost, without simulating them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cost/film_cost.h"
#include "app/figures/figure_set.h"
#include "app/report/command_facts.h"
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

/// The film of a checked scene whose cost is reported.
struct CheckedFilm {
    FilmOptions options = {};                       ///< the output path is ignored
    std::vector<const OutputFormat*> formats = {};  ///< whose costs are estimated; at least one
    std::optional<FilmCost> measured = {};
    SceneCounts counts = {};  ///< of its runs
    std::vector<std::string> cut = {};  ///< words_left_out() of its last frame
    std::optional<double> collisions =
        {};  ///< in all its runs, including those with walls; none: estimated as in equilibrium
};

/// The formats whose costs are reported, in their order.
std::vector<const OutputFormat*> formats_with_costs();

/// What a scene contains and what its film will cost; no `film` means that none can be made from
/// it; `works` are those of other commands. Draws the properties of the particles from their
/// distributions, without placing them. Throws SceneError (a distribution that gives no mass above
/// zero).
Facts facts_of(const Scene& scene, const std::optional<CheckedFilm>& film,
               const NamedWork& works = {}, const std::vector<CommandsRefused>& refused = {});

/// What a figure set is.
Facts facts_of(const FigureSet& set, const NamedWork& works,
               const std::vector<CommandsRefused>& refused = {});

/// A short table for each valid file, and a line for each invalid one; ends with a line break.
std::string check_table(std::span<const CheckedFile> files);

/// A JSON list with one object for each file, in UTF-8; missing values are `null`; ends with a line
/// break.
std::string check_json(std::span<const CheckedFile> files);

}  // namespace carom
