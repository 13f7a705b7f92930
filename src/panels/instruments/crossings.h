// What crosses a partition or a line, each way, of those that a panel shows; and what hits walls.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "stats/paths/line_crossings.h"

namespace carom {

/// The line that a panel counts at: the scene's, or a partition by its number.
CrossedLine crossed_line(const Box& box, const PanelSpec& spec, std::size_t surface = 0);

/// What it is called: the partition's name, or "x = 32".
std::string name_of_line(const Box& box, const PanelSpec& spec, std::size_t surface = 0);

/// "to the right" and "to the left", "up" and "down".
std::array<Phrase, 2> ways_across(int axis);
std::array<std::string, 2> arrows_across(int axis);

}  // namespace carom
