// The cell list: a grid of cells over the box, each with a list of the particles whose centres lie
// in it. Small particles search the cells around their own, so a cell is at least as wide as the
// contact distance of two small ones. Particles much larger than the others would require cells too
// wide to be useful. They are listed in a separate coarse grid, which every particle searches; they
// themselves search for small ones only in the ring or shell of cells that their rim can touch.
//
// A cell has room for three particles; further ones (points may crowd together) are chained behind
// them. All three are returned by one copy of 16 bytes without a branch, because this is the
// innermost loop. Which cell a particle belongs to is state that the owner changes at each
// crossing; it is never recomputed from the position, whose round-off could put the particle into
// the wrong cell.
//
// Where cells are wider than necessary, neighbouring cells overlap: a particle may extend beyond
// the side of its cell by half of the excess width without another touching it undetected. A
// particle that turns back near a border then crosses it less often, which saves a fifth of the
// time of disks at a packing fraction of 0.2.
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

/// The place of a cell among the others along each axis: column, row and, in space, layer.
template <int Dimension>
using CellOf = std::array<std::uint16_t, static_cast<std::size_t>(Dimension)>;

template <int Dimension>
class CellGrid {
    static constexpr std::size_t axes = static_cast<std::size_t>(Dimension);

  public:
    using Cell = CellOf<Dimension>;
    using Shift = std::array<double, axes>;

    /// Creates an empty grid with cell sizes suited to these radii.
    CellGrid(const Box& box, const Eigen::ArrayXd& radii);

    /// The last cell, and the size of a cell along each axis.
    const std::array<int, axes>& last_cell() const { return last_cell_; }
    const std::array<double, axes>& cell_size() const { return cell_size_; }

    /// For each axis, whether the box is periodic and so narrow that two images of one particle may
    /// touch another.
    const std::array<bool, axes>& narrow() const { return narrow_; }

    /// For each axis, how far the centre of a particle may lie beyond a side of its cell before the
    /// particle must move to the next cell.
    const std::array<double, axes>& overhang() const { return overhang_; }

    /// The cell of a position, and its number along one axis; outside the box the outermost one.
    Cell cell_at(const std::array<double, axes>& x) const;
    std::uint16_t cell_along(std::size_t axis, double x) const {
        return static_cast<std::uint16_t>(std::clamp(std::floor(x / cell_size_[axis]), 0.0,
                                                     static_cast<double>(last_cell_[axis])));
    }

    /// The cell beyond a side of a cell (numbered as Side: left 0, right 1, bottom 2, top 3, ...);
    /// in a periodic box the first cell follows the last. Branchless, because the processor could
    /// not predict the branches.
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

    /// Calls f(slots, shift) for every cell with particles that could touch one of `radius` in
    /// `cell` while both stay in their cells. Adding the shift (0 or plus or minus the box size) to
    /// their positions gives the relevant images. The particle itself is among those found.
    template <typename Function>
    void for_each_near(double radius, Cell cell, Function&& f) const;

    /// Calls see(j, shift, 0) for the particles of these cells, except i itself, with their shifts.
    /// `list` is overwritten.
    template <typename See>
    void for_each_neighbour(std::int32_t i, double radius, Cell cell,
                            std::vector<std::int32_t>& list, const See& see) const;

    /// As for_each_near(). For a small particle in a grid without large ones, however, only the
    /// cells that came into range when it crossed `side` of its former cell into `cell`.
    template <typename Function>
    void for_each_newly_near(double radius, Cell cell, int side, Function&& f) const;

    /// Calls f(slots) for every cell with small particles whose place along `axis` is from `first`
    /// to `last`, both included, and for every cell with large ones.
    template <typename Function>
    void for_each_in_band(std::size_t axis, int first, int last, Function&& f) const;

    /// Appends the particles of a cell to `list`, whose first `size` entries are in use; there is
    /// always room for `spare` more.
    static constexpr std::size_t spare = Dimension == 2 ? 64 : 192;
    void append(const Slots& slots, std::vector<std::int32_t>& list, std::size_t& size) const;

    /// Whether this is the simple case for a particle of `radius`: all that it may touch are in the
    /// surrounding cells, and only their nearest images matter. Requires a small particle and not
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
    const std::array<Inner, axes>& inner() const { return inner_; }

    /// Appends all particles in the cells around `cell`, and the large ones nearby; only if
    /// plain().
    void append_around(Cell cell, std::vector<std::int32_t>& list, std::size_t& size) const;

    /// The same, but of the small particles only those that came into range when one crossed
    /// `side` of its former cell into `cell`; only if plain().
    void append_newly_around(Cell cell, int side, std::vector<std::int32_t>& list,
                             std::size_t& size) const;

    /// Prefetches the cells that append_around() will read.
    void fetch_around(Cell cell) const;

  private:
    /// The cells of one grid along an axis, and what follows beyond its ends.
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

    /// One grid: its cells along each axis, and the distance in memory of two neighbours along it.
    struct Lattice {
        std::array<Axis, axes> along{};
        std::array<std::int64_t, axes> stride{};

        template <class Archive>
        void archive(Archive& archive) {
            archive(along, stride);
        }
    };
    /// A cell of a lattice, by its place along each axis, which may lie beyond the ends.
    using Place = std::array<std::int32_t, axes>;

    static Place fine_place(Cell cell) {
        Place place;
        for (std::size_t a = 0; a < axes; ++a) place[a] = cell[a];
        return place;
    }
    Place coarse_place(Cell cell) const {
        Place place;
        for (std::size_t a = 0; a < axes; ++a) place[a] = coarse_cell_[a][cell[a]];
        return place;
    }
    static std::size_t index_of(const Lattice& lattice, const Place& place) {
        std::int64_t index = place[0];
        for (std::size_t a = 1; a < axes; ++a) index += lattice.stride[a] * place[a];
        return static_cast<std::size_t>(index);
    }
    Slots& slots_of(double radius, Cell cell) {
        return radius > small_radius_ ? coarse_slots_[index_of(coarse_, coarse_place(cell))]
                                      : fine_slots_[index_of(fine_, fine_place(cell))];
    }
    void append_large_around(Cell cell, std::vector<std::int32_t>& list, std::size_t& size) const;
    template <std::size_t Firsts, std::size_t Seconds>
    void append_cells(const std::int64_t* first, const std::int64_t* second,
                      std::vector<std::int32_t>& list, std::size_t& size) const;
    template <std::size_t Seconds, std::size_t Thirds>
    static std::array<std::int64_t, Seconds * Thirds> sums_of(const std::int64_t* second,
                                                              const std::int64_t* third);
    void put_in(std::int32_t particle, Slots& slots);
    void take_out(std::int32_t particle, Slots& slots);
    void append_chain(const Slots& slots, std::vector<std::int32_t>& list, std::size_t& size) const;

    /// A cell that has been found along some of the axes: its index, and its shift.
    struct Found {
        std::int64_t index = 0;
        Shift shift{};
    };
    template <std::size_t Axis, typename Range, typename Function>
    static void for_each_within(const LargeVector<Slots>& cells, const Lattice& lattice,
                                const Place& center, const Found& found, const Range& range,
                                Function& f);
    template <typename Function>
    void for_each_around(const LargeVector<Slots>& cells, const Lattice& lattice,
                         const Place& center, Function&& f) const;
    template <std::size_t Axis, typename Function>
    void for_each_at_rim(double radius, const Place& center, const Found& found,
                         double least_square, double most_square, Function& f) const;

    std::array<int, axes> last_cell_{};
    std::array<bool, axes> narrow_{};
    std::array<double, axes> cell_size_{}, overhang_{};
    double small_radius_ = 0.0;  ///< particles with a larger one are in the coarse grid
    bool has_large_ = false;
    bool plain_ = false;
    std::array<Inner, axes> inner_{};
    // Offsets of the cells along each axis in fine_slots_, from the one before the first to the one
    // after the last. Beyond a wall there is an additional column, row or layer of cells, which
    // stay empty.
    std::array<std::vector<std::int64_t>, axes> around_;
    Lattice fine_{}, coarse_{};
    LargeVector<Slots> fine_slots_, coarse_slots_;
    std::array<std::vector<std::int32_t>, axes> coarse_cell_;  ///< of each fine cell along an axis
    std::vector<std::int32_t> next_;  ///< next particle in the chain, for each particle
};

template <int Dimension>
inline void CellGrid<Dimension>::append(const Slots& slots, std::vector<std::int32_t>& list,
                                        std::size_t& size) const {
    std::memcpy(list.data() + size, &slots, sizeof slots);
    size += static_cast<std::size_t>(slots.count());
    if (slots.has_chain()) [[unlikely]]
        append_chain(slots, list, size);
}

// Appends the particles of the cells at first[k] + second[l]. Crowded cells, which have chains, are
// rare: if there is one, everything is done a second time.
template <int Dimension>
template <std::size_t Firsts, std::size_t Seconds>
[[gnu::always_inline]] inline void CellGrid<Dimension>::append_cells(
    const std::int64_t* first, const std::int64_t* second, std::vector<std::int32_t>& list,
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

// The sums of each of the thirds and each of the seconds.
template <int Dimension>
template <std::size_t Seconds, std::size_t Thirds>
[[gnu::always_inline]] inline std::array<std::int64_t, Seconds * Thirds>
CellGrid<Dimension>::sums_of(const std::int64_t* second, const std::int64_t* third) {
    std::array<std::int64_t, Seconds * Thirds> sums;
    for (std::size_t k = 0; k < Thirds; ++k)
        for (std::size_t l = 0; l < Seconds; ++l) sums[k * Seconds + l] = third[k] + second[l];
    return sums;
}

template <int Dimension>
[[gnu::always_inline]] inline void CellGrid<Dimension>::append_around(
    Cell cell, std::vector<std::int32_t>& list, std::size_t& size) const {
    if constexpr (Dimension == 2) {
        append_cells<3, 3>(&around_[1][cell[1]], &around_[0][cell[0]], list, size);
    } else {
        const auto rows = sums_of<3, 3>(&around_[1][cell[1]], &around_[2][cell[2]]);
        append_cells<9, 3>(rows.data(), &around_[0][cell[0]], list, size);
    }
    if (has_large_) append_large_around(cell, list, size);
}

template <int Dimension>
[[gnu::always_inline]] inline void CellGrid<Dimension>::append_newly_around(
    Cell cell, int side, std::vector<std::int32_t>& list, std::size_t& size) const {
    std::array<const std::int64_t*, axes> around;
    for (std::size_t a = 0; a < axes; ++a) around[a] = &around_[a][cell[a]];
    const auto axis = static_cast<std::size_t>(side / 2);
    const std::int64_t* ahead = around[axis] + (side % 2 == 0 ? 0 : 2);
    if constexpr (Dimension == 2) {
        append_cells<1, 3>(ahead, around[1 - axis], list, size);
    } else {
        // the lower one first, along which cells are closer to each other in memory
        const auto [second, third] = other_axes(axis);
        const auto rows = sums_of<1, 3>(ahead, around[third]);
        append_cells<3, 3>(rows.data(), around[second], list, size);
    }
    if (has_large_) append_large_around(cell, list, size);
}

// Calls f for the cells that lie, along this axis and the lower ones, at the distances from the
// center that range(axis) gives: the first and the last.
template <int Dimension>
template <std::size_t Axis, typename Range, typename Function>
void CellGrid<Dimension>::for_each_within(const LargeVector<Slots>& cells, const Lattice& lattice,
                                          const Place& center, const Found& found,
                                          const Range& range, Function& f) {
    const auto [first, last] = range(Axis);
    for (std::int32_t d = first; d <= last; ++d) {
        const Wrapped at = wrap(center[Axis] + d, lattice.along[Axis]);
        if (at.cell < 0) continue;
        Found here = found;
        here.index += lattice.stride[Axis] * at.cell;
        here.shift[Axis] = at.shift;
        if constexpr (Axis == 0)
            f(cells[static_cast<std::size_t>(here.index)], here.shift);
        else
            for_each_within<Axis - 1>(cells, lattice, center, here, range, f);
    }
}

template <int Dimension>
template <typename Function>
void CellGrid<Dimension>::for_each_around(const LargeVector<Slots>& cells, const Lattice& lattice,
                                          const Place& center, Function&& f) const {
    const auto next = [](std::size_t) { return std::array<std::int32_t, 2>{-1, 1}; };
    for_each_within<axes - 1>(cells, lattice, center, Found(), next, f);
}

// A small particle can touch a large one of `radius` only from a cell whose distance is at most the
// sum of radii, and never from a cell that lies entirely under the large one, allowing for the
// overhang of both. `least_square`, `most_square`: squares of the least and the greatest distance
// along the axes above.
template <int Dimension>
template <std::size_t Axis, typename Function>
void CellGrid<Dimension>::for_each_at_rim(double radius, const Place& center, const Found& found,
                                          double least_square, double most_square,
                                          Function& f) const {
    const double reach = (radius + small_radius_) * (1.0 + 1e-9);
    const double inside = radius * (1.0 - 1e-9);
    const double hang = 2.0 * overhang_[Axis], size = cell_size_[Axis];
    const auto chord = [](double r, double square) {
        return std::sqrt(std::max(0.0, r * r - square));
    };
    const auto& along = fine_.along[Axis];
    const int outer =
        std::min(static_cast<int>((chord(reach, least_square) + hang) / size) + 1, along.cells);
    // the cells on this axis that lie entirely inside are left out
    const int inner = Axis == 0 && most_square < inside * inside
                          ? static_cast<int>((chord(inside, most_square) - hang) / size) - 1
                          : -1;
    for (int d = -outer; d <= outer; ++d) {
        if (std::abs(d) <= inner) d = inner + 1;
        if (d > outer) break;
        const Wrapped at = wrap(center[Axis] + d, along);
        if (at.cell < 0) continue;
        Found here = found;
        here.index += fine_.stride[Axis] * at.cell;
        here.shift[Axis] = at.shift;
        if constexpr (Axis == 0) {
            f(fine_slots_[static_cast<std::size_t>(here.index)], here.shift);
        } else {
            const double least = std::max(0.0, (std::abs(d) - 1) * size - hang);
            const double most = (std::abs(d) + 1) * size + hang;
            if (least > reach) continue;
            for_each_at_rim<Axis - 1>(radius, center, here, least_square + least * least,
                                      most_square + most * most, f);
        }
    }
}

template <int Dimension>
template <typename Function>
void CellGrid<Dimension>::for_each_near(double radius, Cell cell, Function&& f) const {
    if (has_large_) for_each_around(coarse_slots_, coarse_, coarse_place(cell), f);
    if (radius > small_radius_)
        for_each_at_rim<axes - 1>(radius, fine_place(cell), Found(), 0.0, 0.0, f);
    else
        for_each_around(fine_slots_, fine_, fine_place(cell), f);
}

template <int Dimension>
template <typename See>
void CellGrid<Dimension>::for_each_neighbour(std::int32_t i, double radius, Cell cell,
                                             std::vector<std::int32_t>& list,
                                             const See& see) const {
    for_each_near(radius, cell, [&](const Slots& slots, const Shift& shift) {
        std::size_t count = 0;
        append(slots, list, count);
        for (std::size_t k = 0; k < count; ++k)
            if (list[k] != i) see(list[k], shift, 0);
    });
}

template <int Dimension>
template <typename Function>
void CellGrid<Dimension>::for_each_newly_near(double radius, Cell cell, int side,
                                              Function&& f) const {
    if (has_large_) {
        for_each_near(radius, cell, f);
        return;
    }
    const auto axis = static_cast<std::size_t>(side / 2);
    const std::int32_t ahead = side % 2 == 0 ? -1 : 1;
    const auto range = [&](std::size_t a) {
        return a == axis ? std::array{ahead, ahead} : std::array<std::int32_t, 2>{-1, 1};
    };
    for_each_within<axes - 1>(fine_slots_, fine_, fine_place(cell), Found(), range, f);
}

template <int Dimension>
template <typename Function>
void CellGrid<Dimension>::for_each_in_band(std::size_t axis, int first, int last,
                                           Function&& f) const {
    const auto range = [&](std::size_t a) {
        return a == axis ? std::array{first, last} : std::array{0, last_cell_[a]};
    };
    const auto each = [&](const Slots& slots, const Shift&) { f(slots); };
    for_each_within<axes - 1>(fine_slots_, fine_, Place{}, Found(), range, each);
    for (const Slots& slots : coarse_slots_) f(slots);
}

extern template class CellGrid<2>;
extern template class CellGrid<3>;

}  // namespace carom
