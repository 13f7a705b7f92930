// The cell list: a grid of cells over the box, each with a list of the particles whose centres lie
// in it. Small disks search the cells around their own, so a cell is at least as wide as the
// contact distance of two small disks. Disks much larger than the others would require cells too
// wide to be useful. They are listed in a separate coarse grid, which every disk searches; they
// themselves search for small disks only in the ring of cells that their rim can touch.
//
// A cell has room for three particles; further ones (points may crowd together) are chained behind
// them. All three are returned by one copy of 16 bytes without a branch, because this is the
// innermost loop. Which cell a particle belongs to is state that the owner changes at each
// crossing; it is never recomputed from the position, whose round-off could put the particle into
// the wrong cell.
//
// Where cells are wider than necessary, neighbouring cells overlap: a disk may extend beyond the
// side of its cell by half of the excess width without another disk touching it undetected. A disk
// that turns back near a border then crosses it less often, which saves a fifth of the time at a
// packing fraction of 0.2.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "physics/box.h"
#include "util/memory/large_pages.h"

namespace carom {

/// Column and row of a cell.
using Cell = std::array<std::uint16_t, 2>;

class CellGrid {
  public:
    /// Creates an empty grid with cell sizes suited to these radii.
    CellGrid(const Box& box, const Eigen::ArrayXd& radii);

    /// Column and row of the last cell, and the size of a cell along each axis.
    const std::array<int, 2>& last_cell() const { return last_cell_; }
    const std::array<double, 2>& cell_size() const { return cell_size_; }

    /// For each axis, whether the box is periodic and so narrow that two images of one disk may
    /// touch another disk.
    const std::array<bool, 2>& narrow() const { return narrow_; }

    /// For each axis, how far the centre of a disk may lie beyond a side of its cell before the
    /// disk must move to the next cell.
    const std::array<double, 2>& overhang() const { return overhang_; }

    /// The cell of a position inside the box.
    Cell cell_at(double x, double y) const;

    /// The cell beyond `side` (left 0, right 1, bottom 2, top 3) of a cell; in a periodic box the
    /// first cell follows the last. Branchless, because the processor could not predict the
    /// branches.
    Cell next_cell(Cell cell, int side) const {
        const auto axis = static_cast<std::size_t>(side / 2);
        const int up = side % 2;
        const int last = last_cell_[axis];
        const int next = cell[axis] + 2 * up - 1;
        const int beyond = (next < 0) | (next > last);
        cell[axis] =
            static_cast<std::uint16_t>((next & (beyond - 1)) | (last & (up - 1) & -beyond));
        return cell;
    }

    /// Whether next_cell() wraps around to the other end of a periodic box.
    bool is_last(Cell cell, int side) const {
        const auto axis = static_cast<std::size_t>(side / 2);
        return cell[axis] == (last_cell_[axis] & -(side % 2));
    }

    void clear();
    void add(std::int32_t particle, double radius, Cell cell);
    void move(std::int32_t particle, double radius, Cell from, Cell to);

    template <class Archive>
    void archive(Archive& archive) {
        archive(last_cell_, narrow_, cell_size_, overhang_, small_radius_, has_large_, plain_,
                inner_, around_, fine_, coarse_, fine_slots_, coarse_slots_, coarse_cell_, next_);
    }

    /// The particles in a cell.
    class Slots {
      public:
        Slots() = default;

        template <class Archive>
        void archive(Archive& archive) {
            archive(particle_, rest_);
        }

      private:
        friend class CellGrid;
        static constexpr std::int32_t most = 3;
        std::array<std::int32_t, most> particle_{};
        /// The lowest two bits hold the count; the others the first particle of the chain plus 1,
        /// or 0 without a chain.
        std::uint32_t rest_ = 0;

        std::int32_t count() const { return static_cast<std::int32_t>(rest_ & 3U); }
        bool has_chain() const { return rest_ > 3U; }
        std::int32_t chain() const { return static_cast<std::int32_t>(rest_ >> 2) - 1; }
        void set_chain(std::int32_t first) {
            rest_ = static_cast<std::uint32_t>(first + 1) << 2 | (rest_ & 3U);
        }
    };

    /// Calls f(slots, shift_x, shift_y) for every cell with disks that could touch a disk of
    /// `radius` in `cell` while both stay in their cells. Adding the shift (0 or plus or minus the
    /// box size) to their positions gives the relevant images. The disk itself is among those
    /// found.
    template <typename Function>
    void for_each_near(double radius, Cell cell, Function&& f) const;

    /// Calls see(j, shift, 0) for the particles of these cells, except i itself, with their shifts.
    /// `list` is overwritten.
    template <typename See>
    void for_each_neighbour(std::int32_t i, double radius, Cell cell,
                            std::vector<std::int32_t>& list, const See& see) const;

    /// As for_each_near(). For a small disk in a grid without large disks, however, only the cells
    /// that came into range when it crossed `side` (left 0, right 1, bottom 2, top 3) of its former
    /// cell into `cell`.
    template <typename Function>
    void for_each_newly_near(double radius, Cell cell, int side, Function&& f) const;

    /// Calls f(slots) for every cell with small disks in the columns (axis 0) or rows from `first`
    /// to `last`, both included, and for every cell with large disks.
    template <typename Function>
    void for_each_in_band(std::size_t axis, int first, int last, Function&& f) const;

    /// Appends the particles of a cell to `list`, whose first `size` entries are in use; there is
    /// always room for `spare` more.
    static constexpr std::size_t spare = 64;
    void append(const Slots& slots, std::vector<std::int32_t>& list, std::size_t& size) const;

    /// Whether this is the simple case for a disk of `radius`: all disks that it may touch are in
    /// the surrounding cells, and only their nearest images matter. Requires a small disk and not
    /// too few cells along a periodic axis.
    bool plain(double radius) const { return plain_ && radius <= small_radius_; }

    /// The range of columns (or rows) around whose cells each particle has only one relevant image:
    /// the first of them and their number.
    struct Inner {
        unsigned first, count;

        template <class Archive>
        void archive(Archive& archive) {
            archive(first, count);
        }
    };
    const std::array<Inner, 2>& inner() const { return inner_; }

    /// Appends all particles in the cells around `cell`, and the large ones nearby; only if
    /// plain().
    void append_around(Cell cell, std::vector<std::int32_t>& list, std::size_t& size) const;

    /// The same, but of the small particles only those that came into range when a disk crossed
    /// `side` of its former cell into `cell`; only if plain().
    void append_newly_around(Cell cell, int side, std::vector<std::int32_t>& list,
                             std::size_t& size) const;

    /// Prefetches the cells that append_around() will read.
    void fetch_around(Cell cell) const;

  private:
    /// The columns (or rows) of one grid, and what follows beyond its ends.
    struct Axis {
        std::int32_t cells;
        bool periodic;
        double length;

        template <class Archive>
        void archive(Archive& archive) {
            archive(cells, periodic, length);
        }
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

    std::int32_t fine_stride() const { return fine_[0].cells + 1; }
    std::size_t fine_index(Cell cell) const {
        return static_cast<std::size_t>(cell[1]) * static_cast<std::size_t>(fine_stride()) +
               cell[0];
    }
    std::size_t coarse_index(Cell cell) const {
        return static_cast<std::size_t>(coarse_cell_[1][cell[1]]) *
                   static_cast<std::size_t>(coarse_[0].cells) +
               static_cast<std::size_t>(coarse_cell_[0][cell[0]]);
    }
    Slots& slots_of(double radius, Cell cell) {
        return radius > small_radius_ ? coarse_slots_[coarse_index(cell)]
                                      : fine_slots_[fine_index(cell)];
    }
    void append_large_around(Cell cell, std::vector<std::int32_t>& list, std::size_t& size) const;
    template <std::size_t Firsts, std::size_t Seconds>
    void append_cells(const std::int64_t* first, const std::int64_t* second,
                      std::vector<std::int32_t>& list, std::size_t& size) const;
    void put_in(std::int32_t particle, Slots& slots);
    void take_out(std::int32_t particle, Slots& slots);
    void append_chain(const Slots& slots, std::vector<std::int32_t>& list, std::size_t& size) const;

    template <typename Function>
    void for_each_in(const LargeVector<Slots>& cells, std::int32_t columns, Wrapped column,
                     Wrapped row, Function&& f) const;
    template <typename Function>
    void for_each_around(const LargeVector<Slots>& cells, const std::array<Axis, 2>& axes,
                         std::int32_t stride, std::int32_t column, std::int32_t row,
                         Function&& f) const;
    template <typename Function>
    void for_each_at_rim(double radius, Cell cell, Function&& f) const;

    std::array<int, 2> last_cell_{};
    std::array<bool, 2> narrow_{};
    std::array<double, 2> cell_size_{}, overhang_{};
    double small_radius_ = 0.0;  ///< disks with a larger one are in the coarse grid
    bool has_large_ = false;
    bool plain_ = false;
    std::array<Inner, 2> inner_{};
    // Offsets of the columns and rows in fine_slots_, from the one before the first to the one
    // after the last. Beyond a wall there is an additional column and row of cells, which stay
    // empty.
    std::array<std::vector<std::int64_t>, 2> around_;
    std::array<Axis, 2> fine_{}, coarse_{};
    LargeVector<Slots> fine_slots_, coarse_slots_;
    std::array<std::vector<std::int32_t>, 2> coarse_cell_;  ///< coarse column or row of each column
                                                            ///< or row of fine cells
    std::vector<std::int32_t> next_;  ///< next particle in the chain, for each particle
};

inline void CellGrid::append(const Slots& slots, std::vector<std::int32_t>& list,
                             std::size_t& size) const {
    std::memcpy(list.data() + size, &slots, sizeof slots);
    size += static_cast<std::size_t>(slots.count());
    if (slots.has_chain()) [[unlikely]]
        append_chain(slots, list, size);
}

// Appends the particles of the cells at first[k] + second[l]. Crowded cells, which have chains, are
// rare: if there is one, everything is done a second time.
template <std::size_t Firsts, std::size_t Seconds>
[[gnu::always_inline]] inline void CellGrid::append_cells(const std::int64_t* first,
                                                          const std::int64_t* second,
                                                          std::vector<std::int32_t>& list,
                                                          std::size_t& size) const {
    // Local copies: as far as the compiler knows, the list might overlap the members.
    std::array<const Slots*, Firsts> row;
    for (std::size_t k = 0; k < Firsts; ++k) row[k] = fine_slots_.data() + first[k];
    std::array<std::int64_t, Seconds> column;
    for (std::size_t l = 0; l < Seconds; ++l) column[l] = second[l];
    std::int32_t* out = list.data() + size;
    std::uint32_t together = 0;
    for (std::size_t k = 0; k < Firsts; ++k) {
        for (std::size_t l = 0; l < Seconds; ++l) {
            const Slots& slots = row[k][column[l]];
            std::memcpy(out, &slots, sizeof slots);
            const std::uint32_t rest = slots.rest_;
            out += rest & 3U;
            together |= rest;
        }
    }
    if (together <= 3U) [[likely]] {
        size = static_cast<std::size_t>(out - list.data());
        return;
    }
    for (std::size_t k = 0; k < Firsts; ++k)
        for (std::size_t l = 0; l < Seconds; ++l)
            append(fine_slots_[static_cast<std::size_t>(first[k] + second[l])], list, size);
}

[[gnu::always_inline]] inline void CellGrid::append_around(Cell cell,
                                                           std::vector<std::int32_t>& list,
                                                           std::size_t& size) const {
    append_cells<3, 3>(&around_[1][cell[1]], &around_[0][cell[0]], list, size);
    if (has_large_) append_large_around(cell, list, size);
}

[[gnu::always_inline]] inline void CellGrid::append_newly_around(Cell cell, int side,
                                                                 std::vector<std::int32_t>& list,
                                                                 std::size_t& size) const {
    const std::array around{&around_[0][cell[0]], &around_[1][cell[1]]};
    const auto axis = static_cast<std::size_t>(side / 2);
    append_cells<1, 3>(around[axis] + (side % 2 == 0 ? 0 : 2), around[1 - axis], list, size);
    if (has_large_) append_large_around(cell, list, size);
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
                               std::int32_t stride, std::int32_t column, std::int32_t row,
                               Function&& f) const {
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
        const Wrapped y = wrap(row + dy, axes[1]);
        if (y.cell < 0) continue;
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
            const Wrapped x = wrap(column + dx, axes[0]);
            if (x.cell >= 0) for_each_in(cells, stride, x, y, f);
        }
    }
}

// A small disk can touch a large one of `radius` only from a cell whose distance is at most the sum
// of radii, and never from a cell that lies entirely under the large disk, allowing for the
// overhang of both.
template <typename Function>
void CellGrid::for_each_at_rim(double radius, Cell cell, Function&& f) const {
    const double reach = (radius + small_radius_) * (1.0 + 1e-9);
    const double inside = radius * (1.0 - 1e-9);
    const auto chord = [](double r, double y) { return std::sqrt(std::max(0.0, r * r - y * y)); };
    const double hang_x = 2.0 * overhang_[0], hang_y = 2.0 * overhang_[1];
    const int most_rows =
        std::min(static_cast<int>((reach + hang_y) / cell_size_[1]) + 1, fine_[1].cells);
    for (int dy = -most_rows; dy <= most_rows; ++dy) {
        const Wrapped y = wrap(cell[1] + dy, fine_[1]);
        const double least = std::max(0.0, (std::abs(dy) - 1) * cell_size_[1] - hang_y);
        if (y.cell < 0 || least > reach) continue;
        const int outer = std::min(
            static_cast<int>((chord(reach, least) + hang_x) / cell_size_[0]) + 1, fine_[0].cells);
        const double most = (std::abs(dy) + 1) * cell_size_[1] + hang_y;
        const int inner = most < inside
                              ? static_cast<int>((chord(inside, most) - hang_x) / cell_size_[0]) - 1
                              : -1;
        for (int dx = -outer; dx <= outer; ++dx) {
            if (std::abs(dx) <= inner) dx = inner + 1;
            if (dx > outer) break;
            const Wrapped x = wrap(cell[0] + dx, fine_[0]);
            if (x.cell >= 0) for_each_in(fine_slots_, fine_stride(), x, y, f);
        }
    }
}

template <typename Function>
void CellGrid::for_each_near(double radius, Cell cell, Function&& f) const {
    if (has_large_)
        for_each_around(coarse_slots_, coarse_, coarse_[0].cells, coarse_cell_[0][cell[0]],
                        coarse_cell_[1][cell[1]], f);
    if (radius > small_radius_)
        for_each_at_rim(radius, cell, f);
    else
        for_each_around(fine_slots_, fine_, fine_stride(), cell[0], cell[1], f);
}

template <typename See>
void CellGrid::for_each_neighbour(std::int32_t i, double radius, Cell cell,
                                  std::vector<std::int32_t>& list, const See& see) const {
    for_each_near(radius, cell, [&](const Slots& slots, double shift_x, double shift_y) {
        std::size_t count = 0;
        append(slots, list, count);
        for (std::size_t k = 0; k < count; ++k)
            if (list[k] != i) see(list[k], std::array<double, 2>{shift_x, shift_y}, 0);
    });
}

template <typename Function>
void CellGrid::for_each_newly_near(double radius, Cell cell, int side, Function&& f) const {
    if (has_large_) {
        for_each_near(radius, cell, f);
        return;
    }
    const int ahead = side % 2 == 0 ? -1 : 1;
    for (int across = -1; across <= 1; ++across) {
        const Wrapped x = wrap(cell[0] + (side < 2 ? ahead : across), fine_[0]);
        const Wrapped y = wrap(cell[1] + (side < 2 ? across : ahead), fine_[1]);
        if (x.cell >= 0 && y.cell >= 0) for_each_in(fine_slots_, fine_stride(), x, y, f);
    }
}

template <typename Function>
void CellGrid::for_each_in_band(std::size_t axis, int first, int last, Function&& f) const {
    for (int k = first; k <= last; ++k) {
        for (int l = 0; l <= last_cell_[1 - axis]; ++l) {
            Cell in_band{};
            in_band[axis] = static_cast<std::uint16_t>(k);
            in_band[1 - axis] = static_cast<std::uint16_t>(l);
            f(fine_slots_[fine_index(in_band)]);
        }
    }
    for (const Slots& slots : coarse_slots_) f(slots);
}

}  // namespace carom
