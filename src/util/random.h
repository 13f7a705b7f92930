// Random numbers that are the same on every machine: std::mt19937_64, whose output the C++ standard
// fixes, and distributions of our own, since those of the standard library are unspecified.
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace carom {

/// A stream of random numbers. Streams of one seed with different purposes are independent of each
/// other.
class Random {
  public:
    /// `purpose` names what the numbers are for ("placement of species 0"), so that adding a use
    /// leaves the others as they were.
    Random(std::uint64_t seed, std::string_view purpose);

    std::uint64_t bits() { return engine_(); }  ///< 64 uniform random bits
    double uniform();                           ///< uniform in [0, 1), a multiple of 2^-53
    double uniform(double low, double high);    ///< uniform in [low, high]
    double normal();  ///< standard normal, by the polar method (Marsaglia and Bray 1964)
    std::uint64_t below(
        std::uint64_t bound);  ///< uniform in {0, ..., bound - 1}, without bias; bound > 0

  private:
    std::mt19937_64 engine_;
    double spare_ = 0.0;
    bool has_spare_ = false;
};

}  // namespace carom
