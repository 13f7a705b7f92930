// What is varied over the runs of a sweep: how it is written, and in which order its runs are.
#include "scene/sweep.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <set>
#include <string>

#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

std::string refusal(const auto& work) {
    try {
        work();
    } catch (const SweepError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("seeds are a range with both ends, or a number of them from 1 on") {
    CHECK(seed_range("8") == SeedRange{1, 8});
    CHECK(seed_range("5:9") == SeedRange{5, 9});
    CHECK(seed_range("7:7").count() == 1);
    CHECK(seed_range("0:0").count() == 1);
    CHECK(seed_range("1:9007199254740991").last == 9007199254740991);
    for (const char* wrong : {"", "0", "9:5", "1:2:3", "a", "1.5", "-1:3", "1:9007199254740992",
                              "1:99999999999999999999", "1 2"}) {
        CAPTURE(wrong);
        CHECK(refusal([&] { seed_range(wrong); }).find(wrong) != std::string::npos);
    }
}

TEST_CASE("values of an axis are equally spaced with both ends, in as few digits as they have") {
    using Values = std::vector<std::string>;
    CHECK(sweep_axis("gas.0.radius=0.1:0.4:7") ==
          SweepAxis{"gas.0.radius", Values{"0.1", "0.15", "0.2", "0.25", "0.3", "0.35", "0.4"}});
    CHECK(sweep_axis("gas.0.count=400:100:4").values == Values{"400", "300", "200", "100"});
    CHECK(sweep_axis("a=-1:1:3").values == Values{"-1", "0", "1"});
    CHECK(sweep_axis("a=1e-3:3e-3:3").values == Values{"0.001", "0.002", "0.003"});
    CHECK(sweep_axis("a=1").values == Values{"1"});
    CHECK(sweep_axis("walls=solid, periodic").values == Values{"solid", "periodic"});
    CHECK(sweep_axis("box.size=[32, 48],[64, 48]").values == Values{"[32, 48]", "[64, 48]"});
    CHECK(sweep_axis("gas.0.name='a, b',c").values == Values{"'a, b'", "c"});
    CHECK(sweep_axis("run.events=[]").values == Values{"[]"});
    for (const char* wrong :
         {"a", "=1", "a=", "a=1,,2", "a=1:2:1", "a=1:2:0", "a=1:2:-3", "a=1:2:99999999", "a=1,1",
          "a=2:2:3", "a=0.1:0.2", "a=1:2:x", "a=1:2:3:4"}) {
        CAPTURE(wrong);
        CHECK_FALSE(refusal([&] { sweep_axis(wrong); }).empty());
    }
}

TEST_CASE("a spaced value is what is written, to the last bit") {
    for (const std::string& text : sweep_axis("a=0.1:0.7:601").values) {
        const double value = std::strtod(text.c_str(), nullptr);
        CHECK(text.size() <= 6);
        CHECK(fmt::format("{}", value) == text);
    }
}

TEST_CASE("points go through a grid with the last axis fastest, seeds inside of a point") {
    const Sweep sweep{{sweep_axis("a=1,2,3"), sweep_axis("b=x,y")}, {5, 8}};
    CHECK(sweep.points() == 6);
    CHECK(sweep.runs() == 24);
    // Counted as loops count.
    std::int64_t run = 0, point = 0;
    for (const char* a : {"1", "2", "3"})
        for (const char* b : {"x", "y"}) {
            CHECK(sweep.changes_at(point) ==
                  std::vector<std::string>{std::string("a=") + a, std::string("b=") + b});
            for (std::uint64_t seed = 5; seed <= 8; ++seed) {
                CHECK(sweep.point_of(run) == point);
                CHECK(sweep.seed_of(run) == seed);
                ++run;
            }
            ++point;
        }
    CHECK(Sweep{}.points() == 1);
    CHECK(Sweep{}.runs() == 1);
    CHECK(Sweep{}.changes_at(0).empty());
}

TEST_CASE("a sweep has no axis twice, none of seeds, and not more than the limits") {
    const auto check = [](const std::vector<std::string>& axes, const char* seeds) {
        return refusal([&] {
            Sweep sweep{.seeds = seed_range(seeds)};
            for (const std::string& axis : axes) sweep.axes.push_back(sweep_axis(axis));
            check_sweep(sweep);
        });
    };
    CHECK(check({"a=1,2", "b=1,2"}, "3").empty());
    CHECK(check({"a=1,2", "a=3,4"}, "3") == "a is varied twice");
    CHECK(check({"gas.0={count: 3}", "gas.0.count=7,8"}, "3") ==
          "gas.0 and gas.0.count are varied, one of which is part of the other");
    CHECK(check({"gas.0.count=7,8", "gas.0={count: 3}"}, "3") ==
          "gas.0.count and gas.0 are varied, one of which is part of the other");
    CHECK(check({"seed=1,2"}, "3").find("`seed`") == 0);
    CHECK(check({}, "1000000").empty());
    CHECK(check({}, "1000001") == "the sweep has 1000001");
    CHECK(check({"a=1:2:10000"}, "100").empty());
    CHECK(check({"a=1:2:10000"}, "101") == "the sweep has 1010000");
    CHECK(check({"a=1:2:101", "b=1:2:100"}, "1") == "the sweep has 10100");
    CHECK_FALSE(check({"a=1:2:10000", "b=1:2:10000", "c=1:2:10000", "d=1:2:10000", "e=1:2:10000"},
                      "9007199254740991")
                    .empty());
}

TEST_CASE("two scenes with one gas and one run have one fingerprint, whatever else they say") {
    const auto fingerprint_of = [](const std::string& text, const Overrides& overrides = {}) {
        return test::scene_from(text, overrides).source.physics;
    };
    const std::string physics =
        "box: {size: [9, 8]}\ngas: [{count: 3, radius: 0.5, speed: 1}]\nrun: {until: 2}\n";
    const std::string one = fingerprint_of("title: A\n" + physics);
    CHECK(fingerprint_of("title: B # other\nseed: 4\nfilm: {seconds: 3}\n" + physics) == one);
    CHECK(fingerprint_of("title: A\nbox:\n  size: [9, 8]\ngas: [{count: 3, radius: 0.5, speed: "
                         "1}]\nrun: {until: 2}\n") == one);
    CHECK(fingerprint_of("title: A\n" + physics, {"run.until=3"}) != one);
    CHECK(fingerprint_of("title: A\n" + physics, {"gas.0.radius=0.4"}) != one);
    CHECK(fingerprint_of("title: A\n" + physics, {"box.walls=periodic"}) != one);
}
