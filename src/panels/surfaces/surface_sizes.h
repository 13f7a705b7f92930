// How large the parts of the picture of surfaces are, in units: the smallest size of text.
#pragma once

namespace carom {

struct SurfaceSize {
    static constexpr double line = 0.11;    ///< of walls that reflect
    static constexpr double chevron = 0.5;  ///< of joined sides: what reaches out of the box
    static constexpr double thick = 0.2;    ///< of partitions
    static constexpr double bath = 1.0;     ///< depth of a heat bath outside of the box
    static constexpr double bar = 0.6;      ///< thickness of a wall that moves
    static constexpr double hatch = 0.5;    ///< outside of one that is driven or held
    static constexpr double block = 1.2;    ///< for what holds a partition, outside of the box
    static constexpr double arrow = 2.2;    ///< of a force, or of a motion that is imposed
    static constexpr double gravity = 2.4;  ///< width of the column that its arrow stands in
    static constexpr double mark = 1.5;     ///< height of a row of words
};

}  // namespace carom
