// Figures drawn by the program, with their tables, and the axes found in their pictures.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "readback/alphabet.h"
#include "support/svg_picture.h"

namespace carom::test {

using Row = std::map<std::string, std::string>;  ///< cells by column name

/// Whether a row's numbers are drawn: not those beyond the axes, and not those of equations.
inline bool is_drawn(const Row& row) {
    const std::string& part = row.at("part");
    return part != "below" && part != "above" && part != "parabola" && part != "matrix";
}

struct DrawnFigure {
    std::string name;
    SvgPicture picture;
    std::vector<Row> table = {};  ///< empty: the figure has none
};

/// All figures of a set, as `carom figures` writes them.
std::map<std::string, DrawnFigure> figures_of(const std::filesystem::path& set);

/// The last `count` rows of the samples of a run, one row for each particle.
std::vector<Row> samples_of(const std::filesystem::path& scene, std::size_t count);

/// The rows of the table that belong to a part of the picture.
std::vector<Row> rows_of(const DrawnFigure& figure, const std::string& part);

double number(const Row& row, const std::string& column);

/// A text of the picture and the extent of its ink.
struct Said {
    std::string words;
    Edges ink;
};
std::vector<Said> texts_of(const SvgPicture& picture);

/// A tick of an axis: its place in pixels and the number at it.
struct Tick {
    double at = 0, value = 0;
};

struct DrawnAxes {
    std::vector<Tick> across = {}, up = {};
    Edges lines = {};  ///< top, bottom of the upright line; left, right of the level one
};

/// Throws std::runtime_error if the picture does not have two axes with two numbers each.
DrawnAxes axes_of(const SvgPicture& picture);

/// The ticks of the upright axis only.
std::vector<Tick> ticks_up(const SvgPicture& picture);

/// A number and the pixel at which it is drawn.
using Pair = Tick;

/// The linear map from numbers to pixels.
struct LinearMap {
    double offset = 0, slope = 0;
    double operator()(double value) const { return offset + slope * value; }
};

/// The linear map that fits the pairs; ticks, which are rounded to whole pixels, count only where
/// the pairs do not determine it.
LinearMap fitted(const std::vector<Tick>& ticks, const std::vector<Pair>& pairs = {});

}  // namespace carom::test
