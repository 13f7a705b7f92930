// The scaling of cost with the number of particles. Fails if a collision costs more than four times
// as much among 100,000 disks or spheres as among 1000, one of 1000 spheres more than 2.5 times as
// much as one of disks at packing fraction 0.2, one between walls more than 1.6 times as much as
// one in a periodic box, one in a very long box more than 1.6 times as much as one in a square, or
// if placing 100,000 disks at random at packing 0.4 takes more than two seconds. The former are
// ratios, the latter is far enough from its bound for any machine.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "bench/measured.h"
#include "physics/placement/placement.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

constexpr double most_growth = 4.0, most_of_disks = 2.5, most_of_walls = 1.6, most_of_length = 1.6;
constexpr double most_seconds = 2.0;

bool collisions_scale(const char* what, double packing, const Gas& small, const Gas& large,
                      int rounds) {
    const double melting = packing > 0.4 ? 3.0 : 10.0;
    test::Measured few(small, melting), many(large, melting);
    for (int k = 0; k < rounds; ++k) {
        few.measure();
        many.measure();
    }
    const double growth = many.nanoseconds() / few.nanoseconds();
    fmt::print("{:>8} {:7.2f} {:14.0f} {:14.0f} {:10.2f} (at most {})\n", what, packing,
               few.nanoseconds(), many.nanoseconds(), growth, most_growth);
    return growth <= most_growth;
}

// Whether a collision of one gas costs at most so many times as much as one of another.
bool costs_little_more(const char* what, const Gas& gas, const Gas& other, double most,
                       int rounds) {
    constexpr double melting = 10.0;
    test::Measured one(gas, melting), reference(other, melting);
    for (int k = 0; k < rounds; ++k) {
        reference.measure();
        one.measure();
    }
    const double ratio = one.nanoseconds() / reference.nanoseconds();
    fmt::print("a collision {} costs {:.2f} times as much (at most {})\n", what, ratio, most);
    return ratio <= most;
}

// Between walls the lattice begins in contact with them.
Gas between_walls(Gas gas) {
    gas.box.walls.fill(Wall::solid);
    return gas;
}

// A box of the same area, in which others have events within the rounding errors of a contact.
Gas in_a_long_box(Gas gas) {
    constexpr double width = 12.0;
    gas.box.size = {gas.box.content() / width, width};
    return gas;
}

bool placement_is_quick(int rounds) {
    Gas gas = test::equal_disks(0.4, 100'000);
    gas.species[0].position = RandomPlaces{};
    double seconds = std::numeric_limits<double>::infinity();
    for (int k = 0; k < rounds; ++k) {
        const double begin = test::cpu_seconds();
        place(gas);
        seconds = std::min(seconds, test::cpu_seconds() - begin);
    }
    fmt::print("100,000 disks placed at packing 0.40: {:.2f} s (at most {} s)\n", seconds,
               most_seconds);
    return seconds <= most_seconds;
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const int rounds = quick ? 2 : 5;
    fmt::print("         packing  ns/collision 1e3          1e5      ratio\n");
    bool good = true;
    for (const double packing : {0.20, 0.65})
        good = collisions_scale("disks", packing, test::equal_disks(packing, 1'000),
                                test::equal_disks(packing, 100'000), rounds) &&
               good;
    for (const double packing : {0.20, 0.49})
        good = collisions_scale("spheres", packing, test::equal_spheres(packing, 864),
                                test::equal_spheres(packing, 97'556), rounds) &&
               good;
    constexpr double packing = 0.2;
    const Gas disks = test::equal_disks(packing, 1'000),
              spheres = test::equal_spheres(packing, 864);
    good = costs_little_more("of spheres, not of disks,", spheres, disks, most_of_disks, rounds) &&
           good;
    good = costs_little_more("of disks between walls, not in a periodic box,", between_walls(disks),
                             disks, most_of_walls, rounds) &&
           good;
    good = costs_little_more("of spheres between walls, not in a periodic box,",
                             between_walls(spheres), spheres, most_of_walls, rounds) &&
           good;
    const Gas many = test::equal_disks(0.6, 40'000);
    good = costs_little_more("of disks in a very long box, not in a square,", in_a_long_box(many),
                             many, most_of_length, rounds) &&
           good;
    good = placement_is_quick(quick ? 1 : 3) && good;
    return good ? 0 : 1;
}
