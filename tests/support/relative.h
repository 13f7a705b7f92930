// doctest's Approx adds 1 to the scale of its epsilon; this one is purely relative.
#pragma once

#include <doctest/doctest.h>

namespace carom::test {

/// Equals a number that differs from `value` by less than `tolerance` times the larger of the two.
inline doctest::Approx relative(double value, double tolerance) {
    return doctest::Approx(value).epsilon(tolerance).scale(0.0);
}

}  // namespace carom::test
