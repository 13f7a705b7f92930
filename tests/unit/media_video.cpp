#include <doctest/doctest.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "media/video_writer.h"
#include "support/files.h"
#include "util/atomic_file.h"
#include "util/diagnostics.h"
#include "util/random.h"

using namespace carom;
using test::contents;
namespace fs = std::filesystem;

namespace {

struct Folder : test::TemporaryFolder {
    fs::path film() const { return path() / "film.mp4"; }
    fs::path webm() const { return path() / "film.webm"; }
};

std::string output_of(const std::string& command) {
    FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 65536> buffer;
    for (std::size_t count; (count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        text.append(buffer.data(), count);
    REQUIRE_MESSAGE(pclose(pipe) == 0, command);
    return text;
}

nlohmann::json probe(const fs::path& film) {
    return nlohmann::json::parse(
        output_of("ffprobe -v error -of json -show_format -show_streams -show_packets "
                  "-show_entries frame=pict_type,key_frame " +
                  film.string()));
}

constexpr int patch = 32, bits = 8;
constexpr std::array<std::uint32_t, 8> colors = {0xffff0000u, 0xff00ff00u, 0xff0000ffu,
                                                 0xffffffffu, 0xff000000u, 0xff808080u,
                                                 0xffe69f00u, 0xff0072b2u};

struct Frame {
    int width, height;
    std::vector<std::uint32_t> pixels;
    PixelView view() { return {pixels.data(), width, height, width}; }
    void square(int left, int top, int size, std::uint32_t color) {
        for (int y = top; y < top + size; ++y)
            std::fill_n(pixels.begin() + y * width + left, size, color);
    }
};

// Flat patches of known colours, the frame's number in black and white squares below them, and
// something that moves.
Frame numbered_frame(const VideoSettings& settings, int number) {
    Frame frame{settings.width, settings.height, {}};
    frame.pixels.assign(std::size_t(settings.width * settings.height), 0xff181818u);
    for (int k = 0; k < int(colors.size()); ++k)
        frame.square(k * patch, 0, patch, colors[std::size_t(k)]);
    for (int k = 0; k < bits; ++k)
        frame.square(k * patch, patch, patch, (number >> k) & 1 ? 0xffffffffu : 0xff000000u);
    frame.square((5 * number) % (settings.width - patch), 2 * patch + number % 20, patch / 2,
                 0xffffd166u);
    return frame;
}

VideoSettings small_film(Quality quality = Quality::standard) {
    VideoSettings settings;
    settings.width = 320;
    settings.height = 180;
    settings.quality = quality;
    return settings;
}

VideoSettings small_webm(Quality quality = Quality::standard) {
    VideoSettings settings = small_film(quality);
    settings.format = VideoFormat::webm;
    return settings;
}

EncodedSegment encode(const VideoSettings& settings, int first, int count) {
    SegmentEncoder encoder(settings);
    for (int i = first; i < first + count; ++i) {
        Frame frame = numbered_frame(settings, i);
        encoder.add(frame.view());
    }
    return encoder.finish();
}

const std::vector<int> lengths = {7, 20, 13, 1, 2};
constexpr int total = 43;

void write_film(const fs::path& path, const VideoSettings& settings) {
    VideoWriter writer(path, settings);
    int first = 0;
    for (const int length : lengths) {
        EncodedSegment segment = encode(settings, first, length);
        CHECK(segment.frames() == length);
        CHECK(segment.bytes() > 0);
        writer.append(std::move(segment));
        first += length;
    }
    writer.commit();
    CHECK(writer.bytes() == std::int64_t(fs::file_size(path)));
}

// Each segment on a thread of its own, all at once, the last one started first.
void write_film_in_threads(const fs::path& path, const VideoSettings& settings) {
    std::vector<EncodedSegment> segments(lengths.size());
    std::vector<std::thread> threads;
    for (std::size_t k = lengths.size(); k-- > 0;) {
        const int first = std::accumulate(lengths.begin(), lengths.begin() + long(k), 0);
        threads.emplace_back([&segments, &settings, first, k] {
            segments[k] = encode(settings, first, lengths[k]);
        });
    }
    for (std::thread& thread : threads) thread.join();
    VideoWriter writer(path, settings);
    for (EncodedSegment& segment : segments) writer.append(std::move(segment));
    writer.commit();
}

// Frames that do not compress: the file passes every buffer long before its end.
EncodedSegment encode_noise(const VideoSettings& settings, int count) {
    SegmentEncoder encoder(settings);
    Random random(1, "noise");
    for (int i = 0; i < count; ++i) {
        Frame frame = numbered_frame(settings, i);
        for (std::uint32_t& pixel : frame.pixels)
            pixel = 0xff000000u | static_cast<std::uint32_t>(random.below(1 << 24));
        encoder.add(frame.view());
    }
    return encoder.finish();
}

struct FileSizeLimit {
    struct rlimit before = {};
    void (*handler)(int) = nullptr;
    explicit FileSizeLimit(rlim_t bytes) {
        handler = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before);
        struct rlimit now = before;
        now.rlim_cur = bytes;
        REQUIRE(setrlimit(RLIMIT_FSIZE, &now) == 0);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, handler);
    }
};

std::string failure_of(const fs::path& path, const VideoSettings& settings, int frames) {
    try {
        VideoWriter writer(path, settings);
        writer.append(encode_noise(settings, frames));
        writer.commit();
    } catch (const SystemError& error) {
        return error.what();
    }
    return "";
}

// `least`: bytes of the film, several buffers.
void check_failing_writes(const fs::path& path, const VideoSettings& settings, rlim_t least) {
    REQUIRE(failure_of(path, settings, 40) == "");
    const auto size = static_cast<rlim_t>(fs::file_size(path));
    REQUIRE(size > least);
    std::ofstream(path) << "earlier";
    for (const rlim_t limit : {rlim_t{1}, size / 2, size - 2000, size - 1}) {
        CAPTURE(limit);
        std::string message;
        {
            const FileSizeLimit limited(limit);
            message = failure_of(path, settings, 40);
        }
        CHECK(message == "cannot write " + path.string() + ": File too large");
        CHECK(contents(path) == "earlier");
    }
}

}  // namespace

TEST_CASE("a film is the same bytes whatever threads encoded its segments, for every quality") {
    const Folder folder;
    for (const Quality quality : {Quality::draft, Quality::standard, Quality::final_}) {
        const VideoSettings settings = small_film(quality);
        write_film(folder.path() / "one.mp4", settings);
        write_film_in_threads(folder.path() / "many.mp4", settings);
        CHECK(contents(folder.path() / "one.mp4") == contents(folder.path() / "many.mp4"));
    }
}

TEST_CASE("ffprobe sees a tagged H.264 film of constant rate") {
    const Folder folder;
    for (const Quality quality : {Quality::draft, Quality::standard, Quality::final_}) {
        CAPTURE(int(quality));
        write_film(folder.film(), small_film(quality));
        const nlohmann::json all = probe(folder.film());
        const nlohmann::json& stream = all["streams"][0];
        CHECK(all["streams"].size() == 1);
        CHECK(stream["codec_name"] == "h264");
        CHECK(stream["codec_tag_string"] == "avc1");
        CHECK(stream["profile"] == "High");
        CHECK(stream["pix_fmt"] == "yuv420p");
        CHECK(stream["width"] == 320);
        CHECK(stream["height"] == 180);
        CHECK(stream["sample_aspect_ratio"] == "1:1");
        CHECK(stream["color_range"] == "tv");
        CHECK(stream["color_space"] == "bt709");
        CHECK(stream["color_transfer"] == "bt709");
        CHECK(stream["color_primaries"] == "bt709");
        CHECK(stream["chroma_location"] == "left");
        CHECK(stream["r_frame_rate"] == "30/1");
        CHECK(stream["avg_frame_rate"] == "30/1");
        CHECK(stream["nb_frames"] == std::to_string(total));
        CHECK(stream["start_pts"] == 0);
        // 43/30 s: the stream counts in ticks exactly, the file in milliseconds, rounded up.
        CHECK(stream["duration_ts"].get<long>() * 30 ==
              total * std::stol(stream["time_base"].get<std::string>().substr(2)));
        CHECK(std::stod(all["format"]["duration"].get<std::string>()) ==
              doctest::Approx(total / 30.0).epsilon(0.001));
        CHECK_FALSE(all["format"]["tags"].contains("creation_time"));
        CHECK_FALSE(all["format"]["tags"].contains("encoder"));
    }
}

TEST_CASE("times are regular across the joints, and every segment begins with a key frame") {
    const Folder folder;
    for (const Quality quality : {Quality::draft, Quality::standard, Quality::final_}) {
        CAPTURE(int(quality));
        write_film(folder.film(), small_film(quality));
        const nlohmann::json all = probe(folder.film());
        const long step =
            std::stol(all["streams"][0]["time_base"].get<std::string>().substr(2)) / 30;
        std::vector<long> shown;
        std::vector<int> keys, key_times;
        long previous = 0;
        for (const nlohmann::json& item : all["packets_and_frames"]) {
            if (item["type"] != "packet") continue;
            const long pts = item["pts"], dts = item["dts"];
            CHECK(item["duration"] == step);
            CHECK(dts <= pts);
            if (!shown.empty()) CHECK(dts == previous + step);
            previous = dts;
            if (item["flags"].get<std::string>()[0] == 'K') {
                keys.push_back(int(shown.size()));
                key_times.push_back(int(pts / step));
            }
            shown.push_back(pts);
        }
        std::sort(shown.begin(), shown.end());
        CHECK(shown.size() == total);
        for (std::size_t i = 0; i < shown.size(); ++i) CHECK(shown[i] == long(i) * step);
        // Closed groups: a key frame comes first of its segment in both orders.
        CHECK(keys == std::vector<int>{0, 7, 27, 40, 41});
        CHECK(key_times == keys);
    }
}

TEST_CASE("the index stands before the pictures") {
    const Folder folder;
    write_film(folder.film(), small_film());
    const std::string bytes = contents(folder.film());
    CHECK(bytes.substr(4, 4) == "ftyp");
    CHECK(bytes.find("moov") < bytes.find("mdat"));
    CHECK(bytes.find("moof") == std::string::npos);
    CHECK(folder.names().size() == 1);
}

TEST_CASE("the encoder's own record of its settings names one thread and no cuts inside a group") {
    const Folder folder;
    write_film(folder.film(), small_film());
    const std::string bytes = contents(folder.film());
    for (const char* setting : {" threads=1 ", " lookahead_threads=1 ", " scenecut=0 "})
        CHECK(bytes.find(setting) != std::string::npos);
}

TEST_CASE("ffmpeg decodes every frame, in order, with the colours that were drawn") {
    const Folder folder;
    for (VideoSettings settings :
         {small_film(Quality::draft), small_film(), small_film(Quality::final_),
          small_webm(Quality::draft), small_webm(), small_webm(Quality::final_)}) {
        CAPTURE(int(settings.quality));
        CAPTURE(int(settings.format));
        write_film(folder.film(), settings);
        const std::string raw = output_of(
            "ffmpeg -v error -i " + folder.film().string() +
            " -fps_mode passthrough -sws_flags accurate_rnd+full_chroma_int -f rawvideo -pix_fmt "
            "rgb24 -");
        const std::size_t frame_bytes = 3 * 320 * 180;
        REQUIRE(raw.size() == total * frame_bytes);
        const auto at = [&](int frame, int x, int y, int channel) {
            return int(static_cast<unsigned char>(
                raw[std::size_t(frame) * frame_bytes + std::size_t(3 * (y * 320 + x) + channel)]));
        };
        int worst = 0;
        for (int i = 0; i < total; ++i) {
            int number = 0;
            for (int k = 0; k < bits; ++k)
                number |= (at(i, k * patch + patch / 2, patch + patch / 2, 0) > 127) << k;
            CHECK(number == i);
            for (int k = 0; k < int(colors.size()); ++k)
                for (int channel = 0; channel < 3; ++channel) {
                    const int drawn = (colors[std::size_t(k)] >> (16 - 8 * channel)) & 255;
                    const int seen = at(i, k * patch + patch / 2, patch / 2, channel);
                    worst = std::max(worst, std::abs(drawn - seen));
                }
        }
        // One step of chroma is up to 2.1 steps of blue; the encoder may round flat areas by one.
        // VP9's coarsest quantiser may miss one step more.
        const bool coarsest =
            settings.format == VideoFormat::webm && settings.quality == Quality::draft;
        CHECK(worst <= (coarsest ? 3 : 2));
    }
}

TEST_CASE("odd sizes are padded to even ones") {
    const Folder folder;
    VideoSettings settings = small_film();
    settings.width = 321;
    settings.height = 181;
    settings.fps = 25;
    write_film(folder.film(), settings);
    const nlohmann::json stream = probe(folder.film())["streams"][0];
    CHECK(stream["width"] == 322);
    CHECK(stream["height"] == 182);
    CHECK(stream["r_frame_rate"] == "25/1");
}

TEST_CASE("texts come back from the file, long ones and those MP4 has no name for") {
    const Folder folder;
    VideoSettings settings = small_film();
    std::string scene = "title: Größe = 1\ntext: \"quotes; and # signs\"\n";
    while (scene.size() < 100'000) scene += "  - {count: 200, radius: 0.01}\t# ⟨v⟩\n";
    settings.metadata = {{"title", "One hot particle — 293 K"},
                         {"description", "A fast disk heats the others."},
                         {"comment", scene},
                         {"keywords", "gas"},
                         {"seed", "18446744073709551615"}};
    write_film(folder.film(), settings);
    const nlohmann::json tags = probe(folder.film())["format"]["tags"];
    CHECK(tags["title"] == "One hot particle — 293 K");
    CHECK(tags["description"] == "A fast disk heats the others.");
    CHECK(tags["comment"].get<std::string>() == scene);
    CHECK(tags["keywords"] == "gas, seed=18446744073709551615");
}

TEST_CASE("an uncommitted film leaves nothing, and the earlier one as it was") {
    const Folder folder;
    std::ofstream(folder.film()) << "earlier";
    {
        VideoWriter writer(folder.film(), small_film());
        writer.append(encode(small_film(), 0, 5));
    }
    CHECK(contents(folder.film()) == "earlier");
    CHECK(folder.names().size() == 1);
}

TEST_CASE("a write that fails, early or late, is one clear error and harms nothing") {
    const Folder folder;
    check_failing_writes(folder.film(), small_film(Quality::draft), 1'000'000);
    CHECK(folder.names().size() == 1);
}

TEST_CASE("a full disk is named") {
    const Folder folder;
    const fs::path disk = folder.path() / "disk";
    fs::create_directories(disk);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=1m") != 0) {
        MESSAGE("skipped: no right to mount a small disk here");
        return;
    }
    std::ofstream(disk / "film.mp4") << "earlier";
    const std::string message = failure_of(disk / "film.mp4", small_film(Quality::draft), 40);
    CHECK(message == "cannot write " + (disk / "film.mp4").string() + ": No space left on device");
    CHECK(contents(disk / "film.mp4") == "earlier");
    CHECK(std::distance(fs::directory_iterator(disk), {}) == 1);
    CHECK(umount(disk.c_str()) == 0);
}

TEST_CASE("a size that the encoder refuses names it and the cause") {
    VideoSettings settings = small_film();
    settings.width = 20000;
    settings.height = 20000;
    CHECK_THROWS_WITH_AS(SegmentEncoder{settings}, doctest::Contains("cannot encode with libx264"),
                         SystemError);
    settings.format = VideoFormat::webm;
    CHECK_THROWS_WITH_AS(SegmentEncoder{settings},
                         doctest::Contains("cannot encode with libvpx-vp9"), SystemError);
}

TEST_CASE("a WebM is the same bytes whatever threads encoded its segments, for every quality") {
    const Folder folder;
    for (const Quality quality : {Quality::draft, Quality::standard, Quality::final_}) {
        write_film(folder.path() / "one.webm", small_webm(quality));
        write_film_in_threads(folder.path() / "many.webm", small_webm(quality));
        CHECK(contents(folder.path() / "one.webm") == contents(folder.path() / "many.webm"));
    }
}

TEST_CASE("ffprobe sees a tagged VP9 film of constant rate, with a key frame at every joint") {
    const Folder folder;
    VideoSettings settings = small_webm();
    settings.metadata = {{"title", "One hot particle — 293 K"}, {"seed", "18446744073709551615"}};
    for (const Quality quality : {Quality::draft, Quality::standard, Quality::final_}) {
        CAPTURE(int(quality));
        settings.quality = quality;
        write_film(folder.webm(), settings);
        const nlohmann::json all = probe(folder.webm());
        const nlohmann::json& stream = all["streams"][0];
        CHECK(all["streams"].size() == 1);
        CHECK(all["format"]["format_name"].get<std::string>().find("webm") != std::string::npos);
        CHECK(stream["codec_name"] == "vp9");
        CHECK(stream["profile"] == "Profile 0");
        CHECK(stream["pix_fmt"] == "yuv420p");
        CHECK(stream["color_range"] == "tv");
        CHECK(stream["color_space"] == "bt709");
        CHECK(stream["color_transfer"] == "bt709");
        CHECK(stream["color_primaries"] == "bt709");
        CHECK(stream["chroma_location"] == "left");
        CHECK(stream["r_frame_rate"] == "30/1");
        CHECK(stream["avg_frame_rate"] == "30/1");
        CHECK(std::stod(all["format"]["duration"].get<std::string>()) ==
              doctest::Approx(total / 30.0).epsilon(0.001));
        const nlohmann::json& tags = all["format"]["tags"];
        CHECK(tags["title"] == "One hot particle — 293 K");
        CHECK(tags["SEED"] == "18446744073709551615");
        CHECK_FALSE(tags.contains("creation_time"));

        // WebM counts in milliseconds.
        std::vector<int> keys;
        int count = 0;
        for (const nlohmann::json& item : all["packets_and_frames"]) {
            if (item["type"] != "packet") continue;
            CHECK(std::abs(item["pts"].get<double>() - count * 1000.0 / 30.0) <= 0.5);
            if (item["flags"].get<std::string>()[0] == 'K') keys.push_back(count);
            ++count;
        }
        CHECK(count == total);
        CHECK(keys == std::vector<int>{0, 7, 27, 40, 41});
    }
}

TEST_CASE("the index of a WebM stands before the pictures") {
    const Folder folder;
    write_film(folder.webm(), small_webm());
    const std::string bytes = contents(folder.webm());
    const std::string index = "\x1c\x53\xbb\x6b";
    const std::size_t cluster = bytes.find("\x1f\x43\xb6\x75");
    CHECK(bytes.starts_with("\x1a\x45\xdf\xa3"));
    CHECK(cluster != std::string::npos);
    CHECK(bytes.find(index) < cluster);  // named in the list of what the file holds
    CHECK(bytes.find(index) < bytes.rfind(index, cluster));
    CHECK(folder.names().size() == 1);
}

TEST_CASE("a WebM whose write fails, early or late, is one clear error and harms nothing") {
    const Folder folder;
    check_failing_writes(folder.webm(), small_webm(Quality::draft), 600'000);
    CHECK(folder.names().size() == 1);
}
