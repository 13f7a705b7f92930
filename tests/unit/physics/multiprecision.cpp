// Numbers of as many bits as asked for.
#include "physics/multiprecision/multiprecision.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace carom;

TEST_CASE("a number has the bits asked for, and a result those of the more precise operand") {
    const Real third = Real(1.0, 300) / Real(3.0);
    CHECK(third.bits() == 300);
    CHECK((third * 3.0).bits() == 300);
    CHECK(Real(2.0).bits() == 53);
    const Real miss = abs(third + third + third - 1.0);
    CHECK(miss < Real::from_text("1e-89", 300));  // 2^-298
    Real copy;
    copy = third;
    CHECK(copy.bits() == 300);
    CHECK(copy == third);
    copy += Real(1.0, 400);
    CHECK(copy.bits() == 400);
    CHECK(-copy < third);
    CHECK(static_cast<double>(third) == 1.0 / 3.0);
    CHECK(third.rounded_down() < third);
    CHECK(third.rounded_up() > third);
    CHECK(third.rounded_up() == std::nextafter(third.rounded_down(), 1.0));
}

TEST_CASE("numbers far outside the range of doubles") {
    const Real tiny = Real::from_text("2.5e-1000", 128);
    CHECK(log10(tiny) == doctest::Approx(std::log10(2.5) - 1000.0).epsilon(1e-12));
    CHECK(static_cast<double>(tiny) == 0.0);
    CHECK(tiny > 0.0);
    CHECK(Real(1.0, 4096) + tiny > 1.0);
    CHECK(sqrt(tiny * tiny) == tiny);
}
