// The scaling of cost with the number of particles. Fails if a collision costs more than four times
// as much among 100,000 disks or spheres as among 1000, one of 1000 spheres more than 2.5 times as
// much as one of disks at packing fraction 0.2, or if placing 100,000 disks at random at packing
// 0.4 takes more than two seconds. The former are ratios, the latter is far enough from its bound
// for any machine.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "bench/measured.h"
#include "physics/placement/placement.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

constexpr double most_growth = 4.0, most_of_disks = 2.5;
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

bool spheres_cost_little_more(int rounds) {
    constexpr double packing = 0.2, melting = 10.0;
    test::Measured disks(test::equal_disks(packing, 1'000), melting);
    test::Measured spheres(test::equal_spheres(packing, 864), melting);
    for (int k = 0; k < rounds; ++k) {
        disks.measure();
        spheres.measure();
    }
    const double ratio = spheres.nanoseconds() / disks.nanoseconds();
    fmt::print("a collision of spheres costs {:.2f} times as much as one of disks (at most {})\n",
               ratio, most_of_disks);
    return ratio <= most_of_disks;
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
    good = spheres_cost_little_more(rounds) && good;
    good = placement_is_quick(quick ? 1 : 3) && good;
    return good ? 0 : 1;
}
