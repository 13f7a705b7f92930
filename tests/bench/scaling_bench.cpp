// How cost grows with the number of disks: per collision at most four times as much for 100,000 as
// for 1000, and 100,000 placed at random at packing 0.4 within two seconds. Fails if not. Both are
// ratios or far enough from the bound for any machine; the lowest of several times is the one that
// was disturbed least.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <string>

#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

constexpr double most_growth = 4.0;
constexpr double most_seconds = 2.0;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// A gas that has melted, and how long its collisions take.
class Measured {
  public:
    Measured(double packing, int count)
        : step_(2e5 / count), simulation_(test::equal_disks(packing, count), melt(packing)) {}

    void measure() {
        const double begin = cpu_seconds();
        const std::int64_t now = simulation_.advance_to(++steps_ * step_).counts.particle;
        const auto collisions = static_cast<double>(now - collisions_);
        collisions_ = now;
        nanoseconds_ = std::min(nanoseconds_, (cpu_seconds() - begin) / collisions * 1e9);
    }

    double nanoseconds() const { return nanoseconds_; }  // per collision

  private:
    static Run melt(double packing) {
        Run run;
        run.equilibrate = packing > 0.5 ? 3.0 : 10.0;
        return run;
    }

    double step_;  // some 1e5 to 1e6 collisions
    Simulation simulation_;
    int steps_ = 0;
    std::int64_t collisions_ = 0;
    double nanoseconds_ = std::numeric_limits<double>::infinity();
};

bool collisions_scale(double packing, int rounds) {
    Measured few(packing, 1'000), many(packing, 100'000);
    for (int k = 0; k < rounds; ++k) {
        few.measure();
        many.measure();
    }
    const double growth = many.nanoseconds() / few.nanoseconds();
    fmt::print("{:7.2f} {:14.0f} {:14.0f} {:10.2f} (at most {})\n", packing, few.nanoseconds(),
               many.nanoseconds(), growth, most_growth);
    return growth <= most_growth;
}

bool placement_is_quick(int rounds) {
    Gas gas = test::equal_disks(0.4, 100'000);
    gas.species[0].position = RandomPlaces{};
    double seconds = std::numeric_limits<double>::infinity();
    for (int k = 0; k < rounds; ++k) {
        const double begin = cpu_seconds();
        place(gas);
        seconds = std::min(seconds, cpu_seconds() - begin);
    }
    fmt::print("100,000 disks placed at packing 0.40: {:.2f} s (at most {} s)\n", seconds,
               most_seconds);
    return seconds <= most_seconds;
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const int rounds = quick ? 2 : 5;
    fmt::print("packing  ns/collision 1e3          1e5      ratio\n");
    bool good = true;
    for (const double packing : {0.20, 0.65}) good = collisions_scale(packing, rounds) && good;
    good = placement_is_quick(quick ? 1 : 3) && good;
    return good ? 0 : 1;
}
