#include "util/threads/relay.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace carom;

TEST_CASE("a relay hands values on in order, on one other thread") {
    std::vector<int> sent(1000), taken;
    std::iota(sent.begin(), sent.end(), 0);
    std::vector<std::thread::id> threads;
    Relay<int> relay([&](int value) {
        taken.push_back(value);
        threads.push_back(std::this_thread::get_id());
    });
    for (const int value : sent) relay.send(value);
    relay.finish();
    CHECK(taken == sent);
    for (const std::thread::id id : threads) CHECK((id == threads.front()));
    CHECK((threads.front() != std::this_thread::get_id()));
}

TEST_CASE("what the taker of a relay throws comes out where values are sent, or at its end") {
    const auto refuse = [](int value) {
        if (value == 3) throw std::runtime_error("three");
    };
    Relay<int> relay(refuse);
    const auto send_many = [&] {
        for (int i = 0; i < 100; ++i) relay.send(i);
    };
    CHECK_THROWS_WITH(send_many(), "three");
    CHECK_THROWS_WITH(relay.finish(), "three");
    Relay<int> last(refuse);
    last.send(3);
    CHECK_THROWS_WITH(last.finish(), "three");
}

TEST_CASE("a relay that has settled has taken all that was sent, and takes more") {
    std::vector<int> taken;
    Relay<int> relay([&](int value) {
        if (value < 0) throw std::runtime_error("negative");
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        taken.push_back(value);
    });
    relay.settle();  // nothing was sent
    for (std::size_t i = 0; i < 20; ++i) {
        relay.send(static_cast<int>(i));
        relay.settle();
        REQUIRE(taken.size() == i + 1);
    }
    relay.send(-1);
    CHECK_THROWS_WITH(relay.settle(), "negative");
}
