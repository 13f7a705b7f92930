// What carom check --measure says of films, against the films; and films that are to fit.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"
#include "support/share_of_cases.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

double bytes_below(const fs::path& folder) {
    double bytes = 0.0;
    for (const auto& file : fs::recursive_directory_iterator(folder))
        if (file.is_regular_file()) bytes += static_cast<double>(file.file_size());
    return bytes;
}

json film_of(const std::string& options, const fs::path& folder) {
    const Outcome outcome = shell("'" + program + "' check --quiet --json " + options, folder);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out).at(0).at("film");
}

// The size that was measured, as a share of that of the film.
double share(const std::string& options) {
    const TemporaryFolder folder;
    const json measured = film_of("--measure " + options, folder.path()).at("measured");
    CHECK(folder.names().empty());
    const Outcome outcome = shell("'" + program + "' render --quiet " + options, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(measured.at("seconds") > 0.0);
    return measured.at("bytes").get<double>() / bytes_below(folder.path());
}

std::vector<std::string> library() {
    std::vector<std::string> scenes;
    for (const auto& file : fs::directory_iterator(root / "scenes"))
        if (file.path().extension() == ".yaml") scenes.push_back(file.path().string());
    std::ranges::sort(scenes);
    return scenes;
}

// Two scenes of 2 seconds, and the set of them.
void write_set(const TemporaryFolder& folder, const std::string& words) {
    for (const char* name : {"one", "two"})
        folder.write(
            std::string(name) + ".yaml",
            fmt::format("title: Small\nbox: {{size: [20, 10]}}\n"
                        "gas: [{{name: a, count: 4, radius: 0.3, speed: 1}}]\n"
                        "run: {{until: 2}}\nfilm: {{seconds: 2, fps: 10, size: [64, 64]}}\n"
                        "figures: [{{name: of-{}, kind: gas}}]\n",
                        name));
    folder.write("set.yaml", fmt::format("title: {}\ndescription: {}\n"
                                         "scenes: [one.yaml, two.yaml]\n",
                                         words, words));
}

}  // namespace

// The slow tests see every scene; the others every third, as many as color_by has values.
TEST_CASE("the size of a film is measured within a third, for scenes with every color_by") {
    const std::vector<std::string> colors{"speed",     "speed-class", "energy",
                                          "direction", "species",     "mass"};
    const std::vector<std::string> scenes = library();
    const auto step = static_cast<std::size_t>(every_nth(3, 3));
    REQUIRE(scenes.size() >= step * colors.size());
    for (std::size_t k = 0; k < scenes.size(); k += step) {
        const std::string options =
            fmt::format("'{}' --size 320x180 --seconds 4 --set film.color_by={}", scenes[k],
                        colors[k / step % colors.size()]);
        CAPTURE(options);
        CHECK(std::abs(std::log(share(options))) < std::log(4.0 / 3.0));
    }
}

TEST_CASE("the size of a film is measured in every format and quality") {
    for (const char* more :
         {"--format webm", "--format gif", "--format png", "--quality draft", "--quality final",
          "--format webm --quality final", "--from 10 --to 20", "--fps 12"}) {
        const std::string options =
            fmt::format("'{}' --size 320x180 --seconds 4 {}", library_scene("mixed-masses"), more);
        CAPTURE(options);
        CHECK(std::abs(std::log(share(options))) < std::log(4.0 / 3.0));
    }
}

TEST_CASE("carom check takes what carom render takes of a film") {
    const TemporaryFolder folder;
    const std::string scene = "'" + library_scene("mixed-masses") + "' ";
    const std::string span = scene + "--size 320x180 --fps 20 --seconds 6 --from 15 --to 30 ";
    const json film = film_of(span + "--format webm", folder.path());
    CHECK(film.at("fps") == 20);
    REQUIRE(shell("'" + program + "' render --quiet -o frames/ " + span, folder.path()).exit_code ==
            0);
    const auto pictures =
        std::distance(fs::directory_iterator(folder.path() / "frames"), fs::directory_iterator());
    CHECK(film.at("frames") == pictures);
    CHECK(film.at("rough").at("formats").size() == 1);
    const auto rough = [&](const char* quality) {
        return film_of(scene + "--quality " + quality, folder.path()).at("rough");
    };
    CHECK(rough("draft").at("bytes") > rough("standard").at("bytes"));
    CHECK(rough("final").at("seconds") > rough("standard").at("seconds"));

    const Outcome late = shell("'" + program + "' check --from 80 " + scene, folder.path());
    CHECK(late.exit_code == 2);
    CHECK(late.err.find("--from 80: the scene runs from 0 to 75") != std::string::npos);
    const Outcome fast =
        shell("'" + program + "' check --format gif --fps 60 " + scene, folder.path());
    CHECK(fast.exit_code == 2);
    CHECK(fast.err.find("a GIF cannot show 60 frames a second") != std::string::npos);
}

TEST_CASE("a film takes at most --max-size, and most of it") {
    const TemporaryFolder folder;
    const std::string scene = "'" + library_scene("mixed-masses") + "' --size 640x360 --seconds 2 ";
    for (const auto& asked : {std::tuple{"a.mp4", "150kB", 1.5e5},
                              {"b.gif", "0.3MB", 3e5},
                              {"c.webm", "300000", 3e5}}) {
        const auto& file = std::get<0>(asked);
        const auto& size = std::get<1>(asked);
        const auto& most = std::get<2>(asked);
        CAPTURE(file);
        const Outcome outcome =
            shell(fmt::format("'{}' render {} -o {} --max-size {}", program, scene, file, size),
                  folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        const auto bytes = static_cast<double>(fs::file_size(folder.path() / file));
        CHECK(bytes <= most);
        CHECK(bytes >= 0.5 * most);
        CHECK(outcome.out.find(std::string("for --max-size ") + size) != std::string::npos);
    }
    const Outcome streamed = shell(
        fmt::format("'{}' render --quiet {} -o - --max-size 150kB | cmp - a.mp4", program, scene),
        folder.path());
    CHECK(streamed.exit_code == 0);

    const Outcome none =
        shell("'" + program + "' render --max-size 5kB -o d.mp4 " + scene, folder.path());
    CHECK(none.exit_code == 2);
    CHECK(none.err.find("--max-size 5kB: a film of 2 seconds takes more") != std::string::npos);
    CHECK_FALSE(fs::exists(folder.path() / "d.mp4"));
    const Outcome wrong = shell("'" + program + "' render --max-size 5cm " + scene, folder.path());
    CHECK(wrong.exit_code == 2);
    CHECK(wrong.err.find("--max-size 5cm: expected a size") != std::string::npos);
}

TEST_CASE("a film that is too large for --max-size leaves the earlier one, and its words") {
    const TemporaryFolder folder;
    write_set(folder, "Small gases that are shown one after the other, with words on a card");
    const std::string join = "'" + program + "' render set.yaml --join --quiet -o f.mp4 --words";
    REQUIRE(shell(join, folder.path()).exit_code == 0);
    const auto bytes = fs::file_size(folder.path() / "f.mp4");
    const std::vector<std::string> names = folder.names();
    folder.write("f.mp4", "earlier");
    folder.write("f.transcript.txt", "earlier");
    // More than what was measured, as each file has a head, and less than all.
    for (const double share : {0.5, 0.8, 0.9, 0.95, 0.98}) {
        const Outcome outcome =
            shell(fmt::format("{} --max-size {:.0f}", join, share * double(bytes)), folder.path());
        CAPTURE(share);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err, "a film of 8 seconds takes more"));
        CHECK(contents(folder.path() / "f.mp4") == "earlier");
        CHECK(contents(folder.path() / "f.transcript.txt") == "earlier");
        CHECK(folder.names() == names);
    }
    const Outcome part =
        shell("'" + program + "' render one.yaml --from 0.5 --to 1 -o f.mp4 --max-size 1kB",
              folder.path());
    CHECK(part.exit_code == 2);
    CHECK(has(part.err, "a film of 0.4 seconds takes more"));
}
