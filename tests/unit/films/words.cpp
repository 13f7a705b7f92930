// The words beside a film.
#include <doctest/doctest.h>

#include <algorithm>

#include "films/words/film_text.h"
#include "panels/recording.h"
#include "scene/describe.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

// Ten equal beads at rest but for one, which hands its speed on: every number is known.
Scene row_of_beads(const std::string& more) {
    return test::scene_from(
        "title: A row of beads\nsubtitle: One is fast\ndescription: Ten beads in a row.\n"
        "box: {length: 11}\ngas:\n"
        "  - {name: fast, radius: 0, position: [1], velocity: [1]}\n"
        "  - {name: still, radius: 0, position: [2, 3, 4, 5, 6, 7, 8, 9, 10]}\n" +
        more);
}

FilmText words_of_span(const Scene& scene, const FrameSpan& span, bool has_sound = false) {
    const Simulation start(scene.gas, scene.run);
    const std::vector<Tick> ticks = timeline(scene);
    FilmTextMaker maker(scene, span, ticks, start.particles(), {}, has_sound);
    const Recording run(start, ticks, {},
                        [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                            maker.see(tick, sample, advanced);
                        });
    return maker.text();
}

FilmText words_of(const Scene& scene) { return words_of_span(scene, {0, frame_count(scene.film)}); }

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("cues are WebVTT") {
    CHECK(webvtt({}) == "WEBVTT\n");
    CHECK(webvtt({{0.0, 1.5, "a < b & c --> d\n\ne\n"},
                  {2.0, 2.0, "no time"},
                  {3.0, 4.0, ""},
                  {3661.2345, 36000.0, "long"}}) ==
          "WEBVTT\n"
          "\n00:00:00.000 --> 00:00:01.500\na &lt; b &amp; c --&gt; d\ne\n"
          "\n01:01:01.235 --> 10:00:00.000\nlong\n");
}

TEST_CASE("what is heard has captions, again after a silence, and is no silent film") {
    // One bead of ten meets the next each second, up to time 8.5; the wall and back is beyond.
    const Scene scene = row_of_beads(
        "run: {until: 8.5, events: [{at: 4.5, pause: 4}]}\n"
        "film: {seconds: 24, fps: 10, sound: collisions}\n");
    const FilmText words = words_of_span(scene, {0, frame_count(scene.film)}, true);
    std::size_t captions = 0;
    for (std::size_t at = 0;
         (at = words.captions.find("[clicks: one for each", at)) != std::string::npos; ++at)
        ++captions;
    CHECK(captions == 2);
    CHECK(contains(words.transcript, "A film of 0:24 with sound.\n"));
    CHECK(contains(words.transcript, "Each collision is heard as a click, higher in pitch where"));
    CHECK(contains(words.descriptions, "Each collision is heard as a click"));
    CHECK(has_captions(scene));
    // The same film in a format without.
    CHECK(words_of(scene).captions.empty());
    CHECK(contains(words_of(scene).transcript, "A silent film of 0:24."));
}

TEST_CASE("a film without events has its words by quarters, with the numbers of the gas") {
    const Scene scene = row_of_beads("run: {until: 8.5}\nfilm: {seconds: 20, fps: 10}\n");
    const FilmText words = words_of(scene);
    CHECK(words.captions.empty());
    CHECK(contains(words.chapters, "00:00:00.000 --> 00:00:05.000\nThe start\n"));
    CHECK(contains(words.chapters, "\n00:00:15.000 --> 00:00:20.000\nTime "));
    CHECK(contains(
        words.descriptions,
        "A row of beads. One is fast. Ten beads in a row. The colour of "
        "a particle shows its speed. Shown with the particles: energy by species and phase space. "
        "Time 0 of 8.50, 0 collisions between particles "
        "so far. Mean speed 0.100, mean energy 0.0500 (fast 0.500 and still 0); 90 % "
        "slow, 0 % medium and 10 % fast.\n"));
    // After 8.5 the speed has gone through eight collisions to one of the others.
    CHECK(
        contains(words.descriptions,
                 "\nThe film ends. Time 8.50 of 8.50, 8 collisions between particles so far. Mean "
                 "speed 0.100, mean energy 0.0500 (fast 0 and still 0.0556);"));
    CHECK(contains(words.transcript, "A row of beads\nOne is fast\n\nA silent film of 0:20.\n"));
    CHECK(contains(words.transcript, "\n0:10  Time "));
    CHECK(contains(words.transcript, "\n0:18  The film ends. Time 8.50 of 8.50"));  // 2 s are held
}

TEST_CASE("captions and reversals are told when they come") {
    const Scene scene = row_of_beads(
        "run:\n  until: 9\n  events:\n    - {at: 0, caption: A bead & its speed, for: 4}\n"
        "    - {at: 4.5, reverse: velocities}\n    - {at: 5, caption: Back again}\n"
        "film: {seconds: 20, fps: 10}\n");
    const FilmText words = words_of(scene);
    CHECK(contains(words.captions, "00:00:00.000 --> 00:00:04.000\nA bead &amp; its speed\n\n"));
    CHECK(contains(words.captions, "--> 00:00:20.000\nBack again\n"));
    CHECK(contains(words.chapters, "\nA bead &amp; its speed\n"));
    CHECK(contains(words.chapters, "\nVelocities reversed\n"));
    CHECK(contains(words.chapters, "00:00:11.100 --> 00:00:15.000\nBack again\n"));
    CHECK(contains(words.transcript, "All velocities are reversed. Time 4.50, 4 collisions"));
    CHECK(contains(words.transcript, "“Back again” Time 3.97"));
    // Of a part, times count from its first frame.
    const FilmText part = words_of_span(scene, {20, 60});
    CHECK(contains(part.captions, "00:00:00.000 --> 00:00:02.000\nA bead"));
    CHECK(contains(part.transcript, "A silent film of 0:04."));
}

TEST_CASE("nudges are told when they come, and in descriptions made from the scene") {
    const std::string run =
        "run:\n  until: 9\n  precision: 256\n  events:\n    - {at: 4.5, reverse: velocities}\n"
        "    - {at: 4.5, nudge: {particle: 0, by: 3e-40}}\n    - {at: 8, nudge: {particle: 2, by: "
        "-0.001}}\nfilm: {seconds: 20, fps: 10}\n";
    const Scene scene = row_of_beads(run);
    const FilmText words = words_of(scene);
    CHECK(contains(words.transcript,
                   "All velocities are reversed. Particle 0 is moved by 3.00×10⁻⁴⁰. Time 4.50, "));
    CHECK(contains(words.transcript, "Particle 2 is moved by 0.00100. Time "));
    CHECK(contains(words.chapters, "\nVelocities reversed\n"));
    CHECK(contains(words.chapters, "\nParticle 2 is moved by 0.00100\n"));
    CHECK(contains(words.descriptions, "Particle 0 is moved by 3.00×10⁻⁴⁰. "));
    // Not where the film is over before, or begins after it.
    const int frames = static_cast<int>(timeline(scene).size());
    CHECK_FALSE(contains(words_of_span(scene, {0, 60}).transcript, "is moved"));
    CHECK_FALSE(contains(words_of_span(scene, {frames - 5, frames}).transcript, "is moved"));
    CHECK(words_of_events({Language::english}, scene.run, scene.gas) ==
          "At time 4.5 all velocities are reversed. Particle 0 is moved by 3.00×10⁻⁴⁰ at time "
          "4.5. Particle 2 is moved by 0.00100 at time 8.");
    Run many;
    CHECK(words_of_events({Language::english}, many, scene.gas).empty());
    for (int k = 1; k <= 4; ++k) many.events.push_back({double(k), Perturbation{0, {"0.1", "0"}}});
    CHECK(words_of_events({Language::english}, many, scene.gas) ==
          "A particle is moved by a small amount 4 times.");
}

TEST_CASE("cards and marks are told too") {
    const FilmText words = words_of(row_of_beads(
        "run: {until: 9, events: [{at: 3, mark: Where they were}]}\n"
        "film: {seconds: 30, fps: 10, title_card: true, end_card: Who has the speed now!}\n"));
    CHECK(contains(words.chapters, "00:00:00.000 --> 00:00:03.000\nA row of beads\n"));
    CHECK(contains(words.chapters, "\nWhere they were\n"));
    CHECK(contains(words.chapters, "00:00:26.000 --> 00:00:30.000\nWho has the speed now!\n"));
    CHECK(contains(words.captions, "00:00:26.000 --> 00:00:30.000\nWho has the speed now!\n"));
    CHECK(
        contains(words.transcript,
                 "The positions of all particles stay visible as outlines: “Where they were”. Time "
                 "3.0"));
    CHECK(contains(words.transcript, "\n0:26  The closing sentence: “Who has the speed now!”.\n"));
}

TEST_CASE("a pause is a cue for who speaks") {
    const Scene scene =
        row_of_beads("run: {until: 8.5, events: [{at: 4, pause: 3}]}\nfilm: {pace: 1, fps: 10}\n");
    CHECK(scene.film.seconds == doctest::Approx(11.5));
    const FilmText words = words_of(scene);
    CHECK(contains(words.chapters, "The film pauses for 3 seconds"));
    CHECK(contains(words.transcript, "The film pauses for 3 seconds. "));
}

TEST_CASE("a panel that comes in is told, and begins no chapter") {
    const Scene scene = row_of_beads(
        "run: {until: 8.5}\nfilm: {seconds: 20, fps: 10, panels: [{kind: temperature, show: "
        "{from: 3, until: 6}}]}\n");
    const FilmText words = words_of(scene);
    CHECK(contains(words.transcript, "The panel “temperature” appears. Time 3"));
    CHECK(contains(words.transcript, "The panel “temperature” disappears. Time 6"));
    CHECK(contains(words.descriptions, "The panel “temperature” appears."));
    CHECK(!contains(words.chapters, "panel"));
    CHECK(!contains(words.chapters, "Time 3"));
}

TEST_CASE("what the film points out is told") {
    const Scene scene = row_of_beads(
        "run: {until: 8.5}\nfilm: {seconds: 20, fps: 10, panels: [temperature], spotlight: [{from: "
        "2, to: 4, of: fast}], callouts: [{at: 5, points_to: 0, text: it rests}, {at: 6, "
        "points_to: {panel: "
        "temperature, x: 3}, text: constant}], camera: [{at: 2.5, view: [1, 4]}, {at: 7, view: "
        "box}]}\n");
    const std::string words = words_of(scene).transcript;
    CHECK(contains(words, "All particles are dimmed except: fast. "));
    CHECK(contains(words, "All particles have their full colours again. "));
    CHECK(contains(words, "Particle 0: “it rests”. "));
    CHECK(contains(words, "“temperature”: “constant”. "));
    CHECK(contains(words, "The camera shows a part of the wire, x = 1 to 4. "));
    CHECK(contains(words, "The camera shows the whole box. "));
}

TEST_CASE("spotlights that overlap are told together, whenever what they light changes") {
    const std::string words =
        words_of(row_of_beads("run: {until: 8.5}\nfilm: {seconds: 20, fps: 10, spotlight: [{from: "
                              "1, to: 5, of: fast}, {from: 3, to: 7, of: [5, 6]}]}\n"))
            .transcript;
    CHECK(contains(words, "All particles are dimmed except: fast. Time 1"));
    CHECK(contains(words,
                   "All particles are dimmed except: fast, particle 5 and particle 6. Time 3"));
    CHECK(contains(words, "All particles are dimmed except: particle 5 and particle 6. Time 5"));
    CHECK(contains(words, "All particles have their full colours again. Time 7"));
    CHECK(!contains(words, "again. Time 5"));
}

TEST_CASE("a part of a film tells of what is seen in it") {
    const Scene scene = row_of_beads(
        "run: {until: 8.5}\nfilm: {seconds: 20, fps: 10, panels: [{kind: temperature, show: "
        "{from: 1}}], spotlight: [{from: 1, to: 2, of: fast}, {from: 3, of: still}], "
        "callouts: [{at: 1, for: 1, points_to: 0, text: over}], camera: [{at: 1, view: [1, 4]}, "
        "{at: 2, "
        "view: [2, 5]}]}\n");
    const auto ticks = timeline(scene);
    const std::string words =
        words_of_span(scene, frames_between(scene.film, ticks, 5.0, {})).transcript;
    for (const char* past : {"dimmed but: fast", "again", "over", "x = 1 to 4", "appears"}) {
        CAPTURE(past);
        CHECK(!contains(words, past));
    }
    CHECK(contains(words, "All particles are dimmed except: still. "));
    CHECK(contains(words, "x = 2 to 5. "));
}

TEST_CASE("nothing is told after the end") {
    // Half of the film stands still at its end, where quarters would be told.
    const Scene scene = row_of_beads("run: {until: 8.5}\nfilm: {seconds: 20, fps: 10}\n");
    const auto ticks = timeline(scene);
    const int stop = static_cast<int>(std::ranges::find(ticks, 8.5, &Tick::time) - ticks.begin());
    const std::string words = words_of_span(scene, {stop - 5, stop + 20}).transcript;
    const std::size_t end = words.find("The film ends.");
    REQUIRE(end != std::string::npos);
    CHECK(words.find("\n0:", end) == std::string::npos);
}

TEST_CASE("a pause that is shortened is told as long as it is") {
    Scene scene = row_of_beads(
        "run: {until: 8.5, events: [{at: 4, pause: 5}]}\nfilm: {seconds: 12, fps: 10}\n");
    scene.film.seconds = 6.5;  // as the command line may set it
    REQUIRE(most_pause_seconds(scene.film) == 3.25);
    CHECK(contains(words_of(scene).transcript, "The film pauses for 3.2 seconds. "));
}
