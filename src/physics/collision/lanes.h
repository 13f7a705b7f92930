// SIMD arithmetic on the compiler's vector types, which it maps to whatever vector instructions the
// processor has. Each lane gives exactly the result of the scalar arithmetic. To be used only
// inside inlined functions, where no calling convention applies.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>

#pragma GCC diagnostic ignored "-Wpsabi"

namespace carom {

using TwoLanes = double __attribute__((vector_size(2 * sizeof(double))));
using FourLanes = double __attribute__((vector_size(4 * sizeof(double))));
using TwoMasks = std::int64_t __attribute__((vector_size(2 * sizeof(std::int64_t))));
using FourMasks = std::int64_t __attribute__((vector_size(4 * sizeof(std::int64_t))));

template <typename T>
concept SomeLanes = std::same_as<T, TwoLanes> || std::same_as<T, FourLanes>;
template <SomeLanes Lanes>
inline constexpr std::size_t lane_count = sizeof(Lanes) / sizeof(double);

[[gnu::always_inline]] inline FourLanes load_lanes(const double* from) {
    FourLanes to;
    std::memcpy(&to, from, sizeof to);
    return to;
}

/// Loads two numbers with one instruction. If they were stored by store_two(), the processor can
/// forward them from the store without waiting.
[[gnu::always_inline]] inline TwoLanes load_two(const double* from) {
    TwoLanes to;
    std::memcpy(&to, from, sizeof to);
    return to;
}
[[gnu::always_inline]] inline FourLanes load_two_and_two(const double* low, const double* high) {
    return __builtin_shufflevector(load_two(low), load_two(high), 0, 1, 2, 3);
}
[[gnu::always_inline]] inline void store_two(TwoLanes from, double* to) {
#ifdef __x86_64__
    asm("" : "+x"(from));  // keeps the compiler from storing the lanes one by one
#endif
    std::memcpy(to, &from, sizeof from);
}

[[gnu::always_inline]] inline void store_lanes(const FourLanes& from, double* to) {
    std::memcpy(to, &from, sizeof from);
}

template <SomeLanes Lanes>
[[gnu::always_inline]] inline Lanes fma(const Lanes& a, const Lanes& b, const Lanes& c) {
    Lanes to;
    for (std::size_t k = 0; k < lane_count<Lanes>; ++k) to[k] = std::fma(a[k], b[k], c[k]);
    return to;
}

template <SomeLanes Lanes>
[[gnu::always_inline]] inline Lanes sqrt(const Lanes& a) {
    Lanes to;
    for (std::size_t k = 0; k < lane_count<Lanes>; ++k) to[k] = std::sqrt(a[k]);
    return to;
}

template <SomeLanes Lanes>
[[gnu::always_inline]] inline Lanes abs(const Lanes& a) {
    Lanes to;
    for (std::size_t k = 0; k < lane_count<Lanes>; ++k) to[k] = std::abs(a[k]);
    return to;
}

/// Keeps the compiler from processing the lanes one by one where they were just combined.
[[gnu::always_inline]] inline void keep_together([[maybe_unused]] TwoLanes& a) {
#ifdef __x86_64__
    asm("" : "+x"(a));
#endif
}

/// A vector with the same number in both lanes.
[[gnu::always_inline]] inline TwoLanes both(double a) { return TwoLanes{a, a}; }

/// The two lanes in exchanged order.
template <typename Two>
[[gnu::always_inline]] inline Two swapped(const Two& a) {
    return __builtin_shufflevector(a, a, 1, 0);
}

/// Lane by lane a where `mask` is set, otherwise b; for scalars one of the two numbers.
template <typename Mask, typename Number>
[[gnu::always_inline]] inline Number select(const Mask& mask, const Number& a, const Number& b) {
    return mask ? a : b;
}

/// The same for a mask combined from several masks, in which each lane is 0 or ~0: the compiler
/// would otherwise generate branches.
template <typename Masks, typename Lanes>
[[gnu::always_inline]] inline Lanes select_bits(const Masks& mask, const Lanes& a, const Lanes& b) {
    return reinterpret_cast<Lanes>((mask & reinterpret_cast<Masks>(a)) |
                                   (~mask & reinterpret_cast<Masks>(b)));
}

}  // namespace carom
