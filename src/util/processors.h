// Versions of a function for several kinds of processors, of which the program chooses one at its
// start. The arithmetic is the same in all, and so are the bits of the results.
#pragma once

#include <cstddef>  // which defines __GLIBC__

/// Before the definition of a function: one version for each kind of processor that is named, as
/// `target_clones` of GCC and Clang names it, and one for all others. Nothing with other compilers
/// and systems, and with sanitizers, which are not ready when the program chooses.
/// CAROM_ONE_VERSION: for comparison.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(CAROM_SANITIZERS) && \
    !defined(CAROM_ONE_VERSION)
#define CAROM_FOR_PROCESSORS(...) __attribute__((target_clones(__VA_ARGS__, "default")))
#else
#define CAROM_FOR_PROCESSORS(...)
#endif

/// The same for functions with fma and lanes of four numbers (collision/lanes.h). Only GCC takes
/// the attribute at the definition of a function that was declared without it; and GCC 12 fails on
/// a version for a lesser processor than it compiles for anyway (-march=native).
#if !defined(__clang__) && !(defined(__AVX2__) && defined(__FMA__))
#define CAROM_FOR_PROCESSORS_WITH_FMA CAROM_FOR_PROCESSORS("arch=x86-64-v3")
#else
#define CAROM_FOR_PROCESSORS_WITH_FMA
#endif
