// The order of disks in memory: along a Z-order curve through their cells, so that disks close to
// each other in the box are close to each other in memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "physics/plane/cell_grid.h"

namespace carom {

/// With fewer disks than this, all fit into the nearest caches of the processor in any order.
inline constexpr std::size_t least_in_order_of_cells = 4096;

/// The bits of a number, with a zero between each two.
constexpr std::uint64_t spread_bits(std::uint64_t bits) {
    bits = (bits | bits << 8) & 0x00FF00FFU;
    bits = (bits | bits << 4) & 0x0F0F0F0FU;
    bits = (bits | bits << 2) & 0x33333333U;
    return (bits | bits << 1) & 0x55555555U;
}

/// The numbers of the disks in that order; unchanged if there are few disks. `origin` is the lower
/// left corner of the grid.
template <typename Bodies>
std::vector<std::int32_t> order_of_cells(const CellGrid& grid, const std::array<double, 2>& origin,
                                         const Bodies& bodies) {
    std::vector<std::int32_t> numbers(bodies.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    if (bodies.size() < least_in_order_of_cells) return numbers;
    std::vector<std::uint64_t> keys(bodies.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const Cell cell = grid.cell_at(static_cast<double>(bodies[k].x[0]) - origin[0],
                                       static_cast<double>(bodies[k].x[1]) - origin[1]);
        keys[k] = (spread_bits(cell[0]) | spread_bits(cell[1]) << 1) << 32 | k;
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t k = 0; k < keys.size(); ++k)
        numbers[k] = static_cast<std::int32_t>(keys[k] & 0xFFFFFFFFU);
    return numbers;
}

/// Renumbers the partners of predicted contacts: particle k is the one that had the number
/// before[k]. Negative numbers do not denote disks and are kept.
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
