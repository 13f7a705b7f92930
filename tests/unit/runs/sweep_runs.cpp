// The runs of a sweep and what they give together, against slow and obvious counting.
#include "runs/sweep_runs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "runs/sweep_summary.h"
#include "support/scene_text.h"
#include "util/diagnostics.h"

using namespace carom;

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

const char* const gas =
    "title: T\nbox: {size: [20, 15]}\ngas:\n  - {name: light, count: 20, radius: 0.4, speed: 2}\n"
    "  - {name: heavy, count: 5, radius: 0.6, mass: 3, temperature: 1}\n"
    "run: {until: 5, sample_every: 0.7}\n";

const Sweep sweep{{sweep_axis("gas.0.radius=0.2,0.4")}, {3, 5}};

std::shared_ptr<const Scene> scene_at(std::int64_t point) {
    return std::make_shared<const Scene>(test::scene_from(gas, sweep.changes_at(point)));
}

// Of sorted values the one at the place p (n - 1), between two by their distances.
double slow_quantile(std::vector<double> values, double p) {
    std::sort(values.begin(), values.end());
    const double place = p * double(values.size() - 1);
    for (std::size_t k = 0; k + 1 < values.size(); ++k)
        if (double(k) <= place && place <= double(k + 1))
            return values[k] * (double(k + 1) - place) + values[k + 1] * (place - double(k));
    return values.back();
}

}  // namespace

TEST_CASE("statistics of a number are those of its definitions") {
    const std::vector<double> values{3.0, -1.0, absent, 4.0, 1.0, 5.0, absent, -9.0, 2.0};
    const std::vector<double> there{3.0, -1.0, 4.0, 1.0, 5.0, -9.0, 2.0};
    double sum = 0.0, squares = 0.0;
    for (const double value : there) sum += value;
    const double mean = sum / 7.0;
    for (const double value : there) squares += (value - mean) * (value - mean);
    const NumberStatistics its = statistics_of(values);
    CHECK(its.count == 7);
    CHECK(its.mean == doctest::Approx(mean).epsilon(1e-14));
    CHECK(its.deviation == doctest::Approx(std::sqrt(squares / 6.0)).epsilon(1e-14));
    CHECK(its.error == doctest::Approx(std::sqrt(squares / 6.0 / 7.0)).epsilon(1e-14));
    CHECK(its.least == -9.0);
    CHECK(its.most == 5.0);
    for (std::size_t k = 0; k < quantile_shares.size(); ++k)
        CHECK(its.quantiles[k] ==
              doctest::Approx(slow_quantile(there, quantile_shares[k])).epsilon(1e-14));
    CHECK(its.quantiles[2] == 2.0);  // the middle of seven
}

TEST_CASE("too few values have no statistics") {
    const NumberStatistics none = statistics_of(std::vector<double>{absent, absent});
    CHECK(none.count == 0);
    for (const double value :
         {none.mean, none.error, none.deviation, none.least, none.quantiles[0]})
        CHECK(std::isnan(value));
    const NumberStatistics one = statistics_of(std::vector<double>{absent, 4.0});
    CHECK(one.count == 1);
    CHECK(one.mean == 4.0);
    CHECK(one.quantiles[0] == 4.0);
    CHECK(std::isnan(one.error));
    CHECK(std::isnan(one.deviation));
}

TEST_CASE("a run of a sweep is the run of its scene with its seed, on any number of threads") {
    const RunRows rows = run_part(sweep, 0, sweep.runs(), 1, scene_at);
    REQUIRE(rows.size() == 6);
    for (std::int64_t run = 0; run < 6; ++run) {
        const Scene scene = test::scene_from(
            gas, {sweep.changes_at(run / 3).front(), "seed=" + std::to_string(3 + run % 3)});
        const RunReport report = run_physics(scene);
        const std::vector<double>& row = rows[static_cast<std::size_t>(run)];
        const std::vector<RunNumber> numbers = numbers_of_runs(scene);
        REQUIRE(row.size() == numbers.size());
        const auto value = [&](const std::string& name) {
            const auto found = std::ranges::find(numbers, name, &RunNumber::name);
            REQUIRE(found != numbers.end());
            return row[static_cast<std::size_t>(found - numbers.begin())];
        };
        CHECK(value("temperature") == *report.summary.temperature);
        CHECK(value("virial pressure") == *report.summary.virial_pressure);
        CHECK(value("wall pressure") == *report.summary.wall_pressure);
        CHECK(value("particle collisions") == double(report.collisions.particle));
        CHECK(value("mean energy of heavy") == *report.summary.species[1].energy);
        CHECK(value("mean energy") == doctest::Approx((20.0 * *report.summary.species[0].energy +
                                                       5.0 * *report.summary.species[1].energy) /
                                                      25.0));
        CHECK(value("mean free path") ==
              doctest::Approx(25.0 * 5.0 * value("mean speed") /
                              (2.0 * double(report.collisions.particle))));
    }
    CHECK(rows[0] != rows[1]);
    CHECK(run_part(sweep, 0, 6, 3, scene_at) == rows);
    const RunRows part = run_part(sweep, 2, 5, 2, scene_at);
    CHECK(part == RunRows(rows.begin() + 2, rows.begin() + 5));
}

TEST_CASE("a gas that finds no room is refused with its run") {
    const Sweep full{{sweep_axis("gas.0.radius=0.4,0.95")}, {1, 2}};
    const auto at = [&](std::int64_t point) {
        Scene scene = test::scene_from(
            "title: T\nbox: {size: [10, 10]}\ngas: [{count: 30, radius: 0.4, speed: 1}]\n"
            "run: {until: 1}\n");
        scene.gas.species[0].radius = point == 0 ? 0.4 : 1.2;
        return std::make_shared<const Scene>(scene);
    };
    try {
        run_part(full, 0, 4, 2, at);
        FAIL("placed");
    } catch (const SceneError& error) {
        CHECK(error.diagnostics().front().message.find("run 2 (gas.0.radius=0.95, seed 1): ") == 0);
    }
}

TEST_CASE("a summary is read back as it was written") {
    const RunRows rows = run_part(sweep, 0, sweep.runs(), 2, scene_at);
    SweepSummary summary{.carom = "0.1",
                         .build = {{"physics", "abc"}},
                         .scene = "a scene.yaml",
                         .title = "“T”",
                         .overrides = {"run.until=5"},
                         .physics = "f00",
                         .sweep = sweep,
                         .numbers = numbers_of_runs(*scene_at(0))};
    for (const std::ptrdiff_t first : {0, 3})
        summary.points.push_back(
            {3, statistics_of(RunRows(rows.begin() + first, rows.begin() + first + 3))});
    const std::string text = text_of(summary);
    const SweepSummary back = sweep_summary(text, "summary.json");
    CHECK(text_of(back) == text);
    CHECK(back.sweep == sweep);
    CHECK(back.points[1].numbers[3].mean == summary.points[1].numbers[3].mean);

    const auto refusal = [](const std::string& wrong) {
        try {
            sweep_summary(wrong, "summary.json");
        } catch (const SystemError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal("{}").find("not the summary of a sweep") != std::string::npos);
    CHECK(refusal(text.substr(0, text.size() / 2)).find("summary.json") != std::string::npos);
    std::string other = text;
    other.replace(other.find("\"format_version\": 1"), 19, "\"format_version\": 2");
    CHECK(refusal(other).find("version 1") != std::string::npos);
    other = text;
    other.replace(other.find("\"standard_error\""), 16, "\"standard_errors\"");
    CHECK(refusal(other) ==
          "cannot read summary.json: it was changed after it was written (key 'standard_error' not "
          "found)");
    other = text;
    other.replace(other.find("\"energy/area\""), 13, "\"pound/inch2\"");
    CHECK(refusal(other) ==
          "cannot read summary.json: it was changed after it was written (unknown unit: "
          "pound/inch2)");
    other = text;
    other.replace(other.find("\"first\": 3"), 10, "\"first\": 9");
    CHECK(refusal(other).find("changed") != std::string::npos);
    other = text;
    other.replace(other.find("\"first\": 3"), 10, "\"first\": 4");
    CHECK(refusal(other).empty());
    other = text;
    other.replace(other.find("\"0.4\""), 5, "\"0.4\", \"0.5\"");
    CHECK(refusal(other).find("points are missing") != std::string::npos);
}
