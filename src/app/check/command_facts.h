// What `carom check` reports about other commands: which of them refuse a scene that is valid, and
// the CPU time that they take.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/report/facts.h"
#include "films/cost/work.h"
#include "util/diagnostics.h"

namespace carom {

/// What some commands refuse of a scene that others accept.
struct CommandsRefused {
    std::vector<std::string> commands;
    std::vector<Diagnostic> reasons;
};

/// The work of commands, by their names.
using NamedWork = std::vector<std::pair<std::string, Work>>;

/// An error for programs.
Json error_value(const Diagnostic& error);

/// A row with the CPU time of each command, and one for each part of it that is slow; the pictures
/// of a film are not listed.
Facts work_rows(const NamedWork& works);

/// A row for each group of commands that refuse the scene.
Facts refused_rows(const std::vector<CommandsRefused>& refused);

}  // namespace carom
