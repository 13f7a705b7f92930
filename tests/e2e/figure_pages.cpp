// Pages of figures, by the program itself: what browsers and LaTeX make of them, templates of one's
// own, and films beside the figures.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/figure_folder.h"
#include "e2e/in_browser.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

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

TEST_CASE("figures of a scene in one page look as each does alone") {
    if (!can_browse()) return;
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: Three\nbox: {size: [40, 30]}\ngas: [{count: 10, radius: 1, speed: 2}]\n"
                 "run: {until: 10}\nfilm: {seconds: 2}\nfigures:\n"
                 "  - {name: start, kind: gas, at: 0}\n"
                 "  - {name: speeds, kind: speed-histogram}\n"
                 "  - {name: entropy, kind: entropy}\n");
    REQUIRE(figures(folder, {"scene.yaml", "--formats", "svg"}).exit_code == 0);
    std::string page = "<!DOCTYPE html><html><head><title>Three</title></head><body>";
    for (const std::string name : {"start", "speeds", "entropy"}) {
        const std::string svg = contents(folder.path() / "out/scene" / (name + ".svg"));
        page += "<div>" + svg.substr(svg.find("<svg")) + "</div>";
    }
    folder.write("page.html", page + "</body></html>");
    const json answer = browsed("inlined", folder.path() / "page.html");
    CHECK(answer.at("bad") == json::array());
    CHECK(answer.at("same") == json{true, true, true});
    for (const json& bytes : answer.at("bytes")) CHECK(bytes.get<int>() > 2000);
}

TEST_CASE("films stand beside their figures, and are rendered once") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    const std::vector<std::string> command{"scene.yaml",
                                           "--page",
                                           "html",
                                           "--films",
                                           "--quiet",
                                           "--set",
                                           "film.size=[320, 180]",
                                           "--set",
                                           "film.seconds=3",
                                           "--set",
                                           "run.events=[{at: 0, caption: They fly}]"};
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
    // A film without captions offers none.
    CHECK(has(contents(out / "scene.html"), "kind=\"captions\""));
    std::vector<std::string> silent(command.begin(), command.end() - 2);
    silent.insert(silent.end(), {"-o", "silent"});
    REQUIRE(figures(folder, silent).exit_code == 0);
    const std::string page = contents(folder.path() / "silent/scene.html");
    CHECK(has(page, "kind=\"descriptions\""));
    CHECK_FALSE(has(page, "kind=\"captions\""));
    CHECK_FALSE(fs::exists(folder.path() / "silent/scene.captions.vtt"));
    // A page does not show the film of another scene.
    CHECK(figures(folder, {"scene.yaml", "--page", "html", "--seed", "5"}).exit_code == 0);
    CHECK_FALSE(has(contents(out / "scene.html"), "<video"));
}

TEST_CASE("a film beside the figures is made again when the scene beside its own has changed") {
    const TemporaryFolder folder;
    const std::string gas = "box: {size: [20, 15]}\ngas: [{count: 9, speed: 2}]\nrun: {until: 1}\n";
    folder.write("scene.yaml", "title: Two\n" + gas +
                                   "film: {seconds: 0.4, fps: 5, size: [64, 64], panels: [], "
                                   "beside: {scene: other.yaml, label: b, own_label: a}}\n"
                                   "figures: [{name: one, kind: gas}]\n");
    folder.write("other.yaml", "title: Other\n" + gas);
    const std::vector<std::string> command{"scene.yaml", "--films",   "-o",
                                           "out",        "--formats", "svg"};
    REQUIRE(figures(folder, command).exit_code == 0);
    const std::string film = contents(folder.path() / "out/scene.mp4");
    CHECK(figures(folder, command).out == "out: up to date, 1 figure\n");
    folder.write("other.yaml", "title: Other\nseed: 5\n" + gas);
    CHECK(figures(folder, command).out == "out: 1 film rendered\nout: up to date, 1 figure\n");
    CHECK((contents(folder.path() / "out/scene.mp4") != film));
}

TEST_CASE("a film beside figures is not rendered in a folder of the user") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: T\nbox: {size: [20, 15]}\ngas: [{count: 9, speed: 2}]\nrun: {until: 1}\n"
                 "film: {seconds: 0.4, fps: 5, size: [64, 64], panels: []}\n"
                 "figures: [{name: one, kind: gas}]\n");
    folder.write("out/.film/scene.mp4", "mine");
    CHECK(figures(folder, {"scene.yaml", "--films", "-o", "out"}).exit_code == 0);
    CHECK(contents(folder.path() / "out/.film/scene.mp4") == "mine");
    CHECK(contents(folder.path() / "out/scene.mp4").find("ftyp") == 4);
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
    const Outcome missing = figures(folder, {"scene.yaml", "--page", "none.html"});
    CHECK(missing.exit_code == 2);
    CHECK(missing.err == "none.html: error: cannot be read: No such file or directory\n");
    CHECK(figures(folder, {"scene.yaml", "--page", "mine.md,markdown"}).exit_code == 2);
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
    CHECK(has(missing.err, "needs figures as pdf or png, and `start` has neither"));
    CHECK(has(
        figures(folder, {"scene.yaml", "-o", "c", "--page", "markdown", "--formats", "pdf"}).err,
        "needs figures as svg or png"));
    // Before the work.
    CHECK_FALSE(fs::exists(folder.path() / "b"));
    CHECK_FALSE(fs::exists(folder.path() / "c"));
    // What is there already is shown, too.
    CHECK(figures(folder, {"scene.yaml", "--page", "latex", "--formats", "svg"}).exit_code == 0);
    CHECK(has(contents(folder.path() / "out/scene/scene.tex"), "start.png"));
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
