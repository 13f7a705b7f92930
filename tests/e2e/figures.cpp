// carom figures, by the program itself: the files of a folder, read by independent programs, and
// which of them are made again.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string ten_disks =
    "title: Ten disks\nbox: {size: [40, 30]}\ngas: [{count: 10, radius: 1, speed: 2}]\n"
    "run: {until: 10}\nfilm: {seconds: 2}\nfigures:\n"
    "  - {name: start, kind: gas, at: 0, caption: \"Ten & more\", alt: Ten disks in a box}\n"
    "  - {name: speeds, kind: speed-histogram, over: [2, 8], size: [10, 6]}\n";

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Outcome figures(const TemporaryFolder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {program, "figures"});
    return run(arguments, folder.path());
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder))
        files[entry.path().filename().string()] = contents(entry.path());
    return files;
}

json captions(const TemporaryFolder& folder) {
    return json::parse(contents(folder.path() / "out/scene/captions.json"));
}

// What headless Chromium says on its console, and of the pictures and films in a page.
std::string seen_in_browser(const fs::path& page, const fs::path& profile) {
    std::string text = contents(page);
    text.replace(text.find("</body>"), 0,
                 "<script>addEventListener('load', () => { document.title = [...document.images]"
                 ".map(p => p.alt + ':' + (p.complete && p.naturalWidth > 0)).join(';') + '|' + "
                 "[...document.querySelectorAll('video')].map(v => v.textTracks.length).join(); "
                 "});</script>");
    const fs::path copy = page.parent_path() / "copy.html";
    std::ofstream(copy) << text;
    const Outcome outcome =
        run({"timeout", "90", "chromium", "--headless", "--no-sandbox", "--disable-gpu",
             "--no-first-run", "--disable-background-networking", "--disable-component-update",
             "--disable-sync", "--enable-logging=stderr", "--user-data-dir=" + profile.string(),
             "--dump-dom", "file://" + copy.string()});
    fs::remove(copy);
    CHECK_FALSE(has(outcome.err, "CONSOLE"));
    const std::size_t begin = outcome.out.find("<title>") + 7;
    return outcome.out.substr(begin, outcome.out.find("</title>") - begin);
}

}  // namespace

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
    CHECK(has(forced.err, "replaced speeds.pdf, which carom had not written so"));
    CHECK(contents(out / "speeds.pdf").starts_with("%PDF"));
    folder.write("out/scene/start.svg", "changed");
    CHECK(figures(folder, {"scene.yaml"}).exit_code == 2);
    CHECK(contents(out / "start.svg") == "changed");
    CHECK(figures(folder, {"scene.yaml", "--only", "speeds"}).exit_code == 0);
    folder.write("out/scene/figures.json", "{}");
    CHECK(has(figures(folder, {"scene.yaml", "--force"}).err, "is not the list that carom keeps"));
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
    CHECK(has(outcome.err, "start.svg of figures that are no longer there; left as it is"));
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
    CHECK(has(shared.err, "f: this folder holds the figures of scene.yaml"));
    CHECK(has(figures(folder, {"scene.yaml", "other/scene.yaml"}).err,
              "the figures of two scenes would go into out/scene"));
    CHECK(figures(folder, {"scene.yaml", "two.yaml", "-o", "g", "--formats", "svg"}).exit_code ==
          0);
    CHECK(fs::exists(folder.path() / "g/two/start.svg"));
    const Outcome misspelt = figures(folder, {"scene.yaml", "--only", "strat"});
    CHECK(misspelt.exit_code == 2);
    CHECK(has(misspelt.err, "did you mean `start`?"));
}

TEST_CASE("pages show the figures, in words that are escaped") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    REQUIRE(figures(folder, {"scene.yaml", "--page", "markdown,html,latex"}).exit_code == 0);
    const fs::path out = folder.path() / "out/scene";
    CHECK(has(contents(out / "scene.md"), "![Ten disks in a box](start.svg)\n"));
    CHECK(has(contents(out / "scene.md"),
              "**Figure 1.** Ten \\& more Data: [start.csv](start.csv).\n"));
    // Of one scene, the title stands above all, once.
    CHECK(contents(out / "scene.md").starts_with("# Ten disks\n\n10 disks, "));
    CHECK_FALSE(has(contents(out / "scene.md"), "\n## "));
    const std::string html = contents(out / "scene.html");
    CHECK(has(html, "<b>Figure 1.</b> Ten &amp; more <small>"));
    CHECK_FALSE(has(html, "http"));
    if (is_installed("chromium"))
        CHECK(seen_in_browser(out / "scene.html", folder.path() / "profile")
                  .starts_with("Ten disks in a box:true;"));
    if (!is_installed("pdflatex")) return;
    folder.write("text.tex",
                 "\\documentclass{article}\n\\usepackage{graphicx}\n"
                 "\\newcommand{\\caromfolder}{out/scene/}\n\\begin{document}\n"
                 "\\input{out/scene/scene}\nSee \\ref{fig:speeds}.\n\\end{document}\n");
    for (int pass = 0; pass < 2; ++pass)
        REQUIRE(run({"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "text.tex"},
                    folder.path())
                    .exit_code == 0);
    const Outcome text = run({"pdftotext", "text.pdf", "-"}, folder.path());
    CHECK(has(text.out, "Figure 1: Ten & more"));
    CHECK(has(text.out, "See 2."));
}

TEST_CASE("films stand beside their figures, and are rendered once") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    const std::vector<std::string> command{
        "scene.yaml", "--page", "html", "--films", "--quiet", "--set", "film.size=[320, 180]"};
    REQUIRE(figures(folder, command).exit_code == 0);
    const fs::path out = folder.path() / "out/scene";
    const auto made = fs::last_write_time(out / "scene.mp4");
    for (const std::string ending :
         {"captions.vtt", "descriptions.vtt", "chapters.vtt", "transcript.txt", "poster.png"})
        CHECK(fs::exists(out / ("scene." + ending)));
    if (is_installed("chromium"))
        CHECK(has(seen_in_browser(out / "scene.html", folder.path() / "profile"), "|3"));
    CHECK(figures(folder, command).exit_code == 0);
    CHECK(fs::last_write_time(out / "scene.mp4") == made);
    // A page does not show the film of another scene.
    CHECK(figures(folder, {"scene.yaml", "--page", "html", "--seed", "5"}).exit_code == 0);
    CHECK_FALSE(has(contents(out / "scene.html"), "<video"));
}

TEST_CASE("a template of one's own is told its mistakes before any work") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    folder.write("mine.md", "{{#figures}}\n{{name}}: {{picture}} at {{time}}\n{{/figures}}\n");
    CHECK(figures(folder, {"scene.yaml", "--page", "mine.md"}).exit_code == 0);
    CHECK(contents(folder.path() / "out/scene/scene.md") ==
          "start: start.svg at 0\nspeeds: speeds.svg at 2 to 8\n");
    folder.write("wrong.html", "<p>{{titel}}</p>\n");
    const Outcome wrong = figures(folder, {"scene.yaml", "-o", "new", "--page", "wrong.html"});
    CHECK(wrong.exit_code == 2);
    CHECK(has(wrong.err, "wrong.html:1:4: error: `titel` is no placeholder of a page"));
    CHECK(has(wrong.err, "did you mean `title`?"));
    CHECK_FALSE(fs::exists(folder.path() / "new"));
    CHECK(figures(folder, {"scene.yaml", "--page", "mine.doc"}).exit_code == 2);
    CHECK(figures(folder, {"scene.yaml", "--page", "mine.md,markdown"}).exit_code == 2);
}

TEST_CASE("the sets of the library make their pages, and the same bytes twice") {
    for (const std::string name : {"kinetic-theory", "collisions"}) {
        CAPTURE(name);
        const TemporaryFolder folder;
        const std::string set = (root / "scenes/sets" / (name + ".yaml")).string();
        const Outcome made = figures(folder, {set});
        CAPTURE(made.err);
        REQUIRE(made.exit_code == 0);
        CHECK(made.err.empty());
        const fs::path out = folder.path() / "out" / name;
        const json words = json::parse(contents(out / "captions.json"));
        CHECK(words.at("figures").size() >= 7);
        for (const std::string ending : {".html", ".tex", ".md"})
            for (const json& figure : words.at("figures"))
                CHECK(has(contents(out / (name + ending)), figure.at("name").get<std::string>()));
        CHECK(has(figures(folder, {set}).out, "up to date"));
        CHECK(figures(folder, {set, "-o", "again"}).exit_code == 0);
        CHECK(files_in(out) == files_in(folder.path() / "again"));
        if (is_installed("chromium"))
            CHECK_FALSE(
                has(seen_in_browser(out / (name + ".html"), folder.path() / "profile"), ":false"));
    }
}

TEST_CASE("a comparison of a set is made from all its scenes, and anew when one of them changes") {
    const TemporaryFolder folder;
    folder.write("one.yaml", ten_disks);
    folder.write("two.yaml", ten_disks);
    folder.write("set.yaml",
                 "title: Both\nscenes: [{scene: one.yaml, figures: [start]}]\nformats: [svg, csv]\n"
                 "template: markdown\ncomparisons:\n"
                 "  - name: both\n    kind: speed-histogram\n    at: 5\n    scenes:\n"
                 "      - {scene: one.yaml, label: first}\n"
                 "      - {scene: two.yaml, label: \"second, faster\", set: gas.0.speed=4}\n");
    const Outcome made = figures(folder, {"set.yaml"});
    CAPTURE(made.err);
    REQUIRE(made.exit_code == 0);
    CHECK(made.out == "out/set: 2 figures made\n");
    const fs::path out = folder.path() / "out/set";
    const json words = json::parse(contents(out / "captions.json"));
    const json runs = words.at("figures")[1].at("runs");
    CHECK(runs[0].at("label") == "first");
    CHECK(runs[1].at("scene") == "two");
    CHECK(runs[1].at("overrides") == json{"gas.0.speed=4"});
    CHECK(has(contents(out / "both.csv"), "\n\"second, faster\",bar,all,"));
    const std::string page = contents(out / "set.md");
    CHECK(page.find("## Ten disks") < page.find("## Side by side"));
    CHECK(page.find("## Side by side") < page.find("(both.svg)"));
    CHECK(has(page, "second, faster (10 disks, "));
    CHECK(has(figures(folder, {"set.yaml"}).out, "up to date, 2 figures"));
    const std::string before = contents(out / "both.svg");
    std::string slower = ten_disks;
    folder.write("two.yaml", slower.replace(slower.find("radius: 1,"), 10, "radius: 2,"));
    CHECK(figures(folder, {"set.yaml"}).out == "out/set: 1 figure made, 1 up to date\n");
    CHECK(contents(out / "both.svg") != before);
    for (const std::string threads : {"1", "3"})
        CHECK(figures(folder, {"set.yaml", "-o", "t" + threads, "--threads", threads}).exit_code ==
              0);
    CHECK(files_in(folder.path() / "t1") == files_in(folder.path() / "t3"));
    // Films are of scenes, and a comparison has none.
    CHECK(figures(folder, {"set.yaml", "--films", "--quiet", "--set", "film.size=[320, 180]"})
              .exit_code == 0);
    CHECK(fs::exists(out / "one.mp4"));
    CHECK_FALSE(fs::exists(out / "both.mp4"));
    CHECK_FALSE(fs::exists(out / ".film"));
}

TEST_CASE("what a set asks of its scenes must be there, and be told apart") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    folder.write("other.yaml", ten_disks);
    folder.write("set.yaml", "title: T\nscenes: [{scene: scene.yaml, figures: [speed]}]\n");
    const Outcome unknown = figures(folder, {"set.yaml"});
    CHECK(unknown.exit_code == 2);
    CHECK(has(unknown.err, "set.yaml:2:40: error: scene.yaml has no figure `speed`"));
    CHECK(has(unknown.err, "did you mean `speeds`?"));
    folder.write("set.yaml", "title: T\nscenes: [scene.yaml, other.yaml]\n");
    const Outcome same = figures(folder, {"set.yaml"});
    CHECK(same.exit_code == 2);
    CHECK(has(same.err, "scene.yaml and other.yaml both have a figure `start`"));
    folder.write("set.yaml", "title: T\nscenes: [nowhere.yaml]\n");
    CHECK(figures(folder, {"set.yaml"}).exit_code == 2);
    folder.write("set.yaml",
                 "title: Both\nformats: [svg]\ntemplate: markdown\nscenes:\n"
                 "  - {scene: other.yaml, figures: [speeds], title: First}\n"
                 "  - {scene: scene.yaml, figures: [start], description: Words.}\n");
    CHECK(figures(folder, {"set.yaml"}).exit_code == 0);
    CHECK(folder.names() ==
          std::vector<std::string>{"other.yaml", "out", "scene.yaml", "set.yaml"});
    const std::string page = contents(folder.path() / "out/set/set.md");
    CHECK(page.starts_with("# Both\n"));
    CHECK(page.find("## First") < page.find("(speeds.svg)"));
    CHECK(page.find("(speeds.svg)") < page.find("## Ten disks"));
    CHECK(page.find("Words.") < page.find("(start.svg)"));
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

TEST_CASE("pages show what there is of each figure, and say what is missing") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    folder.write("mine.tex",
                 "{{#figures}}\n{{number}} {{name}} {{picture}} {{width}}x{{height}} {{kind}} "
                 "{{seed}} [{{csv}}][{{svg}}]\n{{/figures}}\n");
    CHECK(figures(folder, {"scene.yaml", "--page", "mine.tex", "--formats", "png,csv"}).exit_code ==
          0);
    const std::string page = contents(folder.path() / "out/scene/scene.tex");
    CHECK(has(page, "2 speeds speeds.png 10x6 speed-histogram 1 [speeds.csv][]\n"));
    CHECK(page.starts_with("1 start start.png 8.9x"));
    const Outcome missing =
        figures(folder, {"scene.yaml", "-o", "b", "--page", "latex", "--formats", "svg"});
    CHECK(missing.exit_code == 2);
    CHECK(has(missing.err, "shows figures as pdf or png, and there is no such file of `start`"));
    CHECK(has(
        figures(folder, {"scene.yaml", "-o", "c", "--page", "markdown", "--formats", "pdf"}).err,
        "shows figures as svg or png"));
    // All of them, the best there is: vectors.
    CHECK(figures(folder, {"scene.yaml", "--page", "mine.tex"}).exit_code == 0);
    CHECK(has(contents(folder.path() / "out/scene/scene.tex"), "2 speeds speeds.pdf"));
}

TEST_CASE("the pictures in an HTML page are the files beside it") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    CHECK(figures(folder, {"scene.yaml", "--page", "html", "--formats", "svg,png"}).exit_code == 0);
    const std::string page = contents(folder.path() / "out/scene/scene.html");
    std::size_t at = 0;
    for (const std::string name : {"start", "speeds"}) {
        const std::string mark = "<img src=\"data:image/svg+xml;base64,";
        at = page.find(mark, at);
        REQUIRE(at != std::string::npos);
        at += mark.size();
        folder.write("picture.64", page.substr(at, page.find('"', at) - at));
        CHECK(run({"base64", "-d", "picture.64"}, folder.path()).out ==
              contents(folder.path() / "out/scene" / (name + ".svg")));
    }
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
    for (const json& figure : captions(folder).at("figures"))
        CHECK_FALSE(has(figure.at("caption"), "so far"));
}

TEST_CASE("a set has its figures in the order in which it lists them, of scenes of any folder") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "other");
    folder.write("scene.yaml", ten_disks);
    folder.write("set.yaml",
                 "title: T\nformats: [svg]\nscenes: [{scene: scene.yaml, figures: [speeds, "
                 "start]}]\n");
    CHECK(figures(folder, {"set.yaml"}).exit_code == 0);
    const json words = json::parse(contents(folder.path() / "out/set/captions.json"));
    CHECK(words["figures"][0]["name"] == "speeds");
    CHECK(words["figures"][1]["name"] == "start");
    const std::string page = contents(folder.path() / "out/set/set.html");
    CHECK(page.find("id=\"speeds\"") < page.find("id=\"start\""));
    // Films of two scenes of one name would overwrite each other.
    std::string renamed = ten_disks;
    renamed.replace(renamed.find("name: start"), 11, "name: begin");
    renamed.replace(renamed.find("name: speeds"), 12, "name: fast");
    folder.write("other/scene.yaml", renamed);
    folder.write("set.yaml", "title: T\nscenes: [scene.yaml, other/scene.yaml]\n");
    const Outcome same = figures(folder, {"set.yaml"});
    CHECK(same.exit_code == 2);
    CHECK(has(same.err, "two of its scenes are called scene"));
    // A figure that the set no longer shows is told, and left.
    folder.write("set.yaml",
                 "title: T\nformats: [svg]\nscenes: [{scene: scene.yaml, figures: [start]}]\n");
    CHECK(has(figures(folder, {"set.yaml"}).err, "speeds.svg of figures that are no longer there"));
    CHECK(fs::exists(folder.path() / "out/set/speeds.svg"));
}

TEST_CASE("a LaTeX page with letters that pdfLaTeX cannot set is told, and made") {
    const TemporaryFolder folder;
    std::string scene = ten_disks;
    scene.replace(scene.find("Ten & more"), 10, "Ten 二 & λ₂");
    folder.write("scene.yaml", scene);
    const Outcome made = figures(folder, {"scene.yaml", "--page", "latex"});
    CHECK(made.exit_code == 0);
    CHECK(made.err ==
          "carom: out/scene/scene.tex: pdfLaTeX cannot set 二; LuaLaTeX and XeLaTeX "
          "can, with a font that has it\n");
    CHECK(has(contents(folder.path() / "out/scene/scene.tex"),
              "Ten 二 \\& \\(\\lambda\\)\\(_{2}\\)"));
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
