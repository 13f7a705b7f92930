// carom render --page html: a page that holds its film, in a browser.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "e2e/in_browser.h"
#include "support/hostile_words.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string scene = R"(title: Two kinds & <one> "box"
subtitle: Seen for two seconds
box: {size: [20, 15]}
gas:
  - {name: light, count: 20, radius: 0.4, speed: 2}
  - {name: heavy, count: 5, radius: 0.8, mass: 9}
run:
  until: 4
  events:
    - {at: 1, caption: The first words}
    - {at: 3, caption: The last words}
film: {seconds: 16, fps: 5, size: [320, 180], panels: []}
)";

Outcome page_of(const TemporaryFolder& folder, const std::string& file,
                const std::vector<std::string>& more = {}) {
    std::vector<std::string> command{program, "render", file, "--page", "html"};
    command.insert(command.end(), more.begin(), more.end());
    return run(command, folder.path());
}

}  // namespace

TEST_CASE("a page holds its film, chapters, captions, transcript and scene, and asks for nothing") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const Outcome outcome = page_of(folder, "scene.yaml");
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.out.starts_with("out/scene.html: 80 frames, 0:16, "));
    const fs::path page = folder.path() / "out/scene.html";
    const std::string text = contents(page);
    CHECK(has(text, "<h1>Two kinds &amp; &lt;one&gt; &quot;box&quot;</h1>"));
    CHECK(has(text, "A silent film of 0:16."));
    CHECK(!has(text, "http:"));
    CHECK(!has(text, "https:"));
    CHECK(!has(text, "{{"));
    CHECK(page_of(folder, "scene.yaml", {"-o", "again.html", "--threads", "3"}).exit_code == 0);
    CHECK(contents(folder.path() / "again.html").size() == text.size());  // names of one length
    if (!can_browse()) return;
    const json answer = browsed("film", page);
    check_film(answer);
    CHECK(answer["heading"] == "Two kinds & <one> \"box\"");
    CHECK(answer["duration"].get<double>() == doctest::Approx(16.0));
    CHECK(answer["width"] == 320);
    CHECK(answer["tracks"] == json{"captions", "descriptions", "chapters"});
    CHECK(answer["captions"]["cues"].size() == 2);
    CHECK(answer["captions"]["shown"] == json{"The first words", "The last words"});
    CHECK(answer["chapters"][1]["words"].get<std::string>().ends_with("The first words"));
    CHECK(answer["downloads"][0]["name"] == "scene.yaml");
    CHECK(answer["scene"] == scene);
    CHECK(answer["wide"] == 0);
    CHECK(answer["saved"]["name"] == "scene.mp4");
    CHECK(answer["heard"] == 0);
}

TEST_CASE("a page plays the sound of its film, and its captions name it") {
    for (const std::string format : {"mp4", "webm"}) {
        CAPTURE(format);
        const TemporaryFolder folder;
        folder.write("scene.yaml", scene);
        const Outcome outcome =
            page_of(folder, "scene.yaml", {"--set", "film.sound=collisions", "--format", format});
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        const fs::path page = folder.path() / "out/scene.html";
        CHECK(has(contents(page), "A film of 0:16 with sound"));
        if (!can_browse()) return;
        const json answer = browsed("film", page);
        check_film(answer);
        CHECK(answer["heard"] > 0);
        const std::string first = answer["captions"]["shown"].at(0);
        CAPTURE(first);
        CHECK(has(first, "click"));
    }
}

TEST_CASE("a WebM plays from its page, and a page goes to standard output") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const Outcome outcome =
        page_of(folder, "scene.yaml", {"--format", "webm", "-o", "-", "--set", "gas.0.count=5"});
    REQUIRE(outcome.exit_code == 0);
    CHECK(has(outcome.err, "standard output: 80 frames"));
    CHECK(has(outcome.out, "<code>--set gas.0.count=5</code>"));
    if (!can_browse()) return;
    const json answer = browsed("film", folder.write("page.html", outcome.out));
    check_film(answer);
    CHECK(answer["downloads"][1]["name"] == "film.webm");
}

TEST_CASE("words of strangers are words on a page, and never code") {
    const TemporaryFolder folder;
    json hostile{
        {"title", "<script>window.changed = 1</script> \"'><img src=x onerror=alert(1)>"},
        {"subtitle", "{{title}} {{#chapters}} </title></style></script><script>alert(2)"},
        {"description", all_hostile_words()},
        {"box", {{"size", {20, 15}}}},
        {"gas",
         json::array(
             {{{"name", "\" onload=\"alert(3)"}, {"count", 3}, {"radius", 0.5}, {"speed", 1}}})},
        {"run", {{"until", 2}, {"events", json::array()}}},
        {"film", {{"seconds", 12}, {"fps", 5}, {"size", {320, 180}}, {"panels", json::array()}}}};
    hostile["run"]["events"].push_back(
        {{"at", 1}, {"caption", "--> <b onclick=alert(4)>b</b><script>alert(5)</script>"}});
    const std::string name = "<script>alert(6)<!--\" onfocus=alert(7) x=.yaml";
    folder.write(name, hostile.dump());
    const Outcome outcome = page_of(folder, name, {"-o", "page.html"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    REQUIRE(page_of(folder, name, {"-o", "pages/"}).exit_code == 0);
    if (!can_browse()) return;
    const fs::path named = folder.path() / "pages" / (name.substr(0, name.size() - 5) + ".html");
    for (const fs::path& page : {folder.path() / "page.html", named}) {
        const json answer = browsed("film", page);
        check_film(answer);
        CHECK(answer["scripts"] == 1);
        CHECK(answer["heading"] == hostile["title"]);
        CHECK(answer["scene"] == hostile.dump());
        CHECK(answer["captions"]["shown"].size() == 1);
        CHECK(answer["saved"]["bytes"].get<int>() > 1000);
    }
}

TEST_CASE("what does not go with a page is refused, and an interrupted one is not there") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const auto refused = [&](const std::vector<std::string>& more) {
        const Outcome outcome = page_of(folder, "scene.yaml", more);
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    CHECK(has(refused({"--format", "gif"}), "browsers play MP4 and WebM"));
    CHECK(has(refused({"--words"}), "leave --words out"));
    CHECK(has(refused({"--join", "scene.yaml"}), "leave --join out"));
    CHECK(has(refused({"-o", "film.mp4"}), "must end in .html"));
    CHECK(has(refused({"--max-size", "1kB"}), "--max-size 1kB"));
    CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
}
