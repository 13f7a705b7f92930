// A film as a PDF: a page of vectors for each frame, read by Poppler.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string scene = R"(title: Disks & panels
box: {size: [20, 15]}
gas: [{name: light, count: 40, radius: 0.4, speed: 2}]
run: {until: 2}
film: {seconds: 1, fps: 12, size: [640, 360], panels: [speed-histogram]}
)";

std::string rendered(const TemporaryFolder& folder, const std::vector<std::string>& more = {}) {
    folder.write("scene.yaml", scene);
    std::vector<std::string> command{program, "render", "scene.yaml", "-o", "film.pdf", "--quiet"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run(command, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return contents(folder.path() / "film.pdf");
}

}  // namespace

TEST_CASE("a PDF has a page for each frame, of lines, curves and text, the same on all threads") {
    const TemporaryFolder folder;
    const std::string film = rendered(folder);
    CHECK(rendered(folder, {"--threads", "3"}) == film);
    const std::string about = run({"pdfinfo", "film.pdf"}, folder.path()).out;
    CHECK(has(about, "Pages:           12\n"));
    CHECK(has(about, "Page size:       480 x 270 pts"));
    CHECK(has(about, "Title:           Disks & panels\n"));
    CHECK(has(about, "PDF version:     1.4\n"));
    CHECK(has(about, "speed-histogram"));  // the scene is in it
    // Below the line of titles there are no pictures of pixels.
    const std::string images = run({"pdfimages", "-list", "film.pdf"}, folder.path()).out;
    CHECK(std::ranges::count(images, '\n') == 2);
    for (const std::string page : {"1", "12"})
        CHECK(has(run({"pdftotext", "-f", page, "-l", page, "film.pdf", "-"}, folder.path()).out,
                  "Disks & panels"));
    CHECK(folder.names() == std::vector<std::string>{"film.pdf", "scene.yaml"});
}

TEST_CASE("the first and the last page are the stills of the first and the last time") {
    const TemporaryFolder folder;
    rendered(folder);
    REQUIRE(run({"pdftoppm", "-r", "96", "film.pdf", "page"}, folder.path()).exit_code == 0);
    const auto still_at = [&](const std::string& time) {
        REQUIRE(run({program, "still", "scene.yaml", "--at", time, "-o", "still.pdf", "--quiet"},
                    folder.path())
                    .exit_code == 0);
        REQUIRE(run({"pdftoppm", "-r", "96", "-singlefile", "still.pdf", "still"}, folder.path())
                    .exit_code == 0);
        return contents(folder.path() / "still.ppm");
    };
    const auto page = [&](const std::string& number) {
        return contents(folder.path() / ("page-" + number + ".ppm"));
    };
    CHECK(page("01") == still_at("0"));
    CHECK(page("12") == still_at("2"));
    CHECK(page("01") != page("12"));
}

TEST_CASE("LaTeX takes the pages as frames of animate") {
    if (run({"kpsewhich", "animate.sty"}).out.empty()) {
        MESSAGE("the package animate is not installed: its pages are not set");
        return;
    }
    const TemporaryFolder folder;
    rendered(folder);
    folder.write("page.tex",
                 "\\documentclass{article}\\usepackage{graphicx,animate}\\begin{document}"
                 "\\animategraphics[controls,width=8cm]{12}{film}{}{}\\end{document}\n");
    const Outcome set =
        run({"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "page.tex"}, folder.path());
    CAPTURE(set.out);
    REQUIRE(set.exit_code == 0);
    // Every page of the film, and the script of the player, which counts frames from 0.
    const std::string log = contents(folder.path() / "page.log");
    for (int page = 1; page <= 12; ++page)
        CHECK(has(log, "<use film.pdf, page " + std::to_string(page) + ">"));
    CHECK(has(run({"pdfinfo", "-js", "page.pdf"}, folder.path()).out, "i<=11;"));
    CHECK(has(run({"pdfinfo", "page.pdf"}, folder.path()).out, "Pages:           1\n"));
}

TEST_CASE("what the pages of a PDF cannot be is refused") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const auto said = [&](const std::vector<std::string>& arguments) {
        std::vector<std::string> command{program};
        command.insert(command.end(), arguments.begin(), arguments.end());
        const Outcome outcome = run(command, folder.path());
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    CHECK(
        has(said({"render", "scene.yaml", "scene.yaml", "--join", "-o", "a.pdf"}), "do not fade"));
    CHECK(has(said({"render", "scene.yaml", "-o", "a.pdf", "--max-size", "1MB"}), "no pixels"));
    CHECK(has(said({"plan", "scene.yaml", "-o", "plan/", "--format", "pdf"}), "--format"));
    CHECK(has(said({"render", "scene.yaml", "-o", "a.pdf", "--page", "html"}), ".html"));
    CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
}
