// Draws a figure in the size that a text column, a page or a slide requires, with the type size
// that is usual there, as pixels, SVG or PDF.
#pragma once

#include <array>
#include <optional>

#include "draw/canvas.h"
#include "figures/figure_run.h"

namespace carom {

/// The size of the smallest type (labels of axes) in points. Titles are 1.15 times as large.
double smallest_type(const FigureSpec& spec);

/// Width and height in centimetres, rounded to a tenth of a millimetre.
std::array<double, 2> figure_size(const Scene& scene, const FigureSpec& spec);

/// Throws SceneError if the figure shows words and they do not fit into it.
void refuse_long_words(const Scene& scene, const FigureSpec& spec);

/// The picture of a figure, as vector graphics in `format` or else as pixels; `words` are stored
/// with it. Pixel pictures have 300 pixels per inch (slides 144) and say so; vector pictures have
/// the same lengths in centimetres to within a quarter of a millimetre. The background is that of
/// the theme, or none where the scene's film has none (`film.ground`). Throws SystemError.
Canvas draw_figure(const FigureRun& run, const Figure& figure, std::optional<VectorFormat> format,
                   const PictureWords& words);

/// The data that the picture shows, as a table. For a strip of pictures the first column is the
/// time.
Table table_of(const Figure& figure);

}  // namespace carom
