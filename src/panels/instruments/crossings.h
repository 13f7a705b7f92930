// Names and lines for panels that count particles which cross a partition or a line, in each
// direction.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "stats/paths/line_crossings.h"

namespace carom {

/// The line at which a panel counts: the one given in the scene, or a partition by its number.
CrossedLine crossed_line(const Box& box, const PanelSpec& spec, std::size_t surface = 0);

/// The name of that line: the partition's name, or "x = 32".
std::string name_of_line(const Box& box, const PanelSpec& spec, std::size_t surface = 0);

/// The two directions across a line, toward larger coordinates first: "to the right" and "to the
/// left", or "upwards" and "downwards".
std::array<Phrase, 2> ways_across(int axis);
std::array<std::string, 2> arrows_across(int axis);

}  // namespace carom
