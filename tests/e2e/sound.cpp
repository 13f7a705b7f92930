// The sound of films, as ffmpeg decodes it: clicks at the times and pitches that the physics gives.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

// Two beads meet at time 3 in the middle with 2 units of momentum to exchange, and each gives as
// much to its wall at 7. The film is 14 s long; 1.5 s pass before the gas moves, and 2 s after.
const std::string beads =
    "title: Two beads\nbox: {length: 8}\n"
    "gas: [{radius: 0, position: [1, 7], velocity: [1, -1]}]\n"
    "run: {until: 10}\n";

std::string film(const std::string& sound) {
    return beads + "film: {seconds: 14, fps: 10, size: [320, 180], sound: " + sound + "}\n";
}

const std::string dense =
    "title: Many disks\nbox: {size: [40, 30]}\nseed: 5\n"
    "gas: [{count: 400, radius: 0.4, temperature: 9}]\n"
    "run: {until: 12}\n"
    "film: {seconds: 6, fps: 10, size: [320, 180], sound: {loudness: 0.4}}\n";

void render(const TemporaryFolder& folder, const std::string& output,
            std::vector<std::string> more = {}) {
    std::vector<std::string> command{program, "render",    "scene.yaml", "-o",
                                     output,  "--quality", "draft",      "--quiet"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run(command, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
}

json probe(const fs::path& path) {
    const Outcome outcome = run(
        {"ffprobe", "-v", "error", "-show_streams", "-show_format", "-of", "json", path.string()});
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out);
}

json audio_of(const fs::path& path) {
    const json all = probe(path);
    for (const json& stream : all["streams"])
        if (stream["codec_type"] == "audio") return stream;
    return {};
}

// As a player hears it, 48000 samples a second.
std::vector<float> decoded(const fs::path& path) {
    const Outcome outcome = run({"ffmpeg", "-v", "error", "-i", path.string(), "-map", "0:a", "-f",
                                 "f32le", "-ac", "1", "-ar", "48000", "-"});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    std::vector<float> samples(outcome.out.size() / sizeof(float));
    std::memcpy(samples.data(), outcome.out.data(), samples.size() * sizeof(float));
    return samples;
}

double largest(const std::vector<float>& samples) {
    double most = 0.0;
    for (const float one : samples) most = std::max(most, double(std::abs(one)));
    return most;
}

// The loudest place of each click, apart by half a second: 3 ms after it begins.
std::vector<double> clicks_in(const std::vector<float>& samples) {
    const double threshold = 0.3 * largest(samples);
    std::vector<double> seconds;
    for (std::size_t n = 0; n < samples.size(); ++n)
        if (std::abs(samples[n]) > threshold &&
            (seconds.empty() || double(n) / 48000.0 > seconds.back() + 0.5))
            seconds.push_back(double(n) / 48000.0);
    return seconds;
}

// Goertzel's filter: how much of a frequency is in 40 ms of sound.
double power_at(const std::vector<float>& samples, double seconds, double frequency) {
    constexpr std::size_t count = 1920;
    const auto first = static_cast<std::size_t>(std::lround(48000.0 * seconds));
    REQUIRE(first + count <= samples.size());
    const double factor = 2.0 * std::cos(2.0 * std::numbers::pi * frequency / 48000.0);
    double before = 0.0, last = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
        const double next = samples[first + n] + factor * last - before;
        before = last;
        last = next;
    }
    return before * before + last * last - factor * before * last;
}

double loudest_frequency(const std::vector<float>& samples, double seconds) {
    double best = 0.0, most = 0.0;
    for (double frequency = 200.0; frequency < 8000.0; frequency *= 1.005)
        if (const double power = power_at(samples, seconds, frequency); power > most) {
            most = power;
            best = frequency;
        }
    return best;
}

std::string hash_of_pictures(const fs::path& path) {
    const Outcome outcome = run({"ffmpeg", "-v", "error", "-i", path.string(), "-map", "0:v", "-c",
                                 "copy", "-f", "md5", "-"});
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
}

}  // namespace

TEST_CASE("a click is heard when the film shows a collision, with the pitch of its impulse") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", film("{of: collisions, loudness: 0.5}"));
    for (const std::string name : {"film.mp4", "film.webm"}) {
        CAPTURE(name);
        render(folder, name);
        const fs::path path = folder.path() / name;
        const json audio = audio_of(path);
        CHECK(audio["codec_name"] == (name == "film.mp4" ? "aac" : "opus"));
        CHECK(audio["sample_rate"] == "48000");
        CHECK(audio["channels"] == 1);

        const std::vector<float> samples = decoded(path);
        CHECK(largest(samples) <= 0.5);
        CHECK(largest(samples) >= 0.25);
        const std::vector<double> clicks = clicks_in(samples);
        REQUIRE(clicks.size() == 2);
        // A film of 140 frames: 15 before the gas moves, 104 steps for 10 units of time.
        for (const auto& heard : {std::pair{3.0, clicks[0]}, {7.0, clicks[1]}}) {
            const auto& time = heard.first;
            const auto& click = heard.second;
            CAPTURE(time);
            const double shown = 1.5 + time * 10.4 / 10.0;
            // It rises within 3 ms; a packet of AAC has 21 ms, one of Opus 20.
            CHECK(click >= shown - 0.002);
            CHECK(click <= shown + 0.004);
            // 2 in units of the usual impulse, 1, at 880 Hz; a step of pitches is 1.2 %.
            CHECK(loudest_frequency(samples, shown) == doctest::Approx(1760.0).epsilon(0.012));
            CHECK(power_at(samples, shown - 0.1, 1760.0) < 1e-3 * power_at(samples, shown, 1760.0));
        }
    }
    folder.write("scene.yaml", film("{reference: 4}"));
    render(folder, "low.mp4");
    const std::vector<float> low = decoded(folder.path() / "low.mp4");
    CHECK(loudest_frequency(low, 1.5 + 3.0 * 1.04) == doctest::Approx(440.0).epsilon(0.02));
    CHECK(largest(low) <= 0.3);
}

TEST_CASE("sound is as long as the pictures") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", film("collisions"));
    for (const std::string name : {"film.mp4", "film.webm"})
        for (const std::vector<std::string>& part :
             {std::vector<std::string>{}, {"--from", "2", "--to", "5.1"}, {"--fps", "7"}}) {
            CAPTURE(name);
            render(folder, name, part);
            const fs::path path = folder.path() / name;
            const json all = probe(path);
            const Outcome counted =
                run({"ffprobe", "-v", "error", "-count_packets", "-select_streams", "v",
                     "-show_entries", "stream=nb_read_packets,r_frame_rate", "-of", "json",
                     path.string()});
            const json video = json::parse(counted.out)["streams"][0];
            const double frames = std::stod(video["nb_read_packets"].get<std::string>());
            const double rate = std::stod(video["r_frame_rate"].get<std::string>());
            // To a sample; WebM counts milliseconds.
            // What ffmpeg decodes of MP4 ends with a whole packet, whatever the track's length is.
            const double beyond = double(decoded(path).size()) / 48000.0 - frames / rate;
            CHECK(beyond >= -0.0005);
            CHECK(beyond < (name == "film.mp4" ? 1024.0 / 48000.0 : 0.0005));
            if (name == "film.mp4")
                CHECK(std::abs(std::stod(audio_of(path)["duration"].get<std::string>()) -
                               frames / rate) <= 1.0 / 48000.0);
            CHECK(std::stod(all["format"]["duration"].get<std::string>()) ==
                  doctest::Approx(frames / rate).epsilon(0.002));
        }
}

TEST_CASE("a dense gas is no louder than asked, and its pictures are those of a silent film") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", dense);
    for (const std::string ending : {".mp4", ".webm"}) {
        CAPTURE(ending);
        render(folder, "one" + ending, {"--threads", "1"});
        render(folder, "three" + ending, {"--threads", "3"});
        const std::string one = contents(folder.path() / ("one" + ending));
        CHECK((one == contents(folder.path() / ("three" + ending))));
        const std::vector<float> samples = decoded(folder.path() / ("one" + ending));
        CHECK(largest(samples) <= 0.4);
        CHECK(largest(samples) >= 0.2);

        render(folder, "silent" + ending, {"--no-sound"});
        CHECK(audio_of(folder.path() / ("silent" + ending)).is_null());
        CHECK(hash_of_pictures(folder.path() / ("one" + ending)) ==
              hash_of_pictures(folder.path() / ("silent" + ending)));
    }
    render(folder, "none.mp4", {"--set", "film.sound=none"});
    CHECK((contents(folder.path() / "none.mp4") == contents(folder.path() / "silent.mp4")));
}

TEST_CASE("a film that is made in chunks has the same sound, byte for byte") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", dense);
    for (const std::string format : {"mp4", "webm"}) {
        CAPTURE(format);
        render(folder, "direct." + format);
        const Outcome outcome = shell(
            "'" + program + "' plan scene.yaml --quality draft --chunks 2 -o plan --format " +
                format + " --force --quiet && '" + program +
                "' render plan --chunk 2 --quiet && '" + program + "' render plan --quiet && '" +
                program + "' join plan --quiet -o joined." + format,
            folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        CHECK((contents(folder.path() / ("joined." + format)) ==
               contents(folder.path() / ("direct." + format))));
        CHECK(contents(folder.path() / "joined.captions.vtt") ==
              contents(folder.path() / "direct.captions.vtt"));
    }
}

TEST_CASE("several films as one have the sound of each at its place") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", film("collisions"));
    folder.write("silent.yaml", film("none"));
    const Outcome outcome =
        run({program, "render", "scene.yaml", "silent.yaml", "scene.yaml", "--join", "-o",
             "all.mp4", "--quality", "draft", "--quiet", "--words"},
            folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const std::vector<float> samples = decoded(folder.path() / "all.mp4");
    CHECK(samples.size() >= 42 * 48000);
    CHECK(samples.size() < 42 * 48000 + 1024);  // a whole packet at the end
    const std::vector<double> clicks = clicks_in(samples);
    REQUIRE(clicks.size() == 4);
    const double at[] = {4.62, 8.78, 32.62, 36.78};
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(clicks[k] - at[k] - 0.001) <= 0.003);
    const std::string captions = contents(folder.path() / "all.captions.vtt");
    CHECK(has(captions, "00:00:32.600 --> 00:00:34.600\n[clicks: one for each collision, higher "));
    CHECK(has(contents(folder.path() / "all.transcript.txt"), "A film of 0:42 with sound, in 3 "));
}

TEST_CASE("what is heard has captions beside the film, whatever else is asked for") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", film("collisions"));
    render(folder, "film.mp4");
    CHECK(folder.names() ==
          std::vector<std::string>{"film.captions.vtt", "film.mp4", "scene.yaml"});
    // 3.0 and 7.0 are shown at 4.62 and 8.78 s, in the frames that begin at 4.6 and 8.7.
    CHECK(contents(folder.path() / "film.captions.vtt") ==
          "WEBVTT\n\n00:00:04.600 --> 00:00:06.600\n"
          "[clicks: one for each collision, higher where the impulse is larger]\n"
          "\n00:00:08.700 --> 00:00:10.700\n"
          "[clicks: one for each collision, higher where the impulse is larger]\n");
    const Outcome checked = run({program, "check", "scene.yaml", "--accessible", "--set",
                                 "description=Two beads meet.", "film.size=[1280, 720]"},
                                folder.path());
    CAPTURE(checked.err);
    CHECK(checked.exit_code == 0);
    CHECK(has(checked.out, "a click for each collision, at most 0.3 of full scale, with captions"));
}

TEST_CASE("formats without sound say that the film is silent, and need no captions for it") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", film("collisions"));
    for (const std::string name : {"film.gif", "frames/", "film.pdf"}) {
        CAPTURE(name);
        const Outcome outcome = run(
            {program, "render", "scene.yaml", "-o", name, "--fps", "2", "--words"}, folder.path());
        CHECK(outcome.exit_code == 0);
        CHECK(has(outcome.err, "carom: the film is silent, as "));
        const std::string stem = name.substr(0, name.find_first_of("./"));
        CHECK_FALSE(fs::exists(folder.path() / (stem + ".captions.vtt")));
        CHECK(has(contents(folder.path() / (stem + ".transcript.txt")), "A silent film of "));
        const Outcome without = run(
            {program, "render", "scene.yaml", "-o", "other/" + name, "--fps", "2", "--no-sound"},
            folder.path());
        CHECK(without.exit_code == 0);
        CHECK_FALSE(has(without.err, "silent"));
    }
}
