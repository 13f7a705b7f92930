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
#include "draw/style.h"

namespace carom {

/// A sequential map sampled at equal steps; at(0) is its slow end, at(1) its fast end, clamped
/// outside.
class ColorMap {
  public:
    explicit ColorMap(std::vector<Color> samples) : samples_(std::move(samples)) {}
    Color at(double share) const;
    std::span<const Color> samples() const { return samples_; }

  private:
    std::vector<Color> samples_;
};

/// A perceptually uniform map by name (viridis, cividis, plasma, inferno, magma); `first` and
/// `last` cut it, first > last turns it. Throws std::invalid_argument.
ColorMap color_map(std::string_view name, double first = 0.0, double last = 1.0);

/// Names that color_map knows.
std::span<const std::string> color_map_names();

/// The whole of a perceptually uniform map that stands out from page and ground, with the end that
/// stands out least first: on a dark ground slow is dark, on a light one light.
ColorMap color_map_on(std::string_view name, const Theme& theme);

/// Blue, green and red, as in NetLogo's models of gases, at a contrast of 3 with the ground. Three
/// kinds are told apart by all viewers; between them the map is no scale for the colour-blind.
ColorMap netlogo_map(bool dark_ground);

/// Slow, medium and fast: NetLogo's blue, green and red, greys in print, the same whatever the
/// scale of a film is.
Color speed_class_color(std::size_t index, const Theme& theme);

/// A colour that no viewer takes for one of a scale by name, for what has no place on it.
Color color_beside(std::string_view name, const Theme& theme);

/// Around the circle of directions, counterclockwise from the right, the first colour again at the
/// end: right and left, blue and yellow or orange, are told apart by all viewers.
ColorMap direction_map(const Theme& theme);

/// Greys from light to dark by even steps, for print; all are far from black.
ColorMap grey_map();

/// Colours for kinds near those of Okabe and Ito, in a fixed order for each theme, greys in print;
/// they repeat after six, in print after four. Pale greys need an edge (see edge_of).
Color kind_color(std::size_t index, const Theme& theme);

/// The same colours, the one first that is furthest from all of others, from words and from curves
/// of theory: for kinds in a picture where the others mean something else.
std::vector<Color> kind_colors_beside(std::span<const Color> others, const Theme& theme);

}  // namespace carom
