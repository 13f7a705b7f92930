// How many cases of a large set a test tries.
#pragma once

#include <cstdlib>

namespace carom::test {

#ifdef CAROM_SANITIZERS
constexpr bool has_sanitizers = true;
#else
constexpr bool has_sanitizers = false;
#endif

/// The n for which a test tries every n-th case: `usual`; in builds with sanitizers, where each
/// case takes several times as long, `sanitized`; 1, that is all cases, if CAROM_SLOW is set, as
/// the slow tests do.
inline int every_nth(int usual, int sanitized) {
    if (std::getenv("CAROM_SLOW") != nullptr) return 1;
    return has_sanitizers ? sanitized : usual;
}

}  // namespace carom::test
