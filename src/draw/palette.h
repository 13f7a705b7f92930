// Colour maps and colour sets, safe for colour-blind viewers. The maps are viridis, plasma, inferno
// and magma by Smith and van der Walt (CC0) and cividis by Nuñez, Anderton and Renslow (2018,
// doi:10.1371/journal.pone.0199239); see palette-LICENSE.txt.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draw/color.h"

namespace carom {

/// A sequential map sampled at equal steps; at(0) is its slow end, at(1) its fast end, clamped
/// outside.
class ColorMap {
  public:
    explicit ColorMap(std::vector<Color> samples) : samples_(std::move(samples)) {}
    Color at(double share) const;

  private:
    std::vector<Color> samples_;
};

/// A perceptually uniform map by name (viridis, cividis, plasma, inferno, magma); `first` and
/// `last` cut it, first > last turns it. Throws std::invalid_argument.
ColorMap color_map(std::string_view name, double first = 0.0, double last = 1.0);

/// Names that color_map knows.
std::span<const std::string> color_map_names();

/// Blue, green and red, as in NetLogo's models of gases, at a contrast of 3 with the ground. Not
/// safe for all colour-blind viewers.
ColorMap netlogo_map(bool dark_ground);

/// Okabe and Ito's colours for kinds, in a fixed order for a dark or a light ground; repeats after
/// eight.
Color kind_color(std::size_t index, bool dark_ground);

}  // namespace carom
