// How much of a large set of cases a test looks at.
#pragma once

#include <cstdlib>

namespace carom::test {

#ifdef CAROM_SANITIZERS
constexpr bool has_sanitizers = true;
#else
constexpr bool has_sanitizers = false;
#endif

/// A test looks at every n-th case: at every `usual`-th; in builds with sanitizers, where each
/// takes several times as long, at every `sanitized`-th; at all where CAROM_SLOW is set, as by the
/// slow tests.
inline int every_nth(int usual, int sanitized) {
    if (std::getenv("CAROM_SLOW") != nullptr) return 1;
    return has_sanitizers ? sanitized : usual;
}

}  // namespace carom::test
