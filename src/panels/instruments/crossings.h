// Names and lines for panels that count particles which cross a partition or a line, in each
// direction.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/surfaces/place_options.h"
#include "scene/instruments/instrument_reading.h"
#include "stats/paths/line_crossings.h"

namespace carom {

/// Where particles cross: a line that the scene gives, or partitions.
struct CrossedAt {
    SurfaceNumbers surfaces = {};
    std::optional<CountingLine> line = {};
};
std::vector<Binding<CrossedAt>> crossed_keys();

/// For PanelKind: the option that says so.
template <class T>
auto crossed_at(CrossedAt T::*at) {
    return [at](const PanelSpec& panel) {
        return MeasuredAt{.surfaces = (panel.options.as<T>().*at).surfaces};
    };
}

/// Reports a line that is given together with surfaces.
void check_line(const Node& node, Reading& reading);

/// Partitions that particles can cross.
SuitableSurface passable_surfaces(const Reading& reading);

/// The line at which a panel counts: the one given in the scene, or a partition by its number.
CrossedLine crossed_line(const Box& box, const CrossedAt& at, std::size_t surface = 0);

/// The name of that line: the partition's name, or "x = 32".
std::string name_of_line(const Box& box, const CrossedAt& at, std::size_t surface = 0);

/// The directions of ways_across() (scene/describe.h) as arrows.
std::array<std::string, 2> arrows_across(int axis);

}  // namespace carom
