// Where things stand in a frame: a template's grid on a picture of any shape, panels in the places
// there are. Draws nothing.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "draw/geometry.h"
#include "draw/text.h"
#include "scene/scene.h"

namespace carom {

/// A template's grid, stretched to fill a picture. Text keeps its shape: its unit fits both ways.
class Grid {
  public:
    Grid(const LayoutSpec& layout, PictureSize size);

    double unit() const { return unit_; }  ///< pixels
    Rect place(const Slot& slot) const;    ///< pixels

    /// So many unit() in grid units, as a width and as a height.
    double width_of(double units) const { return units * unit_ / across_; }
    double height_of(double units) const { return units * unit_ / up_; }

    /// Height over width in grid units of what has this shape in pixels.
    double shape_of(double shape) const { return shape * across_ / up_; }

  private:
    double across_, up_;  ///< pixels of a grid unit each way
    double unit_;
};

/// The places of `count` panels, row by row. Fewer than there are places share the whole area of a
/// regular grid of places; where these are no regular grid, the first are taken.
std::vector<Slot> shared_slots(const std::vector<Slot>& slots, std::size_t count);

/// Places one below the other, of which those that have enough with less than their height (grid
/// units; none: more is better) leave the rest to the others. Places that do not stand so, or all
/// have enough, stay as they are. `enough` may be shorter than `slots`.
std::vector<Slot> with_heights(std::vector<Slot> slots,
                               const std::vector<std::optional<double>>& enough);

/// The place of one of two boxes, and of a line of words below it.
struct PlaceBeside {
    Slot box, words;
};

/// Places for two boxes of one shape, height over width in pixels (0 of a line, which takes the
/// height that there is), side by side or one above the other, as they are larger; in the middle of
/// the height of `place`, at the left of what they have of its width. Words have all of that.
std::array<PlaceBeside, 2> places_beside(const Slot& place, double shape, const Grid& grid);

}  // namespace carom
