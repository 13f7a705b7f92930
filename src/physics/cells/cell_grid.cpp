#include "physics/cells/cell_grid.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>

namespace carom {
namespace {

constexpr double wider = 1.0 + 1e-9;  // so that round-off never leaves a cell too narrow

// The edge of a square or a cube with this content.
template <int Dimension>
double edge_of(double content) {
    return Dimension == 2 ? std::sqrt(content) : std::cbrt(content);
}

// x^n.
double power(double x, int n) { return n == 0 ? 1.0 : x * power(x, n - 1); }

// Lower limit of the cell size: smaller cells would mostly be empty and cause more crossings. In
// dilute gases crossings outnumber collisions and wide cells can overlap, so larger cells are
// better there. Tuned by counting instructions.
template <int Dimension>
double least_cell(double content, double count, double diameter) {
    const double one_each = edge_of<Dimension>(content / std::max(count, 4.0));
    const double cells_per_particle = one_each > 1.75 * diameter ? 1.0 : 1.25;
    return one_each / edge_of<Dimension>(cells_per_particle);
}

// Estimated number of cells and pairs examined per unit of time, in arbitrary units, if
// particles with radii up to `small` are in the fine grid. Larger ones have more neighbours and
// search more cells, in proportion to their size.
template <int Dimension>
double expected_work(const Eigen::ArrayXd& radii, double small, double content) {
    const double around = power(3.0, Dimension);  // a cell and its neighbours
    const auto larger = (radii > small).cast<double>();
    const double large_count = larger.sum();
    const double small_count = static_cast<double>(radii.size()) - large_count;
    const double cell =
        std::max(2.0 * small,
                 least_cell<Dimension>(content, static_cast<double>(radii.size()), 2.0 * small));
    const double coarse = std::max(2.0 * radii.maxCoeff(), cell);
    const double in_cell = small_count * std::min(1.0, power(cell, Dimension) / content);
    const double in_coarse = large_count * std::min(1.0, power(coarse, Dimension) / content);
    const double look_at_large = large_count > 0.0 ? around + around * in_coarse : 0.0;
    const double per_small = around + around * in_cell + look_at_large;
    const Eigen::ArrayXd ratio = radii / cell;
    // Three cells thick: three times the circumference or the surface.
    const Eigen::ArrayXd ring =
        Dimension == 2 ? Eigen::ArrayXd(around + 6.0 * std::numbers::pi * ratio)
                       : Eigen::ArrayXd(around + 12.0 * std::numbers::pi * ratio.square());
    const double large_work =
        (larger * (1.0 + ratio) * (ring * (1.0 + in_cell) + look_at_large)).sum();
    return small_count * per_small + large_work;
}

template <int Dimension>
double choose_small_radius(const Eigen::ArrayXd& radii, double content) {
    const double largest = radii.maxCoeff();
    double best = largest;
    double least_work = expected_work<Dimension>(radii, largest, content);
    for (double bound = largest / std::numbers::sqrt2; bound > largest * 1e-6;
         bound /= std::numbers::sqrt2) {
        if (!(radii <= bound).any()) break;
        const double small = (radii <= bound).select(radii, 0.0).maxCoeff();
        const double work = expected_work<Dimension>(radii, small, content);
        if (work < least_work) {
            least_work = work;
            best = small;
        }
    }
    return best;
}

int cells_along(double length, double least) {
    const double cells = std::floor(length / (least * wider));
    return static_cast<int>(std::clamp(cells, 1.0, 65535.0));
}

// Particles in two cells separated by one other cell must not touch even if both extend beyond
// their cells. Along a periodic axis those in neighbouring cells must also be less than half the
// box apart, so that the nearest image is the relevant one.
double overhang_of(double cell, double widest_pair, double length, bool periodic) {
    const double free = 0.5 * (cell - widest_pair * wider);
    const double near = periodic ? 0.25 * length / wider - cell : free;
    return std::max(0.0, std::min(free, near));
}

// A coarse cell consists of a whole number of fine ones; the last takes the remainder.
std::vector<std::int32_t> merge(int fine, double fine_length, double least) {
    const int together = static_cast<int>(
        std::min(std::ceil(least * wider / fine_length), static_cast<double>(fine)));
    const int coarse = std::max(1, fine / together);
    std::vector<std::int32_t> merged(static_cast<std::size_t>(fine));
    for (int i = 0; i < fine; ++i)
        merged[static_cast<std::size_t>(i)] = std::min(i / together, coarse - 1);
    return merged;
}

// Whether for two particles in neighbouring cells, fine or coarse, the nearest image is always the
// relevant one. The overhang is given as a fraction of a cell.
bool nearest_is_meant(const std::vector<std::int32_t>& coarse, double overhang, bool periodic,
                      bool has_large) {
    if (!periodic) return true;
    const auto cells = static_cast<double>(coarse.size());
    if (cells < 5 || !has_large) return cells >= 5;
    const auto in_last = std::count(coarse.begin(), coarse.end(), coarse.back());
    const auto in_first = std::count(coarse.begin(), coarse.end(), 0);
    return static_cast<double>(in_first + in_last) + 2.0 * overhang < 0.5 / wider * cells;
}

// The cells around which no other image can be relevant.
template <typename Inner>
Inner inner_cells(const std::vector<std::int32_t>& coarse, bool periodic, bool has_large) {
    const auto count = static_cast<unsigned>(coarse.size());
    if (!periodic) return {0, count};
    if (!has_large) return {1, count > 2 ? count - 2 : 0};
    const auto first = std::count(coarse.begin(), coarse.end(), 0);
    const auto last = std::count(coarse.begin(), coarse.end(), coarse.back());
    return {static_cast<unsigned>(first),
            static_cast<unsigned>(std::max<std::ptrdiff_t>(0, count - first - last))};
}

}  // namespace

template <int Dimension>
CellGrid<Dimension>::CellGrid(const Box& box, const Eigen::ArrayXd& radii) {
    const double content = box.content();
    const double largest = radii.size() > 0 ? radii.maxCoeff() : 0.0;
    small_radius_ = radii.size() > 0 ? choose_small_radius<Dimension>(radii, content) : 0.0;
    has_large_ = small_radius_ < largest;
    const double diameter = 2.0 * small_radius_;
    const double least = std::max(
        diameter, least_cell<Dimension>(content, static_cast<double>(radii.size()), diameter));
    plain_ = true;
    std::int64_t fine_stride = 1, coarse_stride = 1;
    for (std::size_t a = 0; a < axes; ++a) {
        const double length = box.length(a);
        const bool periodic = box.is_periodic(a);
        Axis& fine = fine_.along[a];
        fine = {cells_along(length, least), periodic, length};
        last_cell_[a] = fine.cells - 1;
        narrow_[a] = periodic && 4.0 * largest > 0.99 * length;
        const double cell = cell_size_[a] = length / fine.cells;
        overhang_[a] = overhang_of(cell, diameter, length, periodic);
        coarse_cell_[a] = merge(fine.cells, cell, std::max(2.0 * (largest + overhang_[a]), cell));
        coarse_.along[a] = {coarse_cell_[a].back() + 1, periodic, length};
        plain_ =
            plain_ && nearest_is_meant(coarse_cell_[a], overhang_[a] / cell, periodic, has_large_);
        inner_[a] = inner_cells<Inner>(coarse_cell_[a], periodic, has_large_);
        fine_.stride[a] = fine_stride;
        coarse_.stride[a] = coarse_stride;
        for (std::int32_t k = -1; k <= fine.cells; ++k) {
            const Wrapped in = wrap(k, fine);
            around_[a].push_back(fine_stride * (in.cell < 0 ? fine.cells : in.cell));
        }
        fine_stride *= fine.cells + 1;
        coarse_stride *= coarse_.along[a].cells;
    }
    fine_slots_.resize(static_cast<std::size_t>(fine_stride));
    coarse_slots_.resize(has_large_ ? static_cast<std::size_t>(coarse_stride) : 0);
    next_.assign(static_cast<std::size_t>(radii.size()), -1);
}

template <int Dimension>
CellOf<Dimension> CellGrid<Dimension>::cell_at(const std::array<double, axes>& x) const {
    Cell cell;
    for (std::size_t a = 0; a < axes; ++a) cell[a] = cell_along(a, x[a]);
    return cell;
}

template <int Dimension>
void CellGrid<Dimension>::clear() {
    std::fill(fine_slots_.begin(), fine_slots_.end(), Slots{});
    std::fill(coarse_slots_.begin(), coarse_slots_.end(), Slots{});
}

template <int Dimension>
void CellGrid<Dimension>::add(std::int32_t particle, double radius, Cell cell) {
    put_in(particle, slots_of(radius, cell));
}

template <int Dimension>
void CellGrid<Dimension>::move(std::int32_t particle, double radius, Cell from, Cell to) {
    Slots& old_slots = slots_of(radius, from);
    Slots& new_slots = slots_of(radius, to);
    if (&old_slots == &new_slots) return;
    take_out(particle, old_slots);
    put_in(particle, new_slots);
}

template <int Dimension>
void CellGrid<Dimension>::put_in(std::int32_t particle, Slots& slots) {
    if (slots.count() < Slots::most) {
        slots.particle_[static_cast<std::size_t>(slots.count())] = particle;
        ++slots.rest_;
        return;
    }
    next_[static_cast<std::size_t>(particle)] = slots.chain();
    slots.set_chain(particle);
}

// The last particle, or the first of the chain, fills the gap.
template <int Dimension>
void CellGrid<Dimension>::take_out(std::int32_t particle, Slots& slots) {
    if (!slots.has_chain()) [[likely]] {
        // slots after the last particle may hold anything, so the first match counts; branchless,
        // because the processor could not predict the branches
        const bool not_first = slots.particle_[0] != particle;
        const bool not_second = slots.particle_[1] != particle;
        const std::size_t gap = (not_first ? 1U : 0U) + (not_first & not_second ? 1U : 0U);
        --slots.rest_;
        slots.particle_[gap] = slots.particle_[slots.rest_];
        return;
    }
    for (std::int32_t k = 0; k < slots.count(); ++k) {
        std::int32_t& gap = slots.particle_[static_cast<std::size_t>(k)];
        if (gap != particle) continue;
        gap = slots.chain();
        slots.set_chain(next_[static_cast<std::size_t>(gap)]);
        return;
    }
    if (slots.chain() == particle) {
        slots.set_chain(next_[static_cast<std::size_t>(particle)]);
        return;
    }
    std::int32_t before = slots.chain();
    while (next_[static_cast<std::size_t>(before)] != particle)
        before = next_[static_cast<std::size_t>(before)];
    next_[static_cast<std::size_t>(before)] = next_[static_cast<std::size_t>(particle)];
}

template <int Dimension>
void CellGrid<Dimension>::append_chain(const Slots& slots, std::vector<std::int32_t>& list,
                                       std::size_t& size) const {
    for (std::int32_t i = slots.chain(); i >= 0; i = next_[static_cast<std::size_t>(i)]) {
        if (size + 2 * spare > list.size()) list.resize(2 * list.size() + 2 * spare);
        list[size++] = i;
    }
}

template <int Dimension>
void CellGrid<Dimension>::append_large_around(Cell cell, std::vector<std::int32_t>& list,
                                              std::size_t& size) const {
    for_each_around(coarse_slots_, coarse_, coarse_place(cell),
                    [&](const Slots& slots, const Shift&) { append(slots, list, size); });
}

// Three cells of a row lie within two cache lines. Not inlined, like all functions that only
// prefetch: if GCC inlines such a function it finds no side effect and removes the calls.
template <int Dimension>
void CellGrid<Dimension>::fetch_around(Cell cell) const {
    const std::int64_t* const columns = &around_[0][cell[0]];
    const std::int64_t* const rows = &around_[1][cell[1]];
    const auto fetch = [&](std::int64_t row) {
        for (const std::int64_t column : {columns[0], columns[2]})
            __builtin_prefetch(&fine_slots_[static_cast<std::size_t>(row + column)]);
    };
    for (std::size_t k = 0; k < 3; ++k) {
        if constexpr (Dimension == 2)
            fetch(rows[k]);
        else
            for (std::size_t l = 0; l < 3; ++l) fetch(rows[k] + (&around_[2][cell[2]])[l]);
    }
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace carom
