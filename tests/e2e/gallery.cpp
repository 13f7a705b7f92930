// carom gallery: a site of a folder of scenes, in a browser; what is made again, and what never is
// touched.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "e2e/in_browser.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string scene(const std::string& title) {
    return "title: '" + title +
           "'\nbox: {size: [20, 15]}\ngas: [{name: argon, count: 9, radius: 0.4, speed: 2}]\n"
           "run: {until: 3, events: [{at: 1, caption: A first word}]}\n"
           "film: {seconds: 8, fps: 5, size: [640, 360], panels: []}\n";
}

Outcome gallery(const TemporaryFolder& folder, const std::vector<std::string>& more = {}) {
    std::vector<std::string> command{program, "gallery", "scenes", "-o", "site"};
    command.insert(command.end(), more.begin(), more.end());
    return run(command, folder.path());
}

void write_scenes(const TemporaryFolder& folder) {
    folder.write("scenes/one.yaml", scene("Équilibre of one gas"));
    folder.write("scenes/two.yaml", scene("Reversal"));
    folder.write("scenes/classics/old one.yaml", scene("A classic"));
    folder.write("scenes/set.yaml", "title: A set\nscenes: [{scene: one.yaml}]\n");
    folder.write("scenes/.hidden.yaml", "no scene");
    folder.write("scenes/notes.txt", "no scene");
}

}  // namespace

TEST_CASE("a site has a card and a page for each scene, and plays in a browser from a folder") {
    const TemporaryFolder folder;
    write_scenes(folder);
    const Outcome outcome = gallery(folder);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.out == "site: 3 films made\n");
    const fs::path site = folder.path() / "site";
    for (const std::string file :
         {"index.html", "gallery.json", "films/one.html", "films/one.mp4", "films/one.poster.png",
          "films/one.card.png", "films/one.yaml", "films/classics/old one.html"})
        CHECK(fs::exists(site / file));
    for (const auto& entry : fs::directory_iterator(site))
        CHECK_FALSE(entry.path().filename().string().starts_with("."));
    if (!can_browse()) return;
    const json answer = browsed("gallery", site / "index.html");
    check_sound(answer);
    CHECK(answer["title"] == "scenes");
    CHECK(answer["titles"] == json{"Équilibre of one gas", "Reversal", "A classic"});
    CHECK(answer["sections"] == json{"Films", "classics"});
    CHECK(answer["videos"] == 0);  // posters first
    for (const char* playing : {"hover", "focus"}) CHECK(answer[playing] == true);
    for (const char* none : {"left", "escaped", "calm", "none"}) CHECK(answer[none] == 0);
    CHECK(answer["found"] == 1);
    CHECK(answer["said"] == "1 of 3 films");
    CHECK(answer["foundAgain"] == 1);
    CHECK(answer["saidNone"] == "No film has all these words.");
    CHECK(answer["all"] == 3);
    for (const std::string page :
         {"films/one.html", "films/two.html", "films/classics/old one.html"}) {
        CAPTURE(page);
        const json film = browsed("film", site / page);
        check_film(film);
        CHECK(film["captions"]["cues"].size() == 1);
        CHECK(film["captions"]["shown"] == json{"A first word"});
        CHECK(film["downloads"][0]["address"].get<std::string>().ends_with(".yaml"));
    }
}

TEST_CASE("only what has changed is made again, and what is gone is removed") {
    const TemporaryFolder folder;
    write_scenes(folder);
    REQUIRE(gallery(folder).exit_code == 0);
    CHECK(gallery(folder).out == "site: up to date, 3 films\n");
    folder.write("scenes/two.yaml", scene("Another title"));
    fs::remove(folder.path() / "scenes/one.yaml");
    fs::remove(folder.path() / "scenes/set.yaml");
    CHECK(gallery(folder).out ==
          "site: 1 film made, 1 up to date, 5 files of scenes that no longer exist removed\n");
    CHECK_FALSE(fs::exists(folder.path() / "site/films/one.mp4"));
    CHECK(has(contents(folder.path() / "site/index.html"), "Another title"));
    CHECK(!has(contents(folder.path() / "site/index.html"), "quilibre"));
    CHECK(gallery(folder, {"--title", "Gases <of> mine"}).out == "site: 2 films made\n");
    CHECK(has(contents(folder.path() / "site/index.html"), "<h1>Gases &lt;of&gt; mine</h1>"));
}

TEST_CASE("a site does not offer a scene that keeps itself out of its film") {
    const TemporaryFolder folder;
    folder.write("scenes/one.yaml", scene("Open"));
    std::string closed = scene("Closed");
    closed.insert(closed.find("seconds:"), "recipe: false, ");
    folder.write("scenes/two.yaml", closed);
    REQUIRE(gallery(folder).exit_code == 0);
    const fs::path films = folder.path() / "site/films";
    CHECK(fs::exists(films / "one.yaml"));
    CHECK(has(contents(films / "one.html"), "one.yaml"));
    CHECK_FALSE(fs::exists(films / "two.yaml"));
    CHECK_FALSE(has(contents(films / "two.html"), "two.yaml"));
    CHECK_FALSE(has(contents(films / "two.mp4"), "argon, count"));
    CHECK(gallery(folder).out == "site: up to date, 2 films\n");
    REQUIRE(gallery(folder, {"--no-recipe"}).exit_code == 0);
    CHECK_FALSE(fs::exists(films / "one.yaml"));
}

TEST_CASE("files of others are neither replaced nor removed") {
    const TemporaryFolder folder;
    write_scenes(folder);
    folder.write("site/index.html", "mine");
    Outcome outcome = gallery(folder);
    CHECK(outcome.exit_code == 2);
    CHECK(has(outcome.err, "carom did not write index.html"));
    CHECK(contents(folder.path() / "site/index.html") == "mine");
    CHECK_FALSE(fs::exists(folder.path() / "site/films"));
    folder.write("site/.film/films/one.mp4", "mine");
    REQUIRE(gallery(folder, {"--force"}).exit_code == 0);
    CHECK(contents(folder.path() / "site/.film/films/one.mp4") == "mine");
    // A list that a stranger wrote leads to nothing outside.
    const std::string fingerprint = [&] {
        const json list = json::parse(contents(folder.path() / "site/gallery.json"));
        return list["files"]["films/one.yaml"]["content"].get<std::string>();
    }();
    fs::copy(folder.path() / "scenes/one.yaml", folder.path() / "precious.yaml");
    json list = json::parse(contents(folder.path() / "site/gallery.json"));
    list["files"]["../precious.yaml"] = {{"figure", ""}, {"inputs", ""}, {"content", fingerprint}};
    list["files"][(folder.path() / "precious.yaml").string()] = list["files"]["../precious.yaml"];
    folder.write("site/gallery.json", list.dump());
    CHECK(gallery(folder).exit_code == 0);
    CHECK(fs::exists(folder.path() / "precious.yaml"));
}

TEST_CASE(
    "links that climb, mistakes of scenes and empty folders are told before anything is written") {
    const TemporaryFolder folder;
    folder.write("outside.yaml", scene("Outside"));
    fs::create_directory(folder.path() / "scenes");
    CHECK(has(gallery(folder).err, "there is no scene in this folder"));
    write_scenes(folder);
    fs::create_symlink("../outside.yaml", folder.path() / "scenes/link.yaml");
    Outcome outcome = gallery(folder);
    CHECK(outcome.exit_code == 2);
    CHECK(has(outcome.err, "scenes/link.yaml: this link leads out of the folder"));
    fs::remove(folder.path() / "scenes/link.yaml");
    folder.write("scenes/bad.yaml", "title: [\n");
    folder.write("scenes/worse.yaml", "titel: x\n");
    outcome = gallery(folder);
    CHECK(outcome.exit_code == 2);
    CHECK(has(outcome.err, "scenes/bad.yaml:"));
    CHECK(has(outcome.err, "scenes/worse.yaml:"));
    CHECK(run({program, "gallery", "scenes", "-o", "scenes"}, folder.path()).exit_code == 2);
    CHECK(run({program, "gallery", "outside.yaml", "-o", "site"}, folder.path()).exit_code == 2);
    CHECK_FALSE(fs::exists(folder.path() / "site"));
}

TEST_CASE("names of scenes are addresses and words, never code") {
    const TemporaryFolder folder;
    const std::string name = "javascript:alert(1) <b> \"x\" ' & % # ?";
    folder.write("scenes/" + name + ".yaml", scene("</h3><script>window.changed = 1</script>"));
    folder.write(
        "scenes/\xff"
        "broken.yaml",
        scene("Bytes"));
    folder.write("scenes/two.yaml", scene("\" autofocus onfocus=\"window.changed = 2"));
    REQUIRE(gallery(folder, {"--title", "<script>window.changed = 3</script>"}).exit_code == 0);
    CHECK(fs::exists(folder.path() / "site/films" / (name + ".html")));
    const Outcome again = gallery(folder, {"--title", "<script>window.changed = 3</script>"});
    CHECK(again.exit_code == 0);
    CHECK(has(again.out, "up to date, 3 films"));
    if (!can_browse()) return;
    const json answer = browsed("gallery", folder.path() / "site/index.html");
    check_sound(answer);
    CHECK(answer["title"] == "<script>window.changed = 3</script>");
    CHECK(answer["cards"] == 3);
    for (const json& link : answer["links"]) CHECK(link.get<std::string>().starts_with("file:"));
    const json film = browsed("film", folder.path() / "site/films" / (name + ".html"));
    check_film(film);
}
