// carom run --events: every collision is there, with what happened in it.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/run_scene.h"

using namespace carom::test;
using nlohmann::json;

namespace {

using CollisionRow = std::map<std::string, std::string>;

struct CollisionRun {
    json report;
    std::vector<CollisionRow> rows;
    std::vector<Row> samples;
};

CollisionRun collisions_of(const std::string& scene, const std::vector<std::string>& more = {},
                           bool samples = true) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + scene);
    std::vector<std::string> command{program, "run",      "scene.yaml", "--quiet", "--json",
                                     "-",     "--events", "events.csv", "--csv",   "samples.csv"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run(command, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CollisionRun found{json::parse(outcome.out), {}, {}};
    if (samples) found.samples = rows_of(contents(folder.path() / "samples.csv"));
    const auto rows = quoted_rows(contents(folder.path() / "events.csv"));
    for (std::size_t k = 1; k < rows.size(); ++k) {
        REQUIRE(rows[k].size() == rows[0].size());
        CollisionRow& row = found.rows.emplace_back();
        for (std::size_t i = 0; i < rows[k].size(); ++i) row[rows[0][i]] = rows[k][i];
    }
    return found;
}

double value(const CollisionRow& row, const std::string& name) { return number(row.at(name)); }

// Where a particle is and how fast, since when.
struct Flight {
    double time, x, y, vx, vy;
};

}  // namespace

TEST_CASE("who follows the rows comes from the first sample to the last") {
    const CollisionRun run = collisions_of(small_gas);
    const std::size_t count = 35;
    std::vector<Flight> now(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Row& its = run.samples[i];
        now[i] = {0.0, its.x, its.y, its.vx, its.vy};
    }
    const auto meets = [&](std::size_t i, const CollisionRow& row, const std::string& whose) {
        Flight& its = now[i];
        const double time = value(row, "time"), flown = time - its.time;
        // Free flight up to there: what was lost in rounding is some units in the last place.
        CHECK(its.x + its.vx * flown == doctest::Approx(value(row, whose + "x")).epsilon(1e-12));
        CHECK(its.y + its.vy * flown == doctest::Approx(value(row, whose + "y")).epsilon(1e-12));
        CHECK(its.vx == value(row, whose + "vx_before"));
        CHECK(its.vy == value(row, whose + "vy_before"));
        its = {time, value(row, whose + "x"), value(row, whose + "y"),
               value(row, whose + "vx_after"), value(row, whose + "vy_after")};
    };
    std::int64_t pairs = 0, walls = 0;
    double last = 0.0;
    for (const CollisionRow& row : run.rows) {
        CHECK(value(row, "time") >= last);
        last = value(row, "time");
        const auto first = static_cast<std::size_t>(value(row, "particle"));
        meets(first, row, "");
        const double mass = run.samples[first].mass;
        for (const std::string axis : {"x", "y"}) {
            const std::string v = "v" + axis;
            const double lost = mass * (value(row, v + "_before") - value(row, v + "_after"));
            CHECK(lost == doctest::Approx(value(row, "impulse_" + axis)));
        }
        if (row.at("partner").empty()) {
            ++walls;
            continue;
        }
        ++pairs;
        CHECK(row.at("surface").empty());
        const auto second = static_cast<std::size_t>(value(row, "partner"));
        meets(second, row, "partner_");
        const double dx = value(row, "partner_x") - value(row, "x");
        const double dy = value(row, "partner_y") - value(row, "y");
        CHECK(std::hypot(dx, dy) ==
              doctest::Approx(run.samples[first].radius + run.samples[second].radius));
        for (const std::string v : {"vx", "vy"})
            CHECK(run.samples[second].mass * (value(row, "partner_" + v + "_after") -
                                              value(row, "partner_" + v + "_before")) ==
                  doctest::Approx(value(row, "impulse_" + v.substr(1))));
    }
    CHECK(run.report["collisions"]["particle"] == pairs);
    CHECK(run.report["collisions"]["wall"] == walls);
    CHECK(pairs > 200);
    const std::size_t begin = run.samples.size() - count;
    for (std::size_t i = 0; i < count; ++i) {
        const Row& its = run.samples[begin + i];
        const double flown = its.time - now[i].time;
        CHECK(now[i].x + now[i].vx * flown == doctest::Approx(its.x).epsilon(1e-12));
        CHECK(now[i].y + now[i].vy * flown == doctest::Approx(its.y).epsilon(1e-12));
    }
}

TEST_CASE("a disk between two walls meets them when arithmetic says") {
    // From 6 to the wall at 12 with radius 1 and speed 3, then 10 to and fro.
    const CollisionRun run = collisions_of(one_disk);
    REQUIRE(run.rows.size() == 6);
    for (std::size_t k = 0; k < run.rows.size(); ++k) {
        const CollisionRow& row = run.rows[k];
        const bool right = k % 2 == 0;
        CHECK(value(row, "time") == doctest::Approx((5.0 + 10.0 * static_cast<double>(k)) / 3.0));
        CHECK(row.at("surface") == (right ? "right" : "left"));
        CHECK(row.at("partner").empty());
        CHECK(value(row, "partner_x") == (right ? 12.0 : 0.0));
        CHECK(value(row, "partner_y") == 5.0);
        CHECK(value(row, "impulse_x") == (right ? 12.0 : -12.0));
        CHECK(value(row, "partner_vx_after") == 0.0);
    }
}

TEST_CASE("rows are the same however often samples are taken, and on a line have no y") {
    CHECK(collisions_of(small_gas, {"--set", "run.sample_every=0.01"}).rows ==
          collisions_of(small_gas, {"--set", "run.sample_every=30"}).rows);
    const CollisionRun line = collisions_of(
        "box: {length: 20}\ngas:\n  - {name: a, radius: 0.5, mass: 3, position: [5], velocity: "
        "[2]}\n  - {name: b, radius: 0.5, mass: 1, position: [10], velocity: [0]}\n"
        "run: {until: 3, sample_every: 3}\n",
        {}, false);
    REQUIRE(line.rows.size() == 1);  // at 2, when the gap of 4 is closed; 3 u = 1.5 m u'
    CHECK(line.rows[0].size() == 11);
    CHECK(value(line.rows[0], "time") == 2.0);
    CHECK(value(line.rows[0], "vx_after") == 1.0);
    CHECK(value(line.rows[0], "partner_vx_after") == 3.0);
    CHECK(value(line.rows[0], "impulse_x") == 3.0);
}

TEST_CASE("surfaces are called by their names, with their own velocities") {
    const CollisionRun run = collisions_of(
        "box: {size: [20, 10]}\npartitions: [{name: 'a, piston', x: 10, mass: 2, velocity: 1}]\n"
        "gas: [{radius: 1, mass: 1, position: [5, 5], velocity: [4, 0]}]\n"
        "run: {until: 2, sample_every: 2}\n");
    REQUIRE(!run.rows.empty());
    const CollisionRow& row = run.rows[0];  // the gap of 4 closes at 3 a unit of time
    CHECK(row.at("surface") == "a, piston");
    CHECK(value(row, "time") == doctest::Approx(4.0 / 3.0));
    CHECK(value(row, "partner_vx_before") == 1.0);
    CHECK(value(row, "vx_after") == doctest::Approx(0.0));  // elastic, of masses 1 and 2
    CHECK(value(row, "partner_vx_after") == doctest::Approx(3.0));
    CHECK(value(row, "impulse_x") == doctest::Approx(4.0));
}
