// carom run, by the program itself: its samples, and that they depend on scene and seed only.
#include <doctest/doctest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "e2e/run_scene.h"

using namespace carom::test;
using nlohmann::json;

TEST_CASE("the same scene and seed give the same bytes, another seed others") {
    CHECK(run_scene(small_gas).csv == run_scene(small_gas, {"--threads", "2"}).csv);
    CHECK(run_scene(small_gas).csv != run_scene(small_gas, {"--seed", "2"}).csv);
    CHECK(run_scene(small_gas, {"--seed", "2"}).report["seed"] == 2);
}

TEST_CASE("how often samples are taken changes nothing in the run, and none is lost") {
    const auto [often, csv] = run_scene(small_gas, {"--set", "run.sample_every=0.01"});
    const json once = run_scene(small_gas, {"--set", "run.sample_every=30"}).report;
    for (const char* key : {"collisions", "momentum"}) CHECK(often[key] == once[key]);
    CHECK(often["pressure"]["wall"] == once["pressure"]["wall"]);
    CHECK(csv.size() > 5'000'000);  // several times what is written at once
    CHECK(rows_of(csv).size() == 3001 * 35);
}

TEST_CASE("names with commas and quotes stay one field of the CSV") {
    const auto [report, csv] = run_scene(
        "box: {size: [9, 9]}\ngas: [{name: 'a \"hot\", fast one', count: 1, position: [4, 4]}]\n"
        "run: {until: 1, sample_every: 1}\n");
    CHECK(csv.find("\n0,0,\"a \"\"hot\"\", fast one\",1,0.5,4,4,0,0\n1,0,") != std::string::npos);
    CHECK(report["species"][0]["name"] == "a \"hot\", fast one");
}

TEST_CASE("numbers of the CSV have the fewest digits that give back every bit") {
    const std::string csv = run_scene(
                                "box: {size: [9, 9]}\ngas: [{radius: 0.3, mass: 4.9, position: "
                                "[4.1, 4.7], velocity: [0.1, -0.7]}]\n"
                                "run: {until: 1, sample_every: 1}\n")
                                .csv;
    CHECK(csv.find("\n0,0,gas,4.9,0.3,4.1,4.7,0.1,-0.7\n") != std::string::npos);
    const std::string last = "\n1,0,gas,4.9,0.3,";
    const std::size_t begin = csv.find(last);
    REQUIRE(begin != std::string::npos);
    const std::string x = csv.substr(begin + last.size());
    CHECK(std::strtod(x.c_str(), nullptr) == 4.1 + 0.1);  // 4.199999999999999
    CHECK(std::strtod(x.c_str() + x.find(',') + 1, nullptr) == 4.7 - 0.7);
}
