#include "physics/placement/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/gas.h"
#include "physics/placement/line_squeeze.h"

namespace carom {
namespace {

using Kind = Problem::Kind;

bool on_line(const Gas& gas) { return gas.box.dimension == 1; }

// What particles and their room are called.
struct Nouns {
    std::string_view particle, room, smaller, larger;
};
const Nouns& nouns(const Gas& gas) {
    static constexpr Nouns along_line{"bead", "wire", "shorter", "longer"};
    static constexpr Nouns in_plane{"disk", "box", "smaller", "larger"};
    static constexpr Nouns in_space{"sphere", "box", "smaller", "larger"};
    return on_line(gas) ? along_line : gas.box.dimension == 2 ? in_plane : in_space;
}

// Disks of species "cold".
std::string members(const Gas& gas, std::size_t species) {
    const std::string& name = gas.species[species].name;
    return fmt::format("{}s{}", nouns(gas).particle,
                       name.empty() ? "" : fmt::format(" of species \"{}\"", name));
}

// Particle 3 (cold).
std::string called(const Gas& gas, Eigen::Index particle) {
    Eigen::Index end = 0;
    for (const Species& species : gas.species) {
        end += static_cast<Eigen::Index>(species.count);
        if (particle < end && !species.name.empty())
            return fmt::format("particle {} ({})", particle, species.name);
        if (particle < end) break;
    }
    return fmt::format("particle {}", particle);
}

std::string size_of(const Vec& size, const Gas& gas) {
    return gas.box.dimension == 2 ? fmt::format("{} by {}", size[0], size[1])
                                  : fmt::format("{} by {} by {}", size[0], size[1], size[2]);
}

// As particles are inside it, or reach outside.
std::string whole_box(const Gas& gas) {
    return on_line(gas) ? fmt::format("the wire from 0 to {}", gas.box.size[0])
                        : "the box of " + size_of(gas.box.size, gas);
}

Vec size_of_region(const Species& species) {
    const Region& region = std::get<WithinRegion>(species.position).region;
    return region.high - region.low;
}

ProblemText momentum(const Problem& p, const Gas& gas) {
    const bool is_line = on_line(gas);
    if (p.count == 1)
        return {
            fmt::format("a single {} with `speed` has a momentum, which a periodic {} conserves: "
                        "the gas would drift",
                        nouns(gas).particle, is_line ? "wire" : "box"),
            "give its `velocity` instead, `speed` to others too, or solid walls"};
    if (is_line)
        return {
            fmt::format("no directions let the momenta of the {} beads with `speed` sum to zero, "
                        "as a periodic wire requires",
                        p.count),
            "an even number of beads of each mass and speed, a `temperature`, or a `velocity` "
            "for each"};
    return {fmt::format("{} has momentum {:.6g}, more than all others with `speed` together "
                        "({:.6g}): no directions let them sum to zero, as a periodic box requires",
                        called(gas, p.particle), p.value, p.bound),
            "more of the others, a lower speed or mass, or its `velocity` instead"};
}

ProblemText too_large(const Problem& p, const Gas& gas) {
    const auto& [particle, room, smaller, larger] = nouns(gas);
    return {fmt::format("a {} of radius {:.6g} does not fit {}", particle, p.value,
                        on_line(gas) ? fmt::format("on a wire of length {}", gas.box.size[0])
                                     : "into a box of " + size_of(gas.box.size, gas)),
            fmt::format("a {} {} or a {} {}", smaller, particle, larger, room)};
}

ProblemText too_dense(const Problem& p, const Gas& gas) {
    const Vec& size = gas.box.size;
    if (on_line(gas)) {
        const double length = p.value * size[0];
        return {fmt::format("the beads are {:.6g} long together, longer than the wire of {:.6g}",
                            length, size[0]),
                fmt::format("fewer or shorter beads, or a wire of about {:.3g}", 2.0 * length)};
    }
    const bool in_plane = gas.box.dimension == 2;
    const double excess = p.value / roomy_packing(gas.box.dimension);
    const double scale = in_plane ? std::sqrt(excess) : std::cbrt(excess);
    const std::string_view particle = nouns(gas).particle;
    const std::string larger =
        in_plane ? fmt::format("{:.3g} by {:.3g}", size[0] * scale, size[1] * scale)
                 : fmt::format("{:.3g} by {:.3g} by {:.3g}", size[0] * scale, size[1] * scale,
                               size[2] * scale);
    return {fmt::format("the {}s {} {:.4g} of the box's {} {:.6g} (packing fraction {:.4g}), more "
                        "than the {:.4f} of the densest packing",
                        particle, in_plane ? "cover" : "fill", p.value * gas.box.content(),
                        in_plane ? "area" : "volume", gas.box.content(), p.value,
                        densest_packing(gas.box.dimension)),
            fmt::format("fewer or smaller {}s, or a box of about {}", particle, larger)};
}

ProblemText saturated(const Problem& p, const Gas& gas, std::string_view region) {
    const Species& species = gas.species[p.species];
    const bool within = std::holds_alternative<WithinRegion>(species.position);
    return {fmt::format("{} spheres at random places{} have packing fraction {:.4g}, and random "
                        "placement ends at {:.3f}",
                        p.count, within ? fmt::format(" in {}", region) : "", p.value,
                        saturated_packing),
            fmt::format("fewer spheres ({} have packing fraction {}), smaller ones, {}", p.fitting,
                        roomy_packing(gas.box.dimension),
                        within ? "or more room" : "a larger box, or places on a lattice")};
}

ProblemText in_region(const Problem& p, const Gas& gas, std::string_view region) {
    const Species& species = gas.species[p.species];
    if (p.kind == Kind::region_outside)
        return {fmt::format("{} reaches outside {}", region, whole_box(gas)),
                "make it smaller, or the box larger"};
    const Vec size = size_of_region(species);
    const std::string_view particle = nouns(gas).particle;
    if (p.kind == Kind::region_too_narrow)
        return {fmt::format("a {} of radius {:.6g} does not fit into {}, {}", particle, p.value,
                            region, size_of(size, gas)),
                fmt::format("smaller {}s or more room", particle)};
    if (on_line(gas))
        return {fmt::format("{} beads, {:.6g} long together, do not fit into {}, {:.6g} long",
                            species.count, p.value * size[0], region, size[0]),
                "fewer or shorter beads or more room"};
    return {
        fmt::format("{} {}s in {} have packing fraction {:.4g}, more than the {:.4f} of "
                    "the densest packing",
                    species.count, particle, region, p.value, densest_packing(gas.box.dimension)),
        fmt::format("fewer or smaller {}s or more room", particle)};
}

ProblemText on_lattice(const Problem& p, const Gas& gas) {
    const std::string_view particle = nouns(gas).particle;
    const std::string_view lattice =
        gas.box.dimension == 2 ? "hexagonal lattice" : "face-centred cubic lattice";
    if (p.kind == Kind::lattice_taken)
        return {fmt::format("other {0}s leave {1} sites of a {2} free for {3} {0}s of radius up to "
                            "{4:.6g}",
                            particle, p.fitting, lattice, p.count, p.value),
                fmt::format("fewer or smaller {}s, or a larger box", particle)};
    return {fmt::format("no {} holds {} {}s of radius {}{:.6g} in a box of {}", lattice, p.count,
                        particle, p.bound < p.value ? "up to " : "", p.value,
                        size_of(gas.box.size, gas)),
            fmt::format("use fewer {}s ({} fit, with room to move or without), smaller ones, or a "
                        "larger box",
                        particle, p.fitting)};
}

ProblemText outside(const Problem& p, const Gas& gas) {
    Vec low, high = gas.box.size;
    for (int axis = 0; axis < gas.box.dimension; ++axis)
        if (!gas.box.is_periodic(axis)) {
            low[axis] += p.value;
            high[axis] -= p.value;
        }
    return {
        fmt::format("{}{} is not inside {}", called(gas, p.particle),
                    p.value > 0.0 ? fmt::format(" of radius {:.6g}", p.value) : "", whole_box(gas)),
        on_line(gas) ? fmt::format("its centre must lie between {} and {}", low[0], high[0])
        : gas.box.dimension == 2
            ? fmt::format("its centre must have x from {} to {} and y from {} to {}", low[0],
                          high[0], low[1], high[1])
            : fmt::format("its centre must have x from {} to {}, y from {} to {} and z from {} to "
                          "{}",
                          low[0], high[0], low[1], high[1], low[2], high[2])};
}

ProblemText no_place(const Problem& p, const Gas& gas) {
    const Species& species = gas.species[p.species];
    const bool within = std::holds_alternative<WithinRegion>(species.position);
    const std::string_view particle = nouns(gas).particle;
    return {fmt::format("only {} of {} {} could be placed at packing fraction {:.3g}{}", p.fitting,
                        species.count, members(gas, p.species), p.value,
                        within ? " of their region" : ""),
            fmt::format("fewer or smaller {}s, {}", particle,
                        within ? "or a larger region" : "a larger box, or places on a lattice")};
}

ProblemText no_stretch(const Problem& p, const Gas& gas) {
    const bool within = std::holds_alternative<WithinRegion>(gas.species[p.species].position);
    return {fmt::format("{} {} do not fit {}: together they are {:.6g} long, and the free "
                        "stretches {:.6g}, the widest {:.6g}",
                        p.count, p.particle >= 0 ? members(gas, p.species) : "beads",
                        within ? "in their part of the wire" : "on the wire", p.value, p.bound,
                        p.widest),
            fmt::format("fewer or shorter beads, or a longer {}", within ? "part" : "wire")};
}

ProblemText jam(const Problem& p, const Gas& gas) {
    const auto& [particle, room, smaller, larger] = nouns(gas);
    const std::string where =
        p.kind == Kind::jam_alone
            ? "between two walls that it touches"
            : fmt::format("along a row of touching {}s without any gap", particle);
    return {fmt::format("{} moves {}: it would collide infinitely often", called(gas, p.particle),
                        where),
            fmt::format("smaller {}s or a {} {} give them room", particle, larger, room)};
}

std::string boundary(Eigen::Index particle) {
    if (particle == left_end) return "the left end of the wire";
    if (particle == right_end) return "the right end of the wire";
    return fmt::format("particle {}", particle);
}

ProblemText squeeze(const Problem& p) {
    const auto [first, second] = std::minmax(p.particle, p.other);
    const std::string hint =
        "beads cannot pass one another: give a finite mass, another velocity, or an earlier "
        "end of the run";
    if (first < 0)
        return {fmt::format("{} of infinite mass presses beads against {} at time {:.4g}",
                            boundary(second), boundary(first), p.value),
                hint};
    return {fmt::format("{} and {} of infinite mass leave no room between them at time {:.4g}",
                        boundary(first), boundary(second), p.value),
            hint};
}

}  // namespace

double densest_packing(int dimension) {
    return dimension == 1   ? 1.0
           : dimension == 2 ? std::numbers::pi / std::sqrt(12.0)
                            : std::numbers::pi / std::sqrt(18.0);
}

ProblemText to_text(const Problem& p, const Gas& gas, std::string_view region) {
    switch (p.kind) {
        case Kind::too_many:
            return {fmt::format("{} {} are more than the {:.0f} particles that a gas may have",
                                p.count, members(gas, p.species), p.bound),
                    "give fewer"};
        case Kind::not_positive:
            return {fmt::format("the distribution of the {} gives {:.3g}, which is not above zero",
                                p.quantity, p.value),
                    "raise its mean or narrow it"};
        case Kind::no_mass:
            return {"a point, of radius 0, has no mass from a density",
                    "give a radius, or a mass instead"};
        case Kind::no_temperature:
            return {fmt::format("no velocities can be scaled to a temperature of exactly {:.6g}",
                                p.value),
                    "particles of infinite mass, and a single one in a periodic box, have no "
                    "temperature"};
        case Kind::momentum:
            return momentum(p, gas);
        case Kind::too_large:
            return too_large(p, gas);
        case Kind::too_dense:
            return too_dense(p, gas);
        case Kind::saturated:
            return saturated(p, gas, region);
        case Kind::region_outside:
        case Kind::region_too_narrow:
        case Kind::region_too_dense:
            return in_region(p, gas, region);
        case Kind::no_lattice:
        case Kind::lattice_taken:
            return on_lattice(p, gas);
        case Kind::outside:
            return outside(p, gas);
        case Kind::overlap:
            return {fmt::format("{} overlaps {}: {:.6g} apart, at least {:.6g} needed",
                                called(gas, p.particle), called(gas, p.other), p.value, p.bound),
                    fmt::format("move one of them, or make them {}", nouns(gas).smaller)};
        case Kind::in_surface:
            return {fmt::format("{} overlaps `{}`", called(gas, p.particle),
                                gas.box.surfaces.names().at(static_cast<std::size_t>(p.other))),
                    fmt::format("its {} must lie clear of all partitions and obstacles",
                                nouns(gas).particle)};
        case Kind::same_place:
            return {fmt::format("{} is at the place of {}", called(gas, p.particle),
                                called(gas, p.other)),
                    "beads have an order on the wire: move one of them"};
        case Kind::no_place:
            return no_place(p, gas);
        case Kind::no_stretch:
            return no_stretch(p, gas);
        case Kind::jam:
        case Kind::jam_alone:
            return jam(p, gas);
        case Kind::squeeze:
            return squeeze(p);
    }
    return {};
}

PlacementError::PlacementError(const Problem& problem, const Gas& gas)
    : std::runtime_error([&] {
          const auto [message, hint] = to_text(problem, gas);
          return hint.empty() ? message : message + "; " + hint;
      }()),
      problem_(problem) {}

}  // namespace carom
