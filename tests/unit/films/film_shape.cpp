#include "films/cost/film_shape.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "scene/film.h"
#include "util/diagnostics.h"

using namespace carom;

namespace {

const FormatCost& mp4() { return *output_format("mp4").film; }
const FilmShape asked{{1920, 1080}, 30};

// A film whose bytes follow another law than the one that is expected.
struct FilmLaw {
    double bytes_of_asked, power, power_of_rate;
    int measured = 0;
    double operator()(const FilmShape& shape) {
        ++measured;
        const double pixels = static_cast<double>(shape.size.width) * shape.size.height;
        return bytes_of_asked * std::pow(pixels / (1920.0 * 1080.0), power) *
               std::pow(shape.fps / 30.0, power_of_rate);
    }
};

double loss(const FilmShape& shape) {
    return std::log2(1080.0 / shape.size.height) + std::log2(30.0 / shape.fps);
}

}  // namespace

TEST_CASE("a film that is small enough keeps its shape") {
    FilmLaw film{4e6, 0.5, 1.0};
    const auto shape = fitting_shape(asked, mp4(), 5e6, std::ref(film));
    REQUIRE(shape);
    CHECK(shape->size == asked.size);
    CHECK(shape->fps == 30);
    CHECK(film.measured == 1);
}

TEST_CASE("the shape of a film that fits fits, and is not much smaller than it must be") {
    for (const double power : {0.35, 0.5, 0.8})
        for (const double power_of_rate : {0.6, 1.0})
            for (const double most : {8e6, 4e6, 2.5e6}) {
                CAPTURE(power);
                CAPTURE(power_of_rate);
                CAPTURE(most);
                FilmLaw film{10e6, power, power_of_rate};
                const auto shape = fitting_shape(asked, mp4(), most, std::ref(film));
                REQUIRE(shape);
                CHECK(film.measured <= 6);
                CHECK(film(*shape) <= most);
                CHECK(loss(*shape) > 0.0);
                // Of two laws that lose as much for as many bytes, this is a step or two too far.
                const double least = std::log2(10e6 / most) / std::max(2 * power, power_of_rate);
                CHECK(loss(*shape) < least + 1.0);
                CHECK(shape->size.width % 2 == 0);
                CHECK(std::abs(shape->size.width * 9 - shape->size.height * 16) <= 16);
            }
}

TEST_CASE("what does not fit in the smallest shape does not fit") {
    FilmLaw film{10e6, 0.5, 1.0};
    CHECK_FALSE(fitting_shape(asked, mp4(), 1e5, std::ref(film)));
    // Its bytes fall faster than expected: the smallest is tried before it is given up.
    FilmLaw steep{10e6, 2.0, 2.0};
    const auto shape = fitting_shape(asked, mp4(), 1e5, std::ref(steep));
    REQUIRE(shape);
    CHECK(steep(*shape) <= 1e5);
}

TEST_CASE("a tall film is made narrower") {
    FilmLaw film{10e6, 0.5, 1.0};
    const auto shape = fitting_shape({{1080, 1920}, 30}, mp4(), 3e6, std::ref(film));
    REQUIRE(shape);
    CHECK(shape->size.height > shape->size.width);
    CHECK(shape->size.width >= 240);
}

TEST_CASE("sizes are read with their units") {
    CHECK(parsed_bytes("--max-size", "5MB") == 5e6);
    CHECK(parsed_bytes("--max-size", "800 kB") == 8e5);
    CHECK(parsed_bytes("--max-size", "2.5GB") == 2.5e9);
    CHECK(parsed_bytes("--max-size", "3MiB") == 3.0 * 1024 * 1024);
    CHECK(parsed_bytes("--max-size", "500000") == 5e5);
    for (const char* wrong :
         {"", "MB", "5 Mb", "-5MB", "0", "nan", "inf", "1e999", "5MB5", "5,5MB"})
        CHECK_THROWS_AS(parsed_bytes("--max-size", wrong), UsageError);
}
