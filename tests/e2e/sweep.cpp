// Sweeps by the program itself: planned, run in chunks by several processes, joined; and what
// happens when something of that goes wrong.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "e2e/run_scene.h"
#include "support/csv.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string gas =
    "title: Sweep\nbox: {size: [20, 15]}\n"
    "gas: [{name: a, count: 20, radius: 0.4, temperature: 1}]\nrun: {until: 4}\n";

// A folder with a scene, and the commands of a sweep in it.
struct SweepFolder {
    TemporaryFolder folder;

    explicit SweepFolder(const std::string& scene = gas) { folder.write("gas.yaml", scene); }

    Outcome carom(const std::string& arguments) const {
        return shell("'" + program + "' " + arguments, folder.path());
    }
    void done(const std::string& arguments) const {
        const Outcome outcome = carom(arguments);
        CAPTURE(arguments);
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
    }
    void plan(const std::string& more = "") const {
        done("plan gas.yaml --quiet --seeds 11:14 --vary gas.0.radius=0.2:0.4:3 -o S " + more);
    }
    std::string text(const std::string& name) const { return contents(folder.path() / name); }
    fs::path at(const std::string& name) const { return folder.path() / name; }
    json plan_json() const { return json::parse(text("S/plan.json")); }
};

struct Joined {
    std::string summary, csv;
    bool operator==(const Joined&) const = default;
};

// Chunks in an order that is no order.
Joined joined_of(int chunks) {
    const SweepFolder its;
    its.plan("--chunks " + std::to_string(chunks));
    CHECK(its.carom("plan S --missing").out == its.carom("plan S --list").out);
    for (int k = 0; k < chunks; ++k)
        its.done("run S --quiet --chunk " + std::to_string((k * 3 + chunks / 2) % chunks + 1) +
                 " --threads " + std::to_string(1 + k % 3));
    CHECK(its.carom("plan S --missing").out.empty());
    its.done("join S -o summary.json --csv runs.csv --quiet");
    CHECK(its.text("summary.json") == its.text("S/summary.json"));
    return {its.text("summary.json"), its.text("runs.csv")};
}

// A chunk's error names its file and says how to mend it.
void check_refused_join(const SweepFolder& its, const std::string& words) {
    const Outcome outcome = its.carom("join S -o new.json");
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code != 0);
    CHECK(outcome.err.find(words) != std::string::npos);
    CHECK_FALSE(fs::exists(its.at("new.json")));
}

}  // namespace

TEST_CASE("a sweep has at most as many chunks as runs") {
    const SweepFolder its;
    its.done("plan gas.yaml --quiet --seeds 3 --chunks 16 -o S");
    CHECK(its.carom("plan S --list").out == "1\n2\n3\n");
}

TEST_CASE("each of more than a thousand chunks can be run") {
    const SweepFolder its;
    its.done("plan gas.yaml --quiet --seeds 1:1100 --chunks 1100 --set run.until=0.1 -o S");
    its.done("run S --chunk 1100 --quiet");
    CHECK(fs::exists(its.at("S/chunks/1100.runs")));
    const Outcome beyond = its.carom("run S --chunk 1101");
    CHECK(beyond.exit_code == 2);
    CHECK(has(beyond.err, "have the numbers 1 to 1100"));
    CHECK(has(its.carom("run S --chunk 0").err, "expected a whole number from 1 to 1000000"));
}

TEST_CASE("a sweep has one summary and one table for 1, 3 and 7 chunks in any order") {
    const Joined one = joined_of(1);
    CHECK(joined_of(4) == one);
    CHECK(joined_of(7) == one);
    const json summary = json::parse(one.summary);
    CHECK(summary["runs"] == 12);
    CHECK(summary["points"].size() == 3);
    CHECK(summary["points"][1]["values"]["gas.0.radius"] == 0.3);
    CHECK(std::ranges::count(one.csv, '\n') == 13);
}

TEST_CASE("the numbers of a sweep are those of carom run with the same seed") {
    const SweepFolder its;
    its.plan();
    its.done("run S --quiet");
    its.done("join S --csv runs.csv --quiet");
    std::istringstream lines(its.text("runs.csv"));
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> names = cells_of(line);
    const auto place = [&](const char* name) {
        const auto found = std::ranges::find(names, name);
        REQUIRE(found != names.end());
        return static_cast<std::size_t>(found - names.begin());
    };
    std::vector<double> pressures;
    for (int run = 0; std::getline(lines, line); ++run) {
        const std::vector<std::string> cells = cells_of(line);
        CHECK(cells[0] == std::to_string(run));
        CHECK(cells[1] == std::to_string(11 + run % 4));
        const Outcome outcome = its.carom("run gas.yaml --json - --quiet --seed " + cells[1] +
                                          " --set gas.0.radius=" + cells[2]);
        REQUIRE(outcome.exit_code == 0);
        const json report = json::parse(outcome.out);
        const auto value = [&](const char* name) { return std::stod(cells[place(name)]); };
        CHECK(value("temperature") == report["temperature"].get<double>());
        CHECK(value("virial pressure") == report["pressure"]["virial"].get<double>());
        CHECK(value("wall pressure") == report["pressure"]["wall"].get<double>());
        CHECK(value("particle collisions") == report["collisions"]["particle"].get<double>());
        CHECK(value("wall collisions") == report["collisions"]["wall"].get<double>());
        CHECK(value("mean speed") == report["species"][0]["mean_speed"].get<double>());
        if (run < 4) pressures.push_back(value("virial pressure"));
    }
    REQUIRE(pressures.size() == 4);
    const json point = json::parse(its.text("S/summary.json"))["points"][0]["numbers"];
    const double mean = (pressures[0] + pressures[1] + pressures[2] + pressures[3]) / 4.0;
    CHECK(point["virial pressure"]["n"] == 4);
    CHECK(point["virial pressure"]["mean"].get<double>() == doctest::Approx(mean).epsilon(1e-14));
    CHECK(point["virial pressure"]["max"] == std::ranges::max(pressures));
}

TEST_CASE("a plan is complete, says what is to do, and is kept where nothing has changed") {
    const SweepFolder its;
    const Outcome first =
        its.carom("plan gas.yaml --seeds 4 --vary gas.0.radius=0.2,0.3 --chunks 3 -o S");
    CHECK(first.exit_code == 0);
    CHECK(first.out.find("S: 3 chunks") == 0);
    const json plan = its.plan_json();
    CHECK(plan["kind"] == "sweep");
    CHECK(plan["request"]["text"] == gas);
    CHECK(plan["sweep"]["runs"] == 8);
    REQUIRE(plan["chunks"].size() == 3);
    CHECK(plan["chunks"][0]["first_run"] == 0);
    CHECK(plan["chunks"][2]["last_run"] == 7);
    for (const json& chunk : plan["chunks"]) {
        CHECK(chunk["seconds"].get<double>() > 0.0);
        CHECK(chunk["memory_bytes"].get<double>() > 1e6);
    }
    its.done("run S --chunk 2 --quiet");
    CHECK(its.carom("plan S --missing").out == "1\n3\n");
    CHECK(its.carom("plan S --list").out == "1\n2\n3\n");
    const std::string before = its.text("S/plan.json");
    const Outcome again =
        its.carom("plan gas.yaml --seeds 4 --vary gas.0.radius=0.2,0.3 --chunks 3 -o S");
    CHECK(again.out.find("2 of them to do") != std::string::npos);
    CHECK(its.text("S/plan.json") == before);
    CHECK(its.carom("plan S --missing").out == "1\n3\n");
    its.done("plan gas.yaml --seeds 5 --vary gas.0.radius=0.2,0.3 --chunks 3 -o S --quiet");
    CHECK(its.carom("plan S --missing").out == "1\n2\n3\n");
}

TEST_CASE("a chunk that is done is left as it is unless --force") {
    const SweepFolder its;
    its.plan("--chunks 2");
    its.done("run S --chunk 1 --quiet");
    const auto written = fs::last_write_time(its.at("S/chunks/0001.runs"));
    const std::string bytes = its.text("S/chunks/0001.runs");
    its.done("run S --chunk 1 --quiet");
    CHECK(fs::last_write_time(its.at("S/chunks/0001.runs")) == written);
    its.done("run S --chunk 1 --quiet --force");
    CHECK(fs::last_write_time(its.at("S/chunks/0001.runs")) > written);
    CHECK(its.text("S/chunks/0001.runs") == bytes);
}

TEST_CASE("a process that is killed costs its chunk, which is done again") {
    const SweepFolder whole, killed(
                                 "title: Sweep\nbox: {size: [20, 15]}\n"
                                 "gas: [{name: a, count: 20, radius: 0.4, temperature: 1}]\n"
                                 "run: {until: 4}\n");
    whole.plan("--chunks 3");
    killed.plan("--chunks 3");
    whole.done("run S --quiet");
    killed.done("run S --quiet --chunk 2");
    // No time is short enough on every machine: killed before it has begun, or in the middle.
    shell("'" + program + "' run S --quiet --chunk 1 & sleep 0.03; kill -KILL $!; wait",
          killed.folder.path());
    killed.done("run S --quiet");
    whole.done("join S --quiet --csv a.csv");
    killed.done("join S --quiet --csv a.csv");
    CHECK(killed.text("S/summary.json") == whole.text("S/summary.json"));
    CHECK(killed.text("a.csv") == whole.text("a.csv"));
}

TEST_CASE("two processes on one chunk both succeed") {
    const SweepFolder its;
    its.plan("--chunks 1");
    const Outcome both = shell("'" + program + "' run S --quiet --force --chunk 1 & a=$!; '" +
                                   program + "' run S --quiet --force --chunk 1 && wait $a",
                               its.folder.path());
    CHECK(both.exit_code == 0);
    CHECK(both.err.empty());
    its.done("join S --quiet");
    CHECK(std::distance(fs::directory_iterator(its.at("S/chunks")), {}) == 2);
}

TEST_CASE("chunks that are missing, cut short, changed or of another plan are named at join") {
    const SweepFolder its;
    its.plan("--chunks 3");
    its.done("run S --quiet");
    const std::string bytes = its.text("S/chunks/0002.runs");
    const auto write = [&](const std::string& text) {
        std::ofstream(its.at("S/chunks/0002.runs"), std::ios::binary) << text;
    };
    write(bytes.substr(0, bytes.size() / 2));
    check_refused_join(its, "chunk 2");
    CHECK(its.carom("plan S --missing").out == "2\n");
    std::string changed = bytes;
    changed[bytes.size() / 2] ^= 1;
    write(changed);
    check_refused_join(its, "chunk 2");
    write("");
    check_refused_join(its, "chunk 2");

    const SweepFolder other;
    other.done("plan gas.yaml --quiet --seeds 21:24 --vary gas.0.radius=0.2:0.4:3 --chunks 3 -o S");
    other.done("run S --quiet --chunk 2");
    fs::copy(other.at("S/chunks/0002.runs"), its.at("S/chunks/0002.runs"),
             fs::copy_options::overwrite_existing);
    check_refused_join(its, "chunk 2");
    fs::copy(other.at("S/chunks/0002.json"), its.at("S/chunks/0002.json"),
             fs::copy_options::overwrite_existing);
    check_refused_join(its, "chunk 2");
    // Even with a manifest that says that it is this plan's.
    json manifest = json::parse(its.text("S/chunks/0002.json"));
    manifest["plan"] = its.plan_json()["fingerprint"];
    std::ofstream(its.at("S/chunks/0002.json")) << manifest.dump();
    check_refused_join(its, "0002.runs: it is a chunk of another plan");

    fs::remove(its.at("S/chunks/0002.json"));
    check_refused_join(its, "1 of 3 chunks are missing (2)");
    its.done("run S --quiet");
    its.done("join S --quiet");
}

TEST_CASE("a plan that was edited, and chunks of another build, are refused") {
    const SweepFolder its;
    its.plan("--chunks 2");
    const std::string plan = its.text("S/plan.json");
    std::string edited = plan;
    edited.replace(edited.find("0.2"), 3, "0.1");
    std::ofstream(its.at("S/plan.json")) << edited;
    for (const char* command : {"run S --chunk 1", "join S", "plan S --list"}) {
        const Outcome outcome = its.carom(command);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.err.find("S/plan.json: it was changed after it was written") !=
              std::string::npos);
    }
    std::ofstream(its.at("S/plan.json")) << plan;
    its.done("run S --quiet");
    json manifest = json::parse(its.text("S/chunks/0002.json"));
    manifest["build"]["physics"] = "other";
    std::ofstream(its.at("S/chunks/0002.json")) << manifest.dump();
    check_refused_join(its, "physics differ");
    its.done("join S --quiet --allow-mixed");
}

TEST_CASE("what is wrong with a sweep is said before the first run") {
    const SweepFolder its;
    const auto refusal = [&](const std::string& arguments) {
        const Outcome outcome = its.carom("plan gas.yaml -o S " + arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_FALSE(fs::exists(its.at("S")));
        return outcome.err;
    };
    CHECK(refusal("--vary gas.0.raduis=0.1:0.2:2").find("--vary gas.0.raduis: error: ") == 0);
    CHECK(refusal("--vary gas.0.radius=0.1:40:4").find("with gas.0.radius=") != std::string::npos);
    CHECK(refusal("--vary gas.0.radius=0.1:0.2").find("--vary gas.0.radius=0.1:0.2") !=
          std::string::npos);
    CHECK(refusal("--vary seed=1,2").find("seed") != std::string::npos);
    CHECK(refusal("--seeds 9:1").find("--seeds 9:1") != std::string::npos);
    CHECK(refusal("--seeds 2000000").find("the limit is 1000000 runs of a sweep") !=
          std::string::npos);
    CHECK(refusal("--vary 'gas.0.name=a,b' --vary 'box.walls=solid,periodic' --seeds 2 --set "
                  "'gas.0.count=-1'")
              .find("count") != std::string::npos);
    // Two keys that name one place, and one that changes nothing of the run.
    CHECK(refusal("--vary gas.0.radius=0.1,0.2 --vary gas.a.radius=0.3,0.4")
              .find("the run with gas.0.radius=0.2, gas.a.radius=0.3 is the same as with "
                    "gas.0.radius=0.1, gas.a.radius=0.3") != std::string::npos);
    CHECK(refusal("--vary film.fps=20,30").find("is the same as with") != std::string::npos);
    CHECK(refusal("--vary gas.0.radius=0.1,1e-1").find("is there twice") != std::string::npos);
    CHECK(refusal("--seeds 3 --seed 4").find("--seed") != std::string::npos);
    CHECK(its.carom("run gas.yaml --chunk 1").exit_code == 2);
    CHECK(its.carom("join gas.yaml").exit_code == 2);
    CHECK(its.carom("plan gas.yaml --list").exit_code == 2);
    CHECK(its.folder.names() == std::vector<std::string>{"gas.yaml"});
    its.plan("--chunks 2");
    for (const char* wrong :
         {"run S --chunk 3", "run S --json a.json", "run S --seed 4", "run S --set run.until=3",
          "render S", "plan S --list --missing", "join S -o - --csv -", "join S -o a --csv a",
          "join S --words", "plan S --seeds 5", "plan S --vary gas.0.radius=0.1,0.2",
          "plan S --set run.until=3", "plan S --force", "plan S -o T", "plan S --chunks 3",
          "plan S gas.yaml", "plan S --list --format mp4", "plan S --from 1",
          "plan S --quality final"}) {
        CAPTURE(wrong);
        CHECK(its.carom(wrong).exit_code == 2);
    }
}

TEST_CASE("without seeds a sweep has that of the scene") {
    const SweepFolder its;
    its.done("plan gas.yaml --quiet --seed 9 --vary gas.0.radius=0.2,0.3 -o S");
    CHECK(its.plan_json().at("request").at("seeds") == json::array({9, 9}));
}

TEST_CASE("a plan never replaces files that are not its own") {
    const SweepFolder its;
    fs::create_directory(its.at("S"));
    std::ofstream(its.at("S/thesis.tex")) << "x";
    const Outcome outcome = its.carom("plan gas.yaml --seeds 2 -o S");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("thesis.tex") != std::string::npos);
    CHECK(its.text("S/thesis.tex") == "x");
}

TEST_CASE("files of others are not taken for those of a plan by their names") {
    const SweepFolder its;
    const std::string mine = "{\"mine\": true}";
    fs::create_directories(its.at("S/chunks"));
    const std::vector<std::string> names{"S/summary.json", "S/chunks/0001.json", "S/plan.json"};
    for (const std::string& name : names) {
        std::ofstream(its.at(name)) << mine;
        for (const char* more : {"", " --force"}) {
            const Outcome outcome = its.carom(std::string("plan gas.yaml --seeds 2 -o S") + more);
            CHECK(outcome.exit_code == 2);
            CHECK(has(outcome.err, " is not a file of a plan; choose another folder, or move it"));
        }
        for (const std::string& one : names)
            CHECK((!fs::exists(its.at(one)) || its.text(one) == mine));
    }
    for (const char* name : {"S/chunks/mine.json", "S/starts/mine.start", "S/film.plan/mine"}) {
        CAPTURE(std::string(name));
        fs::remove_all(its.at("S"));
        fs::create_directories(its.at(name).parent_path());
        std::ofstream(its.at(name)) << mine;
        CHECK(its.carom("plan gas.yaml --seeds 2 -o S").exit_code == 2);
        CHECK(its.text(name) == mine);
    }
}

// Snakemake removes it before it plans again.
TEST_CASE("what is left of a plan without its list is carom's") {
    const SweepFolder its;
    its.plan("--chunks 2");
    its.done("run S --quiet");
    its.done("join S --quiet");
    fs::remove(its.at("S/plan.json"));
    its.plan("--chunks 2");
    CHECK(its.carom("plan S --missing").out == "1\n2\n");
    CHECK_FALSE(fs::exists(its.at("S/summary.json")));
}

TEST_CASE("what is joined does not take the place of the plan or of a chunk") {
    const SweepFolder its;
    its.plan("--chunks 2");
    its.done("run S --quiet");
    for (const char* name : {"S/plan.json", "S/chunks/0001.runs", "S/chunks/0002.json"})
        for (const char* option : {"--csv", "-o"}) {
            const std::string before = its.text(name);
            const Outcome outcome = its.carom(std::string("join S ") + option + " " + name);
            CHECK(outcome.exit_code == 2);
            CHECK(has(outcome.err, "a file that the work is read from"));
            CHECK((its.text(name) == before));
        }
    its.done("join S --quiet --csv S/runs.csv");
}

TEST_CASE("a full disk is exit code 75, and the chunk is done once there is room") {
    if (geteuid() != 0) return;
    const SweepFolder its;
    const fs::path disk = its.at("disk");
    fs::create_directory(disk);
    if (run({"mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk.string()}).exit_code != 0) {
        MESSAGE("no tmpfs may be mounted here");
        return;
    }
    const Outcome planned = its.carom("plan gas.yaml --seeds 200 --chunks 1 -o disk/S --quiet");
    std::ofstream(disk / "fill") << std::string(40'000, 'x');
    const Outcome full = its.carom("run disk/S --quiet");
    const bool has_chunk = fs::exists(disk / "S/chunks/0001.runs");
    fs::remove(disk / "fill");
    const Outcome again = its.carom("run disk/S --quiet");
    const Outcome joined = its.carom("join disk/S -o summary.json --quiet");
    run({"umount", disk.string()});
    CHECK(planned.exit_code == 0);
    CHECK(full.exit_code == 75);
    CHECK(full.err.find("No space left on device") != std::string::npos);
    CHECK_FALSE(has_chunk);
    CHECK(again.exit_code == 0);
    CHECK(joined.exit_code == 0);
}
