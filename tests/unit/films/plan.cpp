// A film's plan: written, read back, and drawn from in other processes as here.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "films/chunks/film_chunks.h"
#include "films/first_pass.h"
#include "films/render.h"
#include "scene/load.h"
#include "support/file_size_limit.h"
#include "support/process.h"
#include "support/scene_text.h"
#include "util/diagnostics.h"
#include "util/fingerprint.h"

using namespace carom;
using carom::test::contents;
using carom::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

constexpr const char* small = "size: [320, 180], fps: 12, seconds: 6, ";

// Panels with axes, records of the whole run, trails, marks, flashes and arrows.
Scene plane(const std::string& more = "") {
    return test::scene_from(
        "title: T\nsubtitle: S\nbox: {size: [20, 15]}\n"
        "gas:\n  - {name: light, count: 40, radius: 0.3, speed: 1}\n"
        "  - {name: heavy, count: 1, radius: 1, mass: 9, velocity: [0.5, 0.2], position: [4, 4]}\n"
        "run: {until: 6, equilibrate: 2, events: [{at: 3, reverse: velocities}, "
        "{at: 1, mark: here}, {at: 2, caption: \"words {heavy.speed at 5}, {collisions}\"}]}\n"
        "film: {" +
        std::string(small) +
        "flashes: true, velocities: true, title_card: 1, panels: [speed-histogram, "
        "{kind: entropy}, {kind: return-distance}]" +
        more + "}\n");
}

Scene wire() {
    return test::scene_from(
        "title: T\nbox: {length: 12, walls: periodic}\n"
        "gas: [{name: a, count: 6, radius: 0.1, mass: 2, speed: 1}, "
        "{name: b, count: 4, radius: 0, speed: 1}]\nrun: {until: 8}\n"
        "film: {" +
        std::string(small) +
        "flashes: true, panels: [{kind: collision-map}, {kind: contact-time}, "
        "{kind: single-collision}]}\n");
}

// A bath and a piston, whose state and random numbers a run depends on.
Scene bath() {
    return test::scene_from(
        "title: T\nseed: 7\nbox: {size: [20, 15], walls: {left: {temperature: 2}, right: {mass: "
        "20, "
        "force: -2}}}\ngas: [{count: 30, radius: 0.4, speed: 1}]\nrun: {until: 6}\n"
        "film: {" +
        std::string(small) + "panels: [temperature, {kind: energy-account}]}\n");
}

// Two runs side by side, of which the second keeps nothing of the first's precision.
Scene two_runs() {
    return test::scene_from(
        "title: T\nbox: {size: [20, 15]}\ngas: [{count: 30, radius: 0.4, speed: 1}]\n"
        "run: {until: 6, precision: 96, events: [{at: 3, reverse: velocities}]}\n"
        "film: {" +
        std::string(small) +
        "panels: [return-distance, speed-histogram], "
        "beside: {own_label: A, label: B, set: run.precision=double}}\n");
}

Progress& silent() {
    static Progress progress(Progress::Form::silent, "");
    return progress;
}

// A film planned, made and joined in chunks, the last one first, on so many threads.
void make_in_chunks(const Scene& scene, const FilmOptions& options, int chunks,
                    const fs::path& folder) {
    plan_film(scene, options, {.chunks = chunks}, folder, false, silent());
    const PlanFolder plan(folder);
    CHECK(plan.missing().size() == plan.chunks().size());
    for (auto chunk = plan.chunks().rbegin(); chunk != plan.chunks().rend(); ++chunk)
        CHECK(render_chunk(plan, *chunk, {.threads = 1 + chunk->number % 2}, silent()));
    CHECK(plan.missing().empty());
    join_film(plan, {.output = options.output, .text = options.text}, silent());
}

template <class Work>
std::string refusal_of(const Work& work) {
    try {
        work();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a film that is made in chunks is the film of one process, byte for byte") {
    const TemporaryFolder folder;
    int number = 0;
    for (const Scene& scene : {plane(), wire(), two_runs()})
        for (const auto& [ending, chunks] : {std::pair{".mp4", 1}, {".mp4", 2}, {".gif", 3}}) {
            CAPTURE(number);
            const fs::path direct = folder.path() / (fmt::format("direct{}", number) + ending);
            const fs::path joined = folder.path() / (fmt::format("joined{}", number) + ending);
            render(scene, {.output = direct, .quality = Quality::draft, .threads = 2, .text = true},
                   silent());
            make_in_chunks(scene, {.output = joined, .quality = Quality::draft, .text = true},
                           chunks, folder.path() / fmt::format("plan{}", number++));
            CHECK((test::all_bytes(direct) == test::all_bytes(joined)));
            const auto transcript = [](fs::path film) {
                return contents(film.replace_extension(".transcript.txt"));
            };
            CHECK(transcript(direct) == transcript(joined));
        }
}

TEST_CASE("so is one whose run is not kept: its chunks begin with states of the simulation") {
    const TemporaryFolder folder;
    int number = 0;
    for (const Scene& scene : {plane(), wire(), bath(), two_runs()}) {
        CAPTURE(number);
        const FilmOptions direct{.output = folder.path() / fmt::format("direct{}.mp4", number),
                                 .quality = Quality::draft};
        render(scene, direct, silent());
        FilmOptions joined = direct;
        joined.output = folder.path() / fmt::format("joined{}.mp4", number);
        joined.room = {.memory = 10'000, .file = 0};
        make_in_chunks(scene, joined, 2, folder.path() / fmt::format("plan{}", number++));
        CHECK((contents(direct.output) == contents(joined.output)));
    }
}

TEST_CASE("a film whose frames wait in a file is the same, from one run") {
    const TemporaryFolder folder;
    int number = 0;
    for (const Scene& scene : {plane(), two_runs()})
        for (const char* ending : {".mp4", ".gif"}) {
            const auto rendered = [&](const Recording::Room& room) {
                const fs::path path = folder.path() / fmt::format("{}{}", number++, ending);
                const RenderReport report = render(scene,
                                                   {.output = path,
                                                    .quality = Quality::draft,
                                                    .threads = 2,
                                                    .text = true,
                                                    .room = room},
                                                   silent());
                return std::pair{contents(path), report.passes.size()};
            };
            const auto [bytes, passes] = rendered({});
            CHECK((rendered({.memory = 20'000}) == std::pair{bytes, passes}));
            CHECK(passes == 1);
            const auto [again, more] = rendered({.memory = 0, .file = 0});
            CHECK((again == bytes));
            CHECK(more > passes);
        }
}

TEST_CASE("so are a folder of frames and a part of a film") {
    const TemporaryFolder folder;
    const FilmOptions part{.output = folder.path() / "direct/", .from = 1.5, .to = 4.5};
    render(plane(), part, silent());
    FilmOptions other = part;
    other.output = folder.path() / "joined/";
    make_in_chunks(plane(), other, 2, folder.path() / "plan");
    CHECK((test::all_bytes(part.output) == test::all_bytes(other.output)));
    FilmOptions film{
        .output = folder.path() / "direct.webm", .quality = Quality::draft, .from = 1.5, .to = 4.5};
    render(plane(), film, silent());
    film.output = folder.path() / "joined.webm";
    make_in_chunks(plane(), film, 2, folder.path() / "plan2");
    CHECK((contents(folder.path() / "direct.webm") == contents(film.output)));
}

TEST_CASE("a plan is kept, a chunk is made once, and what is asked anew is made anew") {
    const TemporaryFolder folder;
    const FilmOptions options{.output = "film.mp4", .quality = Quality::draft};
    const fs::path at = folder.path() / "plan";
    CHECK(plan_film(plane(), options, {.chunks = 2}, at, false, silent()).is_new);
    const PlanFolder plan(at);
    REQUIRE(plan.chunks().size() == 2);
    CHECK(render_chunk(plan, plan.chunk(2), {}, silent()));
    CHECK_FALSE(render_chunk(plan, plan.chunk(2), {}, silent()));
    CHECK(render_chunk(plan, plan.chunk(2), {.force = true}, silent()));
    CHECK_FALSE(plan_film(plane(), options, {.chunks = 2}, at, false, silent()).is_new);
    CHECK(plan.missing() == std::vector<int>{1});
    CHECK(plan_film(plane(), options, {.chunks = 1}, at, false, silent()).is_new);
    CHECK(PlanFolder(at).missing() == std::vector<int>{1});
    CHECK(plan_film(plane(), options, {.chunks = 1}, at, true, silent()).is_new);
}

TEST_CASE("a plan that fails or is interrupted leaves the earlier one, with its chunks") {
    const TemporaryFolder folder;
    const FilmOptions options{.output = "film.mp4", .quality = Quality::draft};
    const fs::path at = folder.path() / "plan", other = folder.path() / "other";
    plan_film(plane(), options, {.chunks = 2}, at, false, silent());
    render_chunk(PlanFolder(at), PlanFolder(at).chunk(2), {}, silent());
    const auto files = [&] {
        std::vector<std::string> names;
        for (const auto& file : fs::recursive_directory_iterator(at))
            names.push_back(file.path().lexically_relative(at).string());
        std::ranges::sort(names);
        return names;
    };
    const std::vector<std::string> before = files();
    const auto plan_anew = [&](const fs::path& to) {
        plan_film(plane(), options, {.chunks = 1}, to, true, silent());
    };
    const auto check_kept = [&] {
        CHECK(files() == before);
        CHECK(PlanFolder(at).missing() == std::vector<int>{1});
        CHECK_FALSE(fs::exists(other));
    };
    for (const rlim_t bytes : {1000, 20'000}) {
        const test::FileSizeLimit limit(bytes);
        for (const fs::path& to : {at, other})
            CHECK(refusal_of([&] { plan_anew(to); }) ==
                  fmt::format("cannot write {}: File too large",
                              (to / "starts/0001.start").string()));
        check_kept();
    }
    plan_anew(at);
    CHECK(PlanFolder(at).missing() == std::vector<int>{1});
    CHECK(files() ==
          std::vector<std::string>{"film.plan", "plan.json", "starts", "starts/0001.start"});
}

TEST_CASE("a plan and chunks that are damaged, changed or of another plan are refused") {
    const TemporaryFolder folder;
    const FilmOptions options{.output = folder.path() / "film.mp4", .quality = Quality::draft};
    const fs::path at = folder.path() / "plan", other = folder.path() / "other";
    plan_film(plane(), options, {.chunks = 2}, at, false, silent());
    plan_film(plane(", color_by: mass"), options, {.chunks = 2}, other, false, silent());
    const PlanFolder plan(at);
    const auto join = [&] { join_film(plan, {.output = options.output}, silent()); };
    const auto is_refused = [&](const auto& work, const std::string& words) {
        const std::string refusal = refusal_of(work);
        CAPTURE(refusal);
        CHECK(refusal.find(words) != std::string::npos);
        CHECK_FALSE(fs::exists(options.output));
    };
    is_refused(join, "2 of 2 chunks are missing (1, 2)");
    for (const PlanFolder& one : {plan, PlanFolder(other)})
        for (const PlannedChunk& chunk : one.chunks()) render_chunk(one, chunk, {}, silent());
    is_refused([&] { PlanFolder(at).chunk(3); }, "--chunk 3: the chunks of");

    const fs::path file = at / "chunks/0002.chunk", manifest = at / "chunks/0002.json";
    const std::string whole = contents(file), facts = contents(manifest);
    const auto write = [](const fs::path& path, const std::string& bytes) {
        std::ofstream(path, std::ios::binary) << bytes;
    };
    write(file, whole.substr(0, whole.size() / 2));
    is_refused(join, "chunk 2 is of another plan, cut short or changed");
    CHECK(plan.missing() == std::vector<int>{2});
    std::string changed = whole;
    changed[whole.size() / 2] ^= 1;
    write(file, changed);
    is_refused(join, "chunk 2 is of another plan, cut short or changed");
    // Where the manifest agrees with it, the file itself tells.
    const std::string before = fingerprint(whole), after = fingerprint(changed);
    std::string agreeing = facts;
    agreeing.replace(agreeing.find(before), before.size(), after);
    write(manifest, agreeing);
    is_refused(join, "its content was changed after it was written");
    // Of another plan, with its manifest.
    fs::copy_file(other / "chunks/0002.chunk", file, fs::copy_options::overwrite_existing);
    fs::copy_file(other / "chunks/0002.json", manifest, fs::copy_options::overwrite_existing);
    is_refused(join, "chunk 2 is of another plan, cut short or changed");
    // Another chunk in its place.
    fs::copy_file(at / "chunks/0001.chunk", file, fs::copy_options::overwrite_existing);
    agreeing = facts;
    agreeing.replace(agreeing.find(before), before.size(), fingerprint(contents(file)));
    write(manifest, agreeing);
    is_refused(join, "it is chunk 1 of another plan");
    write(file, whole);
    // Made by another build.
    std::string mixed = facts;
    mixed.replace(mixed.find("cairo "), 6, "chalk ");
    write(manifest, mixed);
    is_refused(join, "pictures differ: cairo ");
    write(manifest, facts);

    std::string text = contents(at / "plan.json");
    const std::size_t frames = text.find("\"first_frame\": 0");
    REQUIRE(frames != std::string::npos);
    text[frames + 15] = '1';
    write(at / "plan.json", text);
    is_refused([&] { PlanFolder{at}; }, "it was changed after it was written; plan again");
    write(at / "plan.json", "{}");
    is_refused([&] { PlanFolder{at}; }, "this is not a plan of carom; name the folder of one");
    write(at / "starts/0001.start", "");
    is_refused([&] { render_chunk(plan, plan.chunk(1), {.force = true}, silent()); },
               "starts/0001.start: it was changed after it was written");
    write(at / "notes.txt", "mine");
    is_refused([&] { plan_film(plane(), options, {.chunks = 2}, at, true, silent()); },
               "notes.txt is not a file of a plan");
    CHECK(contents(at / "notes.txt") == "mine");
    join_film(PlanFolder(other), {.output = options.output}, silent());
    CHECK(fs::exists(options.output));
}

TEST_CASE("chunks consist of whole segments and share them evenly") {
    const std::vector<int> segments{0, 10, 20, 30, 40, 50};
    CHECK(chunk_starts(segments, 1) == std::vector<std::size_t>{0, 5});
    CHECK(chunk_starts(segments, 2) == std::vector<std::size_t>{0, 2, 5});
    CHECK(chunk_starts(segments, 5) == std::vector<std::size_t>{0, 1, 2, 3, 4, 5});
    CHECK(chunk_starts(segments, 100) == std::vector<std::size_t>{0, 1, 2, 3, 4, 5});
}

TEST_CASE("a run that is too large for memory is simulated again, to the same pictures") {
    const Scene scene = plane();
    FilmPlan plan = prepare(scene, {}, silent());
    Simulation start(scene.gas, scene.run);
    const Recording small_memory(start, plan.ticks(), {true},
                                 [](const Tick&, const Sample&, const AdvanceResult&) {},
                                 {.memory = 10'000, .file = 0});
    CHECK_FALSE(small_memory.is_kept());
    const OutputFormat& png = output_format("png");
    const std::vector<std::uint8_t> kept = draw_still(plan, 4.0, png, silent()).file();
    plan.runs = {small_memory};
    CHECK(draw_still(plan, 4.0, png, silent()).file() == kept);
    FilmOptions options;
    FilmPlan read = read_shared(shared_bytes(plan, options), "film.plan", options);
    read_run(read, run_bytes(plan), "film.start");
    CHECK_FALSE(read.runs.front().is_kept());
    CHECK(draw_still(read, 4.0, png, silent()).file() == kept);
}
