// carom run --xyz: read back by a reader that was written from the format's specification and by
// ASE, the trajectory holds the samples of the CSV, every bit of them.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/run_scene.h"

using namespace carom::test;
using nlohmann::json;

namespace {

// `reader`: empty, or ase.
json frames_of(const TemporaryFolder& folder, const std::string& reader = "") {
    std::vector<std::string> command{"/usr/bin/python3", (root / "tests/e2e/read_xyz.py").string(),
                                     (folder.path() / "a.xyz").string()};
    if (!reader.empty()) command.push_back(reader);
    const Outcome read = run(command);
    CAPTURE(read.err);
    REQUIRE(read.exit_code == 0);
    return json::parse(read.out);  // Python's JSON knows Infinity, and this reader does not
}

bool has_ase() {
    if (run({"/usr/bin/python3", "-c", "import ase.io"}).exit_code == 0) return true;
    MESSAGE("python3-ase is not installed: the trajectory is not read by it");
    return false;
}

void check_samples(const json& frames, const std::vector<Row>& rows) {
    std::size_t row = 0;
    for (const json& frame : frames)
        for (std::size_t i = 0; i < frame["pos"].size(); ++i, ++row) {
            REQUIRE(row < rows.size());
            const Row& its = rows[row];
            CHECK(frame["time"] == its.time);
            CHECK(frame["id"][i] == its.particle);
            CHECK(frame["pos"][i] == json{its.x, its.y, 0.0});
            CHECK(frame["velo"][i] == json{its.vx, its.vy, 0.0});
            CHECK(frame["radius"][i] == its.radius);
            CHECK(frame["mass"][i] == its.mass);
            CHECK(frame["species"][i] == (its.species == "light" ? "H" : "He"));
        }
    CHECK(row == rows.size());
}

}  // namespace

TEST_CASE("a trajectory holds the samples of the CSV, by the format's rules and by ASE") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + small_gas);
    const Outcome outcome =
        run({program, "run", "scene.yaml", "--quiet", "--xyz", "a.xyz", "--csv", "a.csv"},
            folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const std::vector<Row> rows = rows_of(contents(folder.path() / "a.csv"));
    const json frames = frames_of(folder);
    CHECK(frames.size() == 44);
    check_samples(frames, rows);
    CHECK(frames[0]["lattice"] == json{20.0, 0.0, 0.0, 0.0, 15.0, 0.0, 0.0, 0.0, 1.0});
    CHECK(frames[0]["pbc"] == json{false, false, false});
    CHECK(frames[0]["names"] == "H: light; He: heavy");
    if (!has_ase()) return;
    const json by_ase = frames_of(folder, "ase");
    check_samples(by_ase, rows);
    CHECK(by_ase[43]["lattice"] == frames[43]["lattice"]);
    CHECK(by_ase[43]["pbc"] == frames[43]["pbc"]);
}

TEST_CASE(
    "a periodic box, a line, infinite masses and strange names are said as readers know them") {
    const TemporaryFolder folder;
    folder.write(
        "scene.yaml",
        "title: T\nbox: {size: [9, 7], walls: {left: periodic, right: periodic}}\n"
        "gas:\n  - {name: \"a \\\"hot\\\", = {fast} one\\\\\", count: 1, position: [4, 4]}\n"
        "  - {name: wall, count: 1, mass: infinite, position: [7, 4]}\n"
        "run: {until: 1, sample_every: 1}\n");
    REQUIRE(
        run({program, "run", "scene.yaml", "--quiet", "--xyz", "a.xyz"}, folder.path()).exit_code ==
        0);
    const std::string text = contents(folder.path() / "a.xyz");
    CHECK(has(text, "pbc=\"T F F\" species_names=\"H: a  hot      fast  one ; He: wall\"\n"));
    CHECK(has(text, "\nHe 7 4 0 0 0 0 0.5 inf 1\n"));
    if (has_ase()) {
        const std::string check =
            "from ase.io import read; a = read('a.xyz', format='extxyz'); "
            "print(a.info['species_names'], a.arrays['mass'][1])";
        const Outcome by_ase = run({"/usr/bin/python3", "-c", check}, folder.path());
        CAPTURE(by_ase.err);
        CHECK(by_ase.out == "H: a  hot      fast  one ; He: wall inf\n");
    }
    folder.write("line.yaml",
                 "title: T\nbox: {length: 20}\ngas: [{count: 1, radius: 0.5, position: [5], "
                 "velocity: [-1]}]\nrun: {until: 1, sample_every: 1}\n");
    REQUIRE(
        run({program, "run", "line.yaml", "--quiet", "--xyz", "a.xyz"}, folder.path()).exit_code ==
        0);
    const json frames = frames_of(folder);
    CHECK(frames[0]["lattice"] == json{20.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
    CHECK(frames[1]["pos"] == json{{4.0, 0.0, 0.0}});
    CHECK(frames[1]["velo"] == json{{-1.0, 0.0, 0.0}});
}

TEST_CASE("a trajectory of spheres has three coordinates and the box of three lengths") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: T\nbox: {size: [20, 10, 8], walls: {back: periodic, front: periodic}}\n"
                 "gas: [{count: 1, radius: 0.5, position: [5, 4, 3], velocity: [-1, 0.5, 2]}]\n"
                 "run: {until: 1, sample_every: 1}\n");
    REQUIRE(
        run({program, "run", "scene.yaml", "--quiet", "--xyz", "a.xyz"}, folder.path()).exit_code ==
        0);
    for (const std::string reader : {"", "ase"}) {
        if (!reader.empty() && !has_ase()) return;
        const json frames = frames_of(folder, reader);
        CHECK(frames[0]["lattice"] == json{20.0, 0.0, 0.0, 0.0, 10.0, 0.0, 0.0, 0.0, 8.0});
        CHECK(frames[0]["pbc"] == json{false, false, true});
        CHECK(frames[1]["pos"] == json{{4.0, 4.5, 5.0}});
        CHECK(frames[1]["velo"] == json{{-1.0, 0.5, 2.0}});
    }
}

TEST_CASE("a trajectory appears with the other outputs, or none of them does") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + one_disk);
    folder.write("full/keep", "");
    const Outcome outcome = shell("ulimit -f 1; exec " + program +
                                      " run scene.yaml --quiet --set run.sample_every=0.01 --xyz "
                                      "a.xyz --events b.csv --json c.json",
                                  folder.path());
    CHECK(outcome.exit_code == 1);
    CHECK(folder.names() == std::vector<std::string>{"full", "scene.yaml"});
    const Outcome same =
        run({program, "run", "scene.yaml", "--xyz", "a", "--events", "./a"}, folder.path());
    CHECK(same.exit_code == 2);
    CHECK(same.err == "carom: --xyz and --events would both be written to ./a\n");
}
