// Files that ask for as much work as they can are read in a time that grows as their size does.
#include <doctest/doctest.h>

#include <cstddef>
#include <ctime>
#include <string>
#include <vector>

#include "scene/load.h"
#include "scene/scene.h"
#include "stats/histogram.h"
#include "support/hostile_files.h"
#include "support/resources.h"
#include "support/share_of_cases.h"

using namespace carom;

namespace {

// Seconds of this processor, which others on the machine change a little.
double time_to_load(const std::string& text) {
    const std::clock_t start = std::clock();
    try {
        load_scene_text(text, "test.yaml", test::resources());
    } catch (const SceneError&) {
    }
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// How many times as long it takes to load the one as the other: the median of some tries, one after
// the other, so that what slows the machine down slows both.
double times_as_long(const std::string& large, const std::string& small) {
    constexpr int tries = 5;
    std::vector<double> ratios;
    for (int k = 0; k < tries; ++k) {
        const double first = time_to_load(large);
        ratios.push_back(first / time_to_load(small));
    }
    return quantile(ratios, 0.5);
}

}  // namespace

// Of a file four times as large the time is four times as long, of what grows as the square 16
// times. A sort, and memory that is farther away, take a little more than four.
TEST_CASE("no file takes more than in proportion to its size") {
    constexpr std::size_t small = (test::has_sanitizers ? 8 : 24) << 10;
    constexpr double between_four_and_sixteen = 9.0;
    for (const test::HostileFile& file : test::hostile_files()) {
        CAPTURE(file.about);
        constexpr double too_short_to_compare = 0.02;
        const std::string large = file.text(4 * small), little = file.text(small);
        const double seconds = time_to_load(large);
        if (seconds < too_short_to_compare) continue;
        const double ratio = seconds / time_to_load(little);
        CHECK((ratio <= between_four_and_sixteen ||
               times_as_long(large, little) <= between_four_and_sixteen));
    }
}
