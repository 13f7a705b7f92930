// Figures that the program has drawn, with their tables; and the axes in their pictures.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "readback/alphabet.h"
#include "support/svg_picture.h"

namespace carom::test {

using Row = std::map<std::string, std::string>;  ///< by column

struct DrawnFigure {
    std::string name;
    SvgPicture picture;
    std::vector<Row> table = {};  ///< empty: the figure has none
};

/// All figures of a set, as `carom figures` writes them.
std::map<std::string, DrawnFigure> figures_of(const std::filesystem::path& set);

/// The last so many samples of a run, one of each particle.
std::vector<Row> samples_of(const std::filesystem::path& scene, std::size_t count);

/// The rows of a part of the picture.
std::vector<Row> rows_of(const DrawnFigure& figure, const std::string& part);

double number(const Row& row, const std::string& column);

/// What a text says, and where its ink is.
struct Said {
    std::string words;
    Edges ink;
};
std::vector<Said> texts_of(const SvgPicture& picture);

/// A mark of an axis and the number at it.
struct Tick {
    double at = 0, value = 0;
};

struct DrawnAxes {
    std::vector<Tick> across = {}, up = {};
    Edges lines = {};  ///< from the ends of the upright line, and those of the level one
};

/// Throws std::runtime_error where there are no two axes with two numbers each.
DrawnAxes axes_of(const SvgPicture& picture);

/// The upright axis alone.
std::vector<Tick> ticks_up(const SvgPicture& picture);

/// A number is at a pixel.
using Pair = Tick;

/// What is linear in the numbers, between ticks and what is drawn: the line through all.
struct LinearMap {
    double offset = 0, slope = 0;
    double operator()(double value) const { return offset + slope * value; }
};

/// Through the pairs; ticks, which lie on whole pixels, count where pairs leave it open.
LinearMap fitted(const std::vector<Tick>& ticks, const std::vector<Pair>& pairs = {});

}  // namespace carom::test
