// carom figures, by the program itself: the files of a folder, read by independent programs, and
// which of them are made again.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/figure_folder.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("the files of figures are read by independent programs") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    const Outcome made = figures(folder, {"scene.yaml"});
    CHECK(made.exit_code == 0);
    CHECK(made.out == "out/scene: 2 figures made\n");
    CHECK(made.err.empty());
    const fs::path out = folder.path() / "out/scene";
    const json words = captions(folder);
    CHECK(words.at("title") == "Ten disks");
    REQUIRE(words.at("figures").size() == 2);
    for (const json& figure : words.at("figures")) {
        CHECK(figure.at("files").size() == 4);
        for (const std::string name : figure.at("files")) CHECK(fs::exists(out / name));
        const std::string name = figure.at("name");
        CHECK(run({"rsvg-convert", "-o", "picture.png", name + ".svg"}, out).exit_code == 0);
        const Outcome text = run({"pdftotext", name + ".pdf", "-"}, out);
        CHECK(text.exit_code == 0);
        if (name == "speeds") CHECK(has(text.out, "speed"));
    }
    CHECK(words["figures"][0]["caption"] == "Ten & more");
    CHECK(words["figures"][0]["alt"] == "Ten disks in a box");
    CHECK(words["figures"][1]["over"] == json{2.0, 8.0});
    CHECK(words["figures"][1]["size_cm"] == json{10.0, 6.0});
}

namespace {

// What read_png.py finds in a picture, and the samples of its pixels at some places.
json png(const fs::path& picture, const std::vector<std::string>& places = {}) {
    std::vector<std::string> command{"python3", (root / "tests/e2e/read_png.py").string(),
                                     picture.string()};
    command.insert(command.end(), places.begin(), places.end());
    const Outcome outcome = run(command);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("a picture in pixels says how large it is on paper") {
    if (!is_installed("python3")) return;
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    REQUIRE(figures(folder, {"scene.yaml", "--formats", "png"}).exit_code == 0);
    const json picture = png(folder.path() / "out/scene/speeds.png");
    CHECK(picture.at("dots_in_a_metre") == json{11811, 11811});  // 300 in an inch
    // 10 by 6 cm, to within half a pixel.
    CHECK(std::abs(picture.at("width").get<double>() / 118.11 - 10.0) < 0.005);
    CHECK(std::abs(picture.at("height").get<double>() / 118.11 - 6.0) < 0.005);
    // Slides have 144 in an inch, and frames of films 96, as an SVG has.
    REQUIRE(figures(folder, {"scene.yaml", "--formats", "png", "--set", "figures.speeds.size=slide",
                             "-o", "slide"})
                .exit_code == 0);
    CHECK(png(folder.path() / "slide/speeds.png").at("dots_in_a_metre") == json{5669, 5669});
    REQUIRE(run({program, "still", "scene.yaml", "--at", "1", "-o", "still.png"}, folder.path())
                .exit_code == 0);
    CHECK(png(folder.path() / "still.png").at("dots_in_a_metre") == json{3780, 3780});
}

TEST_CASE("without a ground nothing lies behind a figure") {
    if (!is_installed("python3")) return;
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    for (const std::string theme : {"print", "light", "dark"}) {
        CAPTURE(theme);
        const auto made = [&](const std::string& ground) {
            const std::string name = theme + ground;
            REQUIRE(figures(folder, {"scene.yaml", "--set", "figures.start.theme=" + theme, "--set",
                                     "figures.speeds.theme=" + theme, "--set",
                                     "film.ground=" + ground, "-o", name})
                        .exit_code == 0);
            return folder.path() / name;
        };
        const fs::path none = made("none"), paper = made("theme");
        const json page = png(paper / "speeds.png", {"0,0", "-1,-1"});
        const json white{255, 255, 255};
        if (theme != "dark") CHECK(page.at("pixels") == json{white, white});
        const json clear{0, 0, 0, 0};
        CHECK(png(none / "speeds.png", {"0,0", "-1,-1"}).at("pixels") == json{clear, clear});
        // The gas lies in its box as before.
        const json box = png(none / "start.png", {"0,0", "500,300"}).at("pixels");
        CHECK(box[0] == clear);
        CHECK(box[1][3] == 255);
        REQUIRE(run({"rsvg-convert", "speeds.svg", "-o", "svg.png"}, none).exit_code == 0);
        CHECK(png(none / "svg.png", {"0,0"}).at("pixels")[0] == clear);
        // Poppler draws a PDF on nothing if it is asked to.
        REQUIRE(run({"pdftocairo", "-png", "-transp", "-singlefile", "speeds.pdf", "pdf"}, none)
                    .exit_code == 0);
        CHECK(png(none / "pdf.png", {"0,0"}).at("pixels")[0] == clear);
    }
}

TEST_CASE("the same scene gives the same bytes in another folder") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    CHECK(figures(folder, {"scene.yaml", "-o", "a"}).exit_code == 0);
    CHECK(figures(folder, {"scene.yaml", "-o", "b"}).exit_code == 0);
    const auto a = files_in(folder.path() / "a");
    CHECK(a.size() == 10);
    CHECK(a == files_in(folder.path() / "b"));
}

TEST_CASE("only what has changed is made again") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    const fs::path svg = folder.path() / "out/scene/start.svg";
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg"}).exit_code == 0);
    const auto made = fs::last_write_time(svg);
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg"}).out ==
          "out/scene: up to date, 2 figures\n");
    fs::remove(folder.path() / "out/scene/speeds.svg");
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg"}).out ==
          "out/scene: 1 figure made, 1 up to date\n");
    CHECK(fs::last_write_time(svg) == made);
    CHECK(figures(folder, {"scene.yaml", "--only", "start"}).out == "out/scene: 1 figure made\n");
    CHECK(captions(folder)["figures"][0]["files"].size() == 4);
    CHECK(captions(folder)["figures"][1]["files"] == json{"speeds.svg"});
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg", "--force"}).out ==
          "out/scene: 2 figures made\n");
    // Another seed is another picture.
    const std::string before = contents(svg);
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg", "--seed", "2"}).out ==
          "out/scene: 2 figures made\n");
    CHECK(contents(svg) != before);
    CHECK(captions(folder)["figures"][0]["seed"] == 2);
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg"}).exit_code == 0);
    CHECK(contents(svg) == before);
}

TEST_CASE("what carom did not write is never replaced unasked") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    const fs::path out = folder.path() / "out/scene";
    fs::create_directories(out);
    folder.write("out/scene/speeds.pdf", "mine");
    const Outcome refused = figures(folder, {"scene.yaml"});
    CHECK(refused.exit_code == 2);
    CHECK(refused.err ==
          "carom: out/scene: carom did not write speeds.pdf, or it was changed since; nothing has "
          "been written. Move it away, or replace it with --force\n");
    CHECK(files_in(out).size() == 1);
    const Outcome forced = figures(folder, {"scene.yaml", "--force"});
    CHECK(forced.exit_code == 0);
    CHECK(has(forced.err, "replaced speeds.pdf, not written by carom or changed since"));
    CHECK(contents(out / "speeds.pdf").starts_with("%PDF"));
    folder.write("out/scene/start.svg", "changed");
    CHECK(figures(folder, {"scene.yaml"}).exit_code == 2);
    CHECK(contents(out / "start.svg") == "changed");
    CHECK(figures(folder, {"scene.yaml", "--only", "speeds"}).exit_code == 0);
    folder.write("out/scene/figures.json", "{}");
    CHECK(has(figures(folder, {"scene.yaml", "--force"}).err, "is not the list that carom keeps"));
}

TEST_CASE("figures that were finished before Ctrl-C stay, and it says so") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    const Outcome outcome =
        shell("'" + program +
                  "' figures scene.yaml --films --set film.seconds=200 & "
                  "for i in $(seq 900); do [ -e out/scene/speeds.csv ] && break; sleep 0.05; done; "
                  "kill -INT $!; wait $!",
              folder.path());
    CHECK(outcome.exit_code == 130);
    CHECK(has(outcome.err,
              "carom: interrupted; figures that were finished stay, and are not made again\n"));
    for (const auto& entry : fs::directory_iterator(folder.path() / "out/scene"))
        CHECK_FALSE(entry.path().filename().string().starts_with("."));
    CHECK(figures(folder, {"scene.yaml", "--set", "film.seconds=200"}).out ==
          "out/scene: up to date, 2 figures\n");
}

TEST_CASE("figures that are refused on the way leave no folder") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: A gas\nbox: {size: [20, 10]}\ngas: [{count: 12, radius: 0.3, speed: 1}]\n"
                 "run: {until: 5}\nfigures: [{name: g, kind: gas}, {name: s, kind: sweep, number: "
                 "nonsense, vary: 'gas.0.radius=0.1:0.3:3'}]\n");
    const Outcome refused = figures(folder, {"scene.yaml", "-o", "new"});
    CHECK(refused.exit_code == 2);
    CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
}

TEST_CASE("figures are made of a scene whose name is not UTF-8, and their texts are") {
    const TemporaryFolder folder;
    folder.write("caf\xE9.yaml", ten_disks);
    const Outcome made = figures(folder, {"caf\xE9.yaml", "--page", "html", "-o", "out"});
    CHECK(made.exit_code == 0);
    CHECK(made.err.empty());
    CHECK(has(contents(folder.path() / "out/start.svg"), "scene caf\uFFFD; seed"));
    CHECK(json::parse(contents(folder.path() / "out/captions.json"))["figures"].size() == 2);
    CHECK(run({"rsvg-convert", "-o", "a.png", "out/start.svg"}, folder.path()).exit_code == 0);
    const std::vector<std::string> with_film{
        "caf\xE9.yaml", "--page", "html", "-o", "out", "--films", "--set", "film.size=[64, 64]"};
    REQUIRE(figures(folder, with_film).exit_code == 0);
    const Outcome again = figures(folder, with_film);
    CHECK(again.exit_code == 0);
    CHECK(again.out == "out: up to date, 2 figures\n");
    folder.write("caf\xE8.yaml", ten_disks);
    CHECK(figures(folder, {"caf\xE8.yaml", "-o", "out"}).exit_code == 2);
}

TEST_CASE("figures do not go to standard output") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    const Outcome refused = figures(folder, {"scene.yaml", "-o", "-"});
    CHECK(refused.exit_code == 2);
    CHECK(refused.err == "carom: -o -: figures are several files; name a folder\n");
    CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
}

TEST_CASE("options with lists may stand before the scene") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    CHECK(figures(folder,
                  {"--only", "start", "--formats", "svg, csv", "--page", "markdown", "scene.yaml"})
              .out == "out/scene: 1 figure made\n");
    for (const std::string file : {"start.svg", "start.csv", "scene.md"})
        CHECK(fs::exists(folder.path() / "out/scene" / file));
    CHECK(figures(folder, {"--only", "start, speeds", "scene.yaml", "--formats", "svg"}).out ==
          "out/scene: 1 figure made, 1 up to date\n");
}

TEST_CASE("files of figures that are gone stay, and are told") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg"}).exit_code == 0);
    std::string renamed = ten_disks;
    renamed.replace(renamed.find("start"), 5, "begin");
    folder.write("scene.yaml", renamed);
    const Outcome outcome = figures(folder, {"scene.yaml", "--formats", "svg"});
    CHECK(outcome.exit_code == 0);
    CHECK(has(outcome.err, "start.svg of figures that no longer exist; left as it is"));
    CHECK(fs::exists(folder.path() / "out/scene/start.svg"));
    CHECK(captions(folder)["figures"][0]["name"] == "begin");
}

TEST_CASE("a folder is for one scene, and a figure must be there to be chosen") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "other");
    for (const std::string name : {"scene.yaml", "two.yaml", "other/scene.yaml"})
        folder.write(name, ten_disks);
    CHECK(figures(folder, {"scene.yaml", "-o", "f", "--formats", "svg"}).exit_code == 0);
    const Outcome shared = figures(folder, {"two.yaml", "-o", "f"});
    CHECK(shared.exit_code == 2);
    CHECK(has(shared.err, "f: this folder holds what was made of scene.yaml"));
    CHECK(has(figures(folder, {"scene.yaml", "other/scene.yaml"}).err,
              "the figures of two scenes would go into out/scene"));
    CHECK(figures(folder, {"scene.yaml", "two.yaml", "-o", "g", "--formats", "svg"}).exit_code ==
          0);
    CHECK(fs::exists(folder.path() / "g/two/start.svg"));
    const Outcome misspelt = figures(folder, {"scene.yaml", "--only", "strat"});
    CHECK(misspelt.exit_code == 2);
    CHECK(has(misspelt.err, "did you mean `start`?"));
}

TEST_CASE("a figure depends on its film's template, too, and tells what was laid over its scene") {
    const TemporaryFolder folder;
    const std::string layout =
        "layout: {grid: [80, 45], title: [1, 1, 78, 4], gas: [1, 6, 50, 38], color_bar: [52, 6, "
        "27, "
        "4]}\n";
    folder.write("mine.yaml", "color_by: speed\n" + layout);
    std::string scene = ten_disks;
    scene.replace(scene.find("seconds: 2"), 10, "seconds: 2, template: mine");
    folder.write("scene.yaml", scene);
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg"}).exit_code == 0);
    CHECK(captions(folder)["figures"][0]["overrides"] == json::array());
    folder.write("mine.yaml", "color_by: mass\n" + layout);
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg"}).out == "out/scene: 2 figures made\n");
    CHECK(figures(folder, {"scene.yaml", "--formats", "svg", "--set", "gas.0.speed=3"}).out ==
          "out/scene: 2 figures made\n");
    CHECK(captions(folder)["figures"][0]["overrides"] == json{"gas.0.speed=3"});
    CHECK(captions(folder)["figures"][0]["times"] == json{0.0});
    CHECK(captions(folder)["figures"][1]["kind"] == "speed-histogram");
    CHECK(captions(folder)["figures"][1]["scene_title"] == "Ten disks");
}

TEST_CASE("a still speaks of no present") {
    const TemporaryFolder folder;
    std::string scene = ten_disks;
    scene +=
        "  - {name: narrow, kind: speed-histogram, at: 5, size: [5, 4]}\n"
        "  - {name: wide, kind: energy-histogram, at: 5}\n"
        "  - {name: middle, kind: velocity-histogram, at: 5, mean_now: true}\n"
        "  - {name: classes, kind: speed-classes, at: 5}\n";
    folder.write("scene.yaml", scene);
    REQUIRE(figures(folder, {"scene.yaml", "--formats", "pdf"}).exit_code == 0);
    for (const std::string name : {"narrow", "wide", "middle", "classes"}) {
        CAPTURE(name);
        const Outcome text = run({"pdftotext", "out/scene/" + name + ".pdf", "-"}, folder.path());
        CAPTURE(text.out);
        CHECK(has(text.out, "mean"));
        CHECK_FALSE(has(text.out, "now"));
    }
    const json words = captions(folder);
    for (const json& figure : words.at("figures")) CHECK_FALSE(has(figure.at("caption"), "so far"));
}

TEST_CASE("every picture says what it is and what it was made from") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    REQUIRE(figures(folder, {"scene.yaml", "--seed", "7"}).exit_code == 0);
    const fs::path out = folder.path() / "out/scene";
    const json known = json::parse(contents(out / "figures.json"));
    const std::string made_from = known.at("figures").at("start").at("inputs");
    const std::string origin = "; scene scene; seed 7; set seed=7; made from " + made_from;
    const std::string svg = contents(out / "start.svg");
    CHECK(has(svg, "<title>Ten disks</title>"));
    CHECK(has(svg, "<desc>Ten disks in a box</desc>"));
    CHECK(has(svg, origin + "</metadata>"));
    const std::string pdf = run({"pdfinfo", "start.pdf"}, out).out;
    CHECK(has(pdf, "Ten disks\n"));
    CHECK(has(pdf, "Ten disks in a box\n"));
    CHECK(has(pdf, origin + "\n"));
    // Each chunk with its check sum, by Python's zlib.
    const std::string read =
        "import struct, sys, zlib\n"
        "png = open(sys.argv[1], 'rb').read()\n"
        "at = 8\n"
        "while at < len(png):\n"
        "    size, = struct.unpack('>I', png[at:at + 4])\n"
        "    body = png[at + 4:at + 8 + size]\n"
        "    assert struct.unpack('>I', png[at + 8 + size:at + 12 + size])[0] == zlib.crc32(body)\n"
        "    if body[:4] == b'iTXt':\n"
        "        print(*body[4:].decode().split('\\0\\0\\0\\0\\0'), sep='=')\n"
        "    at += 12 + size\n";
    const Outcome png = run({"/usr/bin/python3", "-c", read, "start.png"}, out);
    CAPTURE(png.err);
    CHECK(png.out.starts_with("Title=Ten disks\nDescription=Ten disks in a box\nSource=carom "));
    CHECK(png.out.ends_with(origin + "\n"));
    const std::string fonts = run({"pdffonts", "speeds.pdf"}, out).out;
    CHECK(has(fonts, "Inter"));
    std::size_t row = fonts.find("---\n");  // emb sub uni: each font of the table is embedded
    for (row = fonts.find('\n', row) + 1; row < fonts.size(); row = fonts.find('\n', row) + 1)
        CHECK(has(fonts.substr(row, fonts.find('\n', row) - row), " yes yes "));
}
