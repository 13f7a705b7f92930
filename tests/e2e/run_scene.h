// carom run, by the program itself, of small scenes; and its CSV, read back.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/csv.h"
#include "support/process.h"

namespace carom::test {

/// What carom run writes of a scene.
struct SceneRun {
    nlohmann::json report;
    std::string csv;
};

/// Both outputs of a scene that is given as text without its title; nothing else may be said.
inline SceneRun run_scene(const std::string& scene, const std::vector<std::string>& more = {}) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + scene);
    std::vector<std::string> command{program,  "run", "scene.yaml", "--quiet",
                                     "--json", "-",   "--csv",      "samples.csv"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run(command, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(folder.names() == std::vector<std::string>{"samples.csv", "scene.yaml"});
    return {nlohmann::json::parse(outcome.out), contents(folder.path() / "samples.csv")};
}

/// One row of the CSV.
struct Row {
    double time;
    std::size_t particle;
    std::string species;
    double mass, radius, x, y, vx, vy;
};

inline double number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    CHECK(end == text.c_str() + text.size());
    return value;
}

inline std::vector<Row> rows_of(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    CHECK(line == "time,particle,species,mass,radius,x,y,vx,vy");
    std::vector<Row> rows;
    while (std::getline(lines, line)) {
        const std::vector<std::string> fields = cells_of(line);
        REQUIRE(fields.size() == 9);
        rows.push_back({number(fields[0]), std::stoul(fields[1]), fields[2], number(fields[3]),
                        number(fields[4]), number(fields[5]), number(fields[6]), number(fields[7]),
                        number(fields[8])});
    }
    return rows;
}

inline const std::string one_disk =  // 3 round trips of 2 * 10 at speed 3 in 20 units of time
    "box: {size: [12, 10]}\n"
    "gas: [{name: a, radius: 1, mass: 2, position: [6, 5], velocity: [3, 0]}]\n"
    "run: {until: 20, sample_every: 3.2}\n";

inline const std::string small_gas =
    "box: {size: [20, 15]}\n"
    "gas:\n"
    "  - {name: light, count: 30, radius: 0.4, speed: 2}\n"
    "  - {name: heavy, count: 5, radius: {uniform: [0.6, 1]}, density: 3, temperature: 1}\n"
    "run: {until: 30, equilibrate: 5, sample_every: 0.7}\n";

}  // namespace carom::test
