#include "stats/pairs/pair_correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "stats/pairs/near_pairs.h"
#include "util/bin_number.h"

namespace carom {
namespace {

constexpr std::size_t most_radii = 12;  // told apart: their squares change g by the rest

// The time from one search for near pairs to the next: in it, fast particles fly this share of the
// largest distance. Longer times have more pairs that come near, shorter ones more searches.
constexpr double way_of_slice = 0.5;

// The largest speed, but at most a few times that of all particles, so that one that is fast among
// slow ones does not make slices short.
double fast_speed(const Sample& sample) {
    constexpr double most = 4.0;
    if (sample.velocity.rows() == 0) return 0.0;
    const Eigen::ArrayXd square = sample.velocity.square().rowwise().sum();
    return std::sqrt(std::min(square.maxCoeff(), most * most * square.mean()));
}

}  // namespace

PairCorrelation::PairCorrelation(const Box& box, const Particles& particles, Wanted wanted,
                                 std::vector<double> velocity_changes)
    : box_(box),
      particles_(particles),
      wanted_(std::move(wanted)),
      width_(wanted_.to / wanted_.rings),
      paths_(box, std::move(velocity_changes)),
      pairs_(wanted_.rings, wanted_.window == 0.0 ? std::nullopt : wanted_.window),
      expected_(pairs_),
      pieces_(static_cast<std::size_t>(particles.count())) {
    find_kinds();
}

bool PairCorrelation::is_wanted(Eigen::Index i, Eigen::Index j) const {
    const auto is_in = [](const std::vector<bool>& list, Eigen::Index k) {
        return list.empty() || list[static_cast<std::size_t>(k)];
    };
    return (is_in(wanted_.first, i) && is_in(wanted_.second, j)) ||
           (is_in(wanted_.first, j) && is_in(wanted_.second, i));
}

// Counts the pairs for each pair of radii. If there are too many different radii, the particles are
// grouped, and each group has its mean radius.
void PairCorrelation::find_kinds() {
    kinds_.clear();
    last_expected_.reset();
    std::vector<Eigen::Index> by_radius;
    for (Eigen::Index i = 0; i < particles_.count(); ++i) by_radius.push_back(i);
    std::ranges::stable_sort(by_radius, {}, [&](Eigen::Index i) { return particles_.radius[i]; });
    std::vector<std::vector<Eigen::Index>> groups;
    for (const Eigen::Index i : by_radius) {
        if (groups.empty() || particles_.radius[groups.back().front()] != particles_.radius[i])
            groups.emplace_back();
        groups.back().push_back(i);
    }
    if (groups.size() > most_radii) {
        groups.assign(most_radii, {});
        for (std::size_t k = 0; k < by_radius.size(); ++k)
            groups[k * most_radii / by_radius.size()].push_back(by_radius[k]);
    }
    // For each group, the numbers of particles of the first sort, of the second and of both.
    struct Group {
        double radius = 0.0, first = 0.0, second = 0.0, both = 0.0;
    };
    std::vector<Group> all;
    for (const std::vector<Eigen::Index>& group : groups) {
        Group sum;
        for (const Eigen::Index i : group) {
            const auto k = static_cast<std::size_t>(i);
            const bool first = wanted_.first.empty() || wanted_.first[k];
            const bool second = wanted_.second.empty() || wanted_.second[k];
            sum.radius += particles_.radius[i] / static_cast<double>(group.size());
            sum.first += first ? 1.0 : 0.0;
            sum.second += second ? 1.0 : 0.0;
            sum.both += first && second ? 1.0 : 0.0;
        }
        all.push_back(sum);
    }
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a; b < all.size(); ++b) {
            const Group &one = all[a], &other = all[b];
            const double ordered = one.first * other.second + one.second * other.first;
            const double pairs = a == b ? 0.5 * (ordered - one.both * one.both - one.both)
                                        : ordered - one.both * other.both;
            if (pairs > 0.0) kinds_.push_back({{one.radius, other.radius}, pairs});
        }
}

// The expected number of pairs of uniformly distributed points in each ring. The last result is
// kept, as the sides seldom move.
Eigen::ArrayXd PairCorrelation::expected(const BoxSides& sides) {
    if (last_expected_ && last_expected_->first == sides) return last_expected_->second;
    Eigen::ArrayXd pairs = Eigen::ArrayXd::Zero(wanted_.rings);
    for (const auto& [radii, count] : kinds_)
        for (int k = 0; k < wanted_.rings; ++k)
            pairs[k] += count * ring_probability(box_, sides, radii, k * width_, (k + 1) * width_);
    last_expected_ = {sides, pairs};
    return pairs;
}

void PairCorrelation::see(const Sample& sample, std::span<const Collision> collisions,
                          const BoxSides& sides) {
    if (wanted_.window != 0.0) see_pieces(sample, collisions);
    if (sides_ && sample.time > time_ && wanted_.window != 0.0) {
        BoxSides between = sides;
        for (std::size_t axis = 0; axis < sides.size(); ++axis)
            between[axis] = {0.5 * (sides[axis].first + (*sides_)[axis].first),
                             0.5 * (sides[axis].second + (*sides_)[axis].second)};
        const Eigen::ArrayXd its = expected(between);
        for_each_slice(expected_, {time_, sample.time}, [&](Interval part) {
            expected_.at(part.middle()) += (part.to - part.from) * its;
        });
    }
    if (!sides_ || wanted_.window == 0.0) add_moment(sample, sides);
    if (!sides_) since_ = sample.time;
    sides_ = sides;
    time_ = sample.time;
    speed_ = fast_speed(sample);
    if (wanted_.window == 0.0 || time_ <= since_) return;
    const bool is_short = (time_ - since_) * speed_ < way_of_slice * wanted_.to;
    const bool is_read_often = std::exchange(is_read_, false);  // then each reading adds little
    if (!wanted_.window && is_short && !is_read_often) return;
    add_all_pieces();
}

void PairCorrelation::add_all_pieces() {
    const Pieces all = with_open();
    for_each_slice(pairs_, {since_, time_}, [&](Interval part) {
        add_pieces(all, part, pairs_.at(part.middle()), flights_added_);
    });
    for (std::vector<PathPiece>& pieces : pieces_) pieces.clear();
    since_ = time_;
}

// In a window of time flights end at each sample, else at collisions alone.
void PairCorrelation::see_pieces(const Sample& sample, std::span<const Collision> collisions) {
    const auto keep = [&](const PathPiece& piece) {
        if (piece.to > since_) pieces_[static_cast<std::size_t>(piece.particle)].push_back(piece);
    };
    if (wanted_.window)
        paths_(sample, collisions, keep);
    else
        paths_.see_whole(sample, collisions, keep);
}

// With the flights that are still going on.
PairCorrelation::Pieces PairCorrelation::with_open() const {
    Pieces all = pieces_;
    paths_.see_open([&](const PathPiece& piece) {
        all[static_cast<std::size_t>(piece.particle)].push_back(piece);
    });
    return all;
}

void PairCorrelation::add_moment(const Sample& sample, const BoxSides& sides) {
    moment_ = Eigen::ArrayXd::Zero(wanted_.rings);
    moment_expected_ = expected(sides);
    NearPairs(box_, sample.position, wanted_.to).for_each([&](Eigen::Index i, Eigen::Index j) {
        if (!is_wanted(i, j)) return;
        add_at(distance(sample.position, i, j), 1.0, moment_);
    });
}

// The distance of the nearest images of two particles.
double PairCorrelation::distance(const Eigen::ArrayXXd& positions, Eigen::Index i,
                                 Eigen::Index j) const {
    return length(box_.nearest(vec_in(positions, j) - vec_in(positions, i)));
}

// An upper bound for the distance of a path from its end. Gravity bends a piece away from the
// straight line between its ends by no more than g t^2 / 8.
double PairCorrelation::farthest_from_end(std::span<const PathPiece> pieces,
                                          Interval within) const {
    Vec apart;
    double farthest = 0.0, bend = 0.0;
    for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
        const double from = std::max(piece->from, within.from), to = std::min(piece->to, within.to);
        if (!(to > from)) continue;
        apart -= piece->place_after(to - piece->from) - piece->place_after(from - piece->from);
        farthest = std::max(farthest, length(apart));
        const double span = to - from;
        bend = std::max(bend, 0.125 * span * span * length(piece->acceleration));
    }
    return farthest + bend;
}

int PairCorrelation::slices_in(Interval within) const {
    constexpr double most = 1e6;
    const double slices = (within.to - within.from) * speed_ / (way_of_slice * wanted_.to);
    return static_cast<int>(std::clamp(std::round(slices), 1.0, most));
}

// Adds the pieces in an interval, cut into slices of time so short that few pairs come near each
// other in each.
void PairCorrelation::add_pieces(const Pieces& pieces, Interval whole, Eigen::ArrayXd& time,
                                 double& flights) const {
    const int slices = wanted_.window ? 1 : slices_in(whole);
    std::vector<std::size_t> first(pieces.size());  // the piece of each particle where a slice ends
    std::vector<std::span<const PathPiece>> in_slice(pieces.size());
    const auto end = [&](int k) {
        return k == slices ? whole.to : whole.from + (whole.to - whole.from) * k / slices;
    };
    for (int k = 0; k < slices; ++k) {
        const Interval within{end(k), end(k + 1)};
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const std::vector<PathPiece>& all = pieces[i];
            while (first[i] + 1 < all.size() && all[first[i]].to <= within.from) ++first[i];
            std::size_t last = first[i];
            while (last < all.size() && all[last].from < within.to) ++last;
            in_slice[i] = std::span(all).subspan(first[i], last - first[i]);
        }
        add_flights(in_slice, within, time, flights);
    }
}

// Adds the flights of all pairs that may have come near each other, found from their positions at
// the end.
void PairCorrelation::add_flights(std::span<const std::span<const PathPiece>> pieces,
                                  Interval within, Eigen::ArrayXd& time, double& flights) const {
    const auto count = static_cast<Eigen::Index>(pieces.size());
    Eigen::ArrayXXd positions = Eigen::ArrayXXd::Zero(count, box_.dimension);
    Eigen::ArrayXd reach = Eigen::ArrayXd::Zero(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const std::span<const PathPiece> own = pieces[static_cast<std::size_t>(i)];
        if (own.empty()) continue;
        const Vec place = own.back().place_after(within.to - own.back().from);
        for (Eigen::Index axis = 0; axis < box_.dimension; ++axis)
            positions(i, axis) = box_.wrapped(axis, place[axis]);
        reach[i] = farthest_from_end(own, within);
    }
    const double farthest = count > 0 ? reach.maxCoeff() : 0.0;
    NearPairs(box_, positions, wanted_.to + 2.0 * farthest)
        .for_each([&](Eigen::Index i, Eigen::Index j) {
            if (!is_wanted(i, j)) return;
            const double near = wanted_.to + reach[i] + reach[j];
            if (distance(positions, i, j) < near)
                flights += add_pair(pieces[static_cast<std::size_t>(i)],
                                    pieces[static_cast<std::size_t>(j)], within, time);
        });
}

// Takes the intervals in which only gravity changes the velocities; returns their number. Two
// falling particles have no relative acceleration; if one lies on a floor while the other falls,
// the relative path is replaced by chords close to it.
double PairCorrelation::add_pair(std::span<const PathPiece> first,
                                 std::span<const PathPiece> second, Interval within,
                                 Eigen::ArrayXd& time) const {
    double flights = 0.0;
    for (std::size_t i = 0, j = 0; i < first.size() && j < second.size();) {
        const PathPiece &one = first[i], &other = second[j];
        const double from = std::max({one.from, other.from, within.from}),
                     to = std::min({one.to, other.to, within.to});
        if (to > from) {
            flights += 1.0;
            const Vec place =
                other.place_after(from - other.from) - one.place_after(from - one.from);
            const Vec velocity =
                other.velocity_after(from - other.from) - one.velocity_after(from - one.from);
            const Vec acceleration = other.acceleration - one.acceleration;
            const int chords = chords_of(length(acceleration), to - from);
            const double span = (to - from) / chords;
            for (int k = 0; k < chords; ++k) {
                const double after = k * span;
                add_images(place + after * (velocity + 0.5 * after * acceleration),
                           velocity + (after + 0.5 * span) * acceleration, span, time);
            }
        }
        ++(one.to < other.to ? i : j);
    }
    return flights;
}

// Enough chords that none is farther from the path than a small part of a ring.
int PairCorrelation::chords_of(double acceleration, double span) const {
    constexpr double part_of_ring = 1e-3, most = 1e4;
    const double chords = span * std::sqrt(acceleration / (8.0 * part_of_ring * width_));
    return static_cast<int>(std::clamp(std::ceil(chords), 1.0, most));
}

// Adds all images that come near during the flight; in most boxes only the nearest one.
void PairCorrelation::add_images(const Vec& place, const Vec& velocity, double span,
                                 Eigen::ArrayXd& time) const {
    const Vec nearest = box_.nearest(place);
    std::array<int, 3> others{0, 0, 0};
    for (int axis = 0; axis < box_.dimension; ++axis)
        if (box_.is_periodic(axis) &&
            wanted_.to + std::abs(velocity[axis]) * span > 0.5 * box_.length(axis))
            others[static_cast<std::size_t>(axis)] = static_cast<int>(
                std::ceil((wanted_.to + std::abs(velocity[axis]) * span) / box_.length(axis)));
    for (int z = -others[2]; z <= others[2]; ++z)
        for (int y = -others[1]; y <= others[1]; ++y)
            for (int x = -others[0]; x <= others[0]; ++x)
                add_flight({nearest[0] + x * box_.length(0), nearest[1] + y * box_.length(1),
                            nearest[2] + z * box_.length(2)},
                           velocity, span, time);
}

// The distance decreases until the closest approach and increases from there on.
void PairCorrelation::add_flight(const Vec& place, const Vec& velocity, double span,
                                 Eigen::ArrayXd& time) const {
    const double squared = square(velocity), along = dot(place, velocity);
    const double speed = std::sqrt(squared), from = length(place);
    if (from - speed * span >= wanted_.to) return;
    if (!(speed * span > 1e-12 * wanted_.to)) {
        add_at(from, span, time);
        return;
    }
    const double to = length(place + span * velocity);
    // The usual case: the flight stays in one ring and does not pass its closest approach.
    const auto ring = static_cast<Eigen::Index>(from / width_ + edge_rounding);
    const bool is_one_way = along >= 0.0 || along + squared * span <= 0.0;
    if (is_one_way && ring == static_cast<Eigen::Index>(to / width_ + edge_rounding)) {
        if (ring < wanted_.rings) time[ring] += span;
        return;
    }
    // The distance of closest approach, from the cross product, which avoids cancellation.
    const double least = length(cross(place, velocity)) / speed;
    if (least >= wanted_.to) return;
    const double closest = -along / squared;
    if (closest <= 0.0 || closest >= span) {
        add_between(std::min(from, to), std::max(from, to), least, speed, time);
        return;
    }
    add_between(least, from, least, speed, time);
    add_between(least, to, least, speed, time);
}

void PairCorrelation::add_at(double distance, double time, Eigen::ArrayXd& sums) const {
    const double ring = bin_number(distance / width_);
    if (ring < wanted_.rings) sums[static_cast<Eigen::Index>(ring)] += time;
}

// Adds the time that a straight flight with closest distance `least` spends in each ring between
// the distances `from` and `to`.
void PairCorrelation::add_between(double from, double to, double least, double speed,
                                  Eigen::ArrayXd& sums) const {
    const auto when = [&](double distance) {
        return std::sqrt(std::max(0.0, (distance - least) * (distance + least))) / speed;
    };
    double before = when(from);
    for (int ring = static_cast<int>(std::min(bin_number(from / width_), double(wanted_.rings)));
         ring < wanted_.rings; ++ring) {
        const double outer = (ring + 1) * width_;
        const double at = when(std::min(outer, to));
        sums[ring] += std::max(0.0, at - before);
        before = at;
        if (outer >= to) return;
    }
}

Eigen::ArrayXd PairCorrelation::values() const {
    is_read_ = true;
    const Eigen::ArrayXd expected = expected_.sum();
    const bool is_moment = !(expected.sum() > 0.0);
    Eigen::ArrayXd pairs = is_moment ? moment_ : pairs_.sum();
    if (double flights = 0.0; !is_moment && time_ > since_)
        add_pieces(with_open(), {since_, time_}, pairs, flights);
    const Eigen::ArrayXd& points = is_moment ? moment_expected_ : expected;
    return (points > 0.0).select(pairs / points, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace carom
