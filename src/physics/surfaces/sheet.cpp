#include "physics/surfaces/sheet.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace carom {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The sheet is cut along the lines of all rims. Along each axis that gives cells, numbered from 0,
// and borders between them: border k is below cell k. In a periodic box the cells form a ring,
// whose last one may lie across the side of the box.
class Cuts {
  public:
    Cuts(const Sheet::Axis& axis, const std::vector<Gap>& gaps, std::size_t k) : axis_(axis) {
        for (const Gap& gap : gaps)
            for (const double at : {gap.low[k], gap.high[k]}) {
                if (axis.is_periodic)
                    cuts_.push_back(at < axis.length ? at : 0.0);
                else if (at > 0.0 && at < axis.length)
                    cuts_.push_back(at);
            }
        std::ranges::sort(cuts_);
        cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
    }

    bool is_ring() const { return axis_.is_periodic; }
    std::size_t cells() const { return is_ring() ? cuts_.size() : cuts_.size() + 1; }
    /// The first border with cells on both sides, and the one after the last.
    std::size_t first_border() const { return is_ring() ? 0 : 1; }
    std::size_t end_of_borders() const { return cells(); }
    /// The cell below a border.
    std::size_t below(std::size_t border) const { return border == 0 ? cells() - 1 : border - 1; }

    double low(std::size_t cell) const {
        if (is_ring()) return cuts_[cell];
        return cell == 0 ? -infinite : cuts_[cell - 1];
    }
    double high(std::size_t cell) const {
        if (is_ring()) return cell + 1 < cells() ? cuts_[cell + 1] : cuts_[0] + axis_.length;
        return cell < cuts_.size() ? cuts_[cell] : infinite;
    }
    bool is_within(std::size_t cell, double from, double to) const {
        return std::max(low(cell), 0.0) >= from &&
               (is_ring() ? high(cell) : std::min(high(cell), axis_.length)) <= to;
    }

    // The longest runs of cells for which `holds` is true, as intervals. In a ring a run may go
    // across the side of the box, or all around.
    template <typename Condition, typename Take>
    void for_each_run(const Condition& holds, const Take& take) const {
        const std::size_t count = cells();
        std::size_t first = 0;  // where no run of a ring is cut
        while (is_ring() && first < count && holds(first)) ++first;
        if (first == count) return take(-infinite, infinite);
        bool has_begun = false;
        double begin = 0.0, turn_of_begin = 0.0;
        for (std::size_t k = first; k < first + count; ++k) {
            const std::size_t cell = k % count;
            const double turn = k < count ? 0.0 : axis_.length;
            if (!holds(cell)) continue;
            if (!std::exchange(has_begun, true)) begin = low(cell), turn_of_begin = turn;
            if (k + 1 < first + count && holds((k + 1) % count)) continue;
            take(begin, high(cell) + (turn - turn_of_begin));
            has_begun = false;
        }
    }

  private:
    Sheet::Axis axis_;
    std::vector<double> cuts_;
};

}  // namespace

Sheet::Sheet(const std::array<Axis, 2>& axes, const std::vector<Gap>& gaps) {
    if (gaps.empty()) {
        pieces = {{{-infinite, -infinite}, {infinite, infinite}}};
        return;
    }
    const std::array cuts{Cuts(axes[0], gaps, 0), Cuts(axes[1], gaps, 1)};
    const std::size_t columns = cuts[0].cells(), rows = cuts[1].cells();
    std::vector<bool> open(columns * rows);
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i)
            open[j * columns + i] = std::ranges::any_of(gaps, [&](const Gap& gap) {
                return cuts[0].is_within(i, gap.low[0], gap.high[0]) &&
                       cuts[1].is_within(j, gap.low[1], gap.high[1]);
            });
    const auto is_open = [&](std::size_t i, std::size_t j) { return open[j * columns + i]; };

    // Rows that are alike make one rectangle.
    const auto is_same_row = [&](std::size_t a, std::size_t b) {
        for (std::size_t i = 0; i < columns; ++i)
            if (is_open(i, a) != is_open(i, b)) return false;
        return true;
    };
    std::size_t first = 0;
    for (std::size_t j = 0; j < rows; ++j) {
        if (j + 1 < rows && is_same_row(j, j + 1)) continue;
        const bool is_all = first == 0 && j + 1 == rows && cuts[1].is_ring();
        const double low = is_all ? -infinite : cuts[1].low(first);
        const double high = is_all ? infinite : cuts[1].high(j);
        cuts[0].for_each_run([&](std::size_t i) { return !is_open(i, j); },
                             [&](double from, double to) {
                                 pieces.push_back({{from, low}, {to, high}});
                             });
        first = j + 1;
    }

    const auto is_cell_open = [&](std::size_t across, std::size_t a, std::size_t b) {
        return across == 0 ? is_open(a, b) : is_open(b, a);
    };
    for (const std::size_t across : {0U, 1U})
        for (std::size_t k = cuts[across].first_border(); k < cuts[across].end_of_borders(); ++k)
            cuts[1 - across].for_each_run(
                [&](std::size_t cell) {
                    return is_cell_open(across, cuts[across].below(k), cell) !=
                           is_cell_open(across, k, cell);
                },
                [&](double from, double to) {
                    rims.push_back({1 - across, cuts[across].low(k), from, to});
                });

    for (std::size_t j = cuts[1].first_border(); j < cuts[1].end_of_borders(); ++j)
        for (std::size_t i = cuts[0].first_border(); i < cuts[0].end_of_borders(); ++i) {
            const std::size_t left = cuts[0].below(i), under = cuts[1].below(j);
            const bool to_left = is_open(left, under) != is_open(left, j);
            const bool to_right = is_open(i, under) != is_open(i, j);
            const bool down = is_open(left, under) != is_open(i, under);
            const bool up = is_open(left, j) != is_open(i, j);
            if ((to_left || to_right) && (down || up))
                corners.push_back({cuts[0].low(i), cuts[1].low(j)});
        }
}

}  // namespace carom
