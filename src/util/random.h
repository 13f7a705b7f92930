// Random numbers that are the same on every machine: std::mt19937_64, whose output the C++ standard
// defines, and our own distributions, since the algorithms of the standard library's are
// unspecified.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

namespace carom {

/// A stream of random numbers. Streams with the same seed and different purposes are independent.
class Random {
  public:
    /// `purpose` names what the numbers are for ("placement of species 0"), so that adding a new
    /// use of random numbers leaves the other streams unchanged.
    Random(std::uint64_t seed, std::string_view purpose);

    double uniform();                         ///< uniform in [0, 1), a multiple of 2^-53
    double uniform(double low, double high);  ///< uniform in [low, high]
    double normal();  ///< standard normal, by the polar method (Marsaglia and Bray 1964)
    std::uint64_t below(
        std::uint64_t bound);  ///< uniform in {0, ..., bound - 1}, without bias; bound > 0

    /// Shuffles a list; all orders are equally probable (Fisher and Yates).
    template <typename T>
    void shuffle(std::vector<T>& list) {
        for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[below(k)]);
    }

  private:
    std::mt19937_64 engine_;
    double spare_ = 0.0;
    bool has_spare_ = false;
};

}  // namespace carom
