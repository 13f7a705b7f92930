#include "physics/placement/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

#include "physics/placement/draws.h"
#include "physics/placement/feasibility.h"
#include "physics/placement/lattice.h"
#include "physics/placement/line_placement.h"
#include "physics/placement/placed_disks.h"
#include "util/interrupt.h"
#include "util/random.h"

namespace carom {
namespace {

// At packing 0.5 the last disks need a few hundred; random placement jams at 0.547.
constexpr int most_tries = 20'000;

template <typename Rule>
bool has_position(const Species& species) {
    return std::holds_alternative<Rule>(species.position);
}

class Placement {
  public:
    explicit Placement(const Gas& gas) : gas_(gas), placed_(gas.box, 0, 0.0) {}

    std::pair<Particles, Sample> run() {
        std::tie(particles_, start_) = draw_gas(gas_);
        count_ = particles_.count();
        refuse(placement_problems(gas_, particles_));
        placed_ = PlacedDisks(gas_.box, count_, typical_radius());
        place_listed();
        place_on_lattice();
        place_at_random();
        return {std::move(particles_), std::move(start_)};
    }

  private:
    std::size_t species_of(Eigen::Index i) const {
        return static_cast<std::size_t>(particles_.species[i]);
    }

    // Many disks are small where sizes differ: half of the mean keeps their cells small.
    double typical_radius() const { return count_ > 0 ? 0.5 * particles_.radius.mean() : 0.0; }

    void refuse(const std::vector<Problem>& problems) const {
        if (!problems.empty()) throw PlacementError(problems.front(), gas_);
    }

    void put(Eigen::Index i, const Eigen::Array2d& centre) {
        start_.position.row(i) = centre;
        placed_.add(static_cast<std::int32_t>(i), centre, particles_.radius[i]);
    }

    void place_listed() {
        Eigen::Index first = 0;
        for (const Species& species : gas_.species) {
            if (const auto* places = std::get_if<Places>(&species.position))
                for (std::size_t k = 0; k < places->values.size(); ++k)
                    put(first + static_cast<Eigen::Index>(k), places->values[k]);
            first += static_cast<Eigen::Index>(species.count);
        }
    }

    // All species on the lattice share one; which disk has which site is random where they differ.
    void place_on_lattice() {
        std::vector<Eigen::Index> disks;
        double radius = 0.0;
        std::size_t kinds = 0;
        Eigen::Index first = 0;
        for (const Species& species : gas_.species) {
            const auto count = static_cast<Eigen::Index>(species.count);
            if (has_position<LatticePlaces>(species) && count > 0) {
                ++kinds;
                for (Eigen::Index i = first; i < first + count; ++i) disks.push_back(i);
                radius = std::max(radius, particles_.radius.segment(first, count).maxCoeff());
            }
            first += count;
        }
        if (disks.empty()) return;
        const std::vector<Eigen::Array2d> sites = free_sites(disks, radius);
        if (kinds > 1) shuffle(disks);
        for (std::size_t k = 0; k < disks.size(); ++k)  // sites left over are spread evenly
            put(disks[k], sites[k * sites.size() / disks.size()]);
    }

    void shuffle(std::vector<Eigen::Index>& disks) const {
        Random random(gas_.seed, "sites of the lattice");
        for (std::size_t k = disks.size(); k > 1; --k)
            std::swap(disks[k - 1], disks[random.below(k)]);
    }

    // Of the fitting lattices the widest that has enough sites clear of the disks placed before.
    std::vector<Eigen::Array2d> free_sites(const std::vector<Eigen::Index>& disks,
                                           double radius) const {
        std::size_t most = 0;
        const int wanted = static_cast<int>(disks.size());
        for (int count = wanted; count <= 4 * wanted + 64; count += std::max(1, count / 50)) {
            const auto lattices = fitting_lattices(gas_.box, count, radius);
            if (lattices.empty()) break;
            std::vector<Eigen::Array2d> sites = lattice_sites(gas_.box, lattices.front(), radius);
            std::erase_if(
                sites, [&](const Eigen::Array2d& site) { return !placed_.is_free(site, radius); });
            if (sites.size() >= disks.size()) return sites;
            most = std::max(most, sites.size());
        }
        throw PlacementError({.kind = Problem::Kind::lattice_taken,
                              .species = species_of(disks.front()),
                              .count = wanted,
                              .fitting = static_cast<std::int64_t>(most),
                              .value = radius},
                             gas_);
    }

    void place_at_random() {
        std::vector<Eigen::Index> disks;
        std::vector<Random> random;
        for (std::size_t s = 0; s < gas_.species.size(); ++s)
            random.emplace_back(gas_.seed, fmt::format("position of species {}", s));
        for (Eigen::Index i = 0; i < count_; ++i) {
            const Species& species = gas_.species[species_of(i)];
            if (has_position<RandomPlaces>(species) || has_position<WithinRegion>(species))
                disks.push_back(i);
        }
        std::stable_sort(disks.begin(), disks.end(), [&](Eigen::Index a, Eigen::Index b) {
            return particles_.radius[a] > particles_.radius[b];
        });
        std::vector<std::int64_t> found(gas_.species.size(), 0);
        for (const Eigen::Index i : disks) {
            const std::size_t s = species_of(i);
            if (!place_somewhere(i, random[s])) refuse({no_place(s, found[s])});
            ++found[s];
            if (found[s] % 1024 == 0) throw_if_interrupted();
        }
    }

    bool place_somewhere(Eigen::Index i, Random& random) {
        const Species& species = gas_.species[species_of(i)];
        const double radius = particles_.radius[i];
        Eigen::Array2d low(0.0, 0.0), high = gas_.box.size;
        const auto* within = std::get_if<WithinRegion>(&species.position);
        if (within) {
            low = within->region.low;
            high = within->region.high;
        }
        for (int a = 0; a < 2; ++a) {
            if (!within && gas_.box.is_periodic(a)) continue;
            low[a] += radius;
            high[a] -= radius;
            if (low[a] > high[a]) return false;
        }
        for (int tries = 0; tries < most_tries; ++tries) {
            const double x = random.uniform(low[0], high[0]);
            const double y = random.uniform(low[1], high[1]);
            if (!placed_.is_free({x, y}, radius)) continue;
            put(i, {x, y});
            return true;
        }
        return false;
    }

    // The packing fraction is that of all disks in the box, or of the species in its region.
    Problem no_place(std::size_t s, std::int64_t found) const {
        const auto* within = std::get_if<WithinRegion>(&gas_.species[s].position);
        const auto own = particles_.species == static_cast<int>(s);
        const Eigen::ArrayXd radii =
            within ? Eigen::ArrayXd(own.select(particles_.radius, 0.0)) : particles_.radius;
        const double covered = std::numbers::pi * radii.square().sum();
        const double room =
            within ? (within->region.high - within->region.low).prod() : gas_.box.size.prod();
        return {.kind = Problem::Kind::no_place,
                .species = s,
                .fitting = found,
                .value = covered / room};
    }

    const Gas& gas_;
    Eigen::Index count_ = 0;
    Particles particles_;
    Sample start_;
    PlacedDisks placed_;
};

}  // namespace

std::pair<Particles, Sample> place(const Gas& gas) {
    return gas.box.dimension == 1 ? place_on_line(gas) : Placement(gas).run();
}

}  // namespace carom
