// What a view of a part of the box needs, over the picture: a small map of the whole box with the
// part in it, and a bar of a round length; and remarks, which keep clear of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// Where they stand, on one plate.
struct ViewMap {
    Rect plate, map;
    Point bar;            ///< its left end
    double length = 0.0;  ///< of the bar
    double pixels = 0.0;  ///< the same
};

/// In a picture; `shape`: the height of the whole box over its width; `scale`: pixels of a length.
ViewMap view_map(const DrawContext& dc, const Rect& picture, double shape, double scale);

/// How much of it is seen in a view in which things are so many times as large as in the whole box.
double view_map_share(double zoom);

/// Draws it; `part`: what is seen, in shares of the whole, y down.
void draw_view_map(Canvas& canvas, const DrawContext& dc, const ViewMap& map, const Rect& part,
                   double share, Language language);

/// Remarks (plain words) at the lower right of a picture, one above the other: beside the map where
/// there is one and they have room there, else above it.
class Remarks {
  public:
    Remarks(const DrawContext& dc, const Rect& picture, const std::optional<ViewMap>& map)
        : dc_(dc), picture_(picture), map_(map), foot_(picture.bottom()) {}

    /// Adds the longest of its forms that fits, if one does.
    void add(const std::vector<std::string>& forms);
    void draw(Canvas& canvas) const;

    /// Adds the plates of these and of the map to places that are taken in some view: those that
    /// begin where another does are one with it.
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
    double foot_;  ///< of the next one
    std::vector<Remark> remarks_;
};

}  // namespace carom
