// A key in one line: ramps of colours, disks with names and arrows beside each other, ending at the
// right of a place.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "panels/field/color_bar.h"
#include "panels/panel.h"

namespace carom {

class KeyRow {
  public:
    explicit KeyRow(const DrawContext& dc) : dc_(dc) {}

    /// Adds a part of a width in pixels, which `draw` draws from its left end on the baseline.
    using DrawPart = std::function<void(Canvas&, Point)>;
    void add(double width, DrawPart draw);

    /// Adds plain words.
    void add_words(const std::string& words);

    /// Adds a ramp of colours with its title before it and its numbers below. The words for a mean
    /// follow the title, in a second line, if they fit beside a shorter ramp. With `opacity` below
    /// 1 the colours are blended with the ground.
    void add_ramp(const ColorMap& map, const ColorScale& scale, double opacity = 1.0);

    /// What the parts that have room fill; nothing if there are none.
    Rect place() const;

    /// Draws as many parts as have room, beginning with the first.
    void draw(Canvas& canvas) const;

    const DrawContext& context() const { return dc_; }

  private:
    struct Part {
        double width;
        DrawPart draw;
    };
    std::pair<std::size_t, double> shown() const;
    std::vector<std::string> title_of_ramp(const ColorScale& scale, double most) const;

    DrawContext dc_;
    std::vector<Part> parts_;
};

}  // namespace carom
