// Work on several threads: all of it, each once, and of several errors always the same one.
#include "util/threads/on_threads.h"

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "util/diagnostics.h"

using namespace carom;

TEST_CASE("each piece of work is done once on any number of threads") {
    for (const int threads : {0, 1, 2, 7, 100}) {
        std::vector<std::atomic<int>> done(50);
        on_threads(threads, done.size(), [&](std::size_t i) { ++done[i]; });
        for (const auto& count : done) CHECK(count == 1);
    }
    on_threads(4, 0, [](std::size_t) { throw std::logic_error("there is nothing to do"); });
}

TEST_CASE("the first error in order is thrown, and nothing is begun after one") {
    for (const int threads : {1, 3}) {
        std::atomic<int> begun = 0;
        std::string thrown;
        try {
            on_threads(threads, 10'000, [&](std::size_t i) {
                ++begun;
                if (i >= 5) throw std::runtime_error(std::to_string(i));
            });
        } catch (const std::runtime_error& error) {
            thrown = error.what();
        }
        CHECK(thrown == "5");
        CHECK(begun >= 6);
        CHECK(begun < 6 + threads);
    }
}

TEST_CASE("threads are asked for at once, and memory before it is taken") {
    std::atomic<int> begun = 0;
    require_threads(7, [&] { ++begun; });
    CHECK(begun == 7);
    CHECK_THROWS_WITH(require_threads(3, [] { throw std::runtime_error("no font"); }), "no font");
    CHECK_NOTHROW(require_memory(1 << 20, "a picture"));
    CHECK_THROWS_AS(require_memory(std::size_t{1} << 60, "a picture"), SystemError);
    const auto message = [](int threads) {
        try {
            require_memory(std::size_t{1} << 60, "a picture", threads);
        } catch (const SystemError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(message(1).ends_with("raise the limit (ulimit -v)"));
    CHECK(message(2).ends_with("or use fewer threads (--threads)"));
}
