#include "physics/placement/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

#include "physics/placement/draws.h"
#include "physics/placement/lattice.h"
#include "physics/placement/line_placement.h"
#include "physics/placement/placed_disks.h"
#include "util/interrupt.h"
#include "util/random.h"

namespace carom {
namespace {

constexpr double densest_packing = 0.9069;  // pi / sqrt(12): equal disks, Thue 1892
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
        check_room();
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

    double packing_fraction() const {
        return std::numbers::pi * particles_.radius.square().sum() / gas_.box.size.prod();
    }

    // Many disks are small where sizes differ: half of the mean keeps their cells small.
    double typical_radius() const { return count_ > 0 ? 0.5 * particles_.radius.mean() : 0.0; }

    // What cannot be is told without trying.
    void check_room() const {
        for (Eigen::Index i = 0; i < count_; ++i)
            if (2.0 * particles_.radius[i] > gas_.box.size.minCoeff())
                throw PlacementError(
                    species_of(i),
                    fmt::format(
                        "particle {} of radius {:g} does not fit into a box of {:g} x {:g}; "
                        "use smaller disks or a larger box",
                        i, particles_.radius[i], gas_.box.size[0], gas_.box.size[1]));
        if (count_ < 2) return;
        const double packing = packing_fraction();
        const bool equal = particles_.radius.minCoeff() == particles_.radius.maxCoeff();
        if (packing > (equal ? densest_packing : 1.0)) throw too_dense(packing, equal);
    }

    PlacementError too_dense(double packing, bool equal) const {
        const std::size_t species = largest_share();
        const std::string most = equal ? fmt::format("equal disks fill at most {}", densest_packing)
                                       : std::string("disks fill less than 1");
        return {
            species,
            fmt::format("{} {} cannot have room: the gas would fill {:.3g} of the box and {}; "
                        "use fewer or smaller disks, or a larger box",
                        gas_.species[species].count, particles_of(gas_, species), packing, most)};
    }

    std::size_t largest_share() const {
        Eigen::ArrayXd area = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(gas_.species.size()));
        for (Eigen::Index i = 0; i < count_; ++i)
            area[particles_.species[i]] += particles_.radius[i] * particles_.radius[i];
        Eigen::Index largest = 0;
        area.maxCoeff(&largest);
        return static_cast<std::size_t>(largest);
    }

    void put(Eigen::Index i, const Eigen::Array2d& centre) {
        start_.position.row(i) = centre;
        placed_.add(static_cast<std::int32_t>(i), centre, particles_.radius[i]);
    }

    void place_listed() {
        Eigen::Index first = 0;
        for (const Species& species : gas_.species) {
            if (const auto* places = std::get_if<Places>(&species.position)) {
                assert(places->values.size() == static_cast<std::size_t>(species.count));
                for (std::size_t k = 0; k < places->values.size(); ++k)
                    place_at(first + static_cast<Eigen::Index>(k), places->values[k]);
            }
            first += static_cast<Eigen::Index>(species.count);
        }
    }

    void place_at(Eigen::Index i, const Eigen::Array2d& centre) {
        const double radius = particles_.radius[i];
        for (int a = 0; a < 2; ++a) {
            const bool solid = gas_.box.walls[static_cast<std::size_t>(a)] == Wall::solid;
            const double margin = solid ? radius * (1.0 - touching_tolerance) : 0.0;
            if (centre[a] >= margin && centre[a] <= gas_.box.size[a] - margin) continue;
            throw PlacementError(
                species_of(i),
                fmt::format("particle {} of radius {:g} at [{:g}, {:g}] is not inside the box of "
                            "{:g} x {:g}; move it",
                            i, radius, centre[0], centre[1], gas_.box.size[0], gas_.box.size[1]));
        }
        if (const auto other = placed_.overlapped(centre, radius)) {
            const Eigen::Array2d there = start_.position.row(*other).transpose();
            const double distance =
                std::sqrt(nearest_image(gas_.box, centre - there).square().sum());
            throw PlacementError(
                species_of(i),
                fmt::format("particles {} and {} overlap: their centres are {:.6g} apart and their "
                            "radii add up to {:.6g}; move them apart",
                            *other, i, distance, radius + particles_.radius[*other]));
        }
        put(i, centre);
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
        const std::size_t species = species_of(disks.front());
        throw PlacementError(
            species,
            fmt::format("no hexagonal lattice holds {} {} of radius {:g} in this box (at most {} "
                        "found room) at packing fraction {:.3g}; use fewer or smaller disks, or a "
                        "larger box",
                        disks.size(), particles_of(gas_, species), radius, most,
                        packing_fraction()));
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
            if (!place_somewhere(i, random[s])) throw no_room(s, found[s]);
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
            if (!within && gas_.box.walls[static_cast<std::size_t>(a)] == Wall::periodic) continue;
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

    // The packing fraction told is that of all disks in the box, or of the species in its region.
    PlacementError no_room(std::size_t s, std::int64_t found) const {
        const Species& species = gas_.species[s];
        const auto* within = std::get_if<WithinRegion>(&species.position);
        const auto own = particles_.species == static_cast<int>(s);
        const double packing = within ? std::numbers::pi *
                                            own.select(particles_.radius, 0.0).square().sum() /
                                            (within->region.high - within->region.low).prod()
                                      : packing_fraction();
        return {s,
                fmt::format("only {} of {} {} found room at packing fraction {:.3g}{}; use fewer "
                            "or smaller disks, {}",
                            found, species.count, particles_of(gas_, s), packing,
                            within ? " of their region" : "",
                            within ? "or a larger region" : "a larger box, or position: lattice")};
    }

    const Gas& gas_;
    Eigen::Index count_ = 0;
    Particles particles_;
    Sample start_;
    PlacedDisks placed_;
};

}  // namespace

std::pair<Particles, Sample> place(const Gas& gas) {
    return gas.box.dimension == 1 ? place_on_wire(gas) : Placement(gas).run();
}

}  // namespace carom
