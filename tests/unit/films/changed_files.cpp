// Files that carom keeps between its runs, changed by others who made the fingerprints agree: they
// are refused with a message, whatever they hold, and lead nowhere.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "films/chunks/film_chunks.h"
#include "films/first_pass.h"
#include "panels/archived.h"
#include "runs/json.h"
#include "support/files.h"
#include "support/scene_text.h"
#include "util/archive.h"
#include "util/diagnostics.h"
#include "util/fingerprint.h"
#include "works/plan_folder.h"

using namespace carom;
namespace fs = std::filesystem;

namespace {

Scene small_film() {
    return test::scene_from(
        "title: T\nbox: {size: [20, 15]}\ngas: [{count: 3, radius: 0.3, speed: 1}]\n"
        "run: {until: 2}\nfilm: {size: [64, 64], fps: 24, seconds: 2, panels: []}\n");
}

Progress& silent() {
    static Progress progress(Progress::Form::silent, "");
    return progress;
}

// A plan of a film in two chunks.
struct PlannedFilm {
    test::TemporaryFolder folder;

    PlannedFilm() {
        plan_film(small_film(), {.output = "film.gif"}, {.chunks = 2}, folder.path() / "plan",
                  false, silent());
    }

    fs::path path() const { return folder.path() / "plan"; }

    // With a value of plan.json changed, and its fingerprint made anew.
    void change(const std::string& pointer, const Json& value) const {
        Json json = json_in(test::contents(path() / "plan.json"));
        json[Json::json_pointer(pointer)] = value;
        json.erase("fingerprint");
        json["fingerprint"] = fingerprint(text_of(json));
        folder.write("plan/plan.json", text_of(json));
    }
};

// The recording of a run, as film_plan.cpp writes it, that says to have so many frames.
std::string recording(std::int64_t frames, std::int64_t sample) {
    std::string progress;
    bool is_kept = true, with_collisions = false;
    std::vector<Tick> ticks{{}};
    Sample one;
    one.position = one.velocity = Eigen::ArrayXXd::Zero(3, 2);
    std::vector<Sample> samples{one};
    AdvanceResult advanced;
    std::vector<Collision> collisions;
    Archive archive;
    archive(progress, is_kept, with_collisions, ticks, samples, frames, sample, advanced,
            collisions);
    return archive.finished();
}

const Json huge = 1e300, large = 9223372036854775807;

}  // namespace

TEST_CASE("a plan of a stranger is read, or refused with a message") {
    const PlannedFilm plan;
    CHECK(PlanFolder(plan.path()).chunks().size() == 2);
    for (const auto& change :
         std::vector<std::pair<std::string, Json>>{{"/chunks", nullptr},
                                                   {"/chunks/0", 1},
                                                   {"/chunks/0/chunk", 2},
                                                   {"/chunks/0/chunk", "1"},
                                                   {"/chunks/0/chunk", huge},
                                                   {"/chunks/1/chunk", large},
                                                   {"/chunks/0/first_frame", -1},
                                                   {"/chunks/0/last_frame", large},
                                                   {"/chunks/1/first_frame", 0},
                                                   {"/chunks/0/start", "../../secret"},
                                                   {"/chunks/0/start", Json::array()},
                                                   {"/chunks/0/memory_bytes", huge},
                                                   {"/files", 1},
                                                   {"/request", Json::array()},
                                                   {"/request/build", 0}}) {
        const std::string& pointer = change.first;
        CAPTURE(pointer);
        const PlannedFilm changed;
        changed.change(pointer, change.second);
        CHECK_THROWS_AS(PlanFolder(changed.path()), UsageError);
    }
    plan.change("/film/format", "exe");
    CHECK_THROWS_AS(format_of_plan(PlanFolder(plan.path())), UsageError);
    plan.change("/film", 1);
    CHECK_THROWS_AS(format_of_plan(PlanFolder(plan.path())), UsageError);
    plan.change("/request/scene", 1);
    CHECK_THROWS_AS(scene_of_plan(PlanFolder(plan.path())), UsageError);
    plan.change("/kind", "sweep");
    CHECK_THROWS_AS(PlanFolder(plan.path()), UsageError);
}

TEST_CASE("what a film's chunk begins with takes no more memory than it has bytes") {
    FilmPlan plan = prepare(small_film(), {.output = "film.gif"}, silent());
    CHECK_NOTHROW(read_run(plan, recording(1, 0), "start"));
    for (const auto& [frames, sample] :
         {std::pair{std::int64_t{1} << 40, 0}, {std::int64_t{-1}, 0}, {std::int64_t{0}, 0}})
        CHECK_THROWS_AS(read_run(plan, recording(frames, sample), "start"), SystemError);
    for (const std::int64_t sample : {1, -1})
        CHECK_THROWS_WITH_AS(read_run(plan, recording(1, sample), "start"),
                             "cannot read start: its frames do not fit together", SystemError);
}

TEST_CASE("the parts of a film's plan fit together, and its output leads nowhere") {
    FilmOptions options{.output = "/etc/film.mp4"};
    FilmPlan plan = prepare(small_film(), {.output = "film.mp4"}, silent());
    const FilmPlan good = plan;
    FilmOptions read;
    read_shared(shared_bytes(plan, options), "film.plan", read);
    CHECK(read.output == "film.mp4");
    const auto is_refused = [&](const FilmPlan& changed) {
        FilmPlan copy = changed;
        CHECK_THROWS_WITH_AS(read_shared(shared_bytes(copy, options), "film.plan", read),
                             "cannot read film.plan: its parts do not fit together", SystemError);
    };
    plan.segments.back() += 1;
    is_refused(plan);
    plan = good;
    plan.span.first = -1;
    is_refused(plan);
    plan = good;
    plan.starts.front().particles.species[0] = 7;
    is_refused(plan);
    plan = good;
    plan.starts.front().sample.position.resize(2, 2);
    is_refused(plan);
}
