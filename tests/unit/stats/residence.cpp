// Times in bins against a slow sum over small steps, and by hand.
#include "stats/paths/residence.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <utility>

#include "util/random.h"

using namespace carom;

TEST_CASE("a place at constant velocity is in each bin as long as the bin is wide") {
    Residence residence(0.5);
    residence.add({0.25, 2.0, 0.0, 1.0});
    REQUIRE(residence.times().size() == 5);
    CHECK(residence.times()[0] == doctest::Approx(0.125).epsilon(1e-14));
    for (std::size_t i = 1; i < 4; ++i)
        CHECK(residence.times()[i] == doctest::Approx(0.25).epsilon(1e-14));
    CHECK(residence.times()[4] == doctest::Approx(0.125).epsilon(1e-14));
}

TEST_CASE("places below 0 have bins of their own") {
    Residence residence(0.5);
    residence.add({0.25, 0.0, 0.0, 3.0});
    CHECK(residence.first() == 0);
    residence.add({-1.25, 1.0, 0.0, 1.5});
    REQUIRE(residence.first() == -3);
    REQUIRE(residence.times().size() == 4);
    for (const auto& [bin, time] :
         {std::pair<std::size_t, double>{0, 0.25}, {1, 0.5}, {2, 0.5}, {3, 3.25}})
        CHECK(residence.times()[bin] == doctest::Approx(time).epsilon(1e-14));
}

TEST_CASE("bins become wider where a place is far away, and keep all times") {
    constexpr double width = 0.5;
    for (const double far : {1e4, -1e4, 1e9, -1e12, 1e100}) {
        CAPTURE(far);
        Residence residence(width);
        residence.add({-3.25, 0.0, 0.0, 3.0});
        residence.add({0.25, far, 0.0, 1.0});
        CHECK(residence.times().size() <= Residence::most_bins + 16);
        int doubled = 0;
        CHECK(std::frexp(residence.width() / width, &doubled) == 0.5);
        CHECK(Residence::most_bins * residence.width() <= 2.0 * std::abs(far));
        double sum = 0.0;
        for (const double time : residence.times()) sum += time;
        CHECK(sum == doctest::Approx(4.0).epsilon(1e-10));
        const auto bin_of = [&](double place) {
            return static_cast<std::size_t>(std::floor(place / residence.width()) -
                                            double(residence.first()));
        };
        const double in_one = std::abs(residence.width() / far);
        for (const double share : {0.2, 0.5, 0.9})
            CHECK(residence.times().at(bin_of(share * far)) ==
                  doctest::Approx(in_one).epsilon(1e-9));
        CHECK(residence.times().at(bin_of(-3.25)) >= 3.0);
    }
}

TEST_CASE("a thrown ball is in each bin as long as its height by steps says") {
    Random random(5, "stretches");
    for (int trial = 0; trial < 200; ++trial) {
        const MotionStretch stretch{random.uniform(-3.0, 3.0), random.uniform(0.0, 4.0),
                                    random.uniform(-2.0, 1.0), random.uniform(0.1, 1.2)};
        constexpr double width = 0.3;
        constexpr int steps = 20'000;
        Residence exact(width);
        exact.add(stretch);
        std::vector<double> slow(exact.times().size(), 0.0);
        for (int i = 0; i < steps; ++i) {
            const double place = stretch.place_after(stretch.duration * (i + 0.5) / steps);
            const auto bin =
                static_cast<std::size_t>(std::floor(place / width) - double(exact.first()));
            REQUIRE(bin < slow.size());
            slow[bin] += stretch.duration / steps;
        }
        CAPTURE(trial);
        // A step at each edge counts on one side or the other: at most four edges' steps in a bin
        for (std::size_t k = 0; k < slow.size(); ++k)
            CHECK(std::abs(slow[k] - exact.times()[k]) < 4.0 * stretch.duration / steps);
    }
}
