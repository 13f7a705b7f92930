// The size of a picture and the places of everything in it, as plain values.
#pragma once

#include <optional>
#include <vector>

namespace carom {

struct PictureSize {
    int width = 1920;
    int height = 1080;
    bool operator==(const PictureSize&) const = default;
};

/// A rectangle of a template's layout, in units of the template's grid, with the origin at the top
/// left.
struct Slot {
    double x = 0, y = 0, width = 0, height = 0;
};

/// Whether a place lies inside another one.
inline bool is_within(const Slot& slot, const Slot& other) {
    constexpr double rounding = 1e-9;
    return slot.x >= other.x - rounding && slot.y >= other.y - rounding &&
           slot.x + slot.width <= other.x + other.width + rounding &&
           slot.y + slot.height <= other.y + other.height + rounding;
}

/// Whether a place has room for one line only, in which a key or numbers then stand.
inline bool is_one_line(const Slot& slot) { return slot.height < 3.0; }

/// The places of everything in a frame, read from a template.
struct LayoutSpec {
    double grid_width = 80,
           grid_height = 45;  ///< the picture in grid units; stretched to fill it
    Slot title;               ///< in as many lines as it has room for
    Slot gas;
    Slot color_bar;
    std::optional<Slot> caption;  ///< the line of captions and, at the start, of the subtitle,
                                  ///< where the scene has any; the rest has made room for it then
    std::optional<Slot> clock;
    std::optional<Slot> monitors;
    std::vector<Slot> panels;  ///< those inside the gas's place lie over the gas
};

}  // namespace carom
