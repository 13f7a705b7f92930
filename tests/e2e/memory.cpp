// The memory of films, as carom check names it and as the system counts it.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"
#include "support/share_of_cases.h"

#ifndef CAROM_SANITIZERS  // whose own memory is many times that

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

struct Peak {
    int exit_code = -1;
    double bytes = 0.0;
    double page_faults = 0.0;  ///< pages that the system had to grant
};

// Of carom in a folder.
Peak peak_of(const std::string& arguments, const fs::path& folder) {
    const std::string script =
        fmt::format("cd '{}' && exec '{}' {} >/dev/null 2>&1", folder.string(), program, arguments);
    const pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", script.c_str(), nullptr);
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    REQUIRE(wait4(child, &status, 0, &usage) == child);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            1024.0 * static_cast<double>(usage.ru_maxrss), static_cast<double>(usage.ru_minflt)};
}

struct Case {
    std::string size, format, more;
};

}  // namespace

TEST_CASE("files of brackets take no memory before they are refused") {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "plan");
    fs::create_directory(folder.path() / "figures");
    const std::string brackets(60 << 20, '[');
    folder.write("plan/plan.json", brackets);
    folder.write("figures/figures.json", brackets.substr(0, 4 << 20));
    folder.write("scene.yaml", brackets.substr(0, 4 << 20));
    const std::string figure =
        "figure '" + library_scene("two-to-one") + "' --kind speed-histogram -o figures";
    for (const std::string& command :
         {std::string("render plan/"), figure, std::string("check scene.yaml")}) {
        CAPTURE(command);
        const Peak peak = peak_of(command, folder.path());
        CHECK(peak.exit_code == 2);
        CHECK(peak.bytes < 250e6);
    }
}

// What carom check says that the film takes at most, as an MP4.
double named_bytes(const std::string& arguments, const TemporaryFolder& folder) {
    const Outcome check = shell("'" + program + "' check --json " + arguments, folder.path());
    REQUIRE(check.exit_code == 0);
    return json::parse(check.out).at(0).at("film").at("rough").at("formats").at("mp4").at(
        "memory_bytes");
}

TEST_CASE("a film takes at most the memory that carom check names, and at least a quarter of it") {
    const TemporaryFolder folder;
    for (const Case& one : {Case{"320x180", "mp4", ""},
                            {"1280x720", "mp4", "--quality final"},
                            {"1280x720", "webm", ""},
                            {"1920x1080", "gif", ""},
                            {"1920x1080", "png", ""},
                            {"3840x2160", "mp4", ""}}) {
        CAPTURE(one.size);
        CAPTURE(one.format);
        const std::string options = fmt::format(" '{}' --size {} --set film.seconds=1 ",
                                                library_scene("mixed-masses"), one.size);
        const Outcome check = shell("'" + program + "' check --json" + options, folder.path());
        REQUIRE(check.exit_code == 0);
        const json rough = json::parse(check.out).at(0).at("film").at("rough");
        const double named = rough.at("formats").at(one.format).at("memory_bytes");
        const Peak peak =
            peak_of(fmt::format("render --quiet --threads {} --format {} {} {}",
                                rough.at("cores").get<int>(), one.format, one.more, options),
                    folder.path());
        CHECK(peak.exit_code == 0);
        CHECK(peak.bytes <= named);
        // What of the program is there for encoders is not there for pictures.
        CHECK(peak.bytes >= (one.format == "png" ? 0.15 : 0.25) * named);
    }
}

// Large disks that all move fast fill the segments that wait for their turn, and each segment has
// an encoder of its own.
TEST_CASE(
    "a film of many segments, whose frames are large, takes at most the memory that is named") {
    const TemporaryFolder folder;
    const char* const size = every_nth(2, 2) == 1 ? "1080p" : "640x360";
    for (const char* scene : {"a-hundred-never-overlap", "freezing"}) {
        const std::string options =
            fmt::format(" '{}' --size {} --threads 2 ", library_scene(scene), size);
        CAPTURE(options);
        const double named = named_bytes(options, folder);
        const Peak peak = peak_of("render --quiet -o film.mp4" + options, folder.path());
        CHECK(peak.exit_code == 0);
        CHECK(peak.bytes <= named);
    }
}

#ifndef CAROM_EMULATED  // QEMU's own pages count too
TEST_CASE("the encoder of a segment takes the memory of the one before it") {
    const TemporaryFolder folder;
    const auto page_faults = [&](const std::string& seconds) {
        const Peak peak = peak_of("render --quiet --threads 1 -o film.mp4 --size 640x360 '" +
                                      library_scene("one-hot-particle") + "' --seconds " + seconds,
                                  folder.path());
        REQUIRE(peak.exit_code == 0);
        return peak.page_faults;
    };
    // 4 and 12 segments. A segment takes 1,200 pages more; with memory of its own for each encoder
    // it took 2,900.
    CHECK(page_faults("60") - page_faults("8") < 8 * 2000);
}
#endif

TEST_CASE("the memory that carom check names has room for what panels and trails keep of the way") {
    const TemporaryFolder folder;
    for (const std::string& film : std::vector<std::string>{
             "panels: [], trails: {of: all, seconds: 1}", "panels: [velocity-autocorrelation]",
             "panels: [{kind: mean-squared-displacement, origins: all}]",
             "panels: [], field: {of: temperature, cells: 20}"}) {
        CAPTURE(film);
        folder.write("ways.yaml",
                     "title: Ways\nbox: {size: [200, 150]}\n"
                     "gas: [{count: 20000, radius: 0.35, temperature: 1}]\n"
                     "run: {until: 0.1}\nfilm: {seconds: 1.5, fps: 20, size: [640, 360], " +
                         film + "}\n");
        const double named = named_bytes("--threads 2 ways.yaml", folder);
        const Peak peak =
            peak_of("render ways.yaml --quiet --threads 2 -o film.mp4", folder.path());
        CHECK(peak.exit_code == 0);
        CHECK(peak.bytes <= named);
    }
}

// Ten points on a line, which collide some ten times in a unit of time.
std::string often_colliding(int until) {
    return fmt::format(
        "title: Many collisions\nbox: {{length: 10}}\n"
        "gas: [{{count: 10, radius: 0, mass: {{uniform: [1, 2]}}, speed: 1}}]\n"
        "run: {{until: {}}}\nfilm: {{seconds: 2, size: [160, 90], panels: [{{kind: phase, of: [0, "
        "1]}}]}}\n",
        until);
}

TEST_CASE(
    "a film whose panels record many collisions takes at most the memory that is named, and no "
    "more if they are twice as many") {
    const TemporaryFolder folder;
    const auto named_until = [&](int until) {
        folder.write("often.yaml", often_colliding(until));
        return named_bytes("--threads 2 often.yaml", folder);
    };
    const double few = named_until(200), named = named_until(200'000);
    const Peak peak = peak_of("render often.yaml --quiet --threads 2 -o film.mp4", folder.path());
    CHECK(peak.exit_code == 0);
    CHECK(peak.bytes <= named);
    CHECK(peak.bytes > few);  // so that there is a reason to name more
    // What is recorded of the collisions is in a file. Each of its points would take some 60 bytes:
    // with all of them a film with twice as many would take a sixth more.
    folder.write("often.yaml", often_colliding(400'000));
    const Peak twice = peak_of("render often.yaml --quiet --threads 2 -o film.mp4", folder.path());
    CHECK(twice.exit_code == 0);
    CHECK(twice.bytes < 1.05 * peak.bytes);
}

// Of which the sound sees two frames with a million collisions each, and the run beside collides a
// hundred times as often.
TEST_CASE("the memory that is named has room for collisions that are heard, or of the run beside") {
    const TemporaryFolder folder;
    const std::string gas =
        "title: Many collisions\nbox: {length: 10}\ngas: [{count: 10, radius: 0.1, speed: 1}]\n";
    for (const std::string& rest : std::vector<std::string>{
             "run: {until: 200000}\nfilm: {seconds: 2, fps: 1, size: [160, 90], panels: [], sound: "
             "collisions}\n",
             "run: {until: 2000}\nfilm: {seconds: 2, fps: 5, size: [160, 90], panels: [], "
             "beside: {set: gas.0.speed=100, own_label: slow, label: fast}}\n"}) {
        CAPTURE(rest);
        folder.write("often.yaml", gas + rest);
        const double named = named_bytes("--threads 2 often.yaml", folder);
        const Peak peak =
            peak_of("render often.yaml --quiet --threads 2 -o film.mp4", folder.path());
        CHECK(peak.exit_code == 0);
        CHECK(peak.bytes <= named);
    }
}

// Of so many that what they take is most of it.
TEST_CASE("a film of very many disks takes at most the memory that carom check names") {
    const TemporaryFolder folder;
    const int count = 400'000 / every_nth(4, 4);
    folder.write(
        "large.yaml",
        fmt::format("title: Very many disks\nbox: {{size: [800, {}]}}\n"
                    "gas: [{{count: {}, radius: 0.3, temperature: 1}}]\n"
                    "run: {{until: 0.05}}\nfilm: {{seconds: 1, fps: 12, size: [640, 360]}}\n",
                    count * 0.0015, count));
    for (const int threads : {1, 2}) {
        CAPTURE(threads);
        const Outcome check =
            shell(fmt::format("'{}' check --json --threads {} large.yaml", program, threads),
                  folder.path());
        REQUIRE(check.exit_code == 0);
        const double named =
            json::parse(check.out).at(0).at("film").at("rough").at("formats").at("mp4").at(
                "memory_bytes");
        const Peak peak =
            peak_of(fmt::format("render large.yaml --quiet --threads {} -o film.mp4", threads),
                    folder.path());
        CHECK(peak.exit_code == 0);
        CHECK(peak.bytes <= named);
        CHECK(peak.bytes >= 0.4 * named);
    }
}
#endif
