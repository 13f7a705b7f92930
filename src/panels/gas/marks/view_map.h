// What is drawn over a view of a part of the box: a small map of the whole box that shows the part,
// a scale bar of a round length, and remarks that keep clear of both.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// The places of map and scale bar, on one plate.
struct ViewMap {
    Rect plate, map;
    Point bar;            ///< left end of the scale bar
    double length = 0.0;  ///< of the scale bar, in units of the scene
    double pixels = 0.0;  ///< of the scale bar, in pixels
};

/// The layout in a picture. `shape`: height over width of the whole box; `scale`: pixels per unit
/// length.
ViewMap view_map(const DrawContext& dc, const Rect& picture, double shape, double scale);

/// The opacity of the map in a view with this magnification relative to the whole box.
double view_map_share(double zoom);

/// Draws the map and the scale bar. `part`: the visible part as shares of the whole box, y down;
/// `share`: opacity.
void draw_view_map(Canvas& canvas, const DrawContext& dc, const ViewMap& map, const Rect& part,
                   double share, Language language);

/// Remarks (plain words) at the lower right of a picture, one above the other: beside the map if
/// there is one and it leaves room, otherwise above it.
class Remarks {
  public:
    Remarks(const DrawContext& dc, const Rect& picture, const std::optional<ViewMap>& map)
        : dc_(dc), picture_(picture), map_(map), foot_(picture.bottom()) {}

    /// Adds a remark: the first of its forms that fits, which are ordered from longest to shortest;
    /// nothing if none fits.
    void add(const std::vector<std::string>& forms);
    void draw(Canvas& canvas) const;

    /// Adds the plates of the remarks and of the map to the places that are occupied in some view.
    /// Plates with the same top left corner are merged into one.
    void take_places(std::vector<Rect>& taken) const;

  private:
    bool place(const std::vector<std::string>& forms, double width);
    struct Remark {
        std::string words;
        Rect plate;
    };
    const DrawContext& dc_;
    Rect picture_;
    std::optional<ViewMap> map_;
    double foot_;  ///< bottom of the next remark
    std::vector<Remark> remarks_;
};

}  // namespace carom
