// The parts that surfaces are made of.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>
#include <variant>

#include "support/slow_surfaces.h"

namespace carom::test {

using Vector = SlowVector;

SlowSurfaces::SlowSurfaces(const Box& box, const Particles& particles, const Sample& start)
    : box_(box), slack_(0.0L), images_(images_of(box, 1)) {
    const Surfaces& surfaces = box.surfaces;
    std::int32_t surface = 0;
    for (; surface < surfaces.side_count; ++surface) {
        const int axis = surface / 2;
        const long double place = surface % 2 == 0 ? 0.0L : box.size[axis];
        movers_.push_back({.axis = axis,
                           .place = place,
                           .behaviour = surfaces.sides[static_cast<std::size_t>(surface)]});
        if (axis < box.dimension && !box.is_periodic(axis)) add_partition(axis, place, {}, surface);
    }
    for (const Partition& partition : surfaces.partitions) {
        movers_.push_back({.axis = partition.axis,
                           .place = partition.at,
                           .behaviour = partition.behaviour,
                           .is_open = partition.is_open});
        add_partition(partition.axis, partition.at, partition.gaps, surface++);
    }
    for (const Obstacle& obstacle : surfaces.obstacles) add_obstacle(obstacle, surface++);
    for (Mover& mover : movers_) {
        if (const auto* piston = std::get_if<Piston>(&mover.behaviour))
            mover.velocity = piston->velocity;
        set_motion(mover);
    }
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        bodies_.push_back({.x = {},
                           .v = {},
                           .a = {},
                           .radius = particles.radius[i],
                           .inverse_mass = particles.inverse_mass[i],
                           .species = particles.species[i]});
    adopt(start, {});
    order_.resize(bodies_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](auto a, auto b) { return bodies_[a].x.x < bodies_[b].x.x; });
}

bool SlowSurfaces::Part::is_endless() const {
    return normal && std::ranges::all_of(spans, &Span::is_endless);
}

SlowVector SlowSurfaces::Part::across(Vector a) const {
    for (const Span& span : spans) a = a - dot(span.along, a) * span.along;
    return a;
}

bool SlowSurfaces::Part::has(const Vector& r, long double slack) const {
    return std::ranges::all_of(spans, [&](const Span& span) {
        const long double foot = dot(span.along, r);
        return foot >= span.from - slack && foot <= span.to + slack;
    });
}

void SlowSurfaces::add(Part part) {
    part.low = part.high = part.place;
    part.images = images_;
    for (int axis = 0; axis < box_.dimension; ++axis)
        for (const Span& span : part.spans) {
            const long double share = span.along[axis];
            if (share == 0.0L) continue;
            part.low[axis] += std::min(share * span.from, share * span.to);
            part.high[axis] += std::max(share * span.from, share * span.to);
            if (span.is_endless())
                std::erase_if(part.images,
                              [&](const Vector& image) { return image[axis] != 0.0L; });
        }
    parts_.push_back(std::move(part));
}

namespace {

// The pieces into which the ends of gaps divide an axis of a partition. Beyond the walls, which may
// move, the partition goes on as at the walls.
struct Pieces {
    int axis = -1;  // none: there is one piece
    bool is_ring = false;
    long double length = 0.0L;
    std::vector<long double> from{-infinite}, to{infinite};

    std::size_t count() const { return from.size(); }
    // The piece that begins where this one ends; its own number if there is none.
    std::size_t next(std::size_t k) const { return k + 1 < count() ? k + 1 : is_ring ? 0 : k; }
    // A place inside a piece, and inside the box.
    long double inside(std::size_t k) const {
        return 0.5L * (std::max(0.0L, from[k]) + std::min(length, to[k]));
    }
};

Pieces pieces_along(int axis, const Box& box, const std::vector<Gap>& gaps, std::size_t k) {
    Pieces pieces{axis, box.is_periodic(axis), box.length(axis)};
    if (gaps.empty()) return pieces;
    std::set<double> ends;
    for (const Gap& gap : gaps)
        for (const double end : {gap.low[k], gap.high[k]})
            if (end > 0.0 && end < box.length(axis)) ends.insert(end);
    if (pieces.is_ring) pieces.from = {0.0L}, pieces.to = {pieces.length};
    for (const double end : ends) {
        pieces.to.insert(pieces.to.end() - 1, end);
        pieces.from.push_back(end);
    }
    return pieces;
}

}  // namespace

// Faces, edges where a face ends, and corners where two edges meet that are not in line. Those in
// the corner of a gap are met first only by what a membrane has let in.
void SlowSurfaces::add_partition(int axis, long double at, const std::vector<Gap>& gaps,
                                 std::int32_t surface) {
    Pieces along[2];
    std::size_t transverse = 0;
    for (int other = 0; other < box_.dimension; ++other) {
        if (other == axis) continue;
        along[transverse] = pieces_along(other, box_, gaps, transverse);
        ++transverse;
    }
    const auto is_solid = [&](std::size_t p, std::size_t q) {
        return std::ranges::none_of(gaps, [&](const Gap& gap) {
            const auto covers = [&](std::size_t k, std::size_t piece) {
                if (along[k].axis < 0) return true;
                const long double place = along[k].inside(piece);
                return place > gap.low[k] && place < gap.high[k];
            };
            return covers(0, p) && covers(1, q);
        });
    };
    Part part;
    part.surface = surface;
    part.place[axis] = at;
    const auto span_of = [&](std::size_t k, std::size_t piece) -> std::vector<Span> {
        const Pieces& its = along[k];
        if (its.axis < 0) return {};
        return {{along_axis(its.axis), its.from[piece], its.to[piece]}};
    };
    const auto both = [](std::vector<Span> a, const std::vector<Span>& b) {
        a.insert(a.end(), b.begin(), b.end());
        return a;
    };
    for (std::size_t p = 0; p < along[0].count(); ++p)
        for (std::size_t q = 0; q < along[1].count(); ++q) {
            const std::size_t after_p = along[0].next(p), after_q = along[1].next(q);
            const bool is = is_solid(p, q);
            if (is) {
                Part face = part;
                face.normal = along_axis(axis);
                face.spans = both(span_of(0, p), span_of(1, q));
                add(face);
            }
            Part edge = part;
            if (is != is_solid(after_p, q)) {
                edge.place[along[0].axis] = along[0].to[p];
                edge.spans = span_of(1, q);
                add(edge);
            }
            edge = part;
            if (is != is_solid(p, after_q)) {
                edge.place[along[1].axis] = along[1].to[q];
                edge.spans = span_of(0, p);
                add(edge);
            }
            const bool up = is_solid(p, after_q), right = is_solid(after_p, q),
                       beyond = is_solid(after_p, after_q);
            if ((is != right || up != beyond) && (is != up || right != beyond)) {
                Part corner = part;
                for (const std::size_t k : {0U, 1U})
                    corner.place[along[k].axis] = along[k].to[k == 0 ? p : q];
                add(corner);
            }
        }
}

void SlowSurfaces::add_obstacle(const Obstacle& obstacle, std::int32_t surface) {
    if (const auto* ball = std::get_if<Obstacle::Ball>(&obstacle.shape))
        return add({.surface = surface, .place = slow(ball->center), .radius = ball->radius});
    if (const auto* cuboid = std::get_if<Obstacle::Cuboid>(&obstacle.shape)) {
        // Along each axis a part is at the lower end, at the upper end, or spans it.
        for (int k = 0; k < 26; ++k) {
            Part part;
            part.surface = surface;
            int axis = 0, across = 0;
            for (int code = k; axis < 3; ++axis, code /= 3) {
                const long double low = cuboid->low[axis], high = cuboid->high[axis];
                if (code % 3 == 2)
                    part.spans.push_back({along_axis(axis), low, high});
                else
                    part.place[across = axis] = code % 3 == 0 ? low : high;
            }
            if (part.spans.size() == 2) part.normal = along_axis(across);
            add(part);
        }
        return;
    }
    const auto& lines = std::get<Obstacle::Lines>(obstacle.shape);
    const auto& corners = lines.corners;
    const auto corner = [&](std::size_t k) { return slow(corners[k % corners.size()]); };
    for (std::size_t k = 0; k < corners.size(); ++k) add({.surface = surface, .place = corner(k)});
    for (std::size_t k = 0; k + (lines.is_closed ? 0 : 1) < corners.size(); ++k) {
        const Vector line = corner(k + 1) - corner(k);
        const long double length = size(line);
        const Vector along = (1.0L / length) * line;
        add({.surface = surface,
             .place = corner(k),
             .spans = {{along, 0.0L, length}},
             .normal = Vector{-along.y, along.x}});
    }
}

}  // namespace carom::test
