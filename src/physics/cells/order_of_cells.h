// The order of bodies in memory: along a Z-order curve through their cells, so that those close to
// each other in the box are close to each other in memory.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "physics/cells/cell_grid.h"

namespace carom {

/// With fewer bodies than this, all fit into the nearest caches of the processor in any order.
inline constexpr std::size_t least_in_order_of_cells = 4096;

/// The place of a cell on that curve, in 32 bits. In the plane it takes all bits of a column and a
/// row, in space the upper ten of those that are in use.
constexpr std::uint64_t place_on_curve(const CellOf<2>& cell, const std::array<int, 2>&) {
    const auto spread = [](std::uint64_t bits) {  // a zero between each two
        bits = (bits | bits << 8) & 0x00FF00FFU;
        bits = (bits | bits << 4) & 0x0F0F0F0FU;
        bits = (bits | bits << 2) & 0x33333333U;
        return (bits | bits << 1) & 0x55555555U;
    };
    return spread(cell[0]) | spread(cell[1]) << 1;
}
constexpr std::uint64_t place_on_curve(const CellOf<3>& cell, const std::array<int, 3>& last) {
    const auto spread = [](std::uint64_t bits) {  // two zeros between each two
        bits = (bits | bits << 16) & 0x030000FFU;
        bits = (bits | bits << 8) & 0x0300F00FU;
        bits = (bits | bits << 4) & 0x030C30C3U;
        return (bits | bits << 2) & 0x09249249U;
    };
    const auto most = static_cast<unsigned>(std::max({last[0], last[1], last[2]}));
    const int unused = std::max(0, static_cast<int>(std::bit_width(most)) - 10);
    return spread(static_cast<unsigned>(cell[0]) >> unused) |
           spread(static_cast<unsigned>(cell[1]) >> unused) << 1 |
           spread(static_cast<unsigned>(cell[2]) >> unused) << 2;
}

/// The numbers of the bodies in that order; unchanged if there are few. `origin` is the lower
/// corner of the grid.
template <int Dimension, typename Bodies>
std::vector<std::int32_t> order_of_cells(
    const CellGrid<Dimension>& grid,
    const std::array<double, static_cast<std::size_t>(Dimension)>& origin, const Bodies& bodies) {
    std::vector<std::int32_t> numbers(bodies.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    if (bodies.size() < least_in_order_of_cells) return numbers;
    std::vector<std::uint64_t> keys(bodies.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        auto x = origin;
        for (std::size_t a = 0; a < x.size(); ++a)
            x[a] = static_cast<double>(bodies[k].x[a]) - origin[a];
        keys[k] = place_on_curve(grid.cell_at(x), grid.last_cell()) << 32 | k;
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t k = 0; k < keys.size(); ++k)
        numbers[k] = static_cast<std::int32_t>(keys[k] & 0xFFFFFFFFU);
    return numbers;
}

/// Renumbers the partners of predicted contacts: particle k is the one that had the number
/// before[k]. Negative numbers do not denote particles and are kept.
template <typename Bodies>
void renumber_partners(Bodies& bodies, const std::vector<std::int32_t>& before) {
    std::vector<std::int32_t> now(before.size());
    for (std::size_t k = 0; k < before.size(); ++k)
        now[static_cast<std::size_t>(before[k])] = static_cast<std::int32_t>(k);
    for (auto& body : bodies)
        if (std::int32_t& partner = body.prediction.partner; partner >= 0)
            partner = now[static_cast<std::size_t>(partner)];
}

}  // namespace carom
