// Runs a dense gas for very many collisions, in parts, each of which continues from the checkpoint
// written by the part before. After each part all pairs, the energy, the momentum, the clock and
// the memory of the process are checked. Called by `./dev soak`.
#define DOCTEST_CONFIG_IMPLEMENT  // tests/support needs it; main is here
#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "physics/mechanics.h"
#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "physics/theory/collision_rate.h"
#include "support/checkpoint.h"
#include "support/equal_disks.h"
#include "util/archive.h"

using namespace carom;

namespace {

constexpr std::int64_t disks = 10'000;
constexpr double packing = 0.6;  // below freezing: particles still change places

// The deepest overlap of a pair, in diameters; pairs are searched in the order of x.
double deepest_overlap(const Box& box, const Sample& sample) {
    const Eigen::Index count = sample.position.rows();
    std::vector<Eigen::Index> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto x = [&](Eigen::Index i) {
        const double place = std::fmod(sample.position(i, 0), box.size[0]);
        return place < 0.0 ? place + box.size[0] : place;
    };
    std::ranges::sort(order, {}, x);
    double nearest = 4.0;  // squared
    for (std::size_t a = 0; a < order.size(); ++a) {
        for (std::size_t step = 1; step < order.size(); ++step) {
            const Eigen::Index i = order[a], j = order[(a + step) % order.size()];
            const double dx = std::remainder(x(j) - x(i), box.size[0]);
            if (dx < 0.0 || dx > 1.0) break;
            const double dy =
                std::remainder(sample.position(i, 1) - sample.position(j, 1), box.size[1]);
            nearest = std::min(nearest, dx * dx + dy * dy);
        }
    }
    return 1.0 - std::sqrt(nearest);
}

// Resident memory without freed memory that the allocator retains, which varies by chance up to a
// quarter of the total.
std::int64_t resident_kilobytes() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:")) return std::atoll(line.c_str() + 6);
    return 0;
}

// The slope of a straight line fitted to the values, in units of its standard error.
double slope_in_errors(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double x = static_cast<double>(k) - 0.5 * (count - 1.0), y = values[k] - mean;
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    const double scatter = std::max(0.0, yy - xy * xy / xx) / (count - 2.0);
    return scatter > 0.0 ? (xy / xx) / std::sqrt(scatter / xx) : 0.0;
}

class Soak {
  public:
    explicit Soak(double step) : step_(step), simulation_(gas(), endless()) {
        energy_ = energy();
        momentum_ = speeds(simulation_.sample()).sum();
    }

    // Advances by this number of collisions, and passes the simulation through a checkpoint.
    void part(std::int64_t collisions) {
        const std::int64_t begin = collisions_;
        double time = simulation_.sample().time;
        const double begun = time;
        while (collisions_ - begin < collisions) {
            time += step_;
            const AdvanceResult advanced = simulation_.advance_to(time);
            collisions_ = advanced.counts.particle;
            require(advanced.impulses.largest_overlap < 1e-12, "contacts were met too late");
            require(simulation_.sample().time == time, "the clock stands at another time");
        }
        rates_.push_back(static_cast<double>(collisions_ - begin) / (time - begun));
        check_state();
        const std::string bytes = test::written(simulation_);
        Simulation next = test::restored(simulation_, endless(), bytes);
        require(test::written(next) == bytes, "the checkpoint is not read back exactly");
        simulation_ = std::move(next);
        check_memory();
        report();
    }

    // Checks that the collision rate does not change with time: a drifting clock would change it.
    void check_rates() const {
        if (rates_.size() < 6) return;
        const std::vector<double> later(rates_.begin() + 1,
                                        rates_.end());  // the lattice melts first
        const double slope = slope_in_errors(later);
        fmt::print("slope of the collision rate: {:.2f} standard errors\n", slope);
        // There is one test in a run; Student's t with 4 or more degrees of freedom exceeds 8.6
        // with a probability of 1 in 1000.
        require(std::abs(slope) < 8.6, "the collision rate changes with time");
    }

  private:
    static Run endless() {
        Run run;
        run.most_collisions = std::numeric_limits<std::int64_t>::max();
        return run;
    }
    static Gas gas() { return test::equal_disks(packing, disks); }
    static void require(bool holds, const char* what) {
        if (!holds) throw std::runtime_error(what);
    }
    double energy() {
        return kinetic_energies(simulation_.particles(), simulation_.sample()).sum();
    }

    void check_state() {
        const Sample& now = simulation_.sample();
        overlap_ = deepest_overlap(simulation_.box(), now);
        energy_error_ = energy() / energy_ - 1.0;
        momentum_error_ =
            std::max(std::abs(now.velocity.col(0).sum()), std::abs(now.velocity.col(1).sum())) /
            momentum_;
        require(overlap_ < 1e-12, "disks overlap");
        require(std::abs(energy_error_) < 1e-12, "the energy has changed");
        require(momentum_error_ < 1e-12, "the momentum has changed");
    }

    void check_memory() {
        const std::int64_t now = resident_kilobytes();
        if (rates_.size() == 2) memory_ = now;  // by then all buffers have their final sizes
        require(!memory_ || now < *memory_ + *memory_ / 10, "the memory grows");
    }

    void report() {
        fmt::print(
            "{:.3e} collisions, time {:.0f}, {:.1f} a time, overlap {:.1e}, energy {:+.1e}, "
            "momentum {:.1e}, {} kB\n",
            static_cast<double>(collisions_), simulation_.sample().time, rates_.back(),
            std::max(overlap_, 0.0), energy_error_, momentum_error_, resident_kilobytes());
        std::fflush(stdout);
    }

    double step_;
    Simulation simulation_;
    std::int64_t collisions_ = 0;
    double energy_ = 0.0, momentum_ = 0.0;
    double overlap_ = 0.0, energy_error_ = 0.0, momentum_error_ = 0.0;
    std::vector<double> rates_;
    std::optional<std::int64_t> memory_;
};

}  // namespace

// Usage: soak COLLISIONS, carried out in ten parts.
int main(int count, char** words) {
    const double collisions = count == 2 ? std::atof(words[1]) : 0.0;
    if (!(collisions >= 1e5)) {
        fmt::print(stderr, "usage: soak COLLISIONS (1e5 or more)\n");
        return 2;
    }
    try {
        Soak soak(1.0);
        for (int part = 0; part < 10; ++part) soak.part(static_cast<std::int64_t>(collisions / 10));
        soak.check_rates();
    } catch (const std::exception& error) {
        fmt::print(stderr, "soak: {}\n", error.what());
        return 1;
    }
    return 0;
}
