// The report of `carom check`, for people and for programs: what scenes and figure sets contain and
// what they will cost, without simulating them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/check/command_facts.h"
#include "app/check/film_facts.h"
#include "app/figures/figure_set.h"
#include "app/report/facts.h"
#include "util/diagnostics.h"

namespace carom {

struct Scene;

/// A scene file as `carom check` found it, or the file of a figure set.
struct CheckedFile {
    std::string path;
    bool is_set = false;
    std::optional<Facts> facts = {};  ///< none: not valid
    std::vector<Diagnostic> errors = {};
    std::optional<std::vector<Diagnostic>> barriers = {};  ///< none: not asked for
};

/// What a scene contains and what its film will cost; no `film` means that none can be made from
/// it; `run` is what its run was found to calculate, and `works` are those of other commands. Draws
/// the properties of the particles from their distributions, without placing them. Throws
/// SceneError (a distribution that gives no mass above zero).
Facts facts_of(const Scene& scene, const std::optional<CheckedFilm>& film,
               const RunCounts& run = {}, const NamedWork& works = {},
               const std::vector<CommandsRefused>& refused = {});

/// What a figure set is.
Facts facts_of(const FigureSet& set, const NamedWork& works = {},
               const std::vector<CommandsRefused>& refused = {});

/// A short table for each valid file, and a line for each invalid one; ends with a line break.
std::string check_table(std::span<const CheckedFile> files);

/// A JSON list with one object for each file, in UTF-8; missing values are `null`; ends with a line
/// break.
std::string check_json(std::span<const CheckedFile> files);

}  // namespace carom
