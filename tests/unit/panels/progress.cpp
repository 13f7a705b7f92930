// A film that is drawn in parts: what its panels have gathered before a frame, written there and
// read by others, gives the frames from there on as if these had seen all of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "panels/recording.h"
#include "panels/registry.h"
#include "support/library.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/share_of_cases.h"
#include "support/shot.h"
#include "support/test_root.h"
#include "util/diagnostics.h"

using namespace carom;
namespace fs = std::filesystem;

namespace {

using Picture = std::vector<std::uint32_t>;

std::string progress_of(PanelSet& panels) {
    Archive archive;
    panels.archive_progress(archive);
    return archive.finished();
}

// A film as its whole second pass gives it, and what a part needs that begins at one of its frames.
struct WholeFilm {
    test::SurveyedFilm film;
    std::unique_ptr<PanelSet> panels = film.read_panels();
    FramePainter painter{*panels};
    std::vector<FrameData> frames = {};
    std::vector<std::string> progress = {};  // before each frame, and after the last

    explicit WholeFilm(const Scene& scene, const Recording::Room& room = {}) : film(scene, room) {
        RunsPlayer player(film.runs);
        while (player.shown() < size()) {
            player.next();
            progress.push_back(progress_of(*panels));
            frames.push_back(panels->frame_data(player.tick(), player.frames()));
        }
        progress.push_back(progress_of(*panels));
    }
    std::size_t size() const { return film.runs.front().ticks().size(); }
    Picture picture(std::size_t frame) { return test::pixels_of(painter.paint(frames[frame])); }
};

std::vector<Recording> parts_of(const std::vector<Recording>& runs, std::size_t first,
                                std::size_t end) {
    std::vector<Recording> parts;
    for (const Recording& run : runs) parts.push_back(run.part(first, end));
    return parts;
}

// The frames of a part, as panels give them that have seen no frame before.
struct Part {
    const WholeFilm& whole;
    std::vector<Recording> runs;
    std::unique_ptr<PanelSet> panels;
    RunsPlayer player{runs};

    Part(const WholeFilm& of, std::vector<Recording> its, std::size_t first)
        : whole(of), runs(std::move(its)), panels(of.film.read_panels()) {
        Archive read(whole.progress[first], "progress");
        panels->archive_progress(read);
        read.expect_end();
    }
    Part(const WholeFilm& of, std::size_t first, std::size_t end)
        : Part(of, parts_of(of.film.runs, first, end), first) {}
    Part(const Part&) = delete;  // its panels refer to its recording
    Part& operator=(const Part&) = delete;

    FrameData next() {
        player.next();
        return panels->frame_data(player.tick(), player.frames());
    }
};

// Whether the frames of a part are those of the whole film, and leave the same in the panels.
void check_frames(WholeFilm& whole, Part& part, std::size_t first, std::size_t end) {
    CAPTURE(first);
    REQUIRE((progress_of(*part.panels) == whole.progress[first]));
    REQUIRE(part.runs.front().ticks().size() == end - first);
    constexpr std::size_t drawn = 2;
    for (std::size_t i = first; i < end; ++i) {
        const FrameData frame = part.next();
        CHECK(frame.tick.frame == static_cast<int>(i));
        CHECK(frame.bytes == whole.frames[i].bytes);
        CHECK((progress_of(*part.panels) == whole.progress[i + 1]));
        if (i >= first + drawn && i + 1 < end) continue;
        CHECK((test::pixels_of(whole.painter.paint(frame)) == whole.picture(i)));
        if (i == first)
            CHECK((test::pixels_of(FramePainter(*part.panels).paint(frame)) == whole.picture(i)));
    }
}

std::string film(const std::string& keys) {
    return "film: {template: data, size: [320, 180], fps: 10, seconds: 2.5, " + keys + "}\n";
}

std::string plane(const std::string& keys, const std::string& events = "",
                  const std::string& more = "") {
    return "title: T\nbox: {size: [20, 15]}\n" + more +
           "gas:\n  - {name: light, count: 24, radius: 0.4, speed: 1}\n"
           "  - {name: heavy, count: 1, radius: 1, mass: 9, velocity: [0.9, 0.4], position: "
           "[5, 6]}\nrun: {until: 6, events: [" +
           events + "]}\n" + film(keys);
}

std::string wire(const std::string& keys, const std::string& box = "{length: 12}",
                 const std::string& motion = "temperature: 1") {
    return "title: T\nbox: " + box + "\ngas: [{name: a, count: 4, radius: 0.1, mass: 2, " + motion +
           "}, {name: b, count: 4, radius: 0, speed: 1}]\nrun: {until: 6, events: [{at: 1, mark: "
           "here}, {at: 3, "
           "reverse: velocities}]}\n" +
           film(keys);
}

std::string piston(const std::string& keys) {
    return "title: T\nbox: {size: [10, 14], walls: {top: {mass: 20, force: -3}}}\n"
           "gas: [{name: a, count: 20, radius: 0.05, temperature: {exact: 2}}]\n"
           "run: {until: 8}\n" +
           film(keys);
}

// All kinds of panel, and all that pictures of the gas gather on their way.
std::vector<std::string> all_kinds() {
    const std::string divided = "partitions: [{name: divider, x: 10, gaps: [[5, 9]]}]\n";
    return {
        plane("panels: [{kind: speed-histogram, over: start}, {kind: energy-histogram, over: "
              "{window: 2}, of: [light, heavy]}, {kind: velocity-histogram, range: [-1, 1], bins: "
              "9}, position-histogram], trails: {of: [heavy, 3], seconds: 1}, velocities: true"),
        plane("panels: [temperature, energy-by-species, speed-classes, entropy], title_card: 0.5, "
              "field: {of: concentration, species: light, cells: 5, over: 2}",
              "{at: 1, mark: here}, {at: 2, pause: 0.5}, {at: 4, mark: there}"),
        plane("panels: [{kind: pressure, surfaces: divider}, {kind: pressure, gauge: "
              "true}, thermometer, stopwatch], field: {of: flow, cells: 4, over: 20}, end_card: "
              "The end, flashes: "
              "true",
              "", divided),
        plane("panels: [{kind: counter, surfaces: left}, {kind: counter, line: {x: 9}}, {kind: "
              "profile, quantity: temperature, cells: 6}, {kind: positions, of: [0, 1]}], slow: "
              "[{from: 1, to: 3, factor: 0.4}], streaks: true"),
        plane("panels: [sides, {kind: flux, surfaces: divider}, monitors, {kind: text, words: "
              "Words}], spotlight: [{from: 0.5, of: 0}], callouts: [{at: 0.5, points_to: 1, text: "
              "this "
              "one, for: 9}], camera: [{at: 1, follow: 1, width: 5}]",
              "", divided),
        plane("panels: [mean-squared-displacement, velocity-autocorrelation, pair-correlation, "
              "free-path]"),
        plane("panels: [{kind: free-time, over: {window: 2}}, orientational-order, {kind: phase, "
              "of: [heavy]}, {kind: pair-correlation, over: {window: 1}}]"),
        plane("panels: [{kind: mean-squared-displacement, origins: all}, {kind: free-path, of: "
              "[light, heavy]}, {kind: pair-correlation, over: now}, {kind: profile, over: now}]"),
        plane("panels: [speed-histogram, temperature, {kind: profile, over: start}, free-path], "
              "beside: {own_label: A, label: B, set: "
              "gas.0.speed=2}",
              "{at: 2, pause: 0.5}"),
        plane(
            "panels: [run-distance, {kind: profile, around: [8, 7], cells: 4, mark_front: true}], "
            "fade_out: {within: [0, 0, 10, 5], seconds: 1}, trails: {of: 0, seeds: 1}, "
            "beside: {own_label: A, label: B, set: gas.0.speed=2, overlaid: true}"),
        wire("panels: [collision-map, contact-time, "
             "single-collision, return-distance]"),
        wire("panels: [{kind: phase, of: [0, 1]}, return-distance], flashes: true, camera: [{at: "
             "1, follow: 1, width: 5}], field: {of: density, cells: 5, over: 1}",
             "{length: 12, walls: periodic}", "velocity: 9"),
        wire("panels: [piston, energy-account, mean-free-path, {kind: particle-speed, of: 0}]",
             "{length: 12, walls: {right: {velocity: -0.2}}}"),
        piston("panels: [piston, piston-histogram, pressure-volume, halves]"),
    };
}

// As another process would have it.
Recording written_and_read(Recording recording, const Scene& scene, const Particles& particles) {
    Archive written;
    recording.archive(written, scene.gas.box, particles, scene.run);
    Archive read(written.finished(), "part");
    Recording again;
    again.archive(read, scene.gas.box, particles, scene.run);
    read.expect_end();
    return again;
}

// The second pass of a run that is too large for memory: parts of it in order, from one simulation.
void check_parts_of_long_run(const Scene& scene) {
    WholeFilm whole(scene, {.memory = 0, .file = 0});
    const test::SurveyedFilm& its = whole.film;
    REQUIRE_FALSE(its.runs.front().is_kept());
    RunsPlayer player(its.runs);
    const std::vector<const Scene*> scenes = scenes_of_film(its.scene);
    for (std::size_t first = 0; first < whole.size(); ++first) {
        const std::size_t end = std::min(first + 2, whole.size());
        std::vector<Recording> rest = player.rest(end);
        for (std::size_t run = 0; run < rest.size(); ++run)
            rest[run] =
                written_and_read(std::move(rest[run]), *scenes[run], its.starts[run].particles);
        Part part(whole, std::move(rest), first);
        CHECK_FALSE(part.runs.front().is_kept());
        check_frames(whole, part, first, end);
        player.next();
    }
}

}  // namespace

TEST_CASE("panels of every kind go on from any frame as if they had seen all before") {
    std::set<std::string> seen;
    for (const std::string& text : all_kinds()) {
        CAPTURE(text);
        const Scene scene = test::scene_from(text);
        for (const PanelSpec& spec : scene.film.panels) seen.insert(spec.kind);
        WholeFilm whole(scene);
        for (std::size_t first = 0; first < whole.size(); ++first) {
            const std::size_t end = std::min(first + 2, whole.size());
            Part part(whole, first, end);
            check_frames(whole, part, first, end);
        }
        check_parts_of_long_run(scene);
    }
    for (const PanelKind& kind : panel_kinds())
        if (kind.in_films_instead.empty()) {
            CAPTURE(kind.name);
            CHECK(seen.contains(kind.name));
        }
}

TEST_CASE("a first pass has positions only where panels ask for them, and fixes the same") {
    // What looks at velocities alone.
    const std::string drawn =
        "], trails: {of: [heavy], seconds: 1}, velocities: true, monitors: [time, mean-speed]";
    const std::string of_velocities = plane(
        "panels: [speed-histogram, {kind: velocity-histogram, of: heavy}, temperature" + drawn,
        "{at: 1, reverse: velocities}, {at: 2, pause: 0.5}");
    std::vector<std::string> texts = all_kinds();
    texts.push_back(of_velocities);
    texts.push_back(plane("panels: [energy-histogram, energy-by-species, speed-classes" + drawn));
    // Each of what looks at positions, alone.
    for (const std::string keys :
         {"speed-histogram], field: {of: concentration, species: light, cells: 5, over: 2}",
          "speed-histogram], callouts: [{at: 0.5, points_to: 1, text: this one, for: 9}]",
          "speed-histogram], camera: [{at: 1, follow: 1, width: 5}]", "position-histogram]",
          "mean-squared-displacement]", "{kind: profile, quantity: density}]"})
        texts.push_back(plane("panels: [" + keys));
    for (const std::string& text : texts) {
        const Scene scene = test::scene_from(text);
        CAPTURE(text);
        const test::SurveyedFilm recorded(scene);
        for (const std::size_t whole : {1U, 8U}) {
            PanelSet panels(recorded.scene, recorded.starts);
            int without = 0;
            std::size_t run = 0;
            for (const Scene* one : scenes_of_film(scene)) {
                const Recording frames = panels.record(
                    run++, start_scene(*one).simulation, timeline(recorded.scene),
                    [&](const Tick& tick, const Sample& sample, const AdvanceResult&) {
                        if (sample.position.size() > 0) return;
                        CHECK(tick.frame >= static_cast<int>(whole));
                        ++without;
                    },
                    {.frames = whole});
                CHECK(frames.ticks().size() == whole);
                CHECK(frames.is_kept());
            }
            panels.fix_axes();
            Archive written;
            panels.archive(written);
            CHECK((written.finished() == recorded.axes));
            if (text == of_velocities) CHECK(without > 15);
        }
    }
}

namespace {

// Of two seconds, and of few particles where it would take long.
Scene short_film(const fs::path& path) {
    Overrides overrides = test::fewer_particles(path);
    overrides.insert(overrides.end(), {"film.size=[320, 180]", "film.fps=10", "film.seconds=2"});
    return load_scene(path, test::resources(), overrides);
}

// The second frame, one in the middle and the last; and of what is no motion the second frame each.
std::vector<std::size_t> starts_of_parts(const std::vector<Tick>& ticks) {
    std::set<std::size_t> starts{1, ticks.size() / 2, ticks.size() - 1};
    for (std::size_t i = 2; i < ticks.size(); ++i)
        if (ticks[i].phase != Phase::moving && ticks[i - 1].phase == ticks[i].phase &&
            ticks[i - 2].phase != ticks[i].phase)
            starts.insert(i);
    return {starts.begin(), starts.end()};
}

}  // namespace

TEST_CASE("the film of every scene can be drawn from a frame on, to its end") {
    const std::vector<fs::path> files = test::library_files();
    CHECK(files.size() > 40);
    const auto share = static_cast<std::size_t>(test::every_nth(1, 8));
    for (std::size_t k = 0; k < files.size(); k += share) {
        const fs::path& path = files[k];
        CAPTURE(path.string());
        WholeFilm whole(short_film(path));
        for (const std::size_t first : starts_of_parts(whole.film.runs.front().ticks())) {
            Part part(whole, first, whole.size());
            check_frames(whole, part, first, whole.size());
        }
    }
}
