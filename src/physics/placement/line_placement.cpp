#include "physics/placement/line_placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

#include "physics/placement/draws.h"
#include "physics/placement/line_room.h"
#include "physics/placement/placed_disks.h"
#include "physics/placement/placement.h"
#include "util/random.h"

namespace carom {
namespace {

// Beads that are placed together: those on the lattice, those in one part of the wire, or those
// anywhere.
struct Group {
    std::vector<Eigen::Index> beads;
    Stretch part{0.0, 0.0};
    bool whole_wire = true;
    bool even = false;
};

class WirePlacement {
  public:
    explicit WirePlacement(const Gas& gas)
        : gas_(gas),
          length_(gas.box.size[0]),
          ring_(gas.box.walls[0] == Wall::periodic),
          room_(gas.box),
          random_(gas.seed, "places on the wire") {}

    std::pair<Particles, Sample> run() {
        std::tie(particles_, start_) = draw_gas(gas_);
        check_lengths();
        place_listed();
        for (Group& group : groups()) place_group(group);
        return {std::move(particles_), std::move(start_)};
    }

  private:
    std::size_t species_of(Eigen::Index i) const {
        return static_cast<std::size_t>(particles_.species[i]);
    }
    double length(Eigen::Index i) const { return 2.0 * particles_.radius[i]; }

    template <typename Function>
    void for_each_species(Function&& f) const {
        Eigen::Index first = 0;
        for (const Species& species : gas_.species) {
            f(species, first);
            first += static_cast<Eigen::Index>(species.count);
        }
    }

    // What cannot be is told without trying.
    void check_lengths() const {
        const double all = 2.0 * particles_.radius.sum();
        if (all <= length_ * (1.0 + touching_tolerance)) return;
        Eigen::ArrayXd by_species =
            Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(gas_.species.size()));
        for (Eigen::Index i = 0; i < particles_.count(); ++i)
            by_species[particles_.species[i]] += length(i);
        Eigen::Index largest = 0;
        by_species.maxCoeff(&largest);
        const auto species = static_cast<std::size_t>(largest);
        throw PlacementError(
            species,
            fmt::format("{} {} cannot have room: all beads together are {:.6g} long and "
                        "the wire {:g}; use fewer or shorter beads, or a longer wire",
                        gas_.species[species].count, particles_of(gas_, species), all, length_));
    }

    void place_listed() {
        std::vector<Eigen::Index> beads;
        for_each_species([&](const Species& species, Eigen::Index first) {
            const auto* places = std::get_if<Places>(&species.position);
            if (places == nullptr) return;
            assert(places->values.size() == static_cast<std::size_t>(species.count));
            for (std::size_t k = 0; k < places->values.size(); ++k) {
                beads.push_back(first + static_cast<Eigen::Index>(k));
                place_at(beads.back(), places->values[k][0]);
            }
        });
        std::stable_sort(beads.begin(), beads.end(), [&](Eigen::Index a, Eigen::Index b) {
            return start_.position(a, 0) < start_.position(b, 0);
        });
        for (std::size_t k = 0; k + 1 < beads.size(); ++k) check_apart(beads[k], beads[k + 1], 0.0);
        if (ring_ && beads.size() > 1) check_apart(beads.back(), beads.front(), length_);
        take(beads);
    }

    void place_at(Eigen::Index i, double x) {
        const double radius = particles_.radius[i];
        const double margin = ring_ ? 0.0 : radius - touching_tolerance * length_;
        if (!(x >= margin && x <= length_ - margin))
            throw PlacementError(
                species_of(i),
                fmt::format("particle {} of radius {:g} at {:g} is not inside the wire of length "
                            "{:g}; move it",
                            i, radius, x, length_));
        put(i, x);
    }

    void check_apart(Eigen::Index left, Eigen::Index right, double turn) const {
        const double apart = start_.position(right, 0) + turn - start_.position(left, 0);
        const double needed = particles_.radius[left] + particles_.radius[right];
        if (apart > 0.0 && apart >= needed - touching_tolerance * length_) return;
        const auto [first, second] = std::minmax(left, right);
        throw PlacementError(
            species_of(second),
            apart == 0.0
                ? fmt::format("particles {} and {} are two beads at one place, {:g}; move one of "
                              "them, so that they have an order",
                              first, second, start_.position(second, 0))
                : fmt::format("particles {} and {} overlap: their centres are {:.6g} apart and "
                              "their radii add up to {:.6g}; move them apart",
                              first, second, apart, needed));
    }

    // Beads that may be anywhere come last; of parts of the wire the shortest comes first.
    std::vector<Group> groups() const {
        Group lattice, anywhere;
        lattice.even = true;
        std::vector<Group> parts;
        for_each_species([&](const Species& species, Eigen::Index first) {
            std::vector<Eigen::Index> beads(static_cast<std::size_t>(species.count));
            std::iota(beads.begin(), beads.end(), first);
            Group* group = &anywhere;
            if (std::holds_alternative<Places>(species.position)) return;
            if (std::holds_alternative<LatticePlaces>(species.position)) group = &lattice;
            if (const auto* within = std::get_if<WithinRegion>(&species.position))
                group = &part_in(parts, {within->region.low[0], within->region.high[0]});
            group->beads.insert(group->beads.end(), beads.begin(), beads.end());
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
        parts.push_back({.beads = {}, .part = part, .whole_wire = false});
        return parts.back();
    }

    void place_group(Group& group) {
        std::vector<Eigen::Index>& beads = group.beads;
        if (beads.empty()) return;
        const bool one_species = species_of(beads.front()) == species_of(beads.back());
        if (!group.even || !one_species) shuffle(beads);
        if (ring_ && group.whole_wire && room_.empty()) {
            // Where a ring begins is of no matter; its first bead makes a stretch of the rest.
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
            group.whole_wire ? room_.free() : room_.free_within(group.part);
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

    // Beads from left to right with equal or with random gaps. False when there are not as many
    // different places.
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

    // Random numbers are finite in number: two points may have fallen on one.
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

    void shuffle(std::vector<Eigen::Index>& beads) {
        for (std::size_t k = beads.size(); k > 1; --k)
            std::swap(beads[k - 1], beads[random_.below(k)]);
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
        const std::size_t species = species_of(longest);
        double free = 0.0, widest = 0.0;
        for (const Stretch& stretch : stretches) {
            free += stretch.room();
            widest = std::max(widest, stretch.room());
        }
        return {species,
                fmt::format("{} {} have no room {}: together they are {:.6g} long, and the free "
                            "stretches {:.6g}, the widest {:.6g}; use fewer or shorter beads, {}",
                            group.beads.size(), names(group),
                            group.whole_wire ? "on the wire" : "in their part of the wire",
                            sum_of_lengths(group.beads), free, widest,
                            group.whole_wire ? "or a longer wire" : "or a longer part")};
    }

    std::string names(const Group& group) const {
        const auto [first, last] = std::minmax_element(
            group.beads.begin(), group.beads.end(),
            [&](auto a, auto b) { return particles_.species[a] < particles_.species[b]; });
        return species_of(*first) == species_of(*last) ? particles_of(gas_, species_of(*first))
                                                       : "beads";
    }

    const Gas& gas_;
    double length_;
    bool ring_;
    Particles particles_;
    Sample start_;
    WireRoom room_;
    Random random_;
};

}  // namespace

std::pair<Particles, Sample> place_on_wire(const Gas& gas) { return WirePlacement(gas).run(); }

}  // namespace carom
