// Sums of doubles without rounding errors: they do not depend on the order of the terms or on how
// these are divided among threads, and a term that is added and later subtracted leaves no trace.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace carom {

/// The small superaccumulator of R. M. Neal (arXiv:1505.05571): a fixed-point number with one digit
/// for every 32 powers of two in the range of a double. Takes 600 bytes; adding a term takes a few
/// nanoseconds.
class ExactSum {
  public:
    void add(double term) { put(term, 1); }
    void subtract(double term) { put(term, -1); }

    /// Adds all terms of another sum.
    void add(const ExactSum& other);

    /// Returns the sum, rounded once to the nearest double (ties to even). Infinite or NaN if the
    /// terms' floating-point sum would be.
    double value() const;

    /// Returns the sum of the finite terms alone, rounded in the same way.
    double finite_value() const;

  private:
    static constexpr int digit_bits = 32;
    static constexpr std::size_t digits = 67;  ///< those of a double, and two for carries
    /// The most terms between two calls of carry(): each adds at most 52 bits to a digit of 63
    /// bits.
    static constexpr std::int32_t most_terms = 2'000;

    void put(double term, std::int64_t sign) {
        constexpr int mantissa_bits = 52;
        const auto bits = std::bit_cast<std::uint64_t>(term);
        auto exponent = static_cast<unsigned>(bits >> mantissa_bits) & 0x7FFU;
        if (exponent == 0x7FFU) [[unlikely]] {
            put_infinite(term, sign);
            return;
        }
        constexpr std::uint64_t hidden = std::uint64_t{1} << mantissa_bits;
        const std::uint64_t mantissa = (bits & (hidden - 1)) | (exponent > 0 ? hidden : 0);
        exponent += exponent == 0 ? 1U : 0U;
        const unsigned shift = exponent % digit_bits;
        const std::size_t digit = exponent / digit_bits;
        const auto low = static_cast<std::int64_t>((mantissa << shift) & 0xFFFFFFFFU);
        const auto high = static_cast<std::int64_t>(mantissa >> (digit_bits - shift));
        const std::int64_t mask = (bits >> 63 != 0) != (sign < 0) ? -1 : 0;  // -1: negated below
        digits_[digit] += (low ^ mask) - mask;
        digits_[digit + 1] += (high ^ mask) - mask;
        if (++terms_ >= most_terms) [[unlikely]]
            carry();
    }
    void put_infinite(double term, std::int64_t sign);
    void carry();

    std::array<std::int64_t, digits> digits_{};  ///< of 2^(32 k - 1075) each
    std::int32_t terms_ = 0;                     ///< since the last carry()
    std::int64_t infinite_ = 0, minus_infinite_ = 0, not_numbers_ = 0;
};

}  // namespace carom
