// The barometric law of a few particles against the exact volumes of phase space.
#include "physics/theory/barometric_law.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace carom;

namespace {

// Of N equal particles of the plane with mass and gravity 1 under a lid at height 1: the volume of
// phase space that is left where one of them is at h, by inclusion and exclusion of the others that
// would be above the lid.
double volume(int count, double energy, double h) {
    double sum = 0.0, choices = 1.0;
    for (int k = 0; k < count; ++k) {
        const double left = energy - h - k;
        if (left > 0.0) sum += (k % 2 == 0 ? 1.0 : -1.0) * choices * std::pow(left, 2 * count - 2);
        choices *= double(count - 1 - k) / (k + 1);
    }
    return sum;
}

double exact_share_below(int count, double energy, double height) {
    constexpr int steps = 2000;
    double below = 0.0, all = 0.0;
    for (int k = 0; k < steps; ++k) {
        const double h = (k + 0.5) / steps, part = volume(count, energy, h);
        all += part;
        if (h < height) below += part;
    }
    return below / all;
}

}  // namespace

TEST_CASE("in a column without a lid the law is exact for any number") {
    for (const int count : {2, 5, 50}) {
        CAPTURE(count);
        const double energy = 1.7 * count;
        const BarometricLaw law(2.0 * count, energy, 0.8, {{1.5, double(count), 1e3}}, 0);
        for (const double h : {0.1, 0.5, 1.0, 2.5}) {
            const double left = std::max(0.0, 1.0 - 1.5 * 0.8 * h / energy);
            CHECK(law.share_below(h) ==
                  doctest::Approx(1.0 - std::pow(left, 2.0 * count - 1.0)).epsilon(0.002));
        }
    }
}

TEST_CASE("under a lid the law errs in the second order of 1/N") {
    for (const int count : {6, 12}) {
        CAPTURE(count);
        const double energy = 0.6 * count;
        const BarometricLaw law(2.0 * count, energy, 1.0, {{1.0, double(count), 1.0}}, 0);
        const BarometricLaw many(2e6, 0.6e6, 1.0, {{1.0, 1e6, 1.0}}, 0);
        double error = 0.0, error_of_many = 0.0;
        for (const double h : {0.25, 0.5, 0.75}) {
            const double exact = exact_share_below(count, energy, h);
            CHECK(std::abs(law.share_below(h) - exact) < 0.03 / (count * count));
            error += std::abs(law.share_below(h) - exact);
            error_of_many += std::abs(many.share_below(h) - exact);
        }
        CHECK(error < 0.25 * error_of_many);
    }
}

TEST_CASE("many particles follow the exponential, each kind its own") {
    const std::vector<FallingKind> kinds{{1.0, 4000.0, 50.0}, {4.0, 4000.0, 50.0}};
    // At temperature 2 each has 1 T of motion and 1 T of height.
    const double energy = 2.0 * 2.0 * 8000.0;
    const BarometricLaw light(16000.0, energy, 0.5, kinds, 0),
        heavy(16000.0, energy, 0.5, kinds, 1);
    CHECK(1.0 - light.share_below(4.0) == doctest::Approx(std::exp(-1.0)).epsilon(5e-3));
    CHECK(1.0 - heavy.share_below(1.0) == doctest::Approx(std::exp(-1.0)).epsilon(5e-3));
}
