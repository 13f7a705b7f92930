// The layout of a frame: the grid of a template on a picture of any aspect ratio, and the places of
// panels in it. Draws nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "draw/geometry.h"
#include "draw/text.h"
#include "scene/layout.h"

namespace carom {

struct Film;

/// The grid of a template, stretched to fill a picture. Text is not stretched: its unit is the
/// smaller of the two grid steps, times the size of text.
class Grid {
  public:
    /// `text`: the size of text, relative to the usual one.
    Grid(const LayoutSpec& layout, PictureSize size, double text = 1.0);

    /// That of a film in its size and style, with its own layout or with another.
    explicit Grid(const Film& film);
    Grid(const Film& film, const LayoutSpec& layout);

    double unit() const { return unit_; }  ///< pixels
    Rect place(const Slot& slot) const;    ///< pixels

    /// A length of `units` times unit(), in grid units: as a width and as a height.
    double width_of(double units) const { return units * unit_ / across_; }
    double height_of(double units) const { return units * unit_ / up_; }

    /// Converts an aspect ratio (height over width) from pixels to grid units.
    double shape_of(double shape) const { return shape * across_ / up_; }

  private:
    double across_, up_;  ///< pixels of a grid unit each way
    double unit_;
};

/// The width of the rim of the plate under a panel that lies over the gas, in units.
inline constexpr double plate_margin = 1.2;

/// The place of a panel on its plate if `slot` lies over the gas; otherwise `slot` itself.
Slot on_plate(const Slot& slot, const LayoutSpec& layout, const Grid& grid);

/// The places of `count` panels. If there are fewer panels than places and these form one column or
/// one row of equal places, the panels share all of it; otherwise they take the first places.
std::vector<Slot> shared_slots(const std::vector<Slot>& slots, std::size_t count);

/// Adjusts places that form one column: a place for which `enough` (height in grid units; none:
/// more is better) is less than its height leaves the rest to the places without a limit. Places
/// that are not in one column, or that all have a limit, are returned unchanged. `enough` may be
/// shorter than `slots`.
std::vector<Slot> with_heights(std::vector<Slot> slots,
                               const std::vector<std::optional<double>>& enough);

/// The place of one of several boxes, and of a line of text below it.
struct PlaceBeside {
    Slot box, words;
};

/// Places for `count` boxes of the same aspect ratio `shape` (height over width in pixels; 0 for a
/// line, which takes the available height): side by side or one above the other, whichever makes
/// them larger; lines side by side where that alone leaves room for their world lines. They are
/// centred vertically in `place` and left-aligned in their share of its width; the lines of text
/// have the whole share.
std::vector<PlaceBeside> places_beside(const Slot& place, double shape, const Grid& grid,
                                       std::size_t count);

/// The places of `count` boxes in one, and of their lines of text side by side below it.
std::vector<PlaceBeside> places_overlaid(const Slot& place, double shape, const Grid& grid,
                                         std::size_t count);

}  // namespace carom
