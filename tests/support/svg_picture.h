// Reads the shapes and letters of an SVG written by Cairo (1.16 or 1.18), in the coordinates of the
// picture. Shares no code with the drawing.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace carom::test {

struct Spot {
    double x = 0, y = 0;
};

struct Edges {
    double left = 0, top = 0, right = 0, bottom = 0;
    Spot middle() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

/// Red, green and blue from 0 to 255, and alpha from 0 to 1.
using Paint = std::array<double, 4>;

/// The commands of a path and its points: one for each M and L, three for each C, none for Z.
struct Outline {
    std::string commands;
    std::vector<Spot> points;

    Edges edges() const;
};

struct Circle {
    Spot middle;
    double radius = 0;
};

/// A path that is filled or stroked.
struct Shape {
    bool is_stroke = false;
    double width = 0;  ///< of a stroke
    Paint paint = {};
    std::vector<Outline> pieces;     ///< the subpaths
    std::optional<Edges> clip = {};  ///< outside of which nothing of it is seen

    /// The axis-aligned rectangle that this shape is, ignoring the points that Cairo adds to close
    /// it; none for other shapes.
    std::optional<Edges> rectangle() const;
    /// The full circle, drawn as arcs, that this shape is; none for other shapes.
    std::optional<Circle> circle() const;
    /// The corners of a single subpath of straight lines; empty for other shapes.
    std::vector<Spot> corners() const;
};

struct Letter {
    Outline outline;  ///< relative to the start of the baseline
    Spot at;
};

/// Consecutive letters of one colour.
struct Letters {
    std::vector<Letter> all;
    Paint paint = {};

    Edges edges() const;  ///< of the ink
};

struct SvgPicture {
    double width = 0, height = 0;
    std::vector<Shape> shapes;  ///< in the order in which they are drawn
    std::vector<Letters> texts;
};

/// Throws std::runtime_error if the file has something that this reader does not know.
SvgPicture svg_picture(const std::filesystem::path& file);
SvgPicture svg_picture(const std::string& document);

}  // namespace carom::test
