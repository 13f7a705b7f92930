// Time, size and similarity (SSIM) of H.264 settings on films of moving disks at 1080p, and the
// wall time of segments on two cores, compared with x264 alone with two threads of its own.
//   encode_bench                      the tables of docs/encoding.md
//   encode_bench try PRESET PARAMS    one row for other settings, as parameters of x264
//   encode_bench curves [FRAMES [SCENE...]]
//                                     bytes against SSIM of scenes of the library, and the bytes
//                                     of each quality at the SSIM of veryfast at CRF 20
//   encode_bench vary [SCENE...] PARAMS...
//                                     the same for standard, and for standard with each of these
extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/log.h>
#include <libavutil/opt.h>
}

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "draw/canvas.h"
#include "draw/disks/disks.h"
#include "draw/text.h"
#include "films/film_motion.h"
#include "films/first_pass.h"
#include "media/codecs.h"
#include "media/yuv.h"
#include "panels/frame.h"
#include "runs/own_files.h"
#include "scene/load.h"
#include "util/random.h"

namespace {

using namespace carom;

constexpr int width = 1920, height = 1080, box = 1000, frames = 300, segment_frames = 150,
              row_frames = 60;

double seconds_of(clockid_t clock) {
    timespec now = {};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Disks in straight flight that are reflected by the walls, next to static text, a changing
/// histogram and changing numbers: what a film of a gas demands of an encoder.
class MovingPicture {
  public:
    explicit MovingPicture(int count);
    void draw(int frame, Canvas& canvas, DiskPainter& painter) const;
    std::size_t count() const { return flights_.size(); }

  private:
    struct Flight {
        double x, y, vx, vy;
        std::uint32_t color;
    };
    double radius_;
    std::vector<Flight> flights_;
    Canvas still_{{width, height}};
};

MovingPicture::MovingPicture(int count) : radius_(std::sqrt(0.15 / 3.1416 / count) * box) {
    Random random(1, "benchmark film");
    for (int i = 0; i < count; ++i) {
        const double vx = 4 * random.normal(), vy = 4 * random.normal();
        const auto warm = static_cast<std::uint32_t>(std::min(255.0, 18 * std::hypot(vx, vy)));
        flights_.push_back({random.uniform(0, box), random.uniform(0, box), vx, vy,
                            (warm << 16) | (150u << 8) | (255u - warm)});
    }
    still_.fill_all(rgb(0x14161c));
    still_.stroke_rect({39, 39, box + 2, box + 2}, 2, rgb(0xc8ccd4));
    for (int line = 0; line < 10; ++line)
        draw_text(still_, {1100, 80.0 + 100 * line}, "Every collision exchanges momentum, 0.123456",
                  {.size = 34.0 - 2 * (line % 4), .color = rgb(0xe8eaf0)});
}

void MovingPicture::draw(int frame, Canvas& canvas, DiskPainter& painter) const {
    canvas.restore(still_);
    Random random(static_cast<std::uint64_t>(frame), "bars");
    for (int i = 0; i < 40; ++i) {
        const double tall = 32 * i * std::exp(-0.006 * i * i) * random.uniform(0.9, 1.1);
        canvas.fill({1100 + 18.0 * i, 660 - tall, 16, tall}, rgb(0x5b8ff9));
    }
    for (int line = 0; line < 5; ++line)
        draw_text(canvas, {1100, 730.0 + 50 * line}, fmt::format("{:.4f}", random.uniform(0, 100)),
                  {.size = 34, .color = rgb(0xe8eaf0)});
    const double span = box - 2 * radius_;
    const auto thrown_back = [&](double start, double speed) {
        const double folded = std::fmod(std::abs(start + speed * frame), 2 * span);
        return static_cast<float>(40 + radius_ + (folded < span ? folded : 2 * span - folded));
    };
    std::vector<Disk> disks;
    for (const Flight& flight : flights_)
        disks.push_back({thrown_back(flight.x, flight.vx), thrown_back(flight.y, flight.vy),
                         static_cast<float>(radius_), flight.color});
    painter.draw(canvas, disks, {40, 40, box, box});
}

AVFrame* converted(const Canvas& canvas, int number) {
    AVFrame* const frame = av_frame_alloc();
    frame->format = AV_PIX_FMT_YUV420P;
    frame->width = width;
    frame->height = height;
    frame->pts = number;
    if (av_frame_get_buffer(frame, 0) < 0) std::abort();
    to_yuv420(canvas.pixels(), {frame->data[0], frame->data[1], frame->data[2], frame->linesize[0],
                                frame->linesize[1]});
    return frame;
}

/// All frames of a film, drawn and converted to the pixel format of the encoder.
struct ConvertedFrames {
    std::vector<AVFrame*> planes;
    Motion motion;
    explicit ConvertedFrames(const MovingPicture& picture)
        : motion(picture.count() < 500 ? Motion::sparse : Motion::usual) {
        Canvas canvas({width, height});
        DiskPainter painter;
        for (int i = 0; i < frames; ++i) {
            picture.draw(i, canvas, painter);
            planes.push_back(converted(canvas, i));
        }
    }
    /// `count` frames from the middle of a scene's film at 1080p.
    ConvertedFrames(const std::filesystem::path& scene, int count) {
        Progress silent(Progress::Form::silent, "");
        const FilmPlan plan = prepare(load_scene(scene, scene_resources(), {"film.size=1080p"}),
                                      {.output = "film.mp4"}, silent);
        motion = motion_of(plan.scene, plan.particles(), plan.starts.front().sample);
        FilmFrames film(plan);
        FramePainter painter(film.panels());
        const int first = std::max(0, (plan.frames() - count) / 2),
                  end = std::min(plan.frames(), first + count);
        film.go_to(static_cast<std::size_t>(end),
                   [&](const FrameData& frame, const AdvanceResult&) {
                       const int number = frame.tick.frame;
                       if (number >= first)
                           planes.push_back(converted(painter.paint(frame), number - first));
                   });
    }
    ConvertedFrames(const ConvertedFrames&) = delete;
    ConvertedFrames& operator=(const ConvertedFrames&) = delete;
    ~ConvertedFrames() {
        for (AVFrame* frame : planes) av_frame_free(&frame);
    }
};

double ssim_found = 0;

void find_ssim(void*, int, const char* format, va_list arguments) {
    std::array<char, 512> text = {};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    const char* const found = std::strstr(text.data(), "SSIM Mean Y:");
    if (found != nullptr) ssim_found = std::atof(found + std::strlen("SSIM Mean Y:"));
}

struct Encoded {
    double wall_ms = 0, cpu_ms = 0, megabytes = 0, resident_megabytes = 0;  ///< ms per frame
};

double resident_megabytes() {
    std::ifstream statm("/proc/self/statm");
    double all = 0, resident = 0;
    statm >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double drained_bytes(AVCodecContext* context, AVPacket* packet) {
    double bytes = 0;
    while (avcodec_receive_packet(context, packet) == 0) {
        bytes += packet->size;
        av_packet_unref(packet);
    }
    return bytes;
}

AVCodecContext* open_x264(const std::string& preset, const std::string& parameters, int threads) {
    const AVCodec* const codec = avcodec_find_encoder_by_name("libx264");
    AVCodecContext* const context = avcodec_alloc_context3(codec);
    context->width = width;
    context->height = height;
    context->pix_fmt = AV_PIX_FMT_YUV420P;
    context->time_base = {1, 30};
    context->thread_count = threads;
    av_opt_set(context->priv_data, "preset", preset.c_str(), 0);
    av_opt_set(context->priv_data, "x264-params", parameters.c_str(), 0);
    if (avcodec_open2(context, codec, nullptr) < 0) std::abort();
    return context;
}

Encoded encode(const ConvertedFrames& source, const std::string& preset,
               const std::string& parameters, int threads, int count = frames) {
    malloc_trim(0);
    const double resident = resident_megabytes();
    const double wall = seconds_of(CLOCK_MONOTONIC), cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    AVCodecContext* context = open_x264(preset, parameters, threads);
    AVPacket* packet = av_packet_alloc();
    Encoded result;
    for (int i = 0; i < count; ++i) {
        if (avcodec_send_frame(context, source.planes[std::size_t(i)]) < 0) std::abort();
        result.megabytes += drained_bytes(context, packet) / 1e6;
    }
    result.resident_megabytes = resident_megabytes() - resident;
    avcodec_send_frame(context, nullptr);
    result.megabytes += drained_bytes(context, packet) / 1e6;
    av_packet_free(&packet);
    avcodec_free_context(&context);
    result.wall_ms = (seconds_of(CLOCK_MONOTONIC) - wall) * 1e3 / count;
    result.cpu_ms = (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu) * 1e3 / count;
    return result;
}

// The encoder settings of carom films: groups of pictures as long as a segment, one thread.
std::string as_in_films(const std::string& parameters) {
    return fmt::format("{}:keyint={}:{}", parameters, segment_frames, shared_h264_parameters);
}

struct Likeness {
    double ssim;  ///< of luma
    double megabytes;
};

Likeness likeness(const ConvertedFrames& source, const std::string& preset,
                  const std::string& parameters, int count) {
    ssim_found = 0;
    av_log_set_level(AV_LOG_INFO);
    av_log_set_callback(find_ssim);
    const Encoded encoded = encode(source, preset, parameters + ":ssim=1", 1, count);
    av_log_set_callback([](void*, int, const char*, va_list) {});
    return {ssim_found, encoded.megabytes};
}

void print_row(const ConvertedFrames& source, const std::string& name, const std::string& preset,
               const std::string& parameters) {
    // The minimum of three: other work on the machine can only add time.
    Encoded plain = encode(source, preset, parameters, 1, row_frames);
    for (int repeat = 0; repeat < 2; ++repeat)
        plain.cpu_ms =
            std::min(plain.cpu_ms, encode(source, preset, parameters, 1, row_frames).cpu_ms);
    fmt::print("| {} | {:.1f} | {:.1f} | {:.4f} | {:.0f} |\n", name, plain.cpu_ms, plain.megabytes,
               likeness(source, preset, parameters, row_frames).ssim, plain.resident_megabytes);
    std::fflush(stdout);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double conversion_ms(const MovingPicture& picture) {
    Canvas canvas({width, height});
    DiskPainter painter;
    picture.draw(0, canvas, painter);
    AVFrame* frame = converted(canvas, 0);
    std::vector<double> times;
    for (int i = 0; i < 101; ++i) {
        const double start = seconds_of(CLOCK_THREAD_CPUTIME_ID);
        to_yuv420(canvas.pixels(), {frame->data[0], frame->data[1], frame->data[2],
                                    frame->linesize[0], frame->linesize[1]});
        times.push_back((seconds_of(CLOCK_THREAD_CPUTIME_ID) - start) * 1e3);
    }
    av_frame_free(&frame);
    return median(times);
}

struct Settings {
    std::string preset, parameters;
};

Settings settings_of(Quality quality, Motion motion) {
    std::map<std::string, std::string> options;
    for (const auto& [option, value] : h264.encoder_options(quality, motion))
        options[option] = value;
    return {options["preset"], fmt::format("{}:keyint={}", options["x264-params"], segment_frames)};
}

// The same settings with a quantiser larger by `more`; the parameters begin with qp=N.
Settings coarser(Settings its, int more) {
    const std::size_t end = its.parameters.find(':');
    const int quantiser = std::atoi(its.parameters.c_str() + std::strlen("qp="));
    its.parameters.replace(0, end, fmt::format("qp={}", quantiser + more));
    return its;
}

void print_tables(int count) {
    const MovingPicture picture(count);
    const ConvertedFrames source(picture);
    fmt::print("\n{} disks, {} frames: conversion {:.2f} ms a frame\n\n", count, frames,
               conversion_ms(picture));
    fmt::print("| settings | CPU ms a frame | MB for 60 frames | SSIM-Y | MB of memory |\n");
    fmt::print("| --- | --- | --- | --- | --- |\n");
    for (const char* preset : {"ultrafast", "superfast", "veryfast", "medium"})
        print_row(source, fmt::format("x264 {}, CRF 20", preset), preset, "crf=20");
    for (const auto& [name, quality] : {std::pair{"draft", Quality::draft},
                                        {"standard", Quality::standard},
                                        {"final", Quality::final_}}) {
        const Settings its = settings_of(quality, source.motion);
        print_row(source, name, its.preset, its.parameters);
    }
}

/// The rate-distortion curve of one setting: the setting with several quantisers.
struct Curve {
    std::string name;
    std::vector<Settings> settings;
    std::vector<double> megabytes = {}, ssims = {};
    double cpu_ms = std::numeric_limits<double>::infinity();  ///< per frame, of the second setting

    /// Megabytes at a given SSIM: the logarithm of the size is interpolated linearly in decibels of
    /// SSIM.
    double megabytes_at(double ssim) const {
        const auto decibels = [](double one) { return -10 * std::log10(1 - one); };
        std::size_t k = 1;  // the SSIM falls along the curve
        while (k + 1 < ssims.size() && ssims[k] > ssim) ++k;
        const double from = decibels(ssims[k - 1]), to = decibels(ssims[k]);
        const double share = (decibels(ssim) - from) / (to - from);
        return megabytes[k - 1] * std::pow(megabytes[k] / megabytes[k - 1], share);
    }
};

Curve curve_of(const std::string& name, const Settings& its) {
    Curve curve{name, {}};
    for (const int more : {-4, 0, 4, 8}) curve.settings.push_back(coarser(its, more));
    return curve;
}

// The curves of veryfast, of standard, and of standard with each of `vary`; if `vary` is empty,
// also of final.
std::vector<Curve> curves_to_measure(Motion motion, const std::vector<std::string>& vary) {
    Curve veryfast{"veryfast", {}};
    for (const int crf : {16, 20, 24, 28})
        veryfast.settings.push_back({"veryfast", as_in_films(fmt::format("crf={}", crf))});
    const Settings standard = settings_of(Quality::standard, motion);
    std::vector<Curve> curves{veryfast, curve_of("standard", standard)};
    if (vary.empty()) curves.push_back(curve_of("final", settings_of(Quality::final_, motion)));
    for (const std::string& parameters : vary)
        curves.push_back(
            curve_of(parameters, {standard.preset, standard.parameters + ":" + parameters}));
    return curves;
}

// CPU times are those of the second setting of each curve, measured in turn: the minimum of three.
void print_curves(const std::string& scene, int count, const std::vector<std::string>& vary) {
    const ConvertedFrames source(library_folder() / (scene + ".yaml"), count);
    const int there = static_cast<int>(source.planes.size());
    std::vector<Curve> curves = curves_to_measure(source.motion, vary);
    for (Curve& curve : curves)
        for (const auto& [preset, parameters] : curve.settings) {
            const Likeness found = likeness(source, preset, parameters, there);
            curve.megabytes.push_back(found.megabytes);
            curve.ssims.push_back(found.ssim);
        }
    for (int repeat = 0; repeat < 3; ++repeat)
        for (Curve& curve : curves)
            curve.cpu_ms = std::min(curve.cpu_ms, encode(source, curve.settings[1].preset,
                                                         curve.settings[1].parameters, 1, there)
                                                      .cpu_ms);
    const Curve& veryfast = curves.front();
    for (const Curve& curve : curves) {
        fmt::print("| {} | {} |", scene, curve.name);
        for (std::size_t k = 0; k < 4; ++k)
            fmt::print(" {:.3f}, {:.4f} |", curve.megabytes[k], curve.ssims[k]);
        fmt::print(" {:.2f} | {:.1f}, {:.2f} |\n",
                   curve.megabytes_at(veryfast.ssims[1]) / veryfast.megabytes[1], curve.cpu_ms,
                   curve.cpu_ms / veryfast.cpu_ms);
        std::fflush(stdout);
    }
}

void print_curves(int count, std::vector<std::string> scenes,
                  const std::vector<std::string>& vary = {}) {
    if (scenes.empty())
        scenes = {"one-hot-particle", "maxwell-boltzmann", "heat-flow", "cradle",
                  "classics/freezing"};
    fmt::print(
        "{} frames at 1080p: MB, SSIM-Y\n\n"
        "| scene | settings | CRF 16, finer by 4 | CRF 20, as it is | CRF 24, coarser by 4 | CRF "
        "28, by 8 | bytes at the SSIM of veryfast CRF 20 | CPU ms a frame, as a share |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
        count);
    for (const std::string& scene : scenes) print_curves(scene, count, vary);
}

}  // namespace

int main(int argc, char** argv) {
    av_log_set_callback([](void*, int, const char*, va_list) {});
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!words.empty() && words[0] == "curves") {
        const int count = words.size() > 1 ? std::atoi(words[1].c_str()) : 60;
        print_curves(count, {words.begin() + std::min<long>(2, long(words.size())), words.end()});
        return 0;
    }
    if (words.size() >= 2 && words[0] == "vary") {
        std::vector<std::string> scenes, vary;
        for (const std::string& word : std::span(words).subspan(1))
            (word.find('=') == std::string::npos ? scenes : vary).push_back(word);
        print_curves(60, scenes, vary);
        return 0;
    }
    if (words.size() >= 3 && words[0] == "try") {
        for (const int count : {200, 1000}) {
            const ConvertedFrames source{MovingPicture(count)};
            for (std::size_t i = 1; i + 1 < words.size(); i += 2)
                print_row(source, fmt::format("{} disks, {} {}", count, words[i], words[i + 1]),
                          words[i], as_in_films(words[i + 1]));
        }
        return 0;
    }
    for (const int count : {200, 1000}) print_tables(count);
}
