#include "physics/placement/feasibility.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "physics/placement/draws.h"
#include "physics/placement/jam.h"
#include "physics/placement/lattice.h"
#include "physics/placement/line_squeeze.h"
#include "physics/placement/members.h"
#include "physics/placement/placed_particles.h"

namespace carom {
namespace {

using Eigen::Index;
using Kind = Problem::Kind;

double least_side(const Gas& gas, const Vec& sides) {
    return gas.box.dimension == 1 ? sides[0] * (1.0 + touching_tolerance)
                                  : shortest(sides, gas.box.dimension);
}

double most_covered(const Gas& gas) {
    return densest_packing(gas.box.dimension) + (gas.box.dimension == 1 ? touching_tolerance : 0.0);
}

class PlacementCheck {
  public:
    PlacementCheck(const Gas& gas, const Particles& particles, std::int64_t most_compared)
        : gas_(gas), box_(gas.box), particles_(particles), most_compared_(most_compared) {}

    std::vector<Problem> run() {
        for_each_species(gas_, [&](std::size_t s, Index first, Index count) {
            if (count > 0) check_species(s, particles_.radius.segment(first, count));
        });
        const bool all_fit = std::ranges::none_of(
            found_, [](const Problem& problem) { return problem.kind == Kind::too_large; });
        if (all_fit && check_density() && box_.dimension > 1) {
            check_lattice();
            if (box_.dimension == 3) check_random();
        }
        if (box_.dimension == 1) check_listed_beads();
        if (box_.dimension == 2) check_listed<2>();
        if (box_.dimension == 3) check_listed<3>();
        return std::move(found_);
    }

  private:
    template <typename Radii>
    void check_species(std::size_t s, const Radii& radii) {
        const double largest = radii.maxCoeff();
        if (2.0 * largest > least_side(gas_, box_.size))
            found_.push_back({.kind = Kind::too_large, .species = s, .value = largest});
        const auto* within = std::get_if<WithinRegion>(&gas_.species[s].position);
        if (within == nullptr) return;
        const auto [low, high] = within->region;
        const Vec sides = high - low;
        const double covered = sum_of_sizes(box_, radii) / content_of(sides, box_.dimension);
        if (!box_.contains({low, high}))
            found_.push_back({.kind = Kind::region_outside, .species = s});
        else if (box_.dimension > 1 &&
                 2.0 * largest > shortest(sides, box_.dimension) * (1.0 + touching_tolerance))
            found_.push_back({.kind = Kind::region_too_narrow, .species = s, .value = largest});
        else if (covered > most_covered(gas_))
            found_.push_back({.kind = Kind::region_too_dense, .species = s, .value = covered});
    }

    // If all positions in a plane or in space are listed, the overlap test decides instead.
    bool check_density() {
        const double covered = sum_of_sizes(box_, particles_.radius) / box_.content();
        const bool listed = std::ranges::all_of(gas_.species, has_position<Places>);
        if (covered <= most_covered(gas_) || (listed && box_.dimension > 1)) return true;
        std::size_t largest = 0;
        double most = -1.0;
        for_each_species(gas_, [&](std::size_t s, Index first, Index count) {
            const double its = sum_of_sizes(box_, particles_.radius.segment(first, count));
            if (its > most) largest = s;
            most = std::max(most, its);
        });
        found_.push_back({.kind = Kind::too_dense, .species = largest, .value = covered});
        return false;
    }

    // Whether equal spheres at random places, with no others among them, are more than find room:
    // the trial would last very long. In boxes of ten diameters saturated packings have a standard
    // deviation of 0.004, in larger ones less, and between walls they are less dense.
    void check_random() {
        constexpr double beyond_all = saturated_packing + 0.02, least_diameters = 10.0;
        const auto refuse = [&](std::size_t s, std::int64_t count, double radius,
                                const Vec& sides) {
            const double volume = content_of(sides, 3);
            const double one = content_of_ball(radius, 3);
            const double covered = static_cast<double>(count) * one / volume;
            const double fitting = roomy_packing(3) * volume / one;
            if (covered > beyond_all && shortest(sides, 3) >= least_diameters * 2.0 * radius)
                found_.push_back({.kind = Kind::saturated,
                                  .species = s,
                                  .count = count,
                                  .fitting = static_cast<std::int64_t>(fitting),
                                  .value = covered});
        };
        const auto are_equal = [](const auto& radii) { return (radii == radii[0]).all(); };
        if (std::ranges::all_of(gas_.species, has_position<RandomPlaces>) &&
            particles_.count() > 0 && are_equal(particles_.radius))
            refuse(0, particles_.count(), particles_.radius[0], box_.size);
        for_each_species(gas_, [&](std::size_t s, Index first, Index count) {
            const auto* within = std::get_if<WithinRegion>(&gas_.species[s].position);
            if (within == nullptr || count == 0) return;
            const auto radii = particles_.radius.segment(first, count);
            if (are_equal(radii))
                refuse(s, count, radii[0], within->region.high - within->region.low);
        });
    }

    // All species on the lattice share a single one, on which each particle has as much room as the
    // largest needs.
    void check_lattice() {
        const OnLattice placed = particles_on_lattice(gas_, particles_);
        if (placed.numbers.empty()) return;
        Problem problem{
            .kind = Kind::no_lattice,
            .species = static_cast<std::size_t>(particles_.species[placed.numbers.front()]),
            .count = std::ssize(placed.numbers),
            .value = placed.largest,
            .bound = placed.smallest};
        const auto fits = [&](std::int64_t count) {
            return fitting_lattice(box_, count, problem.value).has_value();
        };
        if (fits(problem.count)) return;
        for (std::int64_t too_many = problem.count; too_many - problem.fitting > 1;) {
            const std::int64_t middle = problem.fitting + (too_many - problem.fitting) / 2;
            (fits(middle) ? problem.fitting : too_many) = middle;
        }
        found_.push_back(problem);
    }

    // Whether a particle is inside the box at its place; reported if it is not.
    bool is_inside(std::size_t s, Index i, const Vec& place, double tolerance_of_radius,
                   double tolerance_of_size) {
        const double radius = particles_.radius[i];
        const double margin = radius * (1.0 - tolerance_of_radius);
        bool inside = true;
        for (int axis = 0; axis < box_.dimension; ++axis) {
            const double size = box_.size[axis], x = place[axis];
            const double least = box_.is_periodic(axis) ? 0.0 : margin - tolerance_of_size * size;
            inside = inside && x >= least && x <= size - least;
        }
        if (!inside)
            found_.push_back({.kind = Kind::outside, .species = s, .particle = i, .value = radius});
        return inside;
    }

    template <int dimension>
    void check_listed() {
        PlacedParticles<dimension> placed(box_, particles_.radius);
        std::vector<Vec> places(static_cast<std::size_t>(particles_.count()));
        for_each_listed(gas_, [&](std::size_t s, Index i, const Vec& place) {
            if (!is_inside(s, i, place, touching_tolerance, 0.0)) return;
            if (placed.compared() > most_compared_) return;
            const double radius = particles_.radius[i];
            if (const auto surface = placed.overlapped_surface(place, radius))
                found_.push_back(
                    {.kind = Kind::in_surface, .species = s, .particle = i, .other = *surface});
            if (const auto other = placed.overlapped(place, radius)) {
                const Vec apart = place - places[static_cast<std::size_t>(*other)];
                found_.push_back({.kind = Kind::overlap,
                                  .species = s,
                                  .particle = i,
                                  .other = *other,
                                  .value = length(box_.nearest(apart)),
                                  .bound = radius + particles_.radius[*other]});
            }
            places[static_cast<std::size_t>(i)] = place;
            placed.add(static_cast<std::int32_t>(i), place, radius);
        });
    }

    void check_listed_beads() {
        Beads beads;
        for_each_listed(gas_, [&](std::size_t s, Index i, const Vec& place) {
            if (is_inside(s, i, place, 0.0, touching_tolerance)) beads.emplace_back(place[0], i);
        });
        std::ranges::sort(beads);
        for_each_two_neighbours(box_, beads, [&](Index left, Index right, double apart) {
            check_apart(left, right, apart);
        });
    }

    void check_apart(Index left, Index right, double apart) {
        const double needed = particles_.radius[left] + particles_.radius[right];
        if (apart > 0.0 && apart >= needed - touching_tolerance * box_.size[0]) return;
        const auto [first, second] = std::minmax(left, right);
        found_.push_back({.kind = apart == 0.0 && needed == 0.0 ? Kind::same_place : Kind::overlap,
                          .species = static_cast<std::size_t>(particles_.species[second]),
                          .particle = second,
                          .other = first,
                          .value = apart,
                          .bound = needed});
    }

    const Gas& gas_;
    const Box& box_;
    const Particles& particles_;
    std::int64_t most_compared_;
    std::vector<Problem> found_;
};

/// Particles whose positions are known before all are placed.
struct Known {
    std::vector<Index> numbers;
    std::vector<Vec> places;

    void add(Index number, const Vec& place) {
        numbers.push_back(number);
        places.push_back(place);
    }
};

class MotionCheck {
  public:
    MotionCheck(const Gas& gas, const Particles& particles, const Sample& drawn)
        : gas_(gas), box_(gas.box), particles_(particles), drawn_(drawn) {}

    std::optional<Problem> run(const Run& run) const {
        const Known known = listed();
        // Beads placed later can only take up more room, so a squeeze found among the listed beads
        // is certain. All beads of infinite mass must be listed, because others might lie between
        // them.
        if (box_.dimension == 1 && are_all_fixed_listed())
            if (const auto squeeze = among(known, [&](const Particles& some, const Sample& start) {
                    return first_squeeze(box_, some, start, run);
                }))
                return squeeze;
        if (const auto jam = jam_among(known)) return jam;
        if (box_.dimension == 1) return jam_among(filling());
        for (Index i = 0; i < particles_.count(); ++i)
            if (2.0 * particles_.radius[i] >= box_.shortest_side() * (1.0 - touching_tolerance))
                if (const auto jam = jam_among({{i}, {0.5 * box_.size}})) return jam;
        return jam_among(on_lattice());
    }

  private:
    bool are_all_fixed_listed() const {
        return std::ranges::all_of(gas_.species, [](const Species& species) {
            return !std::holds_alternative<Infinite>(species.mass) || has_position<Places>(species);
        });
    }

    template <typename Check>
    std::optional<Problem> among(const Known& known, Check&& check) const {
        if (known.numbers.empty()) return std::nullopt;
        Particles some{particles_.radius(known.numbers), particles_.inverse_mass(known.numbers),
                       particles_.species(known.numbers)};
        Sample start{0.0, Eigen::ArrayXXd(some.count(), box_.dimension),
                     drawn_.velocity(known.numbers, Eigen::seqN(0, drawn_.velocity.cols()))};
        for (Index k = 0; k < some.count(); ++k)
            put(known.places[static_cast<std::size_t>(k)], start.position, k);
        std::optional<Problem> problem = check(some, start);
        if (problem)
            for (Index* number : {&problem->particle, &problem->other})
                if (*number >= 0) *number = known.numbers[static_cast<std::size_t>(*number)];
        return problem;
    }

    std::optional<Problem> jam_among(const Known& known) const {
        return among(known, [&](const Particles& some, const Sample& start) {
            return first_jam(box_, some, start);
        });
    }

    Known listed() const {
        Known known;
        for_each_listed(gas_, [&](std::size_t, Index i, const Vec& place) { known.add(i, place); });
        return known;
    }

    // All beads, if they fill the line, in an arbitrary order: none of them has room.
    Known filling() const {
        Known known;
        if (2.0 * particles_.radius.sum() < box_.size[0] * (1.0 - touching_tolerance)) return known;
        double end = 0.0;
        for (Index i = 0; i < particles_.count(); ++i) {
            known.add(i, {end + particles_.radius[i], 0.0});
            end += 2.0 * particles_.radius[i];
        }
        return known;
    }

    // The particles of a species on a lattice in which they touch along a side of the box, if only
    // this species uses its sites.
    Known on_lattice() const {
        const auto others = std::ranges::count_if(gas_.species, [](const Species& species) {
            return !has_position<RandomPlaces>(species) && !has_position<WithinRegion>(species);
        });
        const auto [numbers, radius, smallest] = particles_on_lattice(gas_, particles_);
        constexpr double roomy = 0.3;  // fraction covered by squares or cubes around the particles
        double taken = static_cast<double>(numbers.size());
        for (int axis = 0; axis < box_.dimension; ++axis) taken *= 2.0 * radius;
        if (others != 1 || taken < roomy * box_.content()) return {};
        const auto lattice = fitting_lattice(box_, std::ssize(numbers), radius);
        if (!lattice) return {};
        const double touching = 2.0 * radius * (1.0 + touching_tolerance);
        if (2.0 * shortest(lattice->step, box_.dimension) > touching) return {};
        const std::vector<Vec> sites = lattice_sites(box_, *lattice, radius);
        Known known;
        for (std::size_t k = 0; k < numbers.size(); ++k)
            known.add(numbers[k], sites[k * sites.size() / numbers.size()]);
        return known;
    }

    const Gas& gas_;
    const Box& box_;
    const Particles& particles_;
    const Sample& drawn_;
};

}  // namespace

std::vector<Problem> placement_problems(const Gas& gas, const Particles& particles,
                                        std::int64_t most_compared) {
    return PlacementCheck(gas, particles, most_compared).run();
}

std::optional<Problem> motion_problem(const Box& box, const Particles& particles,
                                      const Sample& start, const Run& run) {
    if (box.dimension == 1)
        if (const auto squeeze = first_squeeze(box, particles, start, run)) return squeeze;
    return first_jam(box, particles, start);
}

std::vector<Problem> problems_of(const Gas& gas, const Run* run, std::int64_t most_compared) {
    std::vector<Problem> problems;
    const auto [particles, drawn] = draw_gas(gas, problems);
    if (particles.count() == 0) return problems;
    for (const Problem& problem : placement_problems(gas, particles, most_compared))
        problems.push_back(problem);
    if (run != nullptr && problems.empty())
        if (const auto problem = MotionCheck(gas, particles, drawn).run(*run))
            problems.push_back(*problem);
    return problems;
}

}  // namespace carom
