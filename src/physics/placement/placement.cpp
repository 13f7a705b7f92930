#include "physics/placement/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/placement/draws.h"
#include "physics/placement/feasibility.h"
#include "physics/placement/lattice.h"
#include "physics/placement/line_placement.h"
#include "physics/placement/members.h"
#include "physics/placement/placed_particles.h"
#include "util/interrupt.h"
#include "util/random.h"

namespace carom {
namespace {

// In the plane random placement ends at packing 0.547, and at 0.5 the last disks need a few hundred
// tries. In space it ends at 0.384 (problem.h), and the last spheres need 300 tries at 0.3, 3,000
// at 0.33 and 100,000 at 0.36.
constexpr int most_tries_in(int dimension) { return dimension == 2 ? 20'000 : 2'000'000; }

template <int dimension>
class Placement {
  public:
    Placement(const Gas& gas, const Particles& particles, Sample& start)
        : gas_(gas), particles_(particles), start_(start), placed_(gas.box, particles.radius) {}

    void run() {
        for_each_listed(gas_,
                        [&](std::size_t, Eigen::Index i, const Vec& place) { place_at(i, place); });
        place_on_lattice();
        place_at_random();
    }

  private:
    std::size_t species_of(Eigen::Index i) const {
        return static_cast<std::size_t>(particles_.species[i]);
    }

    void place_at(Eigen::Index i, const Vec& centre) {
        put(centre, start_.position, i);
        placed_.add(static_cast<std::int32_t>(i), centre, particles_.radius[i]);
    }

    // All species on the lattice share one; which particle has which site is random where they
    // differ.
    void place_on_lattice() {
        auto [numbers, radius, smallest] = particles_on_lattice(gas_, particles_);
        if (numbers.empty()) return;
        const std::vector<Vec> sites = free_sites(numbers, radius);
        if (species_of(numbers.front()) != species_of(numbers.back()))
            Random(gas_.seed, "sites of the lattice").shuffle(numbers);
        for (std::size_t k = 0; k < numbers.size(); ++k)  // sites left over are spread evenly
            place_at(numbers[k], sites[k * sites.size() / numbers.size()]);
    }

    // The free sites of the most widely spaced fitting lattice that has enough sites clear of the
    // particles placed before.
    std::vector<Vec> free_sites(const std::vector<Eigen::Index>& numbers, double radius) const {
        std::size_t most = 0;
        const std::int64_t wanted = std::ssize(numbers);
        for (std::int64_t count = wanted; count <= 4 * wanted + 64;
             count += std::max<std::int64_t>(1, count / 50)) {
            const auto lattice = fitting_lattice(gas_.box, count, radius);
            if (!lattice) break;
            std::vector<Vec> sites = lattice_sites(gas_.box, *lattice, radius);
            std::erase_if(sites, [&](const Vec& site) { return !placed_.is_free(site, radius); });
            if (sites.size() >= numbers.size()) return sites;
            most = std::max(most, sites.size());
        }
        throw PlacementError({.kind = Problem::Kind::lattice_taken,
                              .species = species_of(numbers.front()),
                              .count = wanted,
                              .fitting = static_cast<std::int64_t>(most),
                              .value = radius},
                             gas_);
    }

    void place_at_random() {
        std::vector<Eigen::Index> numbers;
        std::vector<Random> random;
        for (std::size_t s = 0; s < gas_.species.size(); ++s)
            random.emplace_back(gas_.seed, fmt::format("position of species {}", s));
        for (Eigen::Index i = 0; i < particles_.count(); ++i) {
            const Species& species = gas_.species[species_of(i)];
            if (has_position<RandomPlaces>(species) || has_position<WithinRegion>(species))
                numbers.push_back(i);
        }
        std::stable_sort(numbers.begin(), numbers.end(), [&](Eigen::Index a, Eigen::Index b) {
            return particles_.radius[a] > particles_.radius[b];
        });
        std::vector<std::int64_t> found(gas_.species.size(), 0);
        for (const Eigen::Index i : numbers) {
            const std::size_t s = species_of(i);
            if (!place_somewhere(i, random[s])) throw PlacementError(no_place(s, found[s]), gas_);
            ++found[s];
        }
    }

    bool place_somewhere(Eigen::Index i, Random& random) {
        const Species& species = gas_.species[species_of(i)];
        const double radius = particles_.radius[i];
        Vec low, high = gas_.box.size;
        const auto* within = std::get_if<WithinRegion>(&species.position);
        if (within) {
            low = within->region.low;
            high = within->region.high;
        }
        for (int a = 0; a < dimension; ++a) {
            if (!within && gas_.box.is_periodic(a)) continue;
            low[a] += radius;
            high[a] -= radius;
            if (low[a] > high[a]) return false;
        }
        for (int tries = 0; tries < most_tries_in(dimension); ++tries) {
            Vec centre;
            for (int a = 0; a < dimension; ++a) centre[a] = random.uniform(low[a], high[a]);
            if (!placed_.is_free(centre, radius)) continue;
            place_at(i, centre);
            return true;
        }
        return false;
    }

    // The packing fraction is that of all particles in the box, or of the species in its region.
    Problem no_place(std::size_t s, std::int64_t found) const {
        const auto* within = std::get_if<WithinRegion>(&gas_.species[s].position);
        const auto own = particles_.species == static_cast<int>(s);
        const Eigen::ArrayXd radii =
            within ? Eigen::ArrayXd(own.select(particles_.radius, 0.0)) : particles_.radius;
        const Vec sides = within ? within->region.high - within->region.low : gas_.box.size;
        return {.kind = Problem::Kind::no_place,
                .species = s,
                .fitting = found,
                .value = sum_of_sizes(gas_.box, radii) / content_of(sides, gas_.box.dimension)};
    }

    const Gas& gas_;
    const Particles& particles_;
    Sample& start_;
    PlacedParticles<dimension> placed_;
};

}  // namespace

std::pair<Particles, Sample> place(const Gas& gas) {
    const EndsAtOnce whole;
    auto [particles, start] = draw_gas(gas);
    if (const auto problems = placement_problems(gas, particles); !problems.empty())
        throw PlacementError(problems.front(), gas);
    if (gas.box.dimension == 1)
        place_on_line(gas, particles, start);
    else if (gas.box.dimension == 2)
        Placement<2>(gas, particles, start).run();
    else
        Placement<3>(gas, particles, start).run();
    return {std::move(particles), std::move(start)};
}

}  // namespace carom
