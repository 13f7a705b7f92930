// The film in a browser: headless Chromium plays it and shows the colours that were drawn. Skipped
// where it is not installed.
#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "e2e/program.h"
#include "e2e/still_life.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// What page.html says of the film beside it, or nothing where there is no browser.
nlohmann::json played(const TemporaryFolder& folder, const std::string& film) {
    fs::copy(root / "tests/e2e/page.html", folder.path() / "page.html");
    const fs::path page = folder.path() / "page.html";
    const Outcome outcome =
        run({"timeout", "90", "chromium", "--headless", "--no-sandbox", "--disable-gpu",
             "--no-first-run", "--disable-background-networking", "--disable-component-update",
             "--disable-sync", "--allow-file-access-from-files",
             "--autoplay-policy=no-user-gesture-required",
             "--user-data-dir=" + (folder.path() / "profile").string(), "--dump-dom",
             "file://" + page.string() + "#" + film});
    const std::size_t begin = outcome.out.find("<pre id=\"out\">");
    REQUIRE(begin != std::string::npos);
    const std::size_t text = begin + std::string("<pre id=\"out\">").size();
    const std::string said = outcome.out.substr(text, outcome.out.find("</pre>", text) - text);
    CAPTURE(said);
    REQUIRE(said.starts_with("{"));
    return nlohmann::json::parse(said);
}

bool has_browser() {
    if (is_installed("chromium")) return true;
    MESSAGE("chromium is not installed: the film is not tried in a browser");
    return false;
}

}  // namespace

TEST_CASE("headless Chromium plays the film in the colours that were drawn") {
    if (!has_browser()) return;
    const TemporaryFolder folder;
    folder.write("scene.yaml", still_life);
    REQUIRE(run({program, "render", "scene.yaml", "-o", "film.mp4", "--quiet"}, folder.path())
                .exit_code == 0);
    const nlohmann::json answer = played(folder, "film.mp4");
    CHECK(answer["width"] == 640);
    CHECK(answer["height"] == 360);
    CHECK(answer["duration"].get<double>() == doctest::Approx(2.0).epsilon(1e-6));
    CHECK(answer["plays"] == true);

    // The page, the disk, the ground. Limited range and the quantiser cost up to 4 of 255 on flat
    // ground.
    const std::array<std::array<int, 3>, 3> drawn{
        {{0xFF, 0xFF, 0xFF}, {0x56, 0xB4, 0xE9}, {0xFF, 0xFF, 0xFF}}};
    for (std::size_t pixel = 0; pixel < drawn.size(); ++pixel)
        for (std::size_t channel = 0; channel < 3; ++channel)
            CHECK(std::abs(answer["colors"][pixel][channel].get<int>() - drawn[pixel][channel]) <=
                  4);
}

TEST_CASE("headless Chromium shows what lies behind a WebM without a ground") {
    if (!has_browser()) return;
    const TemporaryFolder folder;
    folder.write("scene.yaml", still_life);
    REQUIRE(run({program, "render", "scene.yaml", "-o", "film.webm", "--quiet", "--ground", "none"},
                folder.path())
                .exit_code == 0);
    const nlohmann::json answer = played(folder, "film.webm");
    CHECK(answer["plays"] == true);
    CHECK(answer["colors"][0][3] == 0);  // the page
    const std::array<int, 4> disk{0x56, 0xB4, 0xE9, 255}, ground{255, 255, 255, 255};
    for (std::size_t channel = 0; channel < 4; ++channel) {
        CHECK(std::abs(answer["colors"][1][channel].get<int>() - disk[channel]) <= 4);
        CHECK(std::abs(answer["colors"][2][channel].get<int>() - ground[channel]) <= 4);
    }
}
