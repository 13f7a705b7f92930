#include "physics/placement/line_placement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "physics/placement/line_room.h"
#include "physics/placement/members.h"
#include "physics/placement/placed_particles.h"
#include "physics/placement/problem.h"
#include "util/random.h"

namespace carom {
namespace {

// Beads that are placed together: those on the lattice, those in one part of the line, or those
// anywhere.
struct Group {
    std::vector<Eigen::Index> beads;
    Stretch part{0.0, 0.0};
    bool whole_line = true;
    bool even = false;
};

class LinePlacement {
  public:
    LinePlacement(const Gas& gas, const Particles& particles, Sample& start)
        : gas_(gas),
          length_(gas.box.size[0]),
          ring_(gas.box.is_periodic(0)),
          particles_(particles),
          start_(start),
          room_(gas.box),
          random_(gas.seed, "places on the wire") {}

    void run() {
        place_listed();
        for (Group& group : groups()) place_group(group);
    }

  private:
    std::size_t species_of(Eigen::Index i) const {
        return static_cast<std::size_t>(particles_.species[i]);
    }
    double length(Eigen::Index i) const { return 2.0 * particles_.radius[i]; }

    void place_listed() {
        std::vector<Eigen::Index> beads;
        for_each_listed(gas_, [&](std::size_t, Eigen::Index i, const Vec& place) {
            beads.push_back(i);
            put(i, place[0]);
        });
        take(beads);
    }

    // Groups in the order of placement: beads that may be anywhere come last, and shorter parts of
    // the line come before longer ones.
    std::vector<Group> groups() const {
        Group lattice, anywhere;
        lattice.even = true;
        std::vector<Group> parts;
        for_each_species(gas_, [&](std::size_t s, Eigen::Index first, Eigen::Index count) {
            const Species& species = gas_.species[s];
            if (has_position<Places>(species)) return;
            Group* group = has_position<LatticePlaces>(species) ? &lattice : &anywhere;
            if (const auto* within = std::get_if<WithinRegion>(&species.position))
                group = &part_in(parts, {within->region.low[0], within->region.high[0]});
            for (Eigen::Index i = first; i < first + count; ++i) group->beads.push_back(i);
        });
        std::stable_sort(parts.begin(), parts.end(), [](const Group& a, const Group& b) {
            return a.part.room() < b.part.room();
        });
        parts.insert(parts.begin(), std::move(lattice));
        parts.push_back(std::move(anywhere));
        return parts;
    }

    static Group& part_in(std::vector<Group>& parts, Stretch part) {
        for (Group& group : parts)
            if (group.part.low == part.low && group.part.high == part.high) return group;
        parts.push_back({.beads = {}, .part = part, .whole_line = false});
        return parts.back();
    }

    void place_group(Group& group) {
        std::vector<Eigen::Index>& beads = group.beads;
        if (beads.empty()) return;
        const bool one_species = species_of(beads.front()) == species_of(beads.back());
        if (!group.even || !one_species) random_.shuffle(beads);
        if (ring_ && group.whole_line && room_.empty()) {
            // The origin of a ring is arbitrary; the first bead turns the rest of it into one
            // stretch.
            const double gap = (length_ - sum_of_lengths(beads)) / double(beads.size());
            put(beads.front(), group.even ? 0.5 * gap + particles_.radius[beads.front()]
                                          : random_.uniform(0.0, length_));
            take({beads.front()});
            beads.erase(beads.begin());
        }
        share(group);
    }

    void share(const Group& group) {
        const std::vector<Stretch> stretches =
            group.whole_line ? room_.free() : room_.free_within(group.part);
        std::vector<std::size_t> ranks(group.beads.size());  // from the longest to the shortest
        std::iota(ranks.begin(), ranks.end(), 0);
        std::stable_sort(ranks.begin(), ranks.end(), [&](std::size_t a, std::size_t b) {
            return length(group.beads[a]) > length(group.beads[b]);
        });
        std::vector<double> lengths;
        for (const std::size_t rank : ranks) lengths.push_back(length(group.beads[rank]));
        if (lengths.empty()) return;
        const Shares shares = group.even ? share_evenly(stretches, lengths)
                                         : share_at_random(stretches, lengths, random_);
        if (!shares) throw no_room(group, stretches);
        std::vector<std::size_t> stretch_of(ranks.size());
        for (std::size_t k = 0; k < ranks.size(); ++k) stretch_of[ranks[k]] = (*shares)[k];
        if (group.even && lengths.front() == lengths.back())
            std::sort(stretch_of.begin(), stretch_of.end());  // from left to right by number
        std::vector<std::vector<Eigen::Index>> members(stretches.size());
        for (std::size_t k = 0; k < stretch_of.size(); ++k)
            members[stretch_of[k]].push_back(group.beads[k]);
        for (std::size_t i = 0; i < stretches.size(); ++i)
            if (!spread(members[i], stretches[i], group.even)) throw no_room(group, stretches);
        take(group.beads);
    }

    // Places beads from left to right with equal or with random gaps. Returns false if there are
    // not enough distinct positions.
    bool spread(const std::vector<Eigen::Index>& beads, const Stretch& stretch, bool even) {
        const double rest = std::max(0.0, stretch.room() - sum_of_lengths(beads));
        std::vector<double> gaps(beads.size());  // added up from the left
        for (std::size_t k = 0; k < beads.size(); ++k)
            gaps[k] = rest * (even ? double(k + 1) / double(beads.size() + 1) : random_.uniform());
        std::sort(gaps.begin(), gaps.end());
        std::vector<double> x(beads.size());
        double before = stretch.low;
        for (std::size_t k = 0; k < beads.size(); ++k) {
            x[k] = before + gaps[k] + particles_.radius[beads[k]];
            before += length(beads[k]);
        }
        if (!make_distinct(x, stretch)) return false;
        for (std::size_t k = 0; k < beads.size(); ++k) put(beads[k], x[k]);
        return true;
    }

    // Two points may have the same position, because there are only finitely many random numbers.
    static bool make_distinct(std::vector<double>& x, const Stretch& stretch) {
        constexpr double up = std::numeric_limits<double>::infinity();
        double least = stretch.low;
        for (double& place : x) {
            place = std::max(place, std::nextafter(least, up));
            least = place;
        }
        double most = stretch.high;
        for (std::size_t k = x.size(); k-- > 0; most = x[k])
            x[k] = std::min(x[k], std::nextafter(most, -up));
        return x.empty() || x.front() > stretch.low;
    }

    double sum_of_lengths(const std::vector<Eigen::Index>& beads) const {
        return std::accumulate(beads.begin(), beads.end(), 0.0,
                               [&](double sum, Eigen::Index i) { return sum + length(i); });
    }

    void put(Eigen::Index i, double x) {
        start_.position(i, 0) = ring_ && x >= length_ ? x - length_ : x;
    }

    void take(const std::vector<Eigen::Index>& beads) {
        std::vector<Stretch> taken;
        for (const Eigen::Index i : beads)
            taken.push_back({start_.position(i, 0) - particles_.radius[i],
                             start_.position(i, 0) + particles_.radius[i]});
        room_.take(std::move(taken));
    }

    PlacementError no_room(const Group& group, const std::vector<Stretch>& stretches) const {
        const Eigen::Index longest =
            *std::max_element(group.beads.begin(), group.beads.end(),
                              [&](auto a, auto b) { return length(a) < length(b); });
        const bool one_species = std::ranges::all_of(
            group.beads, [&](auto i) { return species_of(i) == species_of(longest); });
        Problem problem{.kind = Problem::Kind::no_stretch,
                        .species = species_of(longest),
                        .particle = one_species ? longest : -1,
                        .count = static_cast<std::int64_t>(group.beads.size()),
                        .value = sum_of_lengths(group.beads)};
        for (const Stretch& stretch : stretches) {
            problem.bound += stretch.room();
            problem.widest = std::max(problem.widest, stretch.room());
        }
        return {problem, gas_};
    }

    const Gas& gas_;
    double length_;
    bool ring_;
    const Particles& particles_;
    Sample& start_;
    LineRoom room_;
    Random random_;
};

}  // namespace

void place_on_line(const Gas& gas, const Particles& particles, Sample& start) {
    LinePlacement(gas, particles, start).run();
}

}  // namespace carom
