#include "util/random.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {
namespace {

std::mt19937_64 seeded(std::uint64_t seed, std::string_view purpose) {
    std::vector<std::uint32_t> words{static_cast<std::uint32_t>(seed),
                                     static_cast<std::uint32_t>(seed >> 32)};
    for (char c : purpose) words.push_back(static_cast<unsigned char>(c));
    std::seed_seq sequence(words.begin(), words.end());
    return std::mt19937_64(sequence);
}

}  // namespace

Random::Random(std::uint64_t seed, std::string_view purpose) : engine_(seeded(seed, purpose)) {}

double Random::uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

double Random::uniform(double low, double high) {
    return std::clamp(low + (high - low) * uniform(), low, high);
}

double Random::normal() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_;
    }
    while (true) {
        const double u = 2.0 * uniform() - 1.0;
        const double v = 2.0 * uniform() - 1.0;
        const double s = u * u + v * v;
        if (s >= 1.0 || s == 0.0) continue;
        const double factor = std::sqrt(-2.0 * std::log(s) / s);
        spare_ = v * factor;
        has_spare_ = true;
        return u * factor;
    }
}

std::uint64_t Random::below(std::uint64_t bound) {
    const std::uint64_t rejected = (0 - bound) % bound;  // 2^64 mod bound
    std::uint64_t value = engine_();
    while (value < rejected) value = engine_();
    return value % bound;
}

}  // namespace carom
