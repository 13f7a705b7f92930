// A film's plan: written, read back, and drawn from in another process as here.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "app/film/render.h"
#include "scene/load.h"
#include "support/process.h"
#include "support/scene_text.h"
#include "util/diagnostics.h"

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
        "{at: 1, mark: here}, {at: 2, caption: words}]}\n"
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
        "{name: b, count: 3, radius: 0, speed: 1}]\nrun: {until: 8}\n"
        "film: {" +
        std::string(small) +
        "flashes: true, panels: [{kind: collision-map}, {kind: contact-time}, "
        "{kind: single-collision}]}\n");
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

// Joined of segments that are drawn one by one.
void draw_one_by_one(const FilmPlan& plan, const fs::path& path) {
    const auto writer = film_writer(plan, {.output = path, .quality = Quality::draft});
    if (!plan.colors.empty()) writer->use_colors(plan.colors);
    for (std::size_t k = 0; k + 1 < plan.segments.size(); ++k) draw(plan, k, *writer)->join();
    writer->commit();
}

std::string refusal_of(const fs::path& path) {
    try {
        read_plan(path);
    } catch (const SystemError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a film drawn from a plan that was read back is the film itself, byte for byte") {
    const TemporaryFolder folder;
    for (const Scene& scene : {plane(), wire(), two_runs()})
        for (const std::string format : {"mp4", "gif"}) {
            CAPTURE(format);
            const fs::path direct = folder.path() / ("direct." + format);
            const fs::path again = folder.path() / ("again." + format);
            const RenderReport report = render(
                scene, {.output = direct, .quality = Quality::draft, .threads = 2}, silent());
            FilmPlan plan = prepare(scene, {.output = again, .text = true}, silent());
            CHECK(plan.passes.size() == 1);
            CHECK(plan.beside.has_value() == scene.film.beside.has_value());
            write_plan(plan, folder.path() / "film.plan");
            const FilmPlan read = read_plan(folder.path() / "film.plan");
            CHECK(read.text.transcript == plan.text.transcript);
            CHECK(read.run.is_kept());
            draw_one_by_one(read, again);
            CHECK(report.frames == read.frames());
            CHECK(contents(again) == contents(direct));
        }
}

TEST_CASE("a run that is too large for memory is simulated again, to the same pictures") {
    const Scene scene = plane();
    FilmPlan plan = prepare(scene, {}, silent());
    Simulation start(scene.gas, scene.run);
    const Recording small_memory(
        start, plan.run.ticks(), {true}, [](const Tick&, const Sample&, const AdvanceResult&) {},
        10'000);
    CHECK_FALSE(small_memory.is_kept());
    const OutputFormat& png = output_format("png");
    const std::vector<std::uint8_t> kept = draw_still(plan, 4.0, png, silent()).file();
    plan.run = small_memory;
    CHECK(draw_still(plan, 4.0, png, silent()).file() == kept);
    const TemporaryFolder folder;
    write_plan(plan, folder.path() / "film.plan");
    const FilmPlan read = read_plan(folder.path() / "film.plan");
    CHECK_FALSE(read.run.is_kept());
    CHECK(draw_still(read, 4.0, png, silent()).file() == kept);
}

TEST_CASE("a damaged plan is refused") {
    const TemporaryFolder folder;
    FilmPlan plan = prepare(plane(), {}, silent());
    const fs::path path = folder.path() / "film.plan";
    write_plan(plan, path);
    const std::string whole = contents(path);
    folder.write("film.plan", whole.substr(0, whole.size() / 2));
    CHECK(refusal_of(path).find("cut short") != std::string::npos);
    std::string changed = whole;
    changed[whole.size() / 2] ^= 1;
    folder.write("film.plan", changed);
    CHECK(refusal_of(path) ==
          "cannot read " + path.string() + ": its content was changed after it was written");
    folder.write("film.plan", "title: T\n");
    CHECK(refusal_of(path).find("not written by carom") != std::string::npos);
}
