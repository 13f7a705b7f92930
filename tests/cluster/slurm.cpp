// The recipes on a real Slurm of one node, which one-node-slurm.sh starts and ends: chunks that are
// killed, jobs that go back to the queue, jobs that end for good.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cluster/recipes.h"
#include "support/process.h"

using namespace carom::test;
using Lines = std::vector<std::string>;

namespace {

bool has_slurm() {
    return are_installed({"munged", "slurmctld", "slurmd", "sbatch", "scontrol", "python3"});
}

struct Slurm : Workplace {
    explicit Slurm(const std::string& film = "size: [320, 180], seconds: 4") {
        write("scenes/first.yaml", scene("count: 40, radius: 0.4, speed: 3", film));
        std::filesystem::create_directory(path() / "slurm");
        make_references();
    }

    /// Runs a script where there is a Slurm; `array` in it is slurm-array.sh, and returns when all
    /// is done. A job that goes back to the queue would start after two minutes: here, at once.
    Outcome with_slurm(const std::string& script) const {
        write("script",
              "export CAROM=$PWD/carom XDG_CACHE_HOME=$PWD/cache\n"
              "array() { '" +
                  (recipes / "slurm-array.sh").string() +
                  "' \"$@\" --wait; }\n"
                  "(while sleep 1; do squeue --noheader --array --format='%A %r' |\n"
                  "    while read -r job reason; do [ \"$reason\" != BeginTime ] ||\n"
                  "    scontrol update JobId=$job StartTime=now; done; done) &\n"
                  "helper=$!\n" +
                  script + "\nend=$?\nkill $helper\nexit $end\n");
        return shell("PATH=$PATH:/usr/sbin timeout 300 '" +
                         (checkout() / "tests/cluster/one-node-slurm.sh").string() +
                         "' slurm bash script",
                     path());
    }

    /// The first time that chunk 2 is asked for, its process is killed at work.
    void kill_chunk_2_once() const {
        write("carom",
              "#!/bin/sh\ncd '" + path().string() +
                  "'\necho \"$@\" >>asked\n"
                  "case \"$* \" in *'--chunk 2 '*) if [ ! -e killed ]; then\n"
                  "    '" +
                  program +
                  "' \"$@\" & sleep 0.2\n"
                  "    kill -KILL $! && touch killed\n    wait $!\n    exit $?\nfi ;; esac\n"
                  "exec '" +
                  program + "' \"$@\"\n");
    }
};

}  // namespace

TEST_CASE("three jobs of Slurm make the film of one process, though a chunk was killed at work") {
    if (!has_slurm()) return;
    const Slurm place("size: [1280, 720], seconds: 20");  // a chunk takes seconds
    place.kill_chunk_2_once();
    const Outcome made = place.with_slurm("array scenes/first.yaml -o out/film.mp4 --chunks 4");
    CHECK_MESSAGE(made.exit_code == 0, made.out, made.err);
    check_same(place, "out/film.mp4", "one.mp4");
    CHECK(place.has("killed"));
    CHECK(place.asked("--chunk 2").size() == 2);
    CHECK(place.asked("--chunk 3").size() == 1);
}

TEST_CASE("slurm-array.sh makes only what is missing, and says which job was the last") {
    if (!has_slurm()) return;
    const Slurm place;
    const Outcome made = place.with_slurm(
        "array scenes/second.yaml -o out/film.gif --chunks 3 || exit 1\n"
        "rm asked out/film.gif out/film.gif.plan/chunks/0002.chunk\n"
        "array scenes/second.yaml -o out/film.gif --chunks 3");
    CHECK_MESSAGE(made.exit_code == 0, made.out, made.err);
    CHECK(made.out.find("tasks 1-3\n") != std::string::npos);
    CHECK(made.out.find("tasks 2\n") != std::string::npos);
    check_same(place, "out/film.gif", "one.gif");
    CHECK(place.asked("render ") == Lines{"render out/film.gif.plan --chunk 2 --quiet"});
}

TEST_CASE(
    "slurm-array.sh plans anew where a template has changed, and takes options without values") {
    if (!has_slurm()) return;
    const Slurm place;
    std::filesystem::copy_file(checkout() / "templates/films/lecture.yaml",
                               place.path() / "scenes/mine.yaml");
    const std::string array =
        "array scenes/second.yaml -o out/film.gif --template mine --no-sound --chunks 2";
    const Outcome made = place.with_slurm(array +
                                          " || exit 1\ncp out/film.gif dark.gif\n"
                                          "sed -i s/dark/light/ scenes/mine.yaml\n" +
                                          array + " || exit 2\n" + array + " --force");
    CHECK_MESSAGE(made.exit_code == 0, made.out, made.err);
    CHECK(place.file("out/film.gif") != place.file("dark.gif"));
    CHECK(place.asked("render ").size() == 6);
}

TEST_CASE("an ensemble by Slurm is that of one process, and a film for more tasks than chunks") {
    if (!has_slurm()) return;
    const Slurm place;
    const Outcome made =
        place.with_slurm("array ensemble.yaml " + Workplace::ensemble +
                         " --chunks 5 -o out/all.json --csv out/all.csv || exit 1\n"
                         "array scenes/second.yaml -o out/many.gif --chunks 6");
    CHECK_MESSAGE(made.exit_code == 0, made.out, made.err);
    check_same(place, "out/all.json", "one.json");
    check_same(place, "out/all.csv", "one.csv");
    check_same(place, "out/many.gif", "one.gif");
}

TEST_CASE(
    "a wrong scene ends the three jobs at once, and a job that was cancelled can be repeated") {
    if (!has_slurm()) return;
    const Slurm place;
    place.write("scenes/wrong.yaml", Workplace::scene("count: -1, radius: 1", Workplace::small));
    const Outcome made = place.with_slurm(
        "array scenes/wrong.yaml -o out/wrong.mp4 && exit 1\n"
        "[ $(squeue --noheader | wc -l) = 0 ] || exit 2\n"
        "scontrol update PartitionName=all State=DOWN\n"
        "'" +
        (recipes / "slurm-array.sh").string() +
        "' scenes/first.yaml -o film.mp4 --chunks 3 || exit 3\n"
        "scancel --name=carom-chunk\n"
        "scontrol update PartitionName=all State=UP\n"
        "for i in $(seq 100); do [ $(squeue --noheader | wc -l) = 0 ] && break; sleep 0.2; done\n"
        "[ ! -e film.mp4 ] || exit 4\n"
        "array scenes/first.yaml -o film.mp4 --chunks 3");
    CHECK_MESSAGE(made.exit_code == 0, made.out, made.err);
    CHECK(made.err.find("not joined") != std::string::npos);
    CHECK(place.asked("plan scenes/wrong.yaml").size() == 1);
    check_same(place, "film.mp4", "one.mp4");
}

TEST_CASE("Snakemake makes films and summaries by Slurm, though a job was killed") {
    if (!has_slurm() || !are_installed({"snakemake"})) return;
    const Slurm place;
    place.write(
        "carom.yaml",
        "carom: ./carom\nchunks: 3\nscenes: [scenes/first.yaml, {scene: scenes/second.yaml, "
        "format: gif}]\nsweeps: [{scene: ensemble.yaml, seeds: '1:6', vary: "
        "['gas.0.radius=0.3:0.5:2'], chunks: 2}]\n");
    place.write("carom",
                "#!/bin/sh\necho \"$@\" >>asked\n"
                "case \"$* \" in *'films/first --chunk 2 '*) if [ ! -e killed ]; then\n"
                "    touch killed; scancel --signal=KILL --full $SLURM_JOB_ID; sleep 60\n"
                "fi ;; esac\nexec '" +
                    program + "' \"$@\"\n");
    const Outcome made =
        place.with_slurm("snakemake -s '" + (recipes / "Snakefile").string() + "' --profile '" +
                         (recipes / "profiles/slurm").string() + "' --latency-wait 5 2>&1");
    CHECK_MESSAGE(made.exit_code == 0, made.out, made.err);
    CHECK(place.has("killed"));
    CHECK(place.asked("films/first --chunk 2 ").size() == 2);
    check_same(place, "out/films/first.mp4", "one.mp4");
    check_same(place, "out/films/second.gif", "one.gif");
    check_same(place, "out/sweeps/ensemble.json", "one.json");
    check_same(place, "out/sweeps/ensemble.csv", "one.csv");
}
