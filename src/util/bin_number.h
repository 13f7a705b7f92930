// Which of equal bins a value belongs to. A value that is on an edge but for rounding errors
// belongs to the bin above, so that equal values of a run are never spread over two bins.
#pragma once

#include <cmath>

namespace carom {

/// In widths of a bin: more than the rounding errors of a value in up to 10^5 bins.
inline constexpr double edge_rounding = 1e-9;

/// The number of the bin that holds `place`, a value in widths of a bin above the lower edge of bin
/// 0; negative for values below that.
inline double bin_number(double place) { return std::floor(place + edge_rounding); }

/// The same among `count` bins of which the last includes its upper edge: -1 below them, `count`
/// above them and for NaN.
inline int bin_among(double place, int count) {
    const double moved = place + edge_rounding;
    if (moved < 0.0) return -1;
    if (moved < count) return static_cast<int>(moved);
    return place <= count + edge_rounding ? count - 1 : count;
}

}  // namespace carom
