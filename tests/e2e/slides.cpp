// carom render --slides: a folder with a page of slides, read by a browser and by ffprobe, and what
// becomes of folders that hold something else.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "e2e/in_browser.h"
#include "e2e/interrupted.h"
#include "support/hostile_words.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string two_kinds = R"(title: Two kinds & <one> "box"
description: Watch the heavy ones slow down.
box: {size: [20, 15]}
gas:
  - {name: light, count: 20, radius: 0.4, speed: 2}
  - {name: heavy, count: 5, radius: 0.8, mass: 9}
run: {until: 4, events: [{at: 1, caption: The first words}, {at: 3, caption: The last words}]}
film: {seconds: 16, fps: 5, size: [640, 360], theme: light, panels: []}
)";

const std::string ring = R"(title: כדורים בתיבה
box: {size: [15, 20]}
gas: [{name: argon, count: 9, radius: 0.4, speed: 2}]
run: {until: 2}
film: {seconds: 8, fps: 5, template: portrait, size: [360, 640], language: de, panels: []}
)";

Outcome slides(const TemporaryFolder& folder, const std::vector<std::string>& words) {
    std::vector<std::string> command{program, "render"};
    command.insert(command.end(), words.begin(), words.end());
    return run(command, folder.path());
}

void write_scenes(const TemporaryFolder& folder) {
    folder.write("two.yaml", two_kinds);
    folder.write("ring.yaml", ring);
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

const std::set<std::string> page_files{"index.html", "reveal-license.txt", "reveal-notes.js",
                                       "reveal.css", "reveal.js",          "slides.json"};

std::set<std::string> with(std::set<std::string> names, const std::set<std::string>& more) {
    names.insert(more.begin(), more.end());
    return names;
}

// What must hold on every page of slides.
void check_slides(const json& answer) {
    check_sound(answer);
    CHECK(answer["before"] == true);
    CHECK(answer["drawn"]["bare"] == true);
    CHECK(answer["drawn"]["inside"] == true);
    for (const char* playing : {"clicked", "spaced", "entered"}) {
        CAPTURE(playing);
        CHECK(answer[playing] == true);
    }
    for (const char* standing : {"clickedAgain", "stopped", "buttonStopped"}) {
        CAPTURE(standing);
        CHECK(answer[standing] == true);
    }
    CHECK(answer["rewound"].get<double>() < 0.05);
    CHECK(answer["kept"] == 0);
    CHECK(answer["speaker"]["bad"] == json::array());
}

}  // namespace

TEST_CASE("each scene gets a slide, whose film starts at a click and stops when it is left") {
    const TemporaryFolder folder;
    write_scenes(folder);
    const Outcome outcome = slides(folder, {"two.yaml", "ring.yaml", "--slides", "talk"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.out.starts_with("talk/two.mp4: 80 frames, 0:16, "));
    CHECK(outcome.out.ends_with("\ntalk/index.html: 2 slides\n"));
    const fs::path talk = folder.path() / "talk";
    CHECK(names_in(talk) == with(page_files, {"two.mp4", "two.png", "ring.mp4", "ring.png"}));
    const std::string page = contents(talk / "index.html");
    for (const char* none : {"http:", "https:", "{{"}) CHECK(!has(page, none));
    if (!can_browse()) return;
    const json answer = browsed("slides", talk / "index.html");
    check_slides(answer);
    REQUIRE(answer["slides"].size() == 2);
    CHECK(answer["language"] == "en");
    CHECK(answer["title"] == "Two kinds & <one> \"box\"");
    CHECK(answer["titleNow"] == "כדורים בתיבה");
    const json &first = answer["slides"][0], &second = answer["slides"][1];
    CHECK(first["heading"] == "Two kinds & <one> \"box\"");
    CHECK(first["label"] == "Film: Two kinds & <one> \"box\"");
    CHECK(has(first["about"], "A silent film of 0:16."));
    CHECK(first["tracks"] == json{"captions", "descriptions", "chapters"});
    CHECK(has(first["notes"], "Watch the heavy ones slow down."));
    CHECK(has(first["notes"], "The last words"));
    CHECK(first["background"] == "#ffffff");
    CHECK(second["background"] != "#ffffff");  // dark
    CHECK(first["ink"] != second["ink"]);
    CHECK(second["language"] == "de");
    CHECK(second["direction"] == "rtl");
    CHECK(second["play"] == "Film starten");
    CHECK(answer["poster"] == 640);
    CHECK(answer["captions"]["mode"] == "showing");
    CHECK(answer["captions"]["after"] == "disabled");
    CHECK(answer["captions"]["stood"] == true);
    CHECK(answer["captions"]["cues"] == json{"The first words", "The last words"});
    CHECK(answer["drawn"]["share"].get<double>() > 0.6);
    CHECK(answer["playsAgain"] == true);
    CHECK(answer["at"] == 1);
    CHECK(answer["left"] == true);   // stopped
    CHECK(answer["waits"] == true);  // the next one
    CHECK(answer["presented"] == true);
    CHECK(answer["stays"] == 1);
    CHECK(answer["back"] == 0);
    CHECK(answer["leftByPresenter"] == true);
    CHECK(answer["turned"] == 1);
    CHECK(has(answer["speaker"]["notes"], "כדורים בתיבה"));
}

TEST_CASE("a single slide, as WebM with sound and with the words of the film beside it") {
    const TemporaryFolder folder;
    write_scenes(folder);
    const Outcome outcome = slides(folder, {"--slides", "two.yaml", "--format", "webm", "--words",
                                            "--set", "film.sound=collisions", "--size", "480x270",
                                            "--language", "fr", "--theme", "dark"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const fs::path talk = folder.path() / "out/slides";
    CHECK(names_in(talk) ==
          with(page_files, {"two.webm", "two.png", "two.captions.vtt", "two.chapters.vtt",
                            "two.descriptions.vtt", "two.transcript.txt"}));
    CHECK(has(contents(talk / "two.captions.vtt"), "The first words"));
    if (!can_browse()) return;
    const json answer = browsed("slides", talk / "index.html");
    check_slides(answer);
    CHECK(answer["language"] == "fr");
    CHECK(answer["words"] == "Lire le film");
    CHECK(answer["poster"] == 480);
    CHECK(answer["slides"][0]["background"] != "#ffffff");
}

TEST_CASE("words of strangers are words on slides, and never code") {
    const TemporaryFolder folder;
    json hostile = {
        {"title", "<script>window.changed = 1</script> \"'><img src=x onerror=alert(1)>"},
        {"description", all_hostile_words()},
        {"box", {{"size", {20, 15}}}},
        {"gas", json::array({{{"name", "\" onload=\"alert(3)"}, {"count", 3}, {"radius", 0.5}}})},
        {"run", {{"until", 2}, {"events", json::array()}}},
        {"film", {{"seconds", 12}, {"fps", 5}, {"size", {320, 180}}, {"panels", json::array()}}}};
    hostile["run"]["events"].push_back(
        {{"at", 1}, {"caption", "</aside><b onclick=alert(4)>b</b><script>alert(5)</script>"}});
    const std::string name = "javascript:alert(1) <b> \"x\" ' & % # ?";
    folder.write(name + ".yaml", hostile.dump());
    const Outcome outcome = slides(folder, {name + ".yaml", "--slides", "a talk/"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(fs::exists(folder.path() / "a talk" / (name + ".mp4")));
    if (!can_browse()) return;
    const json answer = browsed("slides", folder.path() / "a talk/index.html");
    check_slides(answer);
    CHECK(answer["slides"][0]["heading"] == hostile["title"]);
    CHECK(answer["poster"] == 320);
}

TEST_CASE("slides are made again as a whole, and nothing of others is touched") {
    const TemporaryFolder folder;
    write_scenes(folder);
    const fs::path talk = folder.path() / "talk";
    REQUIRE(slides(folder, {"two.yaml", "ring.yaml", "--slides", "talk"}).exit_code == 0);
    const std::string earlier = contents(talk / "two.mp4");
    folder.write("talk/mine.png", "mine");
    Outcome outcome = slides(folder, {"two.yaml", "--slides", "talk", "--seed", "3"});
    CHECK(outcome.out.ends_with("talk/index.html: 1 slide, 2 files of other slides removed\n"));
    CHECK(names_in(talk) == with(page_files, {"two.mp4", "two.png", "mine.png"}));
    CHECK(contents(talk / "two.mp4") != earlier);
    // A page that its user has changed.
    folder.write("talk/index.html", "mine");
    outcome = slides(folder, {"two.yaml", "--slides", "talk"});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err ==
          "carom: --slides talk: carom did not write index.html as it is now; nothing has been "
          "written. Name another folder, or replace it with --force\n");
    CHECK(contents(talk / "index.html") == "mine");
    outcome = slides(folder, {"two.yaml", "--slides", "talk", "--force"});
    CHECK(outcome.exit_code == 0);
    CHECK(has(outcome.err, "replaced index.html"));
    CHECK(has(contents(talk / "index.html"), "reveal.js"));
    CHECK(contents(talk / "mine.png") == "mine");
    // Folders of others.
    folder.write("notes/todo.txt", "mine");
    outcome = slides(folder, {"two.yaml", "--slides", "notes", "--force"});
    CHECK(outcome.exit_code == 2);
    CHECK(has(outcome.err, "notes: this folder holds files and is none of slides; name a new one"));
    CHECK(names_in(folder.path() / "notes") == std::set<std::string>{"todo.txt"});
    CHECK(has(slides(folder, {"two.yaml", "--slides", "notes/todo.txt"}).err, "notes/todo.txt"));
}

TEST_CASE("a folder of slides is there whole or not at all") {
    const TemporaryFolder folder;
    write_scenes(folder);
    folder.write("bad.yaml", "titel: x\n");
    folder.write("full.yaml",
                 "title: Too full\nbox: {size: [10, 10]}\ngas: [{count: 60, radius: 0.68}]\n"
                 "run: {until: 1}\nfilm: {seconds: 1, panels: []}\n");
    CHECK(slides(folder, {"two.yaml", "bad.yaml", "--slides", "talk"}).exit_code == 2);
    // The second scene fails after the first one is drawn.
    const Outcome outcome = slides(folder, {"two.yaml", "full.yaml", "--slides", "talk"});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "");
    folder.write("long.yaml", two_kinds + "seed: 3\n");
    const Interruption stopped =
        interrupted("render two.yaml long.yaml --slides talk --set film.seconds=600 film.fps=30",
                    folder.path());
    CHECK(stopped.exit_code == 130);
    CHECK(has(stopped.err, "nothing was written"));
    CHECK(folder.names() ==
          std::vector<std::string>{"bad.yaml", "full.yaml", "long.yaml", "ring.yaml", "two.yaml"});
    // An earlier folder stays as it was.
    REQUIRE(slides(folder, {"two.yaml", "--slides", "talk"}).exit_code == 0);
    const auto before = names_in(folder.path() / "talk");
    const std::string page = contents(folder.path() / "talk/index.html");
    CHECK(slides(folder, {"ring.yaml", "full.yaml", "--slides", "talk"}).exit_code == 2);
    CHECK(names_in(folder.path() / "talk") == before);
    CHECK(contents(folder.path() / "talk/index.html") == page);
}

TEST_CASE("what does not go with slides is refused, with what to write instead") {
    const TemporaryFolder folder;
    write_scenes(folder);
    folder.write("more/two.yaml", two_kinds);
    const auto refused = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "two.yaml");
        words.emplace_back("--slides");
        const Outcome outcome = slides(folder, words);
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    CHECK(has(refused({"-o", "talk/"}), "write --slides talk/ instead"));
    CHECK(has(refused({"--page", "html"}), "leave --page out"));
    CHECK(has(refused({"ring.yaml", "--join"}), "leave --join out"));
    CHECK(has(refused({"--format", "gif"}), "--slides: browsers play MP4 and WebM, and not GIF"));
    CHECK(has(refused({"--format", "png"}), "give --format mp4 or webm"));
    CHECK(has(refused({"more/two.yaml"}), "two scenes would be written to out/slides/two.mp4"));
    CHECK(has(refused({"--ground", "none"}), "--format webm"));
    CHECK(has(slides(folder, {"two.yaml", "--slides", "talk.html"}).err,
              "--slides talk.html: a set of slides is a folder of several files; name a folder"));
    CHECK(has(refused({"--max-size", "1kB"}), "--max-size 1kB"));
    CHECK(has(refused({"--chunk", "2"}), "the folder of a plan"));
    CHECK(folder.names() == std::vector<std::string>{"more", "ring.yaml", "two.yaml"});
    const Outcome made =
        slides(folder, {"two.yaml", "--slides", "talk", "--depfile", "talk.d", "--quiet"});
    CHECK(made.exit_code == 0);
    CHECK(made.out == "");
    CHECK(contents(folder.path() / "talk.d").starts_with("talk/index.html: \\\n  two.yaml "));
}

TEST_CASE("the files of Reveal.js are those of its package") {
    const fs::path dist = root / "build/npm/node_modules/reveal.js/dist",
                   own = root / "templates/reveal";
    if (!fs::exists(dist)) {
        MESSAGE("reveal.js is not in build/npm: its files are not compared");
        return;
    }
    CHECK(contents(own / "reveal.js") == contents(dist / "reveal.js"));
    CHECK(contents(own / "reveal.css") == contents(dist / "reveal.css"));
    CHECK(contents(own / "notes.js") == contents(dist / "plugin/notes.js"));
    const json package = json::parse(contents(root / "tests/npm/package.json"));
    CHECK(has(contents(own / "LICENSE.txt"),
              "reveal.js " + package["dependencies"]["reveal.js"].get<std::string>()));
}
