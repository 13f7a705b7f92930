#include "media/gif_palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>

#include "media/libav.h"
#include "util/diagnostics.h"

namespace carom {

using libav::Owned, libav::owned, libav::api;

namespace {

void check(int result) {
    if (result < 0)
        throw SystemError(
            fmt::format("cannot choose the colours of a GIF: {}", libav::cause_of(result)));
}

AVFilterContext* add_filter(AVFilterGraph& graph, const char* filter, const char* name,
                            const std::string& options) {
    const AVFilter* const found = api().avfilter_get_by_name(filter);
    if (found == nullptr)
        throw SystemError(
            fmt::format("cannot choose the colours of a GIF: this libavfilter has no {}", filter));
    AVFilterContext* context = nullptr;
    check(api().avfilter_graph_create_filter(
        &context, found, name, options.empty() ? nullptr : options.c_str(), nullptr, &graph));
    return context;
}

int distance(std::uint32_t a, std::uint32_t b) {
    int sum = 0;
    for (const int shift : {16, 8, 0}) {
        const int difference =
            static_cast<int>((a >> shift) & 255u) - static_cast<int>((b >> shift) & 255u);
        sum += difference * difference;
    }
    return sum;
}

constexpr int hash_bits = 14;

std::size_t place_of(std::uint32_t color) { return color * 2654435761u >> (32 - hash_bits); }

}  // namespace

struct PaletteMaker::Implementation {
    int width, height;
    Owned<AVFilterGraph> graph;
    AVFilterContext* source = nullptr;
    AVFilterContext* sink = nullptr;
    std::int64_t frames = 0;
};

PaletteMaker::PaletteMaker(int width, int height)
    : implementation_(std::make_unique<Implementation>()) {
    libav::listen();
    Implementation& own = *implementation_;
    own.width = width;
    own.height = height;
    own.graph = owned(api().avfilter_graph_alloc());
    AVFilterGraph& graph = *own.graph;
    graph.nb_threads = 1;
    own.source = add_filter(graph, "buffer", "in",
                            fmt::format("video_size={}x{}:pix_fmt={}:time_base=1/1", width, height,
                                        static_cast<int>(AV_PIX_FMT_RGB32)));
    AVFilterContext* const maker =
        add_filter(graph, "palettegen", "palette",
                   fmt::format("max_colors={}:reserve_transparent=1:stats_mode=full",
                               std::tuple_size_v<GifPalette>));
    own.sink = add_filter(graph, "buffersink", "out", "");
    check(api().avfilter_link(own.source, 0, maker, 0));
    check(api().avfilter_link(maker, 0, own.sink, 0));
    check(api().avfilter_graph_config(&graph, nullptr));
}

PaletteMaker::~PaletteMaker() = default;

void PaletteMaker::add(const PixelView& frame) {
    Implementation& own = *implementation_;
    assert(frame.width == own.width && frame.height == own.height);
    const Owned<AVFrame> copy = libav::frame(AV_PIX_FMT_RGB32, frame.width, frame.height);
    copy->pts = own.frames++;
    for (int y = 0; y < frame.height; ++y)
        std::memcpy(copy->data[0] + std::ptrdiff_t{y} * copy->linesize[0],
                    frame.data + std::ptrdiff_t{y} * frame.stride,
                    static_cast<std::size_t>(frame.width) * sizeof *frame.data);
    check(api().av_buffersrc_add_frame(own.source, copy.get()));
}

GifPalette PaletteMaker::finish() {
    Implementation& own = *implementation_;
    assert(own.frames > 0);
    check(api().av_buffersrc_add_frame(own.source, nullptr));
    const Owned<AVFrame> colors = owned(api().av_frame_alloc());
    check(api().av_buffersink_get_frame(own.sink, colors.get()));
    GifPalette palette;
    constexpr int side = 16;
    assert(colors->width == side && colors->height == side);
    for (int y = 0; y < side; ++y)
        std::memcpy(palette.data() + std::ptrdiff_t{y} * side,
                    colors->data[0] + std::ptrdiff_t{y} * colors->linesize[0],
                    side * sizeof palette[0]);
    own.graph.reset();
    for (std::uint32_t& color : palette) color |= 0xff000000u;
    palette.back() = 0;
    return palette;
}

ColorFinder::ColorFinder(const GifPalette& palette)
    : palette_(palette), known_(std::size_t{1} << hash_bits) {
    for (Known& known : known_) known = {palette_[0], 0};
}

void ColorFinder::find(const std::uint32_t* pixels, std::uint8_t* indices, int count) {
    for (int i = 0; i < count; ++i) {
        const std::uint32_t color = pixels[i] | 0xff000000u;
        Known& known = known_[place_of(color)];
        if (known.color != color) known = {color, nearest(color)};
        indices[i] = known.index;
    }
}

std::uint8_t ColorFinder::nearest(std::uint32_t color) const {
    int best = 0, least = std::numeric_limits<int>::max();
    for (int i = 0; i < gif_colors; ++i)
        if (const int apart = distance(color, palette_[static_cast<std::size_t>(i)]);
            apart < least) {
            least = apart;
            best = i;
        }
    return static_cast<std::uint8_t>(best);
}

}  // namespace carom
