// Which particles are near which: a grid of cells over the box, each with a list of the particles
// whose centres are in it. Small disks look at the cells around their own, so a cell is at least as
// wide as two small disks that touch. Disks much larger than the others would make such cells
// useless: they are listed in a coarse grid of their own, which every disk looks at, and look
// for small ones only in the ring of cells that their rim can touch.
// A cell has room for three particles; more (points may crowd) are chained behind them. All three
// are handed out with one copy of 16 bytes and no branch, which matters: this is the innermost
// loop. Membership is a state that the owner changes at each crossing; it is never recomputed from
// positions, whose round-off could put a particle into the wrong cell.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "physics/gas.h"
#include "util/large_pages.h"

namespace carom {

/// Column and row of a cell.
struct Cell {
    std::uint16_t column = 0, row = 0;
};

class CellGrid {
  public:
    /// A grid suited to disks of these radii in `box`.
    CellGrid(const Box& box, const Eigen::ArrayXd& radii);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    double cell_width() const { return width_; }
    double cell_height() const { return height_; }

    /// The cell of a position inside the box.
    Cell cell_at(double x, double y) const;

    void clear();
    void add(std::int32_t particle, double radius, Cell cell);
    void move(std::int32_t particle, double radius, Cell from, Cell to);

    /// What a cell holds.
    class Slots {
      public:
        Slots() = default;

      private:
        friend class CellGrid;
        static constexpr std::int32_t most = 3;
        std::array<std::int32_t, most> particle_{};
        std::int32_t rest_ = 0;  ///< how many; if more than `most`: `most` + 1 + the chain's first
    };

    /// Calls f(slots, shift_x, shift_y) for every cell with disks that could touch one of `radius`
    /// while both stay in their cells; the shift (0 or plus or minus the box) takes them to the
    /// images meant. The particle itself is among them.
    template <typename Function>
    void for_each_near(double radius, Cell cell, Function&& f) const;

    /// As for_each_near, but, of a small disk without large ones about, only those that came near
    /// when it crossed `side` (left 0, right 1, bottom 2, top 3) of a cell into `cell`.
    template <typename Function>
    void for_each_newly_near(double radius, Cell cell, int side, Function&& f) const;

    /// Appends the particles of a cell to `list`, of which `size` entries are used; there is always
    /// room for `spare` more.
    static constexpr std::size_t spare = 64;
    void append(const Slots& slots, std::vector<std::int32_t>& list, std::size_t& size) const;

    /// Appends at once all that for_each_near() would hand out, false (and nothing done) where that
    /// is not simply the 9 cells around: at the edge of the box, or with large disks about.
    bool append_around(double radius, Cell cell, std::vector<std::int32_t>& list,
                       std::size_t& size) const;

    /// Asks the processor for the cells around one, which will be looked at soon.
    void fetch_ahead(Cell cell) const;

  private:
    /// Columns (or rows) of one grid and what lies beyond its ends.
    struct Axis {
        std::int32_t cells;
        bool periodic;
        double length;
    };
    struct Wrapped {
        std::int32_t cell;  ///< -1 beyond a wall
        double shift;
    };
    static Wrapped wrap(std::int32_t cell, const Axis& axis) {
        if (cell >= 0 && cell < axis.cells) return {cell, 0.0};
        if (!axis.periodic) return {-1, 0.0};
        return cell < 0 ? Wrapped{cell + axis.cells, -axis.length}
                        : Wrapped{cell - axis.cells, axis.length};
    }

    std::size_t fine_index(Cell cell) const {
        return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns_) +
               cell.column;
    }
    std::size_t coarse_index(Cell cell) const {
        return static_cast<std::size_t>(coarse_row_[cell.row]) *
                   static_cast<std::size_t>(coarse_[0].cells) +
               static_cast<std::size_t>(coarse_column_[cell.column]);
    }
    Slots& slots_of(double radius, Cell cell) {
        return radius > small_radius_ ? coarse_slots_[coarse_index(cell)]
                                      : fine_slots_[fine_index(cell)];
    }
    void put_in(std::int32_t particle, Slots& slots);
    void take_out(std::int32_t particle, Slots& slots);
    void append_chain(const Slots& slots, std::vector<std::int32_t>& list, std::size_t& size) const;

    template <typename Function>
    void for_each_in(const LargeVector<Slots>& cells, std::int32_t columns, Wrapped column,
                     Wrapped row, Function&& f) const;
    template <typename Function>
    void for_each_around(const LargeVector<Slots>& cells, const std::array<Axis, 2>& axes,
                         std::int32_t column, std::int32_t row, Function&& f) const;
    template <typename Function>
    void for_each_at_rim(double radius, Cell cell, Function&& f) const;

    int columns_ = 1, rows_ = 1;
    double width_ = 0.0, height_ = 0.0;
    double small_radius_ = 0.0;  ///< disks with a larger one are in the coarse grid
    bool has_large_ = false;
    std::array<Axis, 2> fine_{}, coarse_{};
    LargeVector<Slots> fine_slots_, coarse_slots_;
    std::vector<std::int32_t> coarse_column_, coarse_row_;  ///< of each column, row of fine cells
    std::vector<std::int32_t> next_;                        ///< of each particle in a chain
};

inline void CellGrid::append(const Slots& slots, std::vector<std::int32_t>& list,
                             std::size_t& size) const {
    std::memcpy(list.data() + size, &slots, sizeof slots);
    if (slots.rest_ > Slots::most) [[unlikely]] {
        append_chain(slots, list, size);
        return;
    }
    size += static_cast<std::size_t>(slots.rest_);
}

inline bool CellGrid::append_around(double radius, Cell cell, std::vector<std::int32_t>& list,
                                    std::size_t& size) const {
    if (has_large_ || radius > small_radius_ || cell.column == 0 || cell.row == 0 ||
        cell.column + 1 >= columns_ || cell.row + 1 >= rows_)
        return false;
    const Slots* const middle = &fine_slots_[fine_index(cell)];
    std::int32_t* const out = list.data();
    std::size_t used = size;
    std::int32_t fullest = 0;
    for (std::ptrdiff_t dy = -columns_; dy <= columns_; dy += columns_)
        for (std::ptrdiff_t dx = -1; dx <= 1; ++dx) {
            const Slots& slots = middle[dy + dx];
            std::memcpy(out + used, &slots, sizeof slots);
            used += static_cast<std::size_t>(std::min(slots.rest_, Slots::most));
            fullest |= slots.rest_;
        }
    if (fullest > Slots::most) [[unlikely]]
        return false;
    size = used;
    return true;
}

template <typename Function>
void CellGrid::for_each_in(const LargeVector<Slots>& cells, std::int32_t columns, Wrapped column,
                           Wrapped row, Function&& f) const {
    const std::size_t cell =
        static_cast<std::size_t>(row.cell) * static_cast<std::size_t>(columns) +
        static_cast<std::size_t>(column.cell);
    f(cells[cell], column.shift, row.shift);
}

template <typename Function>
void CellGrid::for_each_around(const LargeVector<Slots>& cells, const std::array<Axis, 2>& axes,
                               std::int32_t column, std::int32_t row, Function&& f) const {
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
        const Wrapped y = wrap(row + dy, axes[1]);
        if (y.cell < 0) continue;
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
            const Wrapped x = wrap(column + dx, axes[0]);
            if (x.cell >= 0) for_each_in(cells, axes[0].cells, x, y, f);
        }
    }
}

// A small disk can touch one of `radius` only from a cell that comes as near as the sum of radii,
// and never from one that lies wholly under the large disk.
template <typename Function>
void CellGrid::for_each_at_rim(double radius, Cell cell, Function&& f) const {
    const double reach = (radius + small_radius_) * (1.0 + 1e-9);
    const double inside = radius * (1.0 - 1e-9);
    const auto chord = [](double r, double y) { return std::sqrt(std::max(0.0, r * r - y * y)); };
    const int most_rows = std::min(static_cast<int>(reach / height_) + 1, rows_);
    for (int dy = -most_rows; dy <= most_rows; ++dy) {
        const Wrapped y = wrap(cell.row + dy, fine_[1]);
        const double least = std::max(0, std::abs(dy) - 1) * height_;
        if (y.cell < 0 || least > reach) continue;
        const int outer = std::min(static_cast<int>(chord(reach, least) / width_) + 1, columns_);
        const double most = (std::abs(dy) + 1) * height_;
        const int inner = most < inside ? static_cast<int>(chord(inside, most) / width_) - 1 : -1;
        for (int dx = -outer; dx <= outer; ++dx) {
            if (std::abs(dx) <= inner) dx = inner + 1;
            if (dx > outer) break;
            const Wrapped x = wrap(cell.column + dx, fine_[0]);
            if (x.cell >= 0) for_each_in(fine_slots_, columns_, x, y, f);
        }
    }
}

template <typename Function>
void CellGrid::for_each_near(double radius, Cell cell, Function&& f) const {
    if (has_large_)
        for_each_around(coarse_slots_, coarse_, coarse_column_[cell.column], coarse_row_[cell.row],
                        f);
    if (radius > small_radius_)
        for_each_at_rim(radius, cell, f);
    else
        for_each_around(fine_slots_, fine_, cell.column, cell.row, f);
}

template <typename Function>
void CellGrid::for_each_newly_near(double radius, Cell cell, int side, Function&& f) const {
    if (has_large_) {
        for_each_near(radius, cell, f);
        return;
    }
    const int ahead = side % 2 == 0 ? -1 : 1;
    for (int across = -1; across <= 1; ++across) {
        const Wrapped x = wrap(cell.column + (side < 2 ? ahead : across), fine_[0]);
        const Wrapped y = wrap(cell.row + (side < 2 ? across : ahead), fine_[1]);
        if (x.cell >= 0 && y.cell >= 0) for_each_in(fine_slots_, columns_, x, y, f);
    }
}

}  // namespace carom
