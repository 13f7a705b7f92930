// The cost of a film: drawing and conversion of a lecture frame, and the wall time of a whole film
// compared with x264 alone, which encodes the same converted frames with two threads of its own.
// --quick: films of 10 s and three runs instead of 30 s and five.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/opt.h>
}

#include "films/render.h"
#include "media/yuv.h"
#include "panels/frame.h"
#include "runs/own_files.h"
#include "scene/load.h"
#include "support/shot.h"

using namespace carom;

namespace {

double seconds_of(clockid_t clock) {
    timespec time = {};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

// Disks of packing fraction 0.1 in a box of 4 : 3, with all three panels.
Scene scene_of(int disks, double seconds) {
    const double width = std::sqrt(disks * 0.785398 / 0.1 * 4.0 / 3.0);
    const std::string text = fmt::format(
        "title: {0} disks\nsubtitle: a measurement\nbox: {{size: [{1}, {2}]}}\n"
        "gas:\n  - {{name: light, count: {3}, radius: 0.5, temperature: 1}}\n"
        "  - {{name: heavy, count: {4}, radius: 0.5, mass: 9, speed: 0.1}}\n"
        "run: {{until: 40}}\nfilm: {{seconds: {5}}}\n",
        disks, width, 0.75 * width, disks / 2, disks - disks / 2, seconds);
    return load_scene_text(text, "bench", scene_resources());
}

struct Yuv {
    std::vector<std::uint8_t> bytes;
    YuvPlanes planes;
    Yuv(int width, int height) : bytes(static_cast<std::size_t>(width * height * 3 / 2)) {
        planes.y = bytes.data();
        planes.cb = planes.y + width * height;
        planes.cr = planes.cb + width * height / 4;
        planes.y_stride = width;
        planes.chroma_stride = width / 2;
    }
};

void print_drawing() {
    fmt::print("\nA lecture frame at 1080p, CPU ms\n{:>10} {:>8} {:>10} {:>14}\n", "disks", "draw",
               "convert", "if all of it");
    for (int disks : {200, 1000, 10000, 100000}) {
        const test::Shot film(scene_of(disks, disks > 20000 ? 3.0 : 10.0), 90);
        FramePainter painter(*film.panels);
        Yuv yuv(1920, 1080);
        to_yuv420(painter.paint(film.frames.front()).pixels(), yuv.planes);
        double draw = 0.0, convert = 0.0, whole = 0.0;
        std::uint64_t seen = 0;
        for (const FrameData& frame : film.frames) {
            const std::uint64_t before = seen;
            const double begun = seconds_of(CLOCK_THREAD_CPUTIME_ID);
            const Canvas& canvas = painter.paint(frame);
            const double drawn = seconds_of(CLOCK_THREAD_CPUTIME_ID);
            const auto changed = canvas.changes_since(before);
            if (changed) to_yuv420(canvas.pixels(), *changed, yuv.planes);
            const double converted = seconds_of(CLOCK_THREAD_CPUTIME_ID);
            to_yuv420(canvas.pixels(), yuv.planes);
            seen = canvas.picture();
            draw += drawn - begun;
            convert += converted - drawn;
            whole += seconds_of(CLOCK_THREAD_CPUTIME_ID) - converted;
        }
        const double per_frame = 1e3 / static_cast<double>(film.frames.size());
        fmt::print("{:>10} {:>8.2f} {:>10.2f} {:>14.2f}\n", disks, draw * per_frame,
                   convert * per_frame, whole * per_frame);
    }
}

std::vector<Yuv> converted(const Scene& scene) {
    const test::Shot film(scene);
    FramePainter painter(*film.panels);
    std::vector<Yuv> frames;
    for (const FrameData& frame : film.frames) {
        frames.emplace_back(1920, 1080);
        to_yuv420(painter.paint(frame).pixels(), frames.back().planes);
    }
    return frames;
}

void drain(AVCodecContext* context, AVPacket* packet) {
    while (avcodec_receive_packet(context, packet) == 0) av_packet_unref(packet);
}

// Wall time of libx264 in seconds at a preset, CRF 20, two threads; the packets are discarded.
double x264_alone(const std::vector<Yuv>& frames, const char* preset) {
    const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
    AVCodecContext* context = avcodec_alloc_context3(codec);
    context->width = 1920;
    context->height = 1080;
    context->pix_fmt = AV_PIX_FMT_YUV420P;
    context->time_base = {1, 30};
    context->framerate = {30, 1};
    context->thread_count = 2;
    av_opt_set(context->priv_data, "preset", preset, 0);
    av_opt_set(context->priv_data, "crf", "20", 0);
    av_opt_set(context->priv_data, "x264-params", "log-level=error", 0);
    if (avcodec_open2(context, codec, nullptr) != 0)
        throw std::runtime_error("libx264 did not open");
    AVFrame* picture = av_frame_alloc();
    picture->width = 1920;
    picture->height = 1080;
    picture->format = AV_PIX_FMT_YUV420P;
    AVPacket* packet = av_packet_alloc();
    const double begun = seconds_of(CLOCK_MONOTONIC);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const YuvPlanes& planes = frames[i].planes;
        picture->data[0] = planes.y;
        picture->data[1] = planes.cb;
        picture->data[2] = planes.cr;
        picture->linesize[0] = planes.y_stride;
        picture->linesize[1] = picture->linesize[2] = planes.chroma_stride;
        picture->pts = static_cast<std::int64_t>(i);
        avcodec_send_frame(context, picture);
        drain(context, packet);
    }
    avcodec_send_frame(context, nullptr);
    drain(context, packet);
    const double seconds = seconds_of(CLOCK_MONOTONIC) - begun;
    av_packet_free(&packet);
    av_frame_free(&picture);
    avcodec_free_context(&context);
    return seconds;
}

void print_wall(double seconds, int runs) {
    const auto folder = std::filesystem::temp_directory_path() / "carom-bench";
    fmt::print(
        "\nA film of {:.0f} s, 1080p30, two cores, wall seconds, median of {} interleaved runs\n",
        seconds, runs);
    fmt::print("{:>8} {:>10} {:>8} {:>12} {:>7} {:>9} {:>7}\n", "disks", "quality", "film",
               "x264 alone", "ratio", "at most", "MB");
    for (int disks : {200, 1000, 2000}) {
        const Scene scene = scene_of(disks, seconds);
        const std::vector<Yuv> frames = converted(scene);
        for (const auto& [name, quality, preset, most] :
             {std::tuple{"standard", Quality::standard, "veryfast", 0.8},
              std::tuple{"draft", Quality::draft, "ultrafast", 1.2}}) {
            std::vector<double> film, alone, ratios;
            double megabytes = 0.0;
            for (int run = 0; run < runs; ++run) {
                Progress silent(Progress::Form::silent, "");
                const RenderReport report =
                    render(scene, {.output = folder / "film.mp4", .quality = quality, .threads = 2},
                           silent);
                film.push_back(report.wall_seconds);
                alone.push_back(x264_alone(frames, preset));
                ratios.push_back(film.back() / alone.back());
                megabytes = 1e-6 * static_cast<double>(report.bytes);
            }
            fmt::print("{:>8} {:>10} {:>8.2f} {:>12.2f} {:>7.2f} {:>9.1f} {:>7.1f}\n", disks, name,
                       median(film), median(alone), median(ratios), most, megabytes);
        }
    }
    std::filesystem::remove_all(folder);
}

// Peak memory of a film, rendered before anything else has used the memory of this process.
void print_memory() {
    const auto folder = std::filesystem::temp_directory_path() / "carom-bench";
    Progress silent(Progress::Form::silent, "");
    render(scene_of(1000, 20.0), {.output = folder / "film.mp4", .threads = 2}, silent);
    std::filesystem::remove_all(folder);
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print(
        "Peak memory of a 20 s film of 1,000 disks at 1080p on two threads: {:.0f} MB (at most "
        "300)\n",
        static_cast<double>(usage.ru_maxrss) / 1024.0);
}

}  // namespace

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    print_memory();
    print_drawing();
    print_wall(quick ? 10.0 : 30.0, quick ? 3 : 5);
}
