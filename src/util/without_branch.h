// Choosing without a branch. Where which of two values counts is as good as chance, the processor
// guesses wrong half of the time, which costs more than working out both; compilers choose branches
// all the same.
#pragma once

#include <bit>
#include <cstdint>

namespace carom {

/// `yes` if `choice`, else `no`.
[[gnu::always_inline]] inline double pick(bool choice, double yes, double no) {
    const std::uint64_t mask = -static_cast<std::uint64_t>(choice);
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(yes) & mask) |
                                 (std::bit_cast<std::uint64_t>(no) & ~mask));
}
[[gnu::always_inline]] inline std::uint32_t pick(bool choice, std::uint32_t yes, std::uint32_t no) {
    const std::uint32_t mask = -static_cast<std::uint32_t>(choice);
    return (yes & mask) | (no & ~mask);
}
[[gnu::always_inline]] inline std::int32_t pick(bool choice, std::int32_t yes, std::int32_t no) {
    return static_cast<std::int32_t>(
        pick(choice, static_cast<std::uint32_t>(yes), static_cast<std::uint32_t>(no)));
}

}  // namespace carom
