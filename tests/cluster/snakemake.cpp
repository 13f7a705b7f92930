// The Snakefile, by Debian's Snakemake with two jobs at a time: everything is made, what is missing
// is made again and nothing else, and after a kill it goes on.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "cluster/recipes.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

namespace {

struct Snakemake : Workplace {
    Snakemake() {
        write("carom.yaml",
              "carom: ./carom\n"
              "chunks: 4\n"
              "scenes:\n"
              "  - scenes/first.yaml\n"
              "  - {scene: scenes/second.yaml, format: gif, chunks: 2}\n"
              "sweeps:\n"
              "  - {scene: ensemble.yaml, seeds: '1:6', vary: ['gas.0.radius=0.3:0.5:2']}\n"
              "figures: course.yaml\n"
              "out: my results\n");
        write("course.yaml", "title: A gas\nscenes: [drawn.yaml]\n");
        write("drawn.yaml", scene("count: 12, radius: 0.7, speed: 2", small) +
                                "figures: [{name: energies, kind: energy-histogram}]\n");
    }

    std::string command(const std::string& options = "") const {
        return "XDG_CACHE_HOME=$PWD/cache snakemake -s '" + (recipes / "Snakefile").string() +
               "' --profile '" + (recipes / "profiles/local").string() + "' --cores 2 " + options;
    }

    Outcome make(const std::string& options = "") const {
        forget_asked();
        return shell(command(options), path());
    }

    void check_results() const {
        check_same(*this, "my results/films/first.mp4", "one.mp4");
        check_same(*this, "my results/films/second.gif", "one.gif");
        check_same(*this, "my results/sweeps/ensemble.json", "one.json");
        check_same(*this, "my results/sweeps/ensemble.csv", "one.csv");
        CHECK(has("my results/figures/course/captions.json"));
    }
};

}  // namespace

TEST_CASE("Snakemake makes the films and summaries of one process, and again what is missing") {
    if (!are_installed({"snakemake"})) return;
    const Snakemake place;
    place.make_references();
    Outcome made = place.make();
    REQUIRE_MESSAGE(made.exit_code == 0, made.err);
    place.check_results();
    CHECK(place.asked("render ").size() == 6);

    made = place.make();
    CHECK(made.exit_code == 0);
    CHECK(place.asked("") == Lines{});

    fs::remove(place.path() / "my results/plans/films/first/chunks/0003.chunk");
    fs::remove(place.path() / "my results/films/first.mp4");
    made = place.make();
    CHECK_MESSAGE(made.exit_code == 0, made.err);
    place.check_results();
    // Figures are asked for after all else, and carom draws those that have changed.
    CHECK(place.asked("") ==
          Lines{"figures course.yaml -o my results/figures/course --threads 1 --quiet",
                "join my results/plans/films/first -o my results/films/first.mp4 --quiet",
                "render my results/plans/films/first --chunk 3 --threads 1 --quiet"});
}

TEST_CASE("Snakemake goes on after it was killed with all of its jobs") {
    if (!are_installed({"snakemake"})) return;
    const Snakemake place;
    place.make_references();
    const Outcome killed = shell(
        "setsid sh -c 'echo $$ >group; exec " + std::string("sh ./start") +
            "' & for i in $(seq 600); do ls my*/plans/films/*/chunks/*.json >/dev/null 2>&1 && "
            "break; sleep 0.05; done; kill -s KILL -- -$(cat group); wait",
        (place.write("start", place.command() + " >killed.txt 2>&1\n"), place.path()));
    CAPTURE(killed.err);
    CHECK_FALSE(place.has("my results/films/first.mp4"));
    const std::size_t before = place.asked("render ").size();
    CHECK(before >= 1);

    CHECK(place.make().exit_code != 0);  // the folder is locked
    REQUIRE(place.make("--unlock").exit_code == 0);
    const Outcome made = place.make();
    REQUIRE_MESSAGE(made.exit_code == 0, made.err);
    place.check_results();
    CHECK(place.asked("render ").size() < 6);  // what was whole is not made again
}

TEST_CASE("Snakemake makes the other films where one scene is wrong, and tries it once") {
    if (!are_installed({"snakemake"})) return;
    const Snakemake place;
    place.make_references();
    place.write("scenes/first.yaml", Workplace::scene("count: -1, radius: 1", Workplace::small));
    const Outcome made = place.make();
    CHECK(made.exit_code == 1);
    CHECK(made.err.find("scenes/first.yaml:3") != std::string::npos);
    check_same(place, "my results/films/second.gif", "one.gif");
    CHECK(place.asked("plan scenes/first.yaml").size() == 1);
    place.write("carom.yaml", "scenes: scenes\nchunk: 3\n");
    CHECK(place.make().err.find("carom.yaml: unknown key `chunk`") != std::string::npos);
}

TEST_CASE("a disk that is full for a moment costs another attempt") {
    if (!are_installed({"snakemake"})) return;
    const Snakemake place;
    place.write("carom",
                "#!/bin/sh\necho \"$@\" >>asked\ncase $* in *'--chunk 1 '*) "
                "[ -e once ] || { touch once; exit 75; } ;; esac\nexec '" +
                    program + "' \"$@\"\n");
    const Outcome made = place.make("--config sweeps=[] figures=[] scenes=scenes/first.yaml");
    CHECK_MESSAGE(made.exit_code == 0, made.err);
    CHECK(place.asked("--chunk 1 ").size() == 2);
    CHECK(place.has("my results/films/first.mp4"));
}

TEST_CASE("what a scene names beside it is planned anew where it has changed") {
    if (!are_installed({"snakemake"})) return;
    const Snakemake place;
    std::filesystem::copy_file(checkout() / "templates/films/lecture.yaml",
                               place.path() / "scenes/mine.yaml");
    place.write("scenes/other.yaml",
                Workplace::scene("count: 9, radius: 0.4, speed: 1", "seconds: 1"));
    place.write("scenes/first.yaml",
                Workplace::scene("count: 12, radius: 0.4, speed: 3",
                                 Workplace::small +
                                     ", seconds: 1, template: mine, beside: {scene: other.yaml, "
                                     "own_label: a, label: b}"));
    const std::string only = "--config sweeps=[] figures=[] scenes=scenes/first.yaml";
    const Outcome first = place.make(only);
    REQUIRE_MESSAGE(first.exit_code == 0, first.err);
    CHECK(place.make(only).exit_code == 0);
    CHECK(place.asked("") == Lines{});
    const std::string film = place.file("my results/films/first.mp4");
    for (const auto& [changed, before, after] :
         {std::tuple{"scenes/mine.yaml", "theme: dark", "theme: light"},
          std::tuple{"scenes/other.yaml", "count: 9", "count: 8"}}) {
        CAPTURE(changed);
        std::string text = place.file(changed);
        text.replace(text.find(before), std::string(before).size(), after);
        place.write(changed, text);
        const Outcome made = place.make(only);
        CHECK_MESSAGE(made.exit_code == 0, made.err);
        CHECK(place.asked("plan scenes/first.yaml").size() == 1);
        CHECK(place.asked("render ").size() >= 1);
    }
    CHECK(place.file("my results/films/first.mp4") != film);
}

TEST_CASE("seeds that YAML reads as a number of base 60 are refused") {
    if (!are_installed({"snakemake"})) return;
    const Snakemake place;
    place.write("carom.yaml", "carom: ./carom\nsweeps: [{scene: ensemble.yaml, seeds: 1:20}]\n");
    const Outcome made = place.make();
    CHECK(made.exit_code == 1);
    CHECK(made.err.find("sweeps: ensemble: write `seeds` in quotes: \"1:20\"") !=
          std::string::npos);
    CHECK(place.asked("") == Lines{});
}
