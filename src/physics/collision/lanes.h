// Several numbers at once, as the compiler's vector types have them: it makes of them what the
// processor has, and each lane is the same arithmetic as for one number. To be used within inlined
// functions only, where no calling convention matters.
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

/// Two numbers in one piece; stored so they can be loaded so again at once.
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
    asm("" : "+x"(from));  // lest the compiler stores them one by one
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

/// Keeps the compiler from working on the lanes one by one where they were just put together.
[[gnu::always_inline]] inline void keep_together([[maybe_unused]] TwoLanes& a) {
#ifdef __x86_64__
    asm("" : "+x"(a));
#endif
}

/// One number in both.
[[gnu::always_inline]] inline TwoLanes both(double a) { return TwoLanes{a, a}; }

/// The two lanes the other way round.
template <typename Two>
[[gnu::always_inline]] inline Two swapped(const Two& a) {
    return __builtin_shufflevector(a, a, 1, 0);
}

/// Lane by lane a where `mask`, else b; or of two numbers the one.
template <typename Mask, typename Number>
[[gnu::always_inline]] inline Number select(const Mask& mask, const Number& a, const Number& b) {
    return mask ? a : b;
}

/// The same where the mask is made of several, each of which is 0 or ~0 in a lane: of these the
/// compiler would make branches.
template <typename Two>
[[gnu::always_inline]] inline Two select_bits(const TwoMasks& mask, const Two& a, const Two& b) {
    return reinterpret_cast<Two>((mask & reinterpret_cast<TwoMasks>(a)) |
                                 (~mask & reinterpret_cast<TwoMasks>(b)));
}

}  // namespace carom
