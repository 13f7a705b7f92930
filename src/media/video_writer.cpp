#include "media/video_writer.h"

extern "C" {
#include <libavutil/opt.h>
}

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <exception>
#include <limits>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "media/h264_settings.h"
#include "media/libav.h"
#include "media/vp9_settings.h"
#include "media/yuv.h"
#include "util/atomic_file.h"
#include "util/diagnostics.h"

namespace carom {

using libav::cause_of, libav::Owned, libav::owned;

namespace {

constexpr int io_buffer_bytes = 1 << 18;

const char* encoder_name(VideoFormat format) {
    return format == VideoFormat::webm ? "libvpx-vp9" : "libx264";
}

void check_encoder(VideoFormat format, int result) {
    libav::check_encoder(encoder_name(format), result);
}

void tag_as_bt709(AVCodecContext& context) {
    context.color_range = AVCOL_RANGE_MPEG;
    context.color_primaries = AVCOL_PRI_BT709;
    context.color_trc = AVCOL_TRC_BT709;
    context.colorspace = AVCOL_SPC_BT709;
    context.chroma_sample_location = AVCHROMA_LOC_LEFT;
    context.sample_aspect_ratio = {1, 1};
}

using Options = std::vector<std::pair<const char*, std::string>>;

// A segment is one group of pictures, however long.
Options h264_options(Quality quality) {
    const H264Settings chosen = h264_settings(quality);
    return {{"preset", chosen.preset},
            {"profile", "high"},
            {"x264-params",
             fmt::format("{}:keyint=infinite:{}", chosen.parameters, shared_h264_parameters)}};
}

// Without look-ahead and hidden reference frames every packet is a frame that is shown.
Options vp9_options(Quality quality) {
    const Vp9Settings chosen = vp9_settings(quality);
    return {{"deadline", chosen.deadline},
            {"cpu-used", chosen.cpu_used},
            {"crf", chosen.crf},
            {"lag-in-frames", "0"},
            {"auto-alt-ref", "0"},
            {"row-mt", "0"},
            {"aq-mode", "0"}};
}

Owned<AVCodecContext> open_encoder(const VideoSettings& settings) {
    const VideoFormat format = settings.format;
    Owned<AVCodecContext> context = libav::encoder(encoder_name(format));
    context->width = even_size(settings.width);
    context->height = even_size(settings.height);
    context->pix_fmt = settings.transparent ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
    context->time_base = {1, settings.fps};
    context->framerate = {settings.fps, 1};
    context->thread_count = 1;
    context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
    tag_as_bt709(*context);
    if (format == VideoFormat::webm) {
        context->bit_rate = 0;  // crf alone decides
        context->gop_size = std::numeric_limits<int>::max();
    }

    const Options options = format == VideoFormat::webm ? vp9_options(settings.quality)
                                                        : h264_options(settings.quality);
    for (const auto& [name, value] : options)
        check_encoder(format, av_opt_set(context->priv_data, name, value.c_str(), 0));
    check_encoder(format, avcodec_open2(context.get(), nullptr, nullptr));
    return context;
}

Owned<AVFrame> frame_for(const AVCodecContext& context, VideoFormat format) {
    Owned<AVFrame> frame = owned(av_frame_alloc());
    frame->format = context.pix_fmt;
    frame->width = context.width;
    frame->height = context.height;
    frame->color_range = context.color_range;
    frame->color_primaries = context.color_primaries;
    frame->color_trc = context.color_trc;
    frame->colorspace = context.colorspace;
    frame->chroma_location = context.chroma_sample_location;
    check_encoder(format, av_frame_get_buffer(frame.get(), 0));
    return frame;
}

bool same_stream(const AVCodecParameters& a, const AVCodecParameters& b) {
    return a.width == b.width && a.height == b.height &&
           std::equal(a.extradata, a.extradata + a.extradata_size, b.extradata,
                      b.extradata + b.extradata_size);
}

// The texts that libavformat stores in an MP4 file; it drops every other without a word.
constexpr std::array<std::string_view, 14> keys_of_mp4 = {
    "title",     "artist", "album",  "album_artist", "composer",    "date",     "comment",
    "copyright", "genre",  "lyrics", "grouping",     "description", "synopsis", "keywords"};

void set_metadata(AVFormatContext& context, const VideoSettings& settings) {
    std::string others;
    for (const auto& [key, value] : settings.metadata) {
        if (settings.format == VideoFormat::webm ||  // which keeps every name
            std::find(keys_of_mp4.begin(), keys_of_mp4.end(), key) != keys_of_mp4.end())
            av_dict_set(&context.metadata, key.c_str(), value.c_str(), 0);
        else
            others += fmt::format("{}{}={}", others.empty() ? "" : ", ", key, value);
    }
    if (others.empty()) return;
    if (av_dict_get(context.metadata, "keywords", nullptr, 0) != nullptr) others = ", " + others;
    av_dict_set(&context.metadata, "keywords", others.c_str(), AV_DICT_APPEND);
}

// libav's view of an atomic file. Exceptions may not cross its C code: the first is kept here.
struct FileAccess {
    AtomicFile* file = nullptr;
    std::exception_ptr* error = nullptr;
    std::int64_t offset = 0;
};

template <class Work>
bool succeeds(FileAccess& access, Work work) {
    if (*access.error) return false;
    try {
        work();
        return true;
    } catch (...) {
        *access.error = std::current_exception();
        return false;
    }
}

int write_bytes(void* opaque, libav::WrittenByte* data, int size) {
    auto& access = *static_cast<FileAccess*>(opaque);
    const bool written = succeeds(access, [&] {
        access.file->seek(access.offset);
        access.file->write(std::span(data, static_cast<std::size_t>(size)));
    });
    if (!written) return AVERROR(EIO);
    access.offset += size;
    return size;
}

int read_bytes(void* opaque, std::uint8_t* data, int size) {
    auto& access = *static_cast<FileAccess*>(opaque);
    std::int64_t count = 0;
    const bool done = succeeds(access, [&] {
        access.file->seek(access.offset);
        count = access.file->read(std::span(data, static_cast<std::size_t>(size)));
    });
    if (!done) return AVERROR(EIO);
    access.offset += count;
    return count == 0 ? AVERROR_EOF : static_cast<int>(count);
}

std::int64_t seek_to(void* opaque, std::int64_t offset, int whence) {
    auto& access = *static_cast<FileAccess*>(opaque);
    std::int64_t size = 0;
    if (!succeeds(access, [&] { size = access.file->size(); })) return AVERROR(EIO);
    if ((whence & AVSEEK_SIZE) != 0) return size;
    const int from = whence & ~AVSEEK_FORCE;
    const std::int64_t start = from == SEEK_CUR ? access.offset : from == SEEK_END ? size : 0;
    return access.offset = start + offset;
}

Owned<AVIOContext> open_io(FileAccess& access, bool writing) {
    auto* const buffer = static_cast<std::uint8_t*>(av_malloc(io_buffer_bytes));
    AVIOContext* const context = avio_alloc_context(buffer, io_buffer_bytes, writing ? 1 : 0,
                                                    &access, read_bytes, write_bytes, seek_to);
    if (context == nullptr) av_free(buffer);
    return owned(context);
}

}  // namespace

struct EncodedSegment::Implementation {
    std::vector<Owned<AVPacket>> packets;  ///< in decoding order
    Owned<AVCodecParameters> parameters;
    AVRational time_base = {1, 1};
    int reordering = 0;  ///< frames by which decoding runs ahead of showing
    std::int64_t bytes = 0;
};

EncodedSegment::EncodedSegment() : implementation_(std::make_unique<Implementation>()) {}
EncodedSegment::~EncodedSegment() = default;
EncodedSegment::EncodedSegment(EncodedSegment&&) noexcept = default;
EncodedSegment& EncodedSegment::operator=(EncodedSegment&&) noexcept = default;
int EncodedSegment::frames() const { return static_cast<int>(implementation_->packets.size()); }
std::int64_t EncodedSegment::bytes() const { return implementation_->bytes; }

struct SegmentEncoder::Implementation {
    VideoSettings settings;
    Owned<AVCodecContext> context;
    Owned<AVFrame> frame;
    EncodedSegment segment;

    void take_packets(EncodedSegment::Implementation& into);
};

void SegmentEncoder::Implementation::take_packets(EncodedSegment::Implementation& into) {
    while (true) {
        Owned<AVPacket> packet = owned(av_packet_alloc());
        const int result = avcodec_receive_packet(context.get(), packet.get());
        if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
        check_encoder(settings.format, result);
        into.bytes += packet->size;
        into.packets.push_back(std::move(packet));
    }
}

SegmentEncoder::SegmentEncoder(const VideoSettings& settings)
    : implementation_(std::make_unique<Implementation>()) {
    libav::listen();
    implementation_->settings = settings;
    implementation_->context = open_encoder(settings);
    implementation_->frame = frame_for(*implementation_->context, settings.format);
    implementation_->frame->pts = 0;
}

SegmentEncoder::~SegmentEncoder() = default;
SegmentEncoder::SegmentEncoder(SegmentEncoder&&) noexcept = default;

void SegmentEncoder::add(const PixelView& frame) {
    Implementation& own = *implementation_;
    assert(frame.width == own.settings.width && frame.height == own.settings.height);
    AVFrame& planes = *own.frame;
    check_encoder(own.settings.format, av_frame_make_writable(&planes));
    const YuvPlanes to{planes.data[0],     planes.data[1], planes.data[2],    planes.linesize[0],
                       planes.linesize[1], planes.data[3], planes.linesize[3]};
    if (own.settings.transparent)
        to_yuva420(frame, own.settings.behind, to);
    else
        to_yuv420(frame, to);
    check_encoder(own.settings.format, avcodec_send_frame(own.context.get(), &planes));
    ++planes.pts;
    own.take_packets(*own.segment.implementation_);
}

EncodedSegment SegmentEncoder::finish() {
    Implementation& own = *implementation_;
    EncodedSegment::Implementation& segment = *own.segment.implementation_;
    check_encoder(own.settings.format, avcodec_send_frame(own.context.get(), nullptr));
    own.take_packets(segment);
    assert(std::int64_t{own.segment.frames()} == own.frame->pts);
    segment.parameters = owned(avcodec_parameters_alloc());
    check_encoder(own.settings.format,
                  avcodec_parameters_from_context(segment.parameters.get(), own.context.get()));
    segment.time_base = own.context->time_base;
    segment.reordering = own.context->has_b_frames;
    own.context.reset();
    own.frame.reset();
    return std::move(own.segment);
}

struct VideoWriter::Implementation {
    Implementation(const std::filesystem::path& path, VideoSettings chosen)
        : settings(std::move(chosen)), file(path) {}

    void start(const EncodedSegment::Implementation& segment);
    void check(int result);
    static int open_to_read(AVFormatContext* context, AVIOContext** io, const char* url, int flags,
                            AVDictionary** options);
    static int close_after_reading(AVFormatContext* context, AVIOContext* io);

    VideoSettings settings;
    AtomicFile file;
    std::exception_ptr error;
    FileAccess writing{&file, &error, 0};
    FileAccess reading{&file, &error, 0};
    Owned<AVIOContext> io;
    Owned<AVFormatContext> format;
    Owned<AVCodecParameters> parameters;  ///< of the first segment
    std::int64_t frames = 0;
    std::int64_t bytes = 0;
};

// A failed write is reported by libav late, in other words, or only by the context's error field:
// what the file itself said comes first.
void VideoWriter::Implementation::check(int result) {
    if (error) std::rethrow_exception(error);
    const int late = io ? io->error : 0;
    if (result >= 0 && late >= 0) return;
    throw SystemError(fmt::format("cannot write {}: {}", file.path().string(),
                                  cause_of(result < 0 ? result : late)));
}

// What was written is read back, to move it behind the index.
int VideoWriter::Implementation::open_to_read(AVFormatContext* context, AVIOContext** opened,
                                              const char*, int flags, AVDictionary**) {
    auto& own = *static_cast<Implementation*>(context->opaque);
    if (flags != AVIO_FLAG_READ) return AVERROR(EINVAL);
    own.reading.offset = 0;
    try {
        *opened = open_io(own.reading, false).release();
    } catch (const std::bad_alloc&) {
        return AVERROR(ENOMEM);
    }
    return 0;
}

int VideoWriter::Implementation::close_after_reading(AVFormatContext*, AVIOContext* opened) {
    Owned<AVIOContext>{opened}.reset();
    return 0;
}

void VideoWriter::Implementation::start(const EncodedSegment::Implementation& segment) {
    AVFormatContext* allocated = nullptr;
    const bool webm = settings.format == VideoFormat::webm;
    check(avformat_alloc_output_context2(&allocated, nullptr, webm ? "webm" : "mp4", nullptr));
    format = owned(allocated);
    io = open_io(writing, true);
    format->pb = io.get();
    format->url = av_strdup(file.path().c_str());
    format->opaque = this;
    format->io_open = open_to_read;
    format->io_close2 = close_after_reading;
    format->flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_CUSTOM_IO;
    set_metadata(*format, settings);

    AVStream* const stream = avformat_new_stream(format.get(), nullptr);
    if (stream == nullptr) throw std::bad_alloc();
    parameters = owned(avcodec_parameters_alloc());
    check(avcodec_parameters_copy(parameters.get(), segment.parameters.get()));
    check(avcodec_parameters_copy(stream->codecpar, segment.parameters.get()));
    stream->time_base = segment.time_base;
    if (settings.transparent) av_dict_set(&stream->metadata, "alpha_mode", "1", 0);
    stream->avg_frame_rate = {settings.fps, 1};
    AVDictionary* options = nullptr;
    if (webm)
        av_dict_set(&options, "cues_to_front", "1", 0);
    else
        av_dict_set(&options, "movflags", "faststart", 0);
    const int result = avformat_write_header(format.get(), &options);
    av_dict_free(&options);
    check(result);
}

VideoWriter::VideoWriter(const std::filesystem::path& path, const VideoSettings& settings) {
    libav::listen();
    implementation_ = std::make_unique<Implementation>(path, settings);
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::append(EncodedSegment segment) {
    Implementation& own = *implementation_;
    EncodedSegment::Implementation& next = *segment.implementation_;
    assert(segment.frames() > 0);
    if (!own.format) own.start(next);
    if (!same_stream(*own.parameters, *next.parameters))
        throw SystemError(
            fmt::format("cannot write {}: its segments were encoded with different parameters",
                        own.file.path().string()));

    const AVRational stream_time = own.format->streams[0]->time_base;
    std::int64_t index = own.frames;
    for (Owned<AVPacket>& packet : next.packets) {
        packet->stream_index = 0;
        packet->pts += own.frames;
        // At a constant rate the decoding time is the number in the file, whatever its segment.
        packet->dts = index++ - next.reordering;
        packet->duration = 1;
        av_packet_rescale_ts(packet.get(), next.time_base, stream_time);
        own.check(av_write_frame(own.format.get(), packet.get()));
        packet.reset();
    }
    own.frames = index;
}

void VideoWriter::commit() {
    Implementation& own = *implementation_;
    assert(own.frames > 0);
    own.check(av_write_trailer(own.format.get()));
    avio_flush(own.io.get());
    own.check(0);
    own.bytes = own.file.size();
    own.file.commit();
}

std::int64_t VideoWriter::bytes() const { return implementation_->bytes; }

}  // namespace carom
