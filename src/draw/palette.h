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

/// A sequential colour map sampled at equal steps: at(0) is its slow end, at(1) its fast end;
/// shares outside [0, 1] are clamped.
class ColorMap {
  public:
    explicit ColorMap(std::vector<Color> samples) : samples_(std::move(samples)) {}
    Color at(double share) const;
    std::span<const Color> samples() const { return samples_; }

  private:
    std::vector<Color> samples_;
};

/// A perceptually uniform map by name (viridis, cividis, plasma, inferno, magma). `first` and
/// `last` select a part of it; first > last reverses it. Throws std::invalid_argument for an
/// unknown name.
ColorMap color_map(std::string_view name, double first = 0.0, double last = 1.0);

/// The names that color_map() accepts.
std::span<const std::string> color_map_names();

/// The largest part of a perceptually uniform map that stands out from page and ground
/// (least_contrast_of_marks); the end with the least contrast comes first: on a dark ground slow is
/// dark, on a light ground light.
ColorMap color_map_on(std::string_view name, const Theme& theme);

/// The map of a theme with a ramp of its own, through its colours in even steps of Oklab.
ColorMap ramp_map(const Theme& theme);

/// Blue, green and red, as in NetLogo's models of gases, with a contrast of 3 to the ground. All
/// viewers can tell the three kinds apart; the colours interpolated between them are no scale for
/// colour-blind viewers.
ColorMap netlogo_map(bool dark_ground);

/// The colours of slow, medium and fast: those of the theme's ramp, or NetLogo's blue, green and
/// red, greys in print; independent of the palette of the film.
Color speed_class_color(std::size_t index, const Theme& theme);

/// A colour that no viewer confuses with a colour of the named map, for what has no place on that
/// scale.
Color color_beside(std::string_view name, const Theme& theme);

/// A cyclic map of directions, counterclockwise from the right; the last colour equals the first.
/// All viewers can tell right and left apart, blue and coral.
ColorMap direction_map(const Theme& theme);

/// Greys from light to dark in even steps of lightness, for print; all are far from black.
ColorMap grey_map();

/// Colours for kinds of particles, in a fixed order for each theme: those of its series, or blue,
/// coral (so that of a cold and a hot kind the latter is warm), green, violet and two with little
/// colour; greys in print. They repeat after six, in print after four. All viewers can tell them
/// from each other and, in colour, from the theory curve, whose hue none of them has. Pale greys
/// need an edge (see edge_of).
Color kind_color(std::size_t index, const Theme& theme);

/// The colours of kind_color(), ordered by their distance from all of `others`, from words and from
/// curves of theory, farthest first, but of the first two the bluer first: for kinds in a picture
/// where the others have another meaning. A series of the theme's own keeps its order.
std::vector<Color> kind_colors_beside(std::span<const Color> others, const Theme& theme);

}  // namespace carom
