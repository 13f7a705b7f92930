// How a figure is drawn: as large as a text's column, its page or a slide asks, with type of the
// size that is usual there, on pixels, as SVG or as PDF.
#pragma once

#include <array>
#include <optional>

#include "draw/canvas.h"
#include "figures/figure_run.h"

namespace carom {

/// The smallest type, points: labels of axes. Titles are 1.15 times as large.
double smallest_type(const FigureSpec& spec);

/// Width and height in centimetres, to a tenth of a millimetre.
std::array<double, 2> figure_size(const Scene& scene, const FigureSpec& spec);

/// Throws SceneError where the figure is one of words, and has no room for them.
void refuse_long_words(const Scene& scene, const FigureSpec& spec);

/// The picture of a figure, in vectors or in pixels; `words` go with it. Of pixels there are 300 to
/// the inch (a slide 144), vector pictures the same lengths in centimetres to a quarter of a
/// millimetre. Throws SystemError.
Canvas draw_figure(const FigureRun& run, const Figure& figure, std::optional<VectorFormat> format,
                   const PictureWords& words);

/// What the picture shows, as numbers; of a strip with the time of each picture first.
Table table_of(const Figure& figure);

}  // namespace carom
