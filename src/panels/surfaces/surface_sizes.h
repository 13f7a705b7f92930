// The sizes of the parts of the picture of surfaces, in units (1 unit: the smallest size of text).
#pragma once

namespace carom {

struct SurfaceSize {
    static constexpr double line = 0.11;    ///< of walls that reflect
    static constexpr double chevron = 0.5;  ///< of periodic sides: the part outside of the box
    static constexpr double thick = 0.2;    ///< of partitions
    static constexpr double teeth = 0.5;    ///< depth of those of a diffuse wall, with its line
    static constexpr double bath = 1.0;     ///< depth of a heat bath outside of the box
    static constexpr double bar = 0.6;      ///< thickness of a wall that moves
    static constexpr double hatch = 0.5;    ///< outside of a wall that is driven or held
    static constexpr double block = 1.2;    ///< of the holder of a partition, outside of the box
    static constexpr double arrow = 2.2;    ///< of a force, or of an imposed motion
    static constexpr double gravity = 2.4;  ///< width of the column of its arrow
    static constexpr double label = 1.5;    ///< height of a row of words
};

}  // namespace carom
