#include "stats/cell_averages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "physics/collision_error.h"
#include "util/bin_number.h"

namespace carom {
namespace {

constexpr double slices_of_window = 32.0;
constexpr double most_cells_crossed = 1e6;  // by a particle on its way to a collision or a sample

CollisionError too_fast(Eigen::Index particle, double time) {
    return CollisionError(
        fmt::format("from t = {:g} on particle {} goes through more than {:g} cells of a field or "
                    "profile before it collides, or the next picture shows it",
                    time, particle, most_cells_crossed),
        static_cast<std::int32_t>(particle),
        "give it less speed, or show fewer cells or more pictures in the same time");
}

}  // namespace

Region Cells::region(Eigen::Index cell) const {
    Vec low;
    for (int axis = 0; axis < 3; cell /= count[axis++])
        low[axis] = static_cast<double>(cell % count[axis]) * size[axis];
    return {low, low + size};
}

namespace {

Cells one_cell(const Box& box) {
    Cells cells;
    for (int axis = 0; axis < box.dimension; ++axis)
        cells.size[axis] = cells.box[axis] = box.size[axis];
    return cells;
}

}  // namespace

Cells square_cells(const Box& box, int along_longest) {
    if (box.dimension == 1) return slabs(box, 0, along_longest);
    const double side = box.longest_side() / along_longest;
    Cells cells = one_cell(box);
    for (int axis = 0; axis < box.dimension; ++axis) {
        cells.count[axis] = static_cast<int>(std::max(std::round(box.size[axis] / side), 1.0));
        cells.size[axis] /= cells.count[axis];
    }
    return cells;
}

Cells slabs(const Box& box, int axis, int count) {
    Cells cells = one_cell(box);
    cells.count[axis] = count;
    cells.size[axis] /= count;
    return cells;
}

Eigen::ArrayXd CellSums::temperature() const {
    return (thermal_freedom > 0.0)
        .select(thermal_energy / (thermal_freedom * static_cast<double>(velocity.cols())),
                std::numeric_limits<double>::quiet_NaN());
}

CellAverages::CellAverages(const Box& box, const Particles& particles, const Cells& cells,
                           Wanted wanted, std::vector<double> velocity_changes)
    : box_(box),
      particles_(particles),
      cells_(cells),
      wanted_(std::move(wanted)),
      paths_(box, std::move(velocity_changes)) {
    for (int axis = 0; axis < box.dimension; ++axis) gravity_[axis] = box.surfaces.gravity[axis];
}

CellSums CellAverages::no_sums() const {
    const Eigen::ArrayXd none = Eigen::ArrayXd::Zero(cells_.all());
    return {0.0, none, none, Eigen::ArrayXXd::Zero(cells_.all(), box_.dimension), none, none};
}

CellAverages::Point CellAverages::at(const Sample& sample, Eigen::Index i) const {
    Point point{.time = sample.time};
    for (Eigen::Index axis = 0; axis < box_.dimension; ++axis) {
        point.place[axis] = sample.position(i, axis);
        point.velocity[axis] = sample.velocity(i, axis);
    }
    return point;
}

// Without a window there is a single slice for all time.
std::int64_t CellAverages::slice_number(double time) const {
    if (!wanted_.window) return 0;
    return static_cast<std::int64_t>(std::floor(time * slices_of_window / *wanted_.window));
}

// -1 for a position outside the cells, as it can be with sides that move. The last cell includes
// the upper side, which point disks can touch.
Eigen::Index CellAverages::cell_at(const Vec& place) const {
    Eigen::Index cell = 0, stride = 1;
    for (Eigen::Index axis = 0; axis < box_.dimension; ++axis) {
        const Eigen::Index count = cells_.count[axis];
        const double where = place[axis] / cells_.size[axis];
        Eigen::Index k = 0;
        if (box_.is_periodic(axis)) {
            k = static_cast<Eigen::Index>(bin_number(where)) % count;
            if (k < 0) k += count;
        } else {
            k = bin_among(where, cells_.count[axis]);
            if (k < 0 || k >= count) return -1;
        }
        cell += k * stride;
        stride *= count;
    }
    return cell;
}

CellSums& CellAverages::slice_at(double time) {
    const std::int64_t number = slice_number(time);
    auto slice = slices_.end();
    while (slice != slices_.begin() && std::prev(slice)->number >= number) --slice;
    if (slice == slices_.end() || slice->number != number)
        slice = slices_.insert(slice, {number, no_sums()});
    return slice->sums;
}

void CellAverages::see(const Sample& sample, std::span<const Collision> collisions) {
    const double until = sample.time;
    start_ = wanted_.window ? until - *wanted_.window : -std::numeric_limits<double>::infinity();
    const bool is_moment = wanted_.window == 0.0;
    const bool integrates = !is_first_ && !is_moment && until > from_;
    if (integrates && wanted_.window) {
        // Only whole slices count: the start of the window is rounded to the edge of a slice, and
        // what is older is skipped.
        const double length = *wanted_.window / slices_of_window;
        start_ = static_cast<double>(slice_number(start_ + 0.5 * length)) * length;
        while (!slices_.empty() && slices_.front().number < slice_number(start_ + 0.5 * length))
            slices_.pop_front();
    }
    stays_.clear();
    paths_(sample, collisions, [&](const PathPiece& piece) {
        if (integrates) fly(piece);
    });
    if (integrates) {
        if (wanted_.temperature) add_temperatures();
        // Adds the time that has passed to each slice.
        for (double time = std::max(from_, start_); time < until;) {
            double end = until;
            if (wanted_.window)
                end = std::min(until, static_cast<double>(slice_number(time) + 1) *
                                          (*wanted_.window / slices_of_window));
            if (!(end > time)) end = std::nextafter(time, until);
            slice_at(0.5 * (time + end)).time += end - time;
            time = end;
        }
    }
    is_first_ = false;
    if (slices_.empty()) add_moment(sample);
    from_ = until;
}

void CellAverages::fly(const PathPiece& piece) {
    if (!is_member(piece.particle)) return;
    const double from = std::max(piece.from, start_), to = piece.to;
    if (!(to > from)) return;
    crossed_.clear();
    add_crossings(piece, from, to);
    std::ranges::sort(crossed_);
    double time = from;
    for (const double next : crossed_) {
        if (!(next > time)) continue;
        stay(piece, time, next);
        time = next;
    }
    if (to > time) stay(piece, time, to);
}

// Adds the times at which the particle passes from cell to cell, or time passes from slice to
// slice.
void CellAverages::add_crossings(const PathPiece& piece, double from, double to) {
    const auto add = [&](double after) {
        const double time = piece.from + after;
        if (time > from && time < to) crossed_.push_back(time);
    };
    for (Eigen::Index axis = 0; axis < box_.dimension; ++axis) {
        const double place = piece.place[axis], velocity = piece.velocity[axis];
        const double gravity = piece.acceleration[axis], size = cells_.size[axis];
        if (cells_.count[axis] == 1 && box_.is_periodic(axis)) continue;
        const auto at = [&](double time) {
            const double after = time - piece.from;
            return place + after * (velocity + 0.5 * gravity * after);
        };
        double low = std::min(at(from), at(to)), high = std::max(at(from), at(to));
        if (const double turn = piece.from - velocity / gravity;
            gravity != 0.0 && turn > from && turn < to) {
            low = std::min(low, at(turn));
            high = std::max(high, at(turn));
        }
        if (!((high - low) / size < most_cells_crossed)) throw too_fast(piece.particle, piece.from);
        for (double k = std::ceil(low / size); k * size <= high; k += 1.0) {
            const double way = k * size - place;
            if (gravity == 0.0) {
                if (velocity != 0.0) add(way / velocity);
                continue;
            }
            // Both roots, without cancellation.
            const double square = velocity * velocity + 2.0 * gravity * way;
            if (square < 0.0) continue;
            const double sum = velocity + std::copysign(std::sqrt(square), velocity);
            if (sum == 0.0) continue;
            add(-sum / gravity);
            add(2.0 * way / sum);
        }
    }
    if (!wanted_.window) return;
    const double length = *wanted_.window / slices_of_window;
    for (double k = std::floor(from / length) + 1.0; k * length < to; k += 1.0)
        crossed_.push_back(k * length);
}

void CellAverages::stay(const PathPiece& piece, double from, double to) {
    const double span = to - from, middle = 0.5 * (from + to) - piece.from;
    const Vec velocity = piece.velocity_after(middle);  // also the mean
    const Eigen::Index cell = cell_at(piece.place_after(middle));
    if (cell < 0) return;
    CellSums& sums = slice_at(0.5 * (from + to));
    sums.particles[cell] += span;
    sums.speed[cell] += length_of_way(velocity, piece.acceleration, span);
    for (Eigen::Index axis = 0; axis < box_.dimension; ++axis)
        sums.velocity(cell, axis) += span * velocity[axis];
    const double inverse_mass = particles_.inverse_mass[piece.particle];
    if (!wanted_.temperature || inverse_mass == 0.0) return;
    stays_.push_back({cell, from, to, velocity - (0.5 * (from + to) - from_) * piece.acceleration,
                      piece.acceleration - gravity_, 1.0 / inverse_mass});
}

namespace {

// Moments of the particles in a cell, in a frame that has been in free fall since a given time: in
// this frame only particles that lie on a floor are accelerated.
struct CellMotion {
    int count = 0;
    double mass = 0.0, squares = 0.0, products = 0.0, squares_gained = 0.0;
    Vec momentum = {}, force = {};

    void add(double its, const Vec& velocity, const Vec& acceleration) {
        mass += its;
        momentum += its * velocity;
        squares += its * square(velocity);
        if (acceleration == Vec()) return;
        force += its * acceleration;
        products += its * dot(velocity, acceleration);
        squares_gained += its * square(acceleration);
    }

    // Twice the kinetic energy of the motion relative to their centre of mass.
    double thermal(double time) const {
        const double all = squares + time * (2.0 * products + time * squares_gained);
        return std::max(0.0, all - square(momentum + time * force) / mass);
    }
    // The integral of thermal() over time: its integrand is constant where all particles fall
    // alike, otherwise a parabola (Simpson's rule is exact).
    double thermal(double from, double to) const {
        const double first = thermal(from);
        if (squares_gained == 0.0) return (to - from) * first;
        return (to - from) / 6.0 * (first + 4.0 * thermal(0.5 * (from + to)) + thermal(to));
    }
};

}  // namespace

// Goes through all entries and exits of particles, cell by cell, in order of time.
void CellAverages::add_temperatures() {
    struct Change {
        double time;
        std::size_t stay;
        int sign;
    };
    // The changes of one cell stand side by side. `ends` says where those of each cell begin, and
    // after they were written where they end.
    std::vector<std::ptrdiff_t> ends(static_cast<std::size_t>(cells_.all()) + 1);
    for (const CellStay& stay : stays_) ends[static_cast<std::size_t>(stay.cell) + 1] += 2;
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Change> changes(2 * stays_.size());
    for (std::size_t k = 0; k < stays_.size(); ++k) {
        std::ptrdiff_t& end = ends[static_cast<std::size_t>(stays_[k].cell)];
        changes[static_cast<std::size_t>(end++)] = {stays_[k].from, k, 1};
        changes[static_cast<std::size_t>(end++)] = {stays_[k].to, k, -1};
    }
    auto begin = changes.begin();
    for (Eigen::Index cell = 0; cell < cells_.all(); ++cell) {
        const auto end = changes.begin() + ends[static_cast<std::size_t>(cell)];
        std::sort(begin, end, [](const Change& a, const Change& b) {
            if (a.time != b.time) return a.time < b.time;
            return std::tie(a.sign, a.stay) < std::tie(b.sign, b.stay);
        });
        CellMotion now;
        double last = 0.0;  // time of the last change
        for (const Change& change : std::span(begin, end)) {
            if (const double span = change.time - last; now.count > 1 && span > 0.0) {
                CellSums& sums = slice_at(change.time - 0.5 * span);
                sums.thermal_energy[cell] +=
                    now.thermal(change.time - span - from_, change.time - from_);
                sums.thermal_freedom[cell] += span * (now.count - 1);
            }
            const CellStay& stay = stays_[change.stay];
            now.count += change.sign;
            if (now.count == 0)
                now = {};
            else
                now.add(change.sign * stay.mass, stay.velocity, stay.acceleration);
            last = change.time;
        }
        begin = end;
    }
}

void CellAverages::add_moment(const Sample& sample) {
    moment_ = no_sums();
    moment_.time = 1.0;
    Eigen::ArrayXd count = Eigen::ArrayXd::Zero(cells_.all()), mass = count, squares = count;
    Eigen::ArrayXXd momentum = moment_.velocity;
    for (Eigen::Index i = 0; i < particles_.count(); ++i) {
        const Point point = at(sample, i);
        const Eigen::Index cell = is_member(i) ? cell_at(point.place) : -1;
        if (cell < 0) continue;
        moment_.particles[cell] += 1.0;
        moment_.speed[cell] += length(point.velocity);
        put(vec_in(moment_.velocity, cell) + point.velocity, moment_.velocity, cell);
        if (particles_.inverse_mass[i] == 0.0) continue;
        const double its = 1.0 / particles_.inverse_mass[i];
        count[cell] += 1.0;
        mass[cell] += its;
        squares[cell] += its * square(point.velocity);
        put(vec_in(momentum, cell) + its * point.velocity, momentum, cell);
    }
    const auto several = count > 1.0;
    moment_.thermal_freedom = several.select(count - 1.0, 0.0);
    moment_.thermal_energy =
        several.select((squares - momentum.square().rowwise().sum() / mass).max(0.0), 0.0);
}

void CellSums::add(const CellSums& more) {
    time += more.time;
    particles += more.particles;
    speed += more.speed;
    velocity += more.velocity;
    thermal_energy += more.thermal_energy;
    thermal_freedom += more.thermal_freedom;
}

CellSums CellAverages::sums() const {
    if (slices_.empty()) return moment_;
    CellSums all = no_sums();
    for (const Slice& slice : slices_) all.add(slice.sums);
    return all;
}

std::vector<CellSums> CellAverages::pieces() const {
    constexpr double rounding = 1e-6;  // of a slice
    if (!wanted_.window || slices_.empty()) return {};
    const double length = *wanted_.window / slices_of_window;
    double time = 0.0;
    for (const Slice& slice : slices_) time += slice.sums.time;
    if (time < (slices_of_window - 0.5 - rounding) * length) return {};
    std::vector<CellSums> pieces(pieces_of_window, no_sums());
    constexpr auto slices_of_piece = static_cast<std::int64_t>(slices_of_window) / pieces_of_window;
    for (const Slice& slice : slices_) {
        const std::int64_t piece = (slice.number - slices_.front().number) / slices_of_piece;
        pieces[static_cast<std::size_t>(std::min<std::int64_t>(piece, pieces_of_window - 1))].add(
            slice.sums);
    }
    return pieces;
}

}  // namespace carom
