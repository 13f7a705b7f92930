// Fuzz target: files that carom keeps between its runs and that others may have modified: the state
// of a simulation, the plan of a film and the state at the start of its chunks, plans, manifests of
// chunks and of figure folders, summaries of sweeps, chunks. The input selects the file and the
// modification; the fingerprints are then recomputed to match.
#include <fmt/format.h>

#include <array>
#include <cstring>

#include "app/figures/figure_folder.h"
#include "films/chunks/film_chunks.h"
#include "films/first_pass.h"
#include "fuzz/fuzz.h"
#include "runs/json.h"
#include "runs/sweep_summary.h"
#include "support/resources.h"
#include "util/archive.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"
#include "util/fingerprint.h"
#include "works/plan_folder.h"
#include "works/sweep_plan.h"

using namespace carom;
using test::FuzzInput;
namespace fs = std::filesystem;

namespace {

constexpr const char* scene_text =
    "title: T\nbox: {size: [20, 15], walls: {left: {temperature: 2}, right: {mass: 20, force: "
    "-2}}}\n"
    "gas: [{name: a, count: 5, radius: 0.3, speed: 1}, {name: b, count: 2, radius: 0.5}]\n"
    "run: {until: 4, events: [{at: 2, caption: words}]}\n"
    "film: {size: [64, 64], fps: 2, seconds: 4, panels: [speed-histogram, entropy]}\n";

Progress& silent() {
    static Progress progress(Progress::Form::silent, "");
    return progress;
}

// The plan of a film as it is read back; `room` decides whether its run is kept in memory.
FilmPlan planned(const Recording::Room& room) {
    const Scene scene = load_scene_text(scene_text, "scene.yaml", test::resources());
    return prepare(scene, {.output = "film.gif", .room = room}, silent());
}

FilmPlan& plan_in_memory() {
    static FilmPlan plan = planned({});
    return plan;
}

FilmPlan& plan_simulated_again() {
    static FilmPlan plan = planned({.memory = 0, .file = 0});
    return plan;
}

std::string checkpoint() {
    Archive archive;
    const FilmPlan& plan = plan_in_memory();
    Simulation simulation(plan.scene.gas, plan.scene.run);
    simulation.advance_to(1.0);
    simulation.archive(archive);
    return archive.finished();
}

void read_checkpoint(const std::string& bytes) {
    static const FilmPlan& plan = plan_in_memory();
    static const Simulation start(plan.scene.gas, plan.scene.run);
    Archive archive(bytes, "checkpoint");
    const Simulation read(start.box(), start.particles(), plan.scene.run, archive);
    archive.expect_end();
}

std::string shared() {
    FilmOptions options{.output = "film.gif"};
    return shared_bytes(plan_in_memory(), options);
}

void read_shared_part(const std::string& bytes) {
    FilmOptions options;
    read_shared(bytes, "film.plan", options);
}

std::string kept_run() { return run_bytes(plan_in_memory()); }
std::string simulated_run() { return run_bytes(plan_simulated_again()); }

void read_run_part(const std::string& bytes) {
    FilmPlan plan = plan_in_memory();
    read_run(plan, bytes, "0001.start");
}

// The folder of a plan with a single chunk, which has been rendered.
const fs::path& planned_folder() {
    static const fs::path folder = [] {
        const fs::path path = test::fuzz_folder() / "plan";
        plan_film(plan_in_memory().scene, {.output = "film.gif", .quality = Quality::draft},
                  {.chunks = 1}, path, false, silent());
        const PlanFolder plan(path);
        render_chunk(plan, plan.chunk(1), {}, silent());
        return path;
    }();
    return folder;
}

std::string file_of_plan(const char* name) { return test::contents(planned_folder() / name); }

std::string plan_json() { return file_of_plan("plan.json"); }
std::string manifest_json() { return file_of_plan("chunks/0001.json"); }

// A chunk consists of two archives, each preceded by its length: its identity, and the encoded
// segment.
constexpr std::size_t length_size = 8;

std::string with_length(const std::string& bytes) {
    std::string whole;
    for (std::size_t i = 0; i < length_size; ++i)
        whole += static_cast<char>(bytes.size() >> (8 * i) & 0xff);
    return whole + bytes;
}

std::size_t first_length(const std::string& chunk) {
    std::uint64_t length = 0;
    for (std::size_t i = length_size; i-- > 0;)
        length = length << 8 | static_cast<unsigned char>(chunk[i]);
    return length_size + length;
}

std::string segment() {
    const std::string whole = file_of_plan("chunks/0001.chunk");
    return whole.substr(first_length(whole) + length_size);
}

// Does the work while one file has other bytes, and restores the file afterwards.
template <class Work>
void with_file(const fs::path& path, const std::string& bytes, const Work& work) {
    static std::map<fs::path, std::string> originals;
    const std::string& original = originals.try_emplace(path, test::contents(path)).first->second;
    write_file(path, bytes);
    const bool was_read = test::succeeds(work);
    write_file(path, original);
    if (!was_read) throw UsageError("refused");
}

// All queries of a plan before its work begins.
void use_plan() {
    const PlanFolder plan(planned_folder());
    plan.missing();
    for (const PlannedChunk& its : plan.chunks()) plan.output(its);
    test::succeeds([&] { plan.require(PlanKind::film, "render"); });
    test::succeeds([&] { plan.require_all_done(false); });
    test::succeeds([&] { plan.require_same_build(Json::object()); });
    test::succeeds([&] { plan.read("film.plan"); });
    test::succeeds([&] { format_of_plan(plan); });
    test::succeeds([&] { scene_of_plan(plan); });
    test::succeeds([&] { PlannedSweep(plan, "run").scene_at(0); });
}

void read_plan_json(const std::string& text) {
    Json contents = json_in(text);
    if (contents.is_object()) {
        contents.erase("fingerprint");
        contents["fingerprint"] = fingerprint(text_of(contents));
    }
    with_file(planned_folder() / "plan.json", text_of(contents), use_plan);
}

void read_manifest_json(const std::string& text) {
    with_file(planned_folder() / "chunks/0001.json", text, use_plan);
}

void read_segment(const std::string& bytes) {
    const std::string whole = file_of_plan("chunks/0001.chunk");
    const std::string changed = whole.substr(0, first_length(whole)) + with_length(bytes);
    Json manifest = json_in(manifest_json());
    manifest["fingerprint"] = fingerprint(changed);
    with_file(planned_folder() / "chunks/0001.chunk", changed, [&] {
        with_file(planned_folder() / "chunks/0001.json", text_of(manifest), [] {
            join_film(PlanFolder(planned_folder()), {.output = test::fuzz_folder() / "film.gif"},
                      silent());
        });
    });
}

std::string figures_json() {
    return R"({"about": "x", "of": "set", "figures": {"a": {"inputs": "1", "caption": "c", "alt": "d",)"
           R"( "time": "0 to 1", "times": [1], "over": [0, 1]}},)"
           R"( "files": {"a.svg": {"figure": "a", "inputs": "1", "content": "2", "coming": "3"}}})";
}

void read_figures_json(const std::string& text) {
    const fs::path folder = test::fuzz_folder() / "figures";
    write_file(folder / "figures.json", text);
    FigureFolder figures(folder, "set");
    figures.is_current("a.svg", "1");
    figures.foreign(std::vector<std::string>{"a.svg"});
}

std::string summary_json() {
    const NumberStatistics its{.count = 2, .mean = 1.5};
    return text_of(SweepSummary{.carom = "1",
                                .build = {{"a", "b"}},
                                .scene = "scene.yaml",
                                .title = "T",
                                .overrides = {"a=1"},
                                .physics = "0",
                                .sweep = {{{"gas.0.radius", {"0.1", "0.2"}}}, {1, 2}},
                                .numbers = {{"pressure", quantities::pressure(2)}},
                                .points = {{2, {its}}, {2, {its}}}});
}

void read_summary_json(const std::string& text) {
    const SweepSummary summary = sweep_summary(text, "summary.json");
    for (std::int64_t point = 0; point < summary.sweep.points(); ++point)
        summary.sweep.changes_at(point);
    if (summary.sweep.runs() > 0) summary.sweep.seed_of(summary.sweep.runs() - 1);
    text_of(summary);
}

struct Stored {
    std::string (*write)();
    void (*read)(const std::string& bytes);
};

constexpr std::array kept_files{Stored{checkpoint, read_checkpoint},
                                Stored{shared, read_shared_part},
                                Stored{kept_run, read_run_part},
                                Stored{simulated_run, read_run_part},
                                Stored{segment, read_segment},
                                Stored{plan_json, read_plan_json},
                                Stored{manifest_json, read_manifest_json},
                                Stored{figures_json, read_figures_json},
                                Stored{summary_json, read_summary_json}};

const std::string& original(std::size_t which) {
    static std::array<std::string, kept_files.size()> texts;
    if (texts.at(which).empty()) texts.at(which) = kept_files.at(which).write();
    return texts.at(which);
}

// The header of an Archive before its content: a signature and a version, then the length and the
// fingerprint of the content.
constexpr std::size_t unsealed_size = 12, header_size = 52;

bool is_archive(const std::string& bytes) {
    return bytes.size() >= header_size && bytes.starts_with("carom\xff");
}

void seal(std::string& bytes) {
    const std::uint64_t length = bytes.size() - header_size;
    for (std::size_t i = 0; i < 8; ++i)
        bytes[unsealed_size + i] = static_cast<char>(length >> (8 * i) & 0xff);
    const std::string_view content = std::string_view(bytes).substr(header_size);
    bytes.replace(unsealed_size + 8, header_size - unsealed_size - 8, fingerprint(content));
}

// Modifies bytes from `begin` on: replaces a byte or a number of eight bytes, truncates, removes or
// repeats a stretch.
void change_bytes(std::string& bytes, std::size_t begin, FuzzInput& input) {
    static const std::array<std::uint64_t, 12> numbers{
        0,          1,          2,          255,   65'536, 1U << 31,
        1ULL << 40, 1ULL << 61, 1ULL << 63, ~0ULL, ~1ULL,  0x7ff8'0000'0000'0000};
    if (bytes.size() <= begin) return;
    const std::size_t at = begin + input.below(bytes.size() - begin), left = bytes.size() - at;
    switch (input.below(5)) {
        case 0:
            bytes[at] = static_cast<char>(input.byte());
            break;
        case 1: {
            const std::uint64_t number = input.one_of(numbers);
            std::memcpy(bytes.data() + at, &number, std::min(left, sizeof(number)));
            break;
        }
        case 2:
            bytes.resize(at);
            break;
        case 3:
            bytes.erase(at, input.below(32));
            break;
        default:
            bytes.insert(at, bytes.substr(at, input.below(64)));
    }
}

// Replaces or removes one value of a JSON text, at any depth.
void change_value(Json& json, FuzzInput& input) {
    static const std::array<const char*, 16> values{"null",
                                                    "0",
                                                    "-1",
                                                    "1e300",
                                                    "0.5",
                                                    "18446744073709551615",
                                                    "-9223372036854775808",
                                                    "[]",
                                                    "{}",
                                                    "\"\"",
                                                    "\"..\"",
                                                    "true",
                                                    "[[1]]",
                                                    "9007199254740992",
                                                    "\"2\"",
                                                    "[{}]"};
    if (json.is_structured() && !json.empty() && input.below(8) != 0) {
        auto child = json.begin();
        std::advance(child, input.below(json.size()));
        if (input.below(16) == 0)
            json.erase(child);
        else
            change_value(*child, input);
        return;
    }
    json = Json::parse(input.one_of(values));
}

std::string changed_json(const std::string& text, FuzzInput& input) {
    Json json = json_in(text);
    change_value(json, input);
    return text_of(json);
}

}  // namespace

void test::fuzz(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t most = 8;
    FuzzInput input(data, size);
    const std::size_t which = input.below(kept_files.size());
    const bool is_whole = input.is_at_end();
    std::string bytes = original(which);
    const bool seals = is_archive(bytes), is_json = bytes.starts_with('{');
    for (std::size_t k = 0; k < most && !input.is_at_end(); ++k)
        if (is_json && input.below(4) != 0)
            bytes = changed_json(bytes, input);
        else
            change_bytes(bytes, seals ? header_size : 0, input);
    if (seals && input.byte() != 1) seal(bytes);
    const bool was_read = test::succeeds([&] { kept_files.at(which).read(bytes); });
    if (is_whole && !was_read) std::abort();
}
