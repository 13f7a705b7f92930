#include "physics/placement/jam.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "physics/placement/placed_particles.h"

namespace carom {
namespace {

constexpr Eigen::Index wall = -1;

struct Jam {
    Eigen::Index particle;
    bool alone;  ///< it is the whole row
};

/// A particle, or a wall, on a line along one axis.
struct Link {
    double x, radius, velocity;
    bool holds;  ///< is not moved by collisions
    Eigen::Index particle;
};

// The chain from its first to its last link. These are walls, or in a periodic box the same link
// twice, if possible one of infinite mass.
std::vector<Link> closed_chain(std::vector<Link> links, double length, bool periodic) {
    if (!periodic) {
        links.insert(links.begin(), {0.0, 0.0, 0.0, true, wall});
        links.push_back({length, 0.0, 0.0, true, wall});
        return links;
    }
    const auto first = std::ranges::find(links, true, &Link::holds);
    for (auto link = links.begin(); first != links.end() && link != first; ++link)
        link->x += length;
    if (first != links.end()) std::rotate(links.begin(), first, links.end());
    links.push_back(links.front());
    links.back().x += length;
    return links;
}

// Finds a jam in a row between two links that hold, without room between any two links.
std::optional<Jam> jam_of(std::span<const Link> row) {
    const double velocity = row.front().velocity;
    if (velocity < row.back().velocity) return std::nullopt;  // the row opens
    for (const Link& link : row.subspan(1, row.size() - 2))
        if (link.velocity != velocity || velocity > row.back().velocity)
            return Jam{link.particle, row.size() == 3 && row.front().particle == wall &&
                                          row.back().particle == wall};
    return std::nullopt;
}

std::optional<Jam> jam_on_line(const std::vector<Link>& links, double length, bool periodic) {
    const std::vector<Link> chain = closed_chain(links, length, periodic);
    std::size_t begin = 0;  // first link of a row of touching links
    for (std::size_t k = 1; k < chain.size(); ++k) {
        const double room = chain[k].x - chain[k - 1].x - chain[k].radius - chain[k - 1].radius;
        if (room > touching_tolerance * length) begin = k;
        if (!chain[k].holds && k + 1 < chain.size()) continue;
        const bool held = chain[begin].holds || begin == 0;
        if (held && begin < k)
            if (const auto jam = jam_of(std::span(chain).subspan(begin, k - begin + 1))) return jam;
        begin = k;
    }
    return std::nullopt;
}

// Those of some particles that lie on one line along an axis: divided by their coordinates along
// all other axes, from `across` on.
void divide_into_lines(const Box& box, const Sample& start, int axis, int across,
                       std::vector<Eigen::Index> particles,
                       std::vector<std::vector<Eigen::Index>>& lines) {
    if (across == axis) ++across;
    if (across >= box.dimension) {
        lines.push_back(std::move(particles));
        return;
    }
    const auto level = [&](Eigen::Index i) { return start.position(i, across); };
    std::ranges::stable_sort(particles, {}, level);
    const double same_level = touching_tolerance * box.size[across];
    for (auto begin = particles.begin(), end = begin; begin != particles.end(); begin = end) {
        while (end != particles.end() && level(*end) <= level(*begin) + same_level) ++end;
        divide_into_lines(box, start, axis, across + 1, {begin, end}, lines);
    }
}

std::optional<Jam> jam_along(int axis, const Box& box, const Particles& particles,
                             const Sample& start) {
    std::vector<Eigen::Index> all(static_cast<std::size_t>(particles.count()));
    std::iota(all.begin(), all.end(), Eigen::Index{0});
    std::vector<std::vector<Eigen::Index>> lines;
    divide_into_lines(box, start, axis, 0, std::move(all), lines);
    const double length = box.size[axis];
    const bool periodic = box.is_periodic(axis);
    for (const std::vector<Eigen::Index>& line : lines) {
        std::vector<Link> links;
        for (const Eigen::Index i : line)
            links.push_back({start.position(i, axis), particles.radius[i], start.velocity(i, axis),
                             !(particles.inverse_mass[i] > 0.0), i});
        std::ranges::stable_sort(links, {}, &Link::x);
        if (const auto jam = jam_on_line(links, length, periodic)) return jam;
        // In a complete row without room, particles of infinite mass cannot move either.
        for (Link& link : links) link.holds = false;
        if (const auto jam = jam_on_line(links, length, periodic)) return jam;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Problem> first_jam(const Box& box, const Particles& particles, const Sample& start) {
    for (int axis = 0; axis < box.dimension; ++axis)
        if (const auto jam = jam_along(axis, box, particles, start))
            return Problem{.kind = jam->alone ? Problem::Kind::jam_alone : Problem::Kind::jam,
                           .species = static_cast<std::size_t>(particles.species[jam->particle]),
                           .particle = jam->particle};
    return std::nullopt;
}

}  // namespace carom
