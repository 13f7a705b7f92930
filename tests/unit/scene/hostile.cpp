// Files that ask for as much work as they can are read in a time that grows as their size does.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <string>

#include "scene/load.h"
#include "support/hostile_files.h"
#include "support/resources.h"
#include "support/share_of_cases.h"

using namespace carom;

namespace {

// Seconds of this processor, which others on the machine do not change: the least of some tries.
double time_to_load(const std::string& text, int tries) {
    double least = 1e9;
    for (int k = 0; k < tries; ++k) {
        const std::clock_t start = std::clock();
        try {
            load_scene_text(text, "test.yaml", test::resources());
        } catch (const SceneError&) {
        }
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
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
        const std::string large_text = file.text(4 * small);
        double large = time_to_load(large_text, 1);
        if (large < too_short_to_compare) continue;
        const double its = time_to_load(file.text(small), 2);
        large = std::min(large, time_to_load(large_text, 1));
        CAPTURE(large);
        CHECK(large <= between_four_and_sixteen * its);
    }
}
