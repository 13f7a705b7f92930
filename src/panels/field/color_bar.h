// The key of a scale of colours: a bar from its lowest to its highest number. Knows no gas.
#pragma once

#include <string>
#include <vector>

#include "draw/palette.h"
#include "panels/panel.h"

namespace carom {

/// What a scale of colours means, from 0 on.
struct ColorScale {
    std::string title;                      ///< plain words
    double top = 1.0;                       ///< the value of the last colour
    bool is_exceeded = false;               ///< whether there are values above, of the same colour
    std::string symbol = {};                ///< markup, instead where they have no room
    Language language = Language::english;  ///< of the numbers

    Color color(const ColorMap& map, double value) const { return map.at(value / top); }
    void archive(auto& archive) { archive(top, is_exceeded); }
};

/// The end of a scale over some values, a round one: so high that at most this share of them is
/// above. At least 1 value; they are reordered.
void fix_top(ColorScale& scale, std::vector<double>& values, double share_above);

/// The numbers beside its bar; the last says whether there are values above.
std::vector<TickMark> marks_of(const ColorScale& scale);

/// Those of them that stand a line or more apart beside a bar of this height, evenly, the last
/// among them.
std::vector<TickMark> marks_with_room(const ColorScale& scale, double height, double line);

/// Draws title, bar and numbers, as high as the area. With less than full `opacity` the colours lie
/// over the ground.
void draw_color_bar(Canvas& canvas, const DrawContext& dc, const ColorMap& map,
                    const ColorScale& scale, double opacity = 1.0);

}  // namespace carom
