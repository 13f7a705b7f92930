// Scenes in documents of pandoc, by the filter in integrations/pandoc: what pages, PDF, Word and
// EPUB have of them. Skipped where pandoc is not installed.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "e2e/in_documents.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string filter = "../pandoc/carom.lua";

// That of pandoc needs more packages of LaTeX.
const std::string small_template =
    "\\documentclass{article}\n\\usepackage{graphicx}\n\\usepackage{hyperref}\n"
    "\\setkeys{Gin}{width=0.8\\linewidth,keepaspectratio}\n\\providecommand{\\tightlist}{}\n"
    "\\providecommand{\\pandocbounded}[1]{#1}\n\\begin{document}\n$body$\n\\end{document}\n";

bool has_pandoc() {
    if (is_installed("pandoc")) return true;
    MESSAGE("pandoc is not installed: its filter is not tried");
    return false;
}

// lecture.md as `name`, with further options.
Outcome made(const ExampleDocuments& example, const std::string& name,
             const std::vector<std::string>& options = {}) {
    std::vector<std::string> command{"pandoc", "-s", "lecture.md", "-L", filter, "-o", name};
    command.insert(command.end(), options.begin(), options.end());
    const Outcome outcome = example.call(command);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    return outcome;
}

std::vector<std::string> names_in_zip(const fs::path& path) {
    const Outcome names = run({"/usr/bin/python3", "-c",
                               "import sys, zipfile\n"
                               "for name in zipfile.ZipFile(sys.argv[1]).namelist(): print(name)",
                               path.string()});
    std::vector<std::string> lines;
    std::istringstream text(names.out);
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

// What stands between quotes after each `name=`.
std::vector<std::string> values_of(const std::string& html, const std::string& name) {
    std::vector<std::string> values;
    const std::string begin = " " + name + "=\"";
    for (std::size_t at = html.find(begin); at != html.npos; at = html.find(begin, at + 1)) {
        const std::size_t from = at + begin.size();
        values.push_back(html.substr(from, html.find('"', from) - from));
    }
    return values;
}

// Plays the film of a page, and writes what its captions show then into the page.
const std::string player_of_page =
    "<pre id=\"out\">waiting</pre><script>\n"
    "const film = document.querySelector('video'), out = document.getElementById('out');\n"
    "let done = false;\n"
    "const keep_loading = () => { if (done) return; const picture = new Image();\n"
    "  picture.onload = picture.onerror = keep_loading;\n"
    "  picture.src = URL.createObjectURL(new Blob(['no picture'])); };\n"
    "const say = text => { done = true; out.textContent = text; };\n"
    "keep_loading();\n"
    "const begun = !film.paused;\n"
    "film.muted = true; film.currentTime = 2;\n"
    "film.addEventListener('error', () => say('error'));\n"
    "film.addEventListener('seeked', async () => { await film.play();\n"
    "  setTimeout(() => say(JSON.stringify({begun, plays: film.currentTime > 2.1,\n"
    "    words: [...film.textTracks[0].activeCues].map(cue => cue.text).join(),\n"
    "    shows: film.textTracks[0].mode})), 700); }, {once: true});\n"
    "setTimeout(() => say('error: too slow'), 30000);\n"
    "</script>\n";

nlohmann::json played(const ExampleDocuments& example, const std::string& page,
                      const std::vector<std::string>& flags = {}) {
    example.write("played.html", example.text(page) + player_of_page);
    std::vector<std::string> command{"timeout",
                                     "90",
                                     "chromium",
                                     "--headless",
                                     "--no-sandbox",
                                     "--disable-gpu",
                                     "--no-first-run",
                                     "--disable-background-networking",
                                     "--disable-component-update",
                                     "--disable-sync",
                                     "--allow-file-access-from-files",
                                     "--autoplay-policy=no-user-gesture-required",
                                     "--user-data-dir=" + example.path("profile").string()};
    command.insert(command.end(), flags.begin(), flags.end());
    command.insert(command.end(), {"--dump-dom", "file://" + example.path("played.html").string()});
    const Outcome seen = run(command);
    const std::string begin = "<pre id=\"out\">";
    const std::size_t at = seen.out.find(begin);
    REQUIRE(at != std::string::npos);
    const std::size_t from = at + begin.size();
    const std::string said = seen.out.substr(from, seen.out.find("</pre>", from) - from);
    CAPTURE(said);
    REQUIRE(said.starts_with("{"));
    return nlohmann::json::parse(said);
}

}  // namespace

TEST_CASE("a page of pandoc has the film, its words and the pictures of the example") {
    if (!has_pandoc()) return;
    const ExampleDocuments example;
    CHECK(made(example, "lecture.html").err.empty());
    const std::string html = example.text("lecture.html");
    for (const std::string& name : {std::string("src"), std::string("poster")})
        for (const std::string& address : values_of(html, name)) {
            CAPTURE(address);
            CHECK(fs::file_size(example.path(address)) > 50);
        }
    CHECK(values_of(html, "poster").size() == 1);
    CHECK(values_of(html, "kind") ==
          std::vector<std::string>{"captions", "chapters", "descriptions"});
    CHECK(has(html, "<figure id=\"fig-gas\">"));
    CHECK(has(html, "href=\"#fig-gas\""));
    CHECK(has(html, "One fast disk meets <em>forty</em> slow ones"));
    CHECK(has(html, "aria-label=\"One fast disk meets forty slow ones\""));
    CHECK(has(html, "alt=\"Six disks in a box\""));
    const Outcome length =
        run({"ffprobe", "-v", "error", "-show_entries", "format=duration", "-of", "csv=p=0",
             example.path("carom-media/" + example.media(".mp4").at(0)).string()});
    CHECK(std::stod(length.out) == doctest::Approx(8.0));
    if (!is_installed("chromium")) return;
    const nlohmann::json seen = played(example, "lecture.html");
    CHECK(seen["begun"] == false);
    CHECK(seen["plays"] == true);
    CHECK(seen["shows"] == "showing");
    CHECK(seen["words"] == "One fast disk has nearly all of the energy");
}

TEST_CASE("what pandoc has made of a scene is made again when the scene has changed") {
    if (!has_pandoc()) return;
    const ExampleDocuments example;
    made(example, "lecture.html");
    const fs::path film = example.path("carom-media/" + example.media(".mp4").at(0));
    const auto written = fs::last_write_time(film);
    const std::string html = example.text("lecture.html");
    made(example, "lecture.html");
    CHECK(fs::last_write_time(film) == written);
    CHECK(example.text("lecture.html") == html);
    example.write("gas.yaml", example.text("gas.yaml") + "# another\n");
    made(example, "lecture.html");
    CHECK(example.media(".mp4").size() == 2);
    CHECK(example.text("lecture.html") != html);
}

TEST_CASE("PDF, Word, EPUB and slides of pandoc have the pictures of the example") {
    if (!has_pandoc()) return;
    const ExampleDocuments example;
    made(example, "lecture.docx");
    made(example, "lecture.epub");
    for (const char* name : {"lecture.docx", "lecture.epub"}) {
        CAPTURE(name);
        const std::vector<std::string> names = names_in_zip(example.path(name));
        CHECK(std::ranges::count_if(
                  names, [](const std::string& one) { return one.ends_with(".png"); }) == 3);
    }
    CHECK(example.media(".mp4").empty());
    fs::create_directory(example.path("site"));
    made(example, "site/slides.html", {"-t", "revealjs"});
    const std::string slides = example.text("site/slides.html");
    const std::string poster = values_of(slides, "poster").at(0);
    CHECK(poster.starts_with("carom-media/"));
    CHECK(fs::exists(example.path("site/" + poster)));
    if (!is_installed("pdflatex")) return;
    example.write("small.tex", small_template);
    made(example, "lecture.pdf", {"--template", "small.tex"});
    const std::string words = run({"pdftotext", "lecture.pdf", "-"}, example.place()).out;
    CHECK(has(words, "Figure 1: One fast disk meets forty slow ones"));
    CHECK(has(words, "Figure 2: The speeds at the end"));
    CHECK(has(words, "equipartition"));  // a word in the picture of the film
    const std::string pixels = run({"pdfimages", "-list", "lecture.pdf"}, example.place()).out;
    CHECK_FALSE(has(pixels, " image "));
    made(example, "lecture.tex");
    const std::string latex = example.text("lecture.tex");
    CHECK(has(latex, "\\label{fig-gas}"));
    CHECK((has(latex, "\\hyperlink{fig-gas}") || has(latex, "\\hyperref[fig-gas]")));
}

TEST_CASE("a film that begins by itself does not where reduced motion is asked for") {
    if (!has_pandoc() || !is_installed("chromium")) return;
    const ExampleDocuments example;
    example.write("lecture.md", "![A gas](gas.yaml){autoplay=true}\n");
    made(example, "lecture.html", {"--metadata", "title=T"});
    CHECK(played(example, "lecture.html")["begun"] == true);
    CHECK(played(example, "lecture.html", {"--force-prefers-reduced-motion"})["begun"] == false);
}

TEST_CASE("a hostile document is refused by the filter, or its words are words") {
    if (!has_pandoc()) return;
    const ExampleDocuments example;
    const auto call = [&](const std::string& document) {
        example.write("lecture.md", document);
        const Outcome outcome = example.call({"pandoc", "-s", "lecture.md", "-L", filter,
                                              "--metadata", "title=T", "-o", "lecture.html"});
        CHECK_FALSE(fs::exists(example.path("pwned")));
        return outcome;
    };
    for (const std::string& name : hostile_names) {
        CAPTURE(name);
        std::string address;  // as a document may write any letter
        for (const char letter : name)
            address += fmt::format("%{:02x}", static_cast<unsigned char>(letter));
        const Outcome outcome = call("![words](" + address + ".yaml)\n");
        CHECK(outcome.exit_code == 1);
        CHECK(outcome.err.starts_with("carom: a scene is named by letters"));
    }
    for (const char* options :
         {"at=\"1; touch pwned\"", "at=-1", "film=\"<script>\"", "kind=../x", "theme=\"$(x)\""}) {
        CAPTURE(options);
        const Outcome outcome = call(fmt::format("![words](gas.yaml){{{}}}\n", options));
        CHECK(outcome.exit_code == 1);
        CHECK(has(outcome.err, ": expected "));
    }
    const Outcome late = call("![words](gas.yaml){at=99}\n");
    CHECK(late.exit_code == 1);
    CHECK(has(late.err, "--at 99: the scene runs from 0 to 4"));
    const Outcome large = call(
        "```carom\ntitle: T\nbox: {size: [9, 9]}\ngas: [{count: 2}]\nrun: {until: 200}\n```\n");
    CHECK(large.exit_code == 1);
    CHECK(has(large.err, "the limit is 120 seconds of a film, with --limits classroom"));
    const std::string words = "\\\"><script>pwned()</script> \\\\input{canary} $(touch pwned)";
    const std::string own = "title: T\ndescription: \"" + words +
                            "\"\nbox: {size: [9, 9]}\n"
                            "gas: [{count: 2}]\nrun: {until: 1}\nfilm: {size: [320, 180]}\n```\n";
    CHECK(call("```carom\n" + own).exit_code == 0);
    CHECK_FALSE(has(example.text("lecture.html"), "<script>pwned"));
    CHECK(has(example.text("lecture.html"), "&lt;script&gt;pwned()"));
    CHECK(call("```{.carom film=false caption=\"" + words + "\"}\n" + own).exit_code == 0);
    CHECK_FALSE(has(example.text("lecture.html"), "<script>pwned"));
    made(example, "lecture.tex");
    CHECK(has(example.text("lecture.tex"), "\\textbackslash"));
    CHECK_FALSE(has(example.text("lecture.tex"), "\\input{canary}"));
    CHECK(call("![words](gas.yaml){film=true width=\"1\\\" onload=pwned()\" "
               "alt=\"\\\"><script>pwned()</script>\"}\n")
              .exit_code == 0);
    CHECK_FALSE(has(example.text("lecture.html"), "<script>pwned"));
    CHECK_FALSE(has(example.text("lecture.html"), "onload"));
}
