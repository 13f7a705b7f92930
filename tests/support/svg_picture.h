// Reads back what an SVG of Cairo (1.16 or 1.18) draws: shapes and letters in the picture's own
// coordinates. Shares no code with what draws them.
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

/// Commands of a path, and its points: one of M and L, three of C, none of Z.
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
    std::vector<Outline> pieces;  ///< of its path

    /// A rectangle with level sides, without what Cairo adds to close it; none otherwise.
    std::optional<Edges> rectangle() const;
    /// A whole circle of arcs; none otherwise.
    std::optional<Circle> circle() const;
    /// The corners of a path of straight lines in one piece; none otherwise.
    std::vector<Spot> corners() const;
};

struct Letter {
    Outline outline;  ///< from the baseline's start
    Spot at;
};

/// Letters that follow each other in one colour.
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

/// Throws std::runtime_error where the file has something that this reader does not know.
SvgPicture svg_picture(const std::filesystem::path& file);
SvgPicture svg_picture(const std::string& document);

}  // namespace carom::test
