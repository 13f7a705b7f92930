// carom run, by the program itself: its report against truths that are known exactly, and against
// its samples.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "e2e/run_scene.h"
#include "support/relative.h"

using namespace carom::test;
using nlohmann::json;

namespace {

// Every number of the report is one: no word, no NaN.
void check_numbers(const json& value) {
    if (value.is_number_float()) CHECK(std::isfinite(value.get<double>()));
    if (value.is_structured())
        for (const json& item : value) check_numbers(item);
}

}  // namespace

TEST_CASE("a disk between two walls presses with twice its momentum at each return") {
    const auto [report, csv] = run_scene(one_disk);
    CHECK(report["scene"] == "scene.yaml");
    CHECK(report["seed"] == 1);
    CHECK(report["dimension"] == 2);
    CHECK(report["particles"] == 1);
    CHECK(report["time"] == 20.0);
    CHECK(report["precision_bits"] == 53);
    CHECK(report["collisions"] == json{{"particle", 0}, {"wall", 6}, {"per_particle", 0.0}});
    CHECK(report["energy"] ==
          json{{"initial", 9.0}, {"final", 9.0}, {"largest_relative_error", 0.0}});
    CHECK(report["momentum"] == json{{"initial", {6.0, 0.0}}, {"final", {6.0, 0.0}}});
    CHECK(report["overlap"]["largest_relative"] == 0.0);
    CHECK(report["pressure"]["wall"].get<double>() == relative(6 * 12.0 / (20.0 * 44.0), 1e-14));
    // 2K over (12 * 8 + 10 * 10), the room that its centre can reach
    CHECK(report["pressure"]["virial"].get<double>() == relative(18.0 / 196.0, 1e-14));
    CHECK(report["temperature"] == 9.0);
    CHECK(report["species"] ==
          json{{{"name", "a"}, {"count", 1}, {"mean_energy", 9.0}, {"mean_speed", 3.0}}});
    CHECK(report["reversals"] == json::array());
    CHECK(report["seconds"]["total"].get<double>() > 0.0);
    CHECK(report["seconds"]["events_per_second"].get<double>() > 0.0);
    check_numbers(report);

    const std::vector<Row> rows = rows_of(csv);
    REQUIRE(rows.size() == 8);  // at 0, 3.2, ..., 19.2 and at the end
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double time = k < 7 ? 3.2 * static_cast<double>(k) : 20.0;
        CAPTURE(time);
        CHECK(rows[k].time == time);
        CHECK(rows[k].particle == 0);
        CHECK(rows[k].species == "a");
        CHECK(rows[k].mass == 2.0);
        CHECK(rows[k].radius == 1.0);
        const double way = std::fmod(3.0 * time + 5.0, 20.0);  // from the left end of its way
        CHECK(rows[k].x == relative(1.0 + (way <= 10.0 ? way : 20.0 - way), 1e-14));
        CHECK(rows[k].y == 5.0);
        CHECK(rows[k].vx == (way < 10.0 ? 3.0 : -3.0));
        CHECK(rows[k].vy == 0.0);
    }
    CHECK(csv.starts_with("time,particle,species,mass,radius,x,y,vx,vy\n0,0,a,2,1,6,5,3,0\n"));
}

TEST_CASE("pressure times area is the energy of a gas of points") {
    // Whole numbers of round trips, one along each axis: exact but for the radius.
    const auto [report, csv] = run_scene(
        "box: {size: [10, 10]}\n"
        "gas: [{radius: 1e-9, position: [[2, 5], [7, 1]], velocity: [[2, 0], [0, 2]]}]\n"
        "run: {until: 30}\n");
    CHECK(report["collisions"]["wall"] == 12);
    CHECK(report["pressure"]["wall"].get<double>() == relative(4.0 / 100.0, 1e-8));
    CHECK(report["pressure"]["virial"].get<double>() == relative(4.0 / 100.0, 1e-8));
    CHECK(rows_of(csv).size() == 2 * 1001);
}

TEST_CASE("two disks that meet head on change velocities once") {
    const auto [report, csv] = run_scene(
        "box: {size: [30, 10], walls: periodic}\n"
        "gas: [{position: [[10, 5], [20, 5]], velocity: [[1, 0], [-1, 0]]}]\n"
        "run: {until: 8, sample_every: 4}\n");
    CHECK(report["collisions"] == json{{"particle", 1}, {"wall", 0}, {"per_particle", 1.0}});
    CHECK(report["energy"]["largest_relative_error"] == 0.0);
    CHECK(report["pressure"]["wall"].is_null());
    // N T = 1 and r . dp = 1 * 2 in 8 units of time
    CHECK(report["pressure"]["virial"].get<double>() ==
          relative((1.0 + 2.0 / 16.0) / 300.0, 1e-14));
    // (N - 1) T = K, since the momentum of the pair is conserved; K = 1
    CHECK(report["temperature"] == 1.0);
    const std::vector<Row> rows = rows_of(csv);
    REQUIRE(rows.size() == 6);
    CHECK(rows[3].x == 16.0);
    CHECK(rows[4].x == relative(11.0, 1e-14));  // 14.5 at 4.5, then back
    CHECK(rows[5].x == relative(19.0, 1e-14));
    CHECK(rows[4].vx == -1.0);
}

TEST_CASE("a gas at rest has no energy, no error and no pressure") {
    const auto [report, csv] = run_scene(
        "box: {size: [30, 10]}\ngas: [{count: 20}, {name: rock, mass: infinite, count: 1}]\n"
        "run: {until: 8, sample_every: 2}\n",
        {"--set", "gas.0.name=dust"});
    CHECK(report["energy"] ==
          json{{"initial", 0.0}, {"final", 0.0}, {"largest_relative_error", 0.0}});
    CHECK(report["momentum"]["final"] == json{0.0, 0.0});
    CHECK(report["pressure"] == json{{"wall", 0.0}, {"virial", 0.0}, {"since", 0.0}});
    CHECK(report["temperature"] == 0.0);
    CHECK(report["collisions"] == json{{"particle", 0}, {"wall", 0}, {"per_particle", 0.0}});
    CHECK(report["histograms"]["speed"] == json{{"edges", {0.0, 1.0}}, {"counts", {105}}});
    CHECK(report["histograms"]["energy"] == json{{"edges", {0.0, 1.0}}, {"counts", {105}}});
    const std::vector<Row> rows = rows_of(csv);
    CHECK(rows.size() == 105);
    CHECK(std::isinf(rows.back().mass));
}

TEST_CASE("a wall that moves leaves no energy to conserve: null, not a word that is no JSON") {
    const auto [report, csv] = run_scene(
        "box: {size: [30, 10], walls: periodic}\n"
        "gas:\n  - {name: gas, count: 20, speed: 1}\n"
        "  - {name: piston, mass: infinite, position: [15, 5], velocity: [1, 0]}\n"
        "run: {until: 20}\n");
    CHECK(report["energy"] ==
          json{{"initial", nullptr}, {"final", nullptr}, {"largest_relative_error", nullptr}});
    CHECK(report["momentum"]["initial"][0].is_null());
    CHECK(report["momentum"]["initial"][1].is_number());
    CHECK(report["pressure"] == json{{"wall", nullptr}, {"virial", nullptr}, {"since", nullptr}});
    CHECK(report["species"][0]["mean_energy"].is_number());
    CHECK(report["species"][1]["mean_energy"].is_null());
    CHECK(report["species"][1]["mean_speed"] == 1.0);
    CHECK(rows_of(csv).back().vx == 1.0);
}

TEST_CASE("means over time are those of many samples, and do not depend on how many there are") {
    const json report = run_scene(small_gas).report;
    const auto [fine, csv] = run_scene(small_gas, {"--set", "run.sample_every=0.01"});
    std::map<std::string, std::pair<double, double>> sums;
    double samples = 0.0;
    for (const Row& row : rows_of(csv)) {
        const double square = row.vx * row.vx + row.vy * row.vy;
        sums[row.species].first += 0.5 * row.mass * square;
        sums[row.species].second += std::sqrt(square);
        samples += 1.0 / 35.0;
    }
    // Each collision is seen up to 0.01 late, at random.
    constexpr double late = 1e-3;
    const auto mean = [&](const json& from, std::size_t species, const char* of) {
        return from["species"][species][of].get<double>();
    };
    CHECK(mean(report, 0, "mean_energy") == relative(sums["light"].first / (30.0 * samples), late));
    CHECK(mean(report, 1, "mean_speed") == relative(sums["heavy"].second / (5.0 * samples), late));
    CHECK(report["temperature"].get<double>() ==
          relative((sums["light"].first + sums["heavy"].first) / (35.0 * samples), late));
    for (const std::size_t species : {0, 1})
        for (const char* of : {"mean_energy", "mean_speed"})
            CHECK(mean(report, species, of) == relative(mean(fine, species, of), 1e-12));
}

TEST_CASE("the histograms of the report count its samples") {
    const auto [report, csv] = run_scene(small_gas);
    const std::vector<Row> rows = rows_of(csv);
    REQUIRE(rows.size() == 44 * 35);  // ceil(30 / 0.7) + 1 samples
    std::vector<double> speeds, energies;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Row& row = rows[k];
        const auto sample = static_cast<double>(k / 35);
        CHECK(row.time == (sample == 43.0 ? 30.0 : sample * 0.7));
        CHECK(row.particle == k % 35);
        CHECK(row.species == (row.particle < 30 ? "light" : "heavy"));
        speeds.push_back(std::sqrt(row.vx * row.vx + row.vy * row.vy));
        energies.push_back(0.5 * row.mass * speeds.back() * speeds.back());
    }
    for (const auto& measured : {std::pair("speed", speeds), {"energy", energies}}) {
        const auto& name = measured.first;
        const auto& values = measured.second;
        CAPTURE(name);
        const std::vector<double> edges = report["histograms"][name]["edges"];
        const std::vector<std::int64_t> counts = report["histograms"][name]["counts"];
        REQUIRE(edges.size() == counts.size() + 1);
        CHECK(counts.size() >= 8);
        for (std::size_t b = 0; b < counts.size(); ++b)
            CHECK(counts[b] == std::count_if(values.begin(), values.end(), [&](double value) {
                      return value >= edges[b] && value < edges[b + 1];
                  }));
    }
    double first = 0.0, last = 0.0, momentum = 0.0;
    for (std::size_t k = 0; k < 35; ++k) {
        first += energies[k];
        last += energies[rows.size() - 35 + k];
        momentum += rows[k].mass * rows[k].vx;
    }
    CHECK(report["energy"]["initial"].get<double>() == relative(first, 1e-13));
    CHECK(report["energy"]["final"].get<double>() == relative(last, 1e-13));
    CHECK(report["energy"]["largest_relative_error"].get<double>() < 1e-13);
    CHECK(report["momentum"]["initial"][0].get<double>() == relative(momentum, 1e-12));
    CHECK(report["overlap"]["largest_relative"].get<double>() < 1e-13);
    CHECK(report["collisions"]["per_particle"].get<double>() ==
          2.0 * report["collisions"]["particle"].get<double>() / 35.0);
    check_numbers(report);
}

TEST_CASE("a reversed gas comes home by as many events as it left") {
    const std::string gas =
        "box: {size: [20, 15], walls: periodic}\n"
        "gas: [{count: 20, speed: 2, position: lattice}]\n";
    const json once = run_scene(gas + "run: {until: 10, events: [{at: 4, reverse: velocities}]}\n")
                          .report["reversals"];
    REQUIRE(once.size() == 1);
    CHECK(once[0]["at"] == 4.0);
    CHECK(once[0]["bits"] == 53);
    CHECK(once[0]["events"]["out"].get<int>() > 5);
    CHECK(once[0]["events"]["out"] == once[0]["events"]["back"]);
    const double largest = once[0]["largest_return_distance"];
    const double mean = once[0]["root_mean_square"];
    CHECK(largest < 1e-9);  // one or two collisions each
    CHECK(largest > 0.0);
    CHECK(mean <= largest);
    CHECK(mean * std::sqrt(20.0) >= largest);

    // The run ends before the second has led back to the first.
    const json late = run_scene(gas +
                                "run: {until: 9, events: [{at: 1, reverse: velocities}, "
                                "{at: 6, reverse: velocities}]}\n")
                          .report["reversals"];
    CHECK(late[1]["events"]["out"].get<int>() > 5);
    CHECK(late[1]["events"]["back"].is_null());
    CHECK(late[1]["largest_return_distance"].is_null());
    CHECK(late[1]["root_mean_square"].is_null());

    // The second comes before the first has led home; at 8 the gas is elsewhere.
    const json twice = run_scene(gas +
                                 "run: {until: 10, events: [{at: 4, reverse: velocities}, "
                                 "{at: 5, reverse: velocities}]}\n")
                           .report["reversals"];
    REQUIRE(twice.size() == 2);
    CHECK(twice[0]["largest_return_distance"].is_null());
    CHECK(twice[0]["events"]["back"].is_number());
    CHECK(twice[1]["largest_return_distance"].is_null());

    // The second comes when it is home: it has been there.
    const json after = run_scene(gas +
                                 "run: {until: 16, events: [{at: 4, reverse: velocities}, "
                                 "{at: 8, reverse: velocities}]}\n")
                           .report["reversals"];
    CHECK(after[0]["largest_return_distance"] == once[0]["largest_return_distance"]);
    CHECK(after[1]["largest_return_distance"].is_null());
}

TEST_CASE("with bits that are found a gas comes home where doubles go astray") {
    const std::string gas =
        "box: {size: [20, 15], walls: {bottom: periodic, top: periodic}}\n"
        "gas:\n  - {name: free, count: 30, speed: 2}\n"
        "  - {name: fixed, count: 2, radius: 1, mass: infinite}\n";
    const auto reversed = [&](const std::string& more) {
        return run_scene(gas + "run: {until: 60, " + more +
                         "events: [{at: 30, reverse: velocities}]}\n")
            .report;
    };
    const json astray = reversed("")["reversals"][0];
    CHECK(astray["largest_return_distance"].get<double>() > 1.0);
    CHECK(astray["log10_largest_return_distance"].get<double>() > 0.0);

    const json report = reversed("precision: auto, ");
    const int bits = report["precision_bits"];
    CHECK(bits >= 128);
    CHECK(bits <= 1024);
    const json home = report["reversals"][0];
    CHECK(home["bits"] == bits);
    CHECK(home["largest_return_distance"].get<double>() < 0.5e-9);
    CHECK(home["log10_largest_return_distance"].get<double>() ==
          relative(std::log10(home["largest_return_distance"].get<double>()), 1e-12));
    CHECK(home["events"]["out"].get<int>() > 300);
    CHECK(home["events"]["out"] == home["events"]["back"]);
    check_numbers(report);

    const json given = reversed("precision: 8192, ");
    CHECK(given["precision_bits"] == 8192);
    CHECK(given["reversals"][0]["largest_return_distance"] == 0.0);  // too small for a double
    CHECK(given["reversals"][0]["log10_largest_return_distance"].get<double>() < -2000.0);
    CHECK(given["reversals"][0]["events"] == home["events"]);
    check_numbers(given);

    const json fine = reversed("precision: auto, tolerance: 1e-290, ");
    CHECK(fine["reversals"][0]["largest_return_distance"].get<double>() < 0.5e-290);
}

TEST_CASE("a nudge of 1e-40 leads a reversed gas astray, and the bits have room for it") {
    const json report =
        run_scene(
            "box: {size: [20, 15]}\ngas: [{count: 60, speed: 2}]\n"
            "run: {until: 160, precision: auto, events: [{at: 80, reverse: velocities}, "
            "{at: 80, nudge: {particle: 7, by: [0, 1e-40]}}]}\n")
            .report;
    CHECK(report["precision_bits"].get<int>() >= 192);
    CHECK(report["reversals"][0]["largest_return_distance"].get<double>() > 1.0);
}

TEST_CASE("beads on a wire have one coordinate, and press with a force") {
    // Points of equal masses pass their velocities on: as if each flew alone from end to end.
    const TemporaryFolder folder;
    folder.write(
        "scene.yaml",
        "title: T\nbox: {length: 10}\n"
        "gas: [{position: [2, 7], velocity: [1, -2]}]\nrun: {until: 20, sample_every: 10}\n");
    const Outcome outcome =
        run({program, "run", "scene.yaml", "--quiet", "--json", "-", "--csv", "samples.csv"},
            folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const json report = json::parse(outcome.out);
    CHECK(report["dimension"] == 1);
    CHECK(report["momentum"] == json{{"initial", {-1.0}}, {"final", {-1.0}}});
    CHECK(report["collisions"]["wall"] == 6);
    CHECK(report["collisions"]["particle"].get<int>() > 0);
    CHECK(report["energy"]["largest_relative_error"] == 0.0);
    // Momentum 2 * 1 * 2 hits and 2 * 2 * 4 hits on two ends in 20 units of time; 2E / L
    CHECK(report["pressure"]["wall"].get<double>() == relative(0.5, 1e-14));
    CHECK(report["pressure"]["virial"].get<double>() == relative(0.5, 1e-14));
    CHECK(report["temperature"] == 2.5);  // twice the mean energy
    CHECK(contents(folder.path() / "samples.csv")
              .starts_with("time,particle,species,mass,radius,x,vx\n"
                           "0,0,gas,1,0,2,1\n0,1,gas,1,0,7,-2\n10,0,"));
}
