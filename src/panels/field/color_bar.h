// The key of a colour scale: a bar from its lowest to its highest value. Independent of the gas.
#pragma once

#include <string>
#include <vector>

#include "draw/palette.h"
#include "panels/panel.h"

namespace carom {

/// The meaning of a colour scale, which begins at 0.
struct ColorScale {
    std::string title;         ///< plain words
    double top = 1.0;          ///< the value of the last colour
    bool is_exceeded = false;  ///< whether there are values above, of the same colour
    std::string symbol = {};   ///< markup, used instead of the title if that does not fit
    std::string mean = {};     ///< over what the values are averaged, plain words
    Language language = Language::english;  ///< of the numbers

    Color color(const ColorMap& map, double value) const { return map.at(value / top); }
    void archive(auto& archive) { archive(top, is_exceeded); }
};

/// Sets the upper end of a scale to a round number such that at most `share_above` of the values
/// lie above it. Requires at least one value; reorders `values`.
void fix_top(ColorScale& scale, std::vector<double>& values, double share_above);

/// The numbers beside the bar; the last one shows whether there are values above it.
std::vector<TickMark> marks_of(const ColorScale& scale);

/// The same numbers, evenly thinned so that beside a bar of this height they are at least `line`
/// apart; the last one is always kept.
std::vector<TickMark> marks_with_room(const ColorScale& scale, double height, double line);

/// Draws title, bar and numbers over the full height of the area. With `opacity` below 1 the
/// colours are blended with the ground.
void draw_color_bar(Canvas& canvas, const DrawContext& dc, const ColorMap& map,
                    const ColorScale& scale, double opacity = 1.0);

}  // namespace carom
