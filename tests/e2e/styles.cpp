// Styles, and the words of figures as text: what the program makes of them, read by other programs.
#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "e2e/figure_folder.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// The colour of the pixel at the top left, as ffmpeg reads it.
std::string first_pixel(const fs::path& picture) {
    const Outcome outcome =
        run({"ffmpeg", "-v", "error", "-i", picture.string(), "-vf", "crop=1:1:0:0", "-frames:v",
             "1", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"});
    REQUIRE(outcome.out.size() == 3);
    std::string hex = "#";
    for (const char byte : outcome.out)
        for (const int digit : {static_cast<std::uint8_t>(byte) >> 4, byte & 15})
            hex += "0123456789abcdef"[digit];
    return hex;
}

// The words of an SVG, as librsvg takes them for text.
std::string words_in(const fs::path& svg) {
    const fs::path pdf = fs::path(svg).replace_extension("words.pdf");
    REQUIRE(run({"rsvg-convert", "-f", "pdf", "-o", pdf.string(), svg.string()}).exit_code == 0);
    return run({"pdftotext", pdf.string(), "-"}).out;
}

}  // namespace

TEST_CASE("films, stills and figures follow a style, wherever it is named") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", std::string(ten_disks) + "style: house.yaml\n");
    folder.write("plain.yaml", ten_disks);
    folder.write("house.yaml", "base: light\ncolors: {page: \"#ffeedd\"}\n");
    const auto done = [&](const std::vector<std::string>& words) {
        std::vector<std::string> command{program};
        command.insert(command.end(), words.begin(), words.end());
        const Outcome outcome = run(command, folder.path());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 0);
        return outcome;
    };
    done({"still", "scene.yaml", "-o", "still.png"});
    CHECK(first_pixel(folder.path() / "still.png") == "#ffeedd");
    done({"still", "plain.yaml", "--style", "house.yaml", "-o", "option.png"});
    CHECK(contents(folder.path() / "option.png") != "");
    CHECK(first_pixel(folder.path() / "option.png") == "#ffeedd");
    done({"still", "scene.yaml", "--style", "conference", "-o", "other.png"});
    CHECK(first_pixel(folder.path() / "other.png") == "#000000");
    done({"figures", "plain.yaml", "--style", "house.yaml", "--formats", "png", "-o", "figures"});
    CHECK(first_pixel(folder.path() / "figures/speeds.png") == "#ffeedd");
    // A changed style makes figures again.
    folder.write("house.yaml", "base: light\ncolors: {page: \"#ddeeff\"}\n");
    done({"figures", "plain.yaml", "--style", "house.yaml", "--formats", "png", "-o", "figures"});
    CHECK(first_pixel(folder.path() / "figures/speeds.png") == "#ddeeff");
    const Outcome depends =
        done({"still", "scene.yaml", "-o", "still.png", "--depfile", "still.d"});
    CHECK(has(contents(folder.path() / "still.d"), "house.yaml"));
}

TEST_CASE("pages have the colours and the font of the style of what they show") {
    const TemporaryFolder folder;
    folder.write("films/scene.yaml", std::string(ten_disks) + "style: house.yaml\n");
    folder.write("films/house.yaml",
                 "base: light\nfont: Inter\ncolors: {page: \"#ffeedd\", series: [\"#aa0000\"]}\n");
    const std::string page = " --page: #ffeedd;", font = " --family: Inter;";
    const auto follows = [&](const fs::path& file) {
        const std::string text = contents(folder.path() / file);
        CAPTURE(file.string());
        CHECK(has(text, page));
        CHECK(has(text, "--band: #aa0000;"));
        CHECK(has(text, font));
    };
    const std::vector<std::string> small{"--size", "160x90", "--fps", "2", "--quiet"};
    const auto done = [&](std::vector<std::string> words, bool is_small) {
        words.insert(words.begin(), program);
        if (is_small) words.insert(words.end(), small.begin(), small.end());
        const Outcome outcome = run(words, folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
    };
    done({"render", "films/scene.yaml", "--page", "html", "-o", "film.html"}, true);
    follows("film.html");
    done({"gallery", "films", "-o", "site"}, true);
    follows("site/index.html");
    done({"figures", "films/scene.yaml", "--page", "html", "-o", "book", "--quiet"}, false);
    follows("book/scene.html");
}

TEST_CASE("the chunks of a film carry its style with them") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", std::string(ten_disks) + "style: house.yaml\n");
    folder.write("house.yaml", "base: light\ncolors: {page: \"#ffeedd\"}\n");
    const auto size = std::vector<std::string>{"--size", "320x180", "--fps", "5", "--quiet"};
    const auto done = [&](std::vector<std::string> words) {
        words.insert(words.begin(), program);
        const Outcome outcome = run(words, folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
    };
    const auto with_size = [&](std::vector<std::string> words) {
        words.insert(words.end(), size.begin(), size.end());
        return words;
    };
    done(with_size({"render", "scene.yaml", "-o", "whole.mp4"}));
    done(with_size({"plan", "scene.yaml", "--chunks", "2", "-o", "plan"}));
    fs::remove(folder.path() / "house.yaml");
    done({"render", "plan", "--quiet"});
    done({"join", "plan", "-o", "joined.mp4", "--quiet"});
    CHECK(contents(folder.path() / "joined.mp4") == contents(folder.path() / "whole.mp4"));
}

TEST_CASE("a font that is not installed is an error with its place in the style") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", std::string(ten_disks) + "style: house.yaml\n");
    folder.write("house.yaml", "base: light\nfont: Interr\n");
    const Outcome outcome = run({program, "still", "scene.yaml", "-o", "a.png"}, folder.path());
    CHECK(outcome.exit_code == 2);
    CHECK(has(outcome.err, "house.yaml:2:7: error: this machine has no font `Interr`"));
    CHECK(has(outcome.err, "did you mean `Inter`?"));
    CHECK(!fs::exists(folder.path() / "a.png"));
    // The run alone needs no font.
    CHECK(run({program, "run", "scene.yaml"}, folder.path()).exit_code == 0);
}

TEST_CASE("pale colours of a style are notes, of check and of what draws") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", std::string(ten_disks) + "style: house.yaml\n");
    folder.write("house.yaml", "base: light\ncolors:\n  muted: \"#aaaaaa\"\n");
    const std::string note = "house.yaml:3:10: the contrast of `muted` with `page` is 2.32";
    const Outcome drawn = run({program, "still", "scene.yaml", "-o", "a.png"}, folder.path());
    CHECK(drawn.exit_code == 0);
    CHECK(has(drawn.err, note));
    CHECK(has(run({program, "check", "scene.yaml"}, folder.path()).out, note));
    const Outcome strict =
        run({program, "still", "scene.yaml", "--strict", "-o", "b.png"}, folder.path());
    CHECK(strict.exit_code == 2);
    CHECK(has(strict.err, "house.yaml:3:10: error: the contrast of `muted` with `page` is 2.32"));
    CHECK(!fs::exists(folder.path() / "b.png"));
}

TEST_CASE("the shipped styles have no faults") {
    for (const char* style : {"conference", "textbook"}) {
        const Outcome found =
            run({program, "check", library_scene("one-hot-particle"), "--style", style});
        if (has(found.err, "fonts-lmodern")) {
            MESSAGE("fonts-lmodern is not installed: ", style, " is not checked");
            continue;
        }
        CAPTURE(style);
        CAPTURE(found.out);
        CHECK(found.exit_code == 0);
        CHECK(!has(found.out, "contrast of"));
        CHECK(!has(found.out, "look alike"));
    }
}

TEST_CASE("words of an SVG are text for other programs, if a figure asks for it") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", std::string(ten_disks) + "style: house.yaml\n");
    folder.write("house.yaml", "font: Inter\n");
    const auto drawn = [&](const std::string& keys, const std::string& output) {
        CHECK(figures(folder, {"scene.yaml", "--set", "figure_defaults=" + keys, "--formats", "svg",
                               "-o", output})
                  .exit_code == 0);
        return folder.path() / output / "speeds.svg";
    };
    const fs::path text = drawn("{svg_text: text}", "text"), paths = drawn("{}", "paths");
    const std::string words = words_in(text);
    CAPTURE(words);
    CHECK(has(words, "Speed distribution"));
    CHECK(has(words, "speed"));
    CHECK(!has(words_in(paths), "Speed"));
    CHECK(has(contents(text), "font-family=\"'Inter', sans-serif\""));
    CHECK(!has(contents(text), "glyph"));
    CHECK(!has(contents(text), "0.12345"));  // no mark of a text is left
    CHECK(contents(text).size() < contents(paths).size());
    // Drawn by librsvg, both look the same: the mean difference of grey levels is small.
    for (const fs::path& one : {text, paths})
        CHECK(run({"rsvg-convert", one.string(), "-o", one.string() + ".png"}).exit_code == 0);
    const Outcome compared =
        run({"ffmpeg", "-i", text.string() + ".png", "-i", paths.string() + ".png", "-lavfi",
             "[0]format=gray[a];[1]format=gray[b];[a][b]psnr", "-f", "null", "-"});
    const std::size_t at = compared.err.find("average:");
    REQUIRE(at != std::string::npos);
    const std::string average = compared.err.substr(at + std::string("average:").size());
    CHECK((average.starts_with("inf") || std::stod(average) > 30.0));
}

TEST_CASE("a figure has the words at its axes that the scene gives") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    CHECK(figures(folder, {"scene.yaml", "--set", "figures.speeds.x_title=celerity <c>", "--set",
                           "figures.speeds.y_title=how many", "--formats", "pdf,csv"})
              .exit_code == 0);
    const Outcome words = run({"pdftotext", "speeds.pdf", "-"}, folder.path() / "out/scene");
    CHECK(has(words.out, "celerity <c>"));
    CHECK(has(words.out, "how many"));
    // Data keep their names.
    CHECK(!has(contents(folder.path() / "out/scene/speeds.csv"), "celerity"));
    CHECK(
        figures(folder, {"scene.yaml", "--set",
                         "figures.0={name: sweep, kind: sweep, vary: 'gas.0.speed=1:2:2', number: "
                         "temperature, y_title: how hot}",
                         "--formats", "pdf"})
            .exit_code == 0);
    CHECK(has(run({"pdftotext", "sweep.pdf", "-"}, folder.path() / "out/scene").out, "how hot"));
}
