// Boxes with surfaces against the obvious geometry of them, in long double: whatever the loop says
// happened, happened at a contact, and nothing that it did not say has happened on the way.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/events/event_loop.h"
#include "physics/placement/placement.h"
#include "support/relative.h"
#include "util/random.h"

using namespace carom;

namespace {

struct Vector {
    long double x, y;
};
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
long double length(Vector a) { return std::hypot(a.x, a.y); }

// The distance of a point from a straight line between two points, with its ends.
long double distance_from_line(Vector p, Vector a, Vector b) {
    const Vector line = b - a, from = p - a;
    const long double square = line.x * line.x + line.y * line.y;
    const long double share = std::clamp((from.x * line.x + from.y * line.y) / square, 0.0L, 1.0L);
    return length({from.x - share * line.x, from.y - share * line.y});
}

// The distance of a point from a surface that does not move, in the nearest of its images.
class Geometry {
  public:
    explicit Geometry(const Box& box) : box_(box) {}

    int count() const {
        return 4 +
               static_cast<int>(box_.surfaces.partitions.size() + box_.surfaces.obstacles.size());
    }
    bool is_at_rest(int surface) const {
        const auto moves = [](const Behaviour& behaviour) {
            return std::holds_alternative<Piston>(behaviour) ||
                   std::holds_alternative<Driven>(behaviour);
        };
        const auto k = static_cast<std::size_t>(surface);
        if (surface < 4) return !box_.is_periodic(surface / 2) && !moves(box_.surfaces.sides[k]);
        if (k - 4 < box_.surfaces.partitions.size())
            return !moves(box_.surfaces.partitions[k - 4].behaviour);
        return true;
    }
    long double distance(int surface, Vector p) const {
        long double least = 1e9L;
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                if ((x == 0 || box_.is_periodic(0)) && (y == 0 || box_.is_periodic(1)))
                    least = std::min(
                        least, plain(surface, {p.x + x * box_.size[0], p.y + y * box_.size[1]}));
        return least;
    }

  private:
    long double along(int axis, double at, double from, double to, Vector p) const {
        return axis == 0 ? distance_from_line(p, {at, from}, {at, to})
                         : distance_from_line(p, {from, at}, {to, at});
    }
    long double plain(int surface, Vector p) const {
        if (surface < 4) {
            const int axis = surface / 2;
            return along(axis, surface % 2 == 0 ? 0.0 : box_.size[axis], -99.0, 99.0, p);
        }
        auto k = static_cast<std::size_t>(surface - 4);
        if (k < box_.surfaces.partitions.size()) {
            const Partition& line = box_.surfaces.partitions[k];
            long double least = 1e9L;
            double from = 0.0;
            for (const auto& [gap_from, gap_to] : line.gaps) {
                if (gap_from > from)
                    least = std::min(least, along(line.axis, line.at, from, gap_from, p));
                from = gap_to;
            }
            return std::min(least, along(line.axis, line.at, from, box_.length(1 - line.axis), p));
        }
        const Obstacle& obstacle = box_.surfaces.obstacles[k - box_.surfaces.partitions.size()];
        if (const auto* disk = std::get_if<Obstacle::Disk>(&obstacle.shape))
            return length({p.x - disk->center[0], p.y - disk->center[1]}) - disk->radius;
        const auto& lines = std::get<Obstacle::Lines>(obstacle.shape);
        long double least = 1e9L;
        for (std::size_t i = 0; i + (lines.is_closed ? 0 : 1) < lines.corners.size(); ++i) {
            const auto &a = lines.corners[i], &b = lines.corners[(i + 1) % lines.corners.size()];
            least = std::min(least, distance_from_line(p, {a[0], a[1]}, {b[0], b[1]}));
        }
        return least;
    }
    Box box_;
};

// Something of each kind, one after the other.
Gas random_gas(int scene, Random& random) {
    Gas gas;
    Box& box = gas.box;
    box.size = {random.uniform(6.0, 12.0), random.uniform(6.0, 12.0)};
    const double x = box.size[0], y = box.size[1];
    const bool periodic = scene % 5 == 0;
    if (periodic) box.walls[1] = Wall::periodic;
    if (scene % 3 != 0)
        box.surfaces.gravity = {scene % 9 == 1 ? random.uniform(0.0, 0.3) : 0.0,
                                periodic ? 0.0 : random.uniform(-2.0, 0.0)};
    std::vector<Partition>& partitions = box.surfaces.partitions;
    std::vector<Obstacle>& obstacles = box.surfaces.obstacles;
    switch (scene % 8) {
        case 0:
            obstacles = {{"peg", Obstacle::Disk{{0.5 * x, 0.02 * y}, 0.8}}};
            break;
        case 1:
            obstacles = {
                {"wedge",
                 Obstacle::Lines{{{0.3 * x, 0.3 * y}, {0.6 * x, 0.35 * y}, {0.5 * x, 0.6 * y}},
                                 true}}};
            break;
        case 2:
            partitions = {{.name = "gap", .axis = 0, .at = 0.5 * x, .gaps = {{0.3 * y, 0.6 * y}}}};
            break;
        case 3:
            partitions = {{.name = "piston",
                           .axis = 0,
                           .at = 0.5 * x,
                           .behaviour = Piston{random.uniform(0.1, 20.0), random.uniform(-0.5, 0.5),
                                               random.uniform(-0.5, 0.5)}}};
            break;
        case 4:
            partitions = {{.name = "driven",
                           .axis = 1,
                           .at = 0.5 * y,
                           .gaps = {{0.2 * x, 0.5 * x}},
                           .behaviour = Driven{random.uniform(-0.2, 0.2), 6.0}}};
            break;
        case 5:
            box.surfaces.sides[1] = Piston{.mass = 5.0, .force = -1.0};
            box.surfaces.gravity[0] = 0.0;  // or the piston would fall out of the box
            break;
        case 6:
            obstacles = {{"shelf", Obstacle::Lines{{{0.3 * x, 0.5 * y}, {0.7 * x, 0.55 * y}}}}};
            break;
        default:
            box.surfaces.sides[0] = Bath{1.0};
            break;
    }
    const double largest = scene % 11 == 3 ? 0.0 : random.uniform(0.05, 0.4);
    gas.species = {{.name = "disks",
                    .count = static_cast<std::int64_t>(3 + random.below(14)),
                    .radius = UniformDistribution{0.5 * largest, largest},
                    .mass = Quantity{UniformDistribution{0.5, 2.0}},
                    .velocity = Temperature{1.0}}};
    gas.seed = static_cast<std::uint64_t>(scene) + 1;
    return gas;
}

// A disk on its way from a state.
Vector place_at(const Sample& state, Eigen::Index i, const Eigen::Array2d& gravity, long double t) {
    return {state.position(i, 0) + t * (state.velocity(i, 0) + 0.5L * t * gravity[0]),
            state.position(i, 1) + t * (state.velocity(i, 1) + 0.5L * t * gravity[1])};
}

}  // namespace

TEST_CASE("disks meet surfaces where these are, and never lie in them") {
    Random random(7, "boxes with surfaces");
    std::int64_t pairs = 0, hits = 0;
    for (int scene = 0; scene < 240; ++scene) {
        CAPTURE(scene);
        const Gas gas = random_gas(scene, random);
        const auto [particles, start] = place(gas);
        const Geometry geometry(gas.box);
        EventLoop<2, double, true> loop(gas.box, particles);
        loop.start(start);
        Sample before = start;
        Collision collision{};
        double now = 0.0, deepest = 0.0, furthest = 0.0;
        for (int k = 0; k < 150 && loop.advance_one(now + 20.0, collision); ++k) {
            const double wait = collision.time - now;
            for (int part = 1; part <= 4; ++part) {
                for (Eigen::Index i = 0; i < particles.count(); ++i) {
                    const Vector p =
                        place_at(before, i, gas.box.surfaces.gravity, wait * part / 4.0L);
                    for (int surface = 0; surface < geometry.count(); ++surface)
                        if (geometry.is_at_rest(surface))
                            deepest = std::max(deepest,
                                               static_cast<double>(particles.radius[i] -
                                                                   geometry.distance(surface, p)));
                }
            }
            now = collision.time;
            loop.sample(now, before);
            if (collision.second.is_particle()) {
                ++pairs;
                continue;
            }
            ++hits;
            const int surface = collision.second.surface();
            if (!geometry.is_at_rest(surface)) continue;
            const Eigen::Index i = collision.first;
            const long double distance =
                geometry.distance(surface, {before.position(i, 0), before.position(i, 1)});
            furthest =
                std::max(furthest, static_cast<double>(std::abs(distance - particles.radius[i])));
        }
        // Coordinates up to 12 are rounded a few times on the way to a contact.
        CHECK(furthest < 2e-12);
        CHECK(deepest < 2e-12);
    }
    CHECK(pairs > 3000);
    CHECK(hits > 10'000);
}

// What disks, pistons and their weights have, less what driven walls and baths gave.
TEST_CASE("the account of energy closes") {
    Random random(8, "accounts of energy");
    for (int scene = 0; scene < 80; ++scene) {
        CAPTURE(scene);
        const Gas gas = random_gas(scene, random);
        const auto [particles, start] = place(gas);
        EventLoop<2, double, true> loop(gas.box, particles);
        loop.start(start);
        const auto account = [&](double time) {
            Sample state;
            loop.sample(time, state);
            double sum = kinetic_energies(particles, state).sum();
            for (int a = 0; a < 2; ++a)
                sum -= gas.box.surfaces.gravity[a] *
                       (state.position.col(a) / particles.inverse_mass).sum();
            const auto surfaces = loop.surfaces(time);
            for (std::size_t k = 0; k < surfaces.size(); ++k) {
                const SurfaceState& surface = surfaces[k];
                sum -= surface.heat;
                if (!surface.motion) continue;
                const std::size_t partitions = gas.box.surfaces.partitions.size();
                const Behaviour& behaviour =
                    k < 4 ? gas.box.surfaces.sides[k]
                          : gas.box.surfaces.partitions[std::min(k - 4, partitions - 1)].behaviour;
                const int axis =
                    k < 4 ? static_cast<int>(k / 2) : gas.box.surfaces.partitions[k - 4].axis;
                if (const auto* piston = std::get_if<Piston>(&behaviour))
                    sum +=
                        0.5 * piston->mass * surface.motion->velocity * surface.motion->velocity -
                        (piston->force + piston->mass * gas.box.surfaces.gravity[axis]) *
                            surface.motion->place;
                else
                    sum -= surface.work;
            }
            return sum;
        };
        const double begin = account(0.0);
        loop.advance(40.0, nullptr);
        CHECK(std::abs(account(40.0) - begin) < 1e-12 * (10.0 + std::abs(begin)));
    }
}
