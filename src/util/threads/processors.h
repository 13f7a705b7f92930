// Versions of a function for several kinds of processors, one of which is chosen when the program
// starts. All perform the same arithmetic and give bit-identical results.
#pragma once

#include <cstddef>  // which defines __GLIBC__

/// Precedes the definition of a function: the compiler generates one version for each kind of
/// processor named, in the syntax of `target_clones` of GCC and Clang, and one for all others.
/// Expands to nothing with other compilers and systems, and with sanitizers, which are not
/// initialised yet when the version is chosen. CAROM_ONE_VERSION disables it, for comparison.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(CAROM_SANITIZERS) && \
    !defined(CAROM_ONE_VERSION)
#define CAROM_FOR_PROCESSORS(...) __attribute__((target_clones(__VA_ARGS__, "default")))
#else
#define CAROM_FOR_PROCESSORS(...)
#endif

/// The same for functions that use fma and vectors of four numbers (collision/lanes.h). Only GCC
/// accepts the attribute at the definition of a function that was declared without it; for a member
/// of a class template it has to stand at the declaration, or it has no effect. And GCC 12
/// fails on a version for a processor that is less capable than the one it compiles for anyway
/// (-march=native).
#if !defined(__clang__) && !(defined(__AVX2__) && defined(__FMA__))
#define CAROM_FOR_PROCESSORS_WITH_FMA CAROM_FOR_PROCESSORS("arch=x86-64-v4", "arch=x86-64-v3")
#else
#define CAROM_FOR_PROCESSORS_WITH_FMA
#endif
