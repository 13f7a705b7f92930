// Words of strangers in all that carom writes: read by other programs they are words, and neither
// script nor markup nor commands.
#include "support/hostile_words.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

// Where formulae and numbers may stand, dollar signs and braces are written so.
std::string with_dollars(const std::string& words) {
    std::string text;
    for (const char c : words)
        text += c == '$' ? "\\$" : std::string(c == '{' || c == '}' ? 2 : 1, c);
    return text;
}

std::string joined(std::size_t first, std::size_t last) {
    std::string text;
    for (std::size_t k = first; k < last; ++k)
        text += (text.empty() ? "" : " ") + hostile_words.at(k);
    return text;
}

const std::string title = joined(0, 6);

json figures_of_scene() {
    json runs = json::array();
    for (std::size_t k = 0; k < 6; ++k)
        runs.push_back({{"label", hostile_words[k]}, {"set", fmt::format("seed={}", k + 1)}});
    const std::string all = with_dollars(all_hostile_words());
    return {{{"name", "gas"}, {"kind", "gas"}, {"at", 1}, {"caption", all}, {"alt", all}},
            {{"name", "energies"}, {"kind", "energy-by-species"}, {"at", 1}, {"title", title}},
            {{"name", "runs"}, {"kind", "speed-histogram"}, {"at", 1}, {"compare", runs}}};
}

// Each word is the name of a species and a caption, and stands in all other places for words.
json scene() {
    json gas = json::array(), events = json::array();
    for (std::size_t k = 0; k < hostile_words.size(); ++k) {
        gas.push_back({{"name", hostile_words[k]}, {"count", 1}, {"radius", 0.3}, {"speed", 1}});
        events.push_back({{"at", k}, {"caption", with_dollars(hostile_words[k])}});
    }
    gas[0]["label"] = hostile_words[4];
    events.push_back({{"at", 0.5}, {"mark", hostile_words[5]}});
    return {{"title", title},
            {"subtitle", joined(6, 12)},
            {"description", all_hostile_words()},
            {"box", {{"size", {40, 30}}}},
            {"partitions", {{{"name", hostile_words[0]}, {"x", 20}, {"gaps", {{10, 20}}}}}},
            {"gas", gas},
            {"run", {{"until", hostile_words.size()}, {"events", events}}},
            {"film",
             {{"seconds", 3 * hostile_words.size()},  // a caption needs 2.5
              {"fps", 4},
              {"size", {320, 180}},
              {"title_card", 1},
              {"end_card", with_dollars(joined(12, 16))},
              {"panels",
               {{{"kind", "text"}, {"words", with_dollars(joined(4, 9))}},
                {{"kind", "energy-by-species"}, {"title", hostile_words[1]}}}}}},
            {"figures", figures_of_scene()}};
}

// Anywhere without a backslash before it that is not itself escaped.
bool stands_bare(const std::string& text, const std::string& part) {
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) {
        std::size_t backslashes = 0;
        while (backslashes < at && text[at - 1 - backslashes] == '\\') ++backslashes;
        if (backslashes % 2 == 0) return true;
    }
    return false;
}

// What Liquid makes of a page, as Jekyll lets it before it reads Markdown: the same page, if there
// are no tags in it. An unknown tag is an error.
void check_liquid(const std::string& page) {
    for (const char* tag : {"{%", "{{"}) CHECK_FALSE(has(page, tag));
    if (!is_installed("node") || !fs::exists(root / "build/npm/node_modules/liquidjs")) {
        MESSAGE("node or build/npm is not there: pages are not read by Liquid");
        return;
    }
    const TemporaryFolder folder;
    folder.write("page", page);
    const auto read = [&](const std::string& before) {
        return run({"env", "NODE_PATH=" + (root / "build/npm/node_modules").string(), "node", "-e",
                    "const { Liquid } = require('liquidjs');"
                    "const page = process.argv[1] + require('fs').readFileSync('page', 'utf8');"
                    "new Liquid().parseAndRender(page, { site: { title: 'CANARY' } })"
                    ".then(text => process.stdout.write(text));",
                    before},
                   folder.path());
    };
    const Outcome outcome = read("");
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out == page);
    CHECK(read("\\{{ site.title }}").out == "\\CANARY" + page);  // a backslash hides nothing
}

// A Markdown page as GitHub and other readers show it: no link or picture but its own files.
void check_markdown(const fs::path& page) {
    if (!is_installed("pandoc")) return;
    for (const char* reader : {"gfm", "markdown+autolink_bare_uris"}) {
        CAPTURE(reader);
        const Outcome read = run({"pandoc", "-f", reader, "-t", "html", page.string()});
        CHECK(read.exit_code == 0);
        CHECK(has(read.out, "http://a.bc www.a.bc a@a.bc doi:10.1/a"));
        for (const char* active :
             {"href=\"http", "mailto:a", "href=\"doi", "<script", "<b>", "onerror=pwned()>"})
            CHECK_FALSE(has(read.out, active));
    }
}

class HostileScene {
  public:
    HostileScene() {
        folder.write("scene.yaml", scene().dump());
        folder.write("canary.tex", "CANARYTEXT\n");
    }

    Outcome call(const std::string& arguments) const {
        const Outcome outcome = shell("'" + program + "' " + arguments, folder.path());
        CAPTURE(arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 0);
        CHECK_FALSE(fs::exists(folder.path() / "pwned"));
        return outcome;
    }
    fs::path path(const std::string& name) const { return folder.path() / name; }

    TemporaryFolder folder;
};

struct Checker : pugi::xml_tree_walker {
    bool for_each(pugi::xml_node& node) override {
        const std::string name = node.name();
        CAPTURE(name);
        CHECK(node.type() != pugi::node_pi);
        CHECK(node.type() != pugi::node_comment);
        CHECK(node.type() != pugi::node_cdata);
        CHECK(node.type() != pugi::node_doctype);
        for (const char* active : {"script", "foreignObject", "iframe", "a", "b", "set", "animate",
                                   "handler", "style", "object", "embed"})
            CHECK(name != active);
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            const std::string its = attribute.name(), value = attribute.value();
            CHECK_FALSE(its.starts_with("on"));
            const bool is_link = its.ends_with("href");
            CHECK((!is_link || value.starts_with("#") || value.starts_with("data:image/png;")));
            CHECK((value.find("url(") == value.npos || value.find("url(#") != value.npos));
        }
        return true;
    }
};

void check_svg(const fs::path& path) {
    CAPTURE(path.string());
    pugi::xml_document svg;
    REQUIRE(svg.load_file(path.c_str(), pugi::parse_full));
    Checker checker;
    CHECK(svg.child("svg"));
    svg.child("svg").traverse(checker);
}

// What Chromium has made of it, with what it says of scripts; a call of pwned() is an error there.
Outcome in_browser(const fs::path& page) {
    const TemporaryFolder profile;
    return run({"timeout", "90", "chromium", "--headless", "--no-sandbox", "--disable-gpu",
                "--no-first-run", "--disable-background-networking", "--disable-component-update",
                "--disable-sync", "--enable-logging=stderr",
                "--user-data-dir=" + profile.path().string(), "--dump-dom",
                "file://" + page.string()});
}

void check_vtt(const fs::path& path) {
    CAPTURE(path.string());
    const std::string text = contents(path);
    CHECK(text.starts_with("WEBVTT\n\n"));
    std::istringstream lines(text.substr(8));
    bool begins = true;
    for (std::string line; std::getline(lines, line); begins = line.empty()) {
        CAPTURE(line);
        const bool is_time = line.find("-->") != line.npos;
        CHECK((line.empty() || is_time == begins));
        if (is_time) CHECK(line.size() == std::string("00:00:00.000 --> 00:00:00.000").size());
        CHECK(line.find('<') == line.npos);
        CHECK((is_time || line.find('>') == line.npos));
    }
}

}  // namespace

TEST_CASE("pictures have the words of strangers as words") {
    const HostileScene hostile;
    hostile.call("figures scene.yaml -o out --quiet --formats svg,pdf,png");
    hostile.call("still scene.yaml --quiet --at 3 -o still.svg");
    for (const char* name : {"out/gas.svg", "out/energies.svg", "out/runs.svg", "still.svg"})
        check_svg(hostile.path(name));
    pugi::xml_document svg;
    REQUIRE(svg.load_file(hostile.path("out/gas.svg").c_str()));
    CHECK(svg.child("svg").child_value("desc") == all_hostile_words());
    const Outcome pdf = run({"pdfinfo", hostile.path("out/gas.pdf").string()});
    CHECK(has(pdf.out, "JavaScript:      no"));
    CHECK(has(pdf.out, hostile_words[0]));
    const json found = json::parse(contents(hostile.path("out/captions.json")));
    CHECK(found.dump().find("pwned()") != std::string::npos);
    if (!is_installed("chromium")) return;
    for (const char* name : {"out/gas.svg", "still.svg"}) {
        const Outcome seen = in_browser(hostile.path(name));
        CHECK(has(seen.out, "<svg"));
        CHECK_FALSE(has(seen.out, "<script"));
        CHECK_FALSE(has(seen.err, "pwned"));
    }
}

TEST_CASE("pages have the words of strangers as words") {
    const HostileScene hostile;
    hostile.call("figures scene.yaml -o out --quiet --page markdown,html,latex");
    const std::string markdown = contents(hostile.path("out/scene.md"));
    for (const char* active : {"<script", "<img", "<svg", "<b>", "[a](", "](x)", "<?"})
        CHECK_FALSE(stands_bare(markdown, active));
    check_liquid(markdown);
    check_liquid(contents(hostile.path("out/scene.html")));
    check_markdown(hostile.path("out/scene.md"));
    if (is_installed("chromium")) {
        const Outcome seen = in_browser(hostile.path("out/scene.html"));
        CHECK(has(seen.out, "<title>&lt;script&gt;pwned()&lt;/script&gt;"));
        CHECK_FALSE(has(seen.out, "<script"));
        CHECK_FALSE(has(seen.out, "onerror=pwned()>\n"));
        CHECK_FALSE(has(seen.out, "src=\"x\""));
        CHECK_FALSE(has(seen.err, "pwned"));
    }
    if (!is_installed("pdflatex")) return;
    hostile.folder.write("text.tex",
                         "\\documentclass{article}\n\\usepackage{graphicx}\n"
                         "\\newcommand{\\caromfolder}{out/}\n\\begin{document}\n"
                         "\\input{out/scene}\n\\end{document}\n");
    run({"pdflatex", "-no-shell-escape", "-interaction=nonstopmode", "text.tex"},
        hostile.folder.path());
    const Outcome text = run({"pdftotext", "-layout", "text.pdf", "-"}, hostile.folder.path());
    CHECK(has(text.out, "\\input{canary}"));
    CHECK_FALSE(has(text.out, "CANARYTEXT"));
    CHECK_FALSE(fs::exists(hostile.path("pwned")));
}

TEST_CASE("the words of a film are words in players") {
    const HostileScene hostile;
    hostile.call("render scene.yaml --quiet --quality draft --words -o film.mp4");
    for (const char* part : {"captions", "chapters", "descriptions"})
        check_vtt(hostile.path(fmt::format("film.{}.vtt", part)));
    CHECK(has(contents(hostile.path("film.captions.vtt")), "\n00:00.000 --&gt; 99:59.000\n"));
    CHECK(has(contents(hostile.path("film.transcript.txt")), hostile_words[0]));
    const Outcome tags = run({"ffprobe", "-v", "error", "-of", "json", "-show_format", "film.mp4"},
                             hostile.folder.path());
    CHECK(json::parse(tags.out)["format"]["tags"]["title"] == title);
}

TEST_CASE("tables and JSON give the words of strangers back exactly") {
    const HostileScene hostile;
    const Outcome ran = hostile.call("run scene.yaml --quiet --json - --csv samples.csv");
    const Outcome checked = hostile.call("check scene.yaml --json");
    CHECK(json::parse(checked.out)[0]["title"] == title);
    const json species = json::parse(checked.out)[0]["species"],
               of_run = json::parse(ran.out)["species"];
    const Outcome names = run({"python3", "-c",
                               "import csv, json, sys\n"
                               "rows = list(csv.reader(open(sys.argv[1], newline='')))\n"
                               "print(json.dumps([row[2] for row in rows[1:]]))",
                               hostile.path("samples.csv").string()});
    const json read = json::parse(names.out);
    for (std::size_t k = 0; k < hostile_words.size(); ++k) {
        CHECK(species[k]["name"] == hostile_words[k]);
        CHECK(of_run[k]["name"] == hostile_words[k]);
        CHECK(read[k] == hostile_words[k]);
    }
}

TEST_CASE("names of files are words, and no addresses or commands, on pages") {
    const TemporaryFolder folder;
    const std::string name = "javascript:pwned()'\"><script>pwned()<script>";
    json calm = {{"title", "Calm"},
                 {"box", {{"size", {40, 30}}}},
                 {"gas", {{{"count", 5}, {"speed", 1}}}},
                 {"run", {{"until", 2}}},
                 {"film", {{"seconds", 1}, {"size", {320, 180}}}},
                 {"figures", {{{"name", "gas"}, {"kind", "gas"}, {"at", 1}}}}};
    folder.write(name + ".yaml", calm.dump());
    folder.write("page.tex", "{{#films}}{{film}}{{/films}}\n");
    const auto made = [&](const std::string& page, const std::string& scene_name) {
        return run({program, "figures", scene_name + ".yaml", "-o", page, "--quiet", "--films",
                    "--page", page},
                   folder.path());
    };
    CHECK(made("html", name).exit_code == 0);
    const std::string html = contents(folder.path() / "html" / (name + ".html"));
    CHECK(made("markdown", name).exit_code == 0);
    CHECK(has(html, "href=\"./javascript:pwned"));
    CHECK_FALSE(has(html, "\"javascript:"));
    CHECK_FALSE(has(html, "<script>"));
    const std::string markdown = contents(folder.path() / "markdown" / (name + ".md"));
    CHECK(has(markdown, "](./javascript:pwned"));
    CHECK_FALSE(has(markdown, "](javascript:"));
    folder.write("a\\input{canary}.yaml", calm.dump());
    const Outcome latex = run({program, "figures", "a\\input{canary}.yaml", "-o", "latex",
                               "--films", "--page", "page.tex"},
                              folder.path());
    CHECK(latex.exit_code == 2);
    CHECK(has(latex.err, "a\\input{canary}.mp4: a LaTeX page cannot name this file"));
}
