// Films as H.264 or VP9, with or without sound: libav's encoders, its muxers, and the file itself.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "media/codecs.h"
#include "media/film_file.h"
#include "media/film_io.h"
#include "media/film_writer.h"
#include "media/libav.h"
#include "media/sound_encoder.h"
#include "media/yuv.h"
#include "sound/rate.h"
#include "util/archive.h"
#include "util/diagnostics.h"
#include "util/files/spool.h"

namespace carom {

using libav::Owned, libav::owned, libav::api;

namespace {

void tag_as_bt709(AVCodecContext& context) {
    context.color_range = AVCOL_RANGE_MPEG;
    context.color_primaries = AVCOL_PRI_BT709;
    context.color_trc = AVCOL_TRC_BT709;
    context.colorspace = AVCOL_SPC_BT709;
    context.chroma_sample_location = AVCHROMA_LOC_LEFT;
    context.sample_aspect_ratio = {1, 1};
}

Owned<AVCodecContext> open_encoder(const VideoSettings& settings, const Codec& codec) {
    Owned<AVCodecContext> context = libav::encoder(codec.encoder);
    context->width = even_size(settings.width);
    context->height = even_size(settings.height);
    context->pix_fmt = settings.transparent ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
    context->time_base = {1, settings.fps};
    context->framerate = {settings.fps, 1};
    context->thread_count = 1;
    context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
    context->bit_rate = 0;  // the quality alone decides
    context->gop_size = std::numeric_limits<int>::max();
    tag_as_bt709(*context);
    for (const auto& [name, value] : codec.encoder_options(settings.quality, settings.motion))
        libav::check_encoder(codec.encoder,
                             api().av_opt_set(context->priv_data, name, value.c_str(), 0));
    libav::check_encoder(codec.encoder, api().avcodec_open2(context.get(), nullptr, nullptr));
    return context;
}

Owned<AVFrame> frame_for(const AVCodecContext& context) {
    Owned<AVFrame> frame = libav::frame(context.pix_fmt, context.width, context.height);
    frame->color_range = context.color_range;
    frame->color_primaries = context.color_primaries;
    frame->color_trc = context.color_trc;
    frame->colorspace = context.colorspace;
    frame->chroma_location = context.chroma_sample_location;
    return frame;
}

bool same_stream(const AVCodecParameters& a, const AVCodecParameters& b) {
    return a.width == b.width && a.height == b.height &&
           std::equal(a.extradata, a.extradata + a.extradata_size, b.extradata,
                      b.extradata + b.extradata_size);
}

// The metadata keys that libavformat stores in an MP4 file; it drops all others silently.
constexpr std::array<std::string_view, 14> keys_of_mp4 = {
    "title",     "artist", "album",  "album_artist", "composer",    "date",     "comment",
    "copyright", "genre",  "lyrics", "grouping",     "description", "synopsis", "keywords"};

void set_metadata(AVFormatContext& context, const VideoSettings& settings, const Codec& codec) {
    std::string others;
    for (const auto& [key, value] : settings.metadata) {
        if (value.empty()) continue;
        if (codec.keeps_all_metadata ||
            std::find(keys_of_mp4.begin(), keys_of_mp4.end(), key) != keys_of_mp4.end())
            api().av_dict_set(&context.metadata, key.c_str(), value.c_str(), 0);
        else
            others += fmt::format("{}{}={}", others.empty() ? "" : ", ", key, value);
    }
    if (others.empty()) return;
    if (api().av_dict_get(context.metadata, "keywords", nullptr, 0) != nullptr)
        others = ", " + others;
    api().av_dict_set(&context.metadata, "keywords", others.c_str(), AV_DICT_APPEND);
}

void set_chapters(AVFormatContext& context, const VideoSettings& settings) {
    const std::size_t count = settings.chapters.size();
    if (count == 0) return;
    context.chapters = static_cast<AVChapter**>(api().av_calloc(count, sizeof(AVChapter*)));
    if (context.chapters == nullptr) throw std::bad_alloc();
    for (const FilmChapter& its : settings.chapters) {
        auto* chapter = static_cast<AVChapter*>(api().av_mallocz(sizeof(AVChapter)));
        if (chapter == nullptr) throw std::bad_alloc();
        context.chapters[context.nb_chapters++] = chapter;
        chapter->id = context.nb_chapters;
        chapter->time_base = {1, settings.fps};
        chapter->start = its.first;
        chapter->end = its.end;
        api().av_dict_set(&chapter->metadata, "title", its.title.c_str(), 0);
    }
}

// Side data of a packet: WebM keeps its alpha planes there.
void archive_side_data(Archive& archive, AVPacket& packet, int index) {
    AVPacketSideDataType type = {};
    std::vector<std::uint8_t> bytes;
    if (!archive.is_reading()) {
        const AVPacketSideData& its = packet.side_data[index];
        type = its.type;
        bytes.assign(its.data, its.data + its.size);
    }
    archive(type, bytes);
    if (!archive.is_reading()) return;
    std::uint8_t* const data = api().av_packet_new_side_data(&packet, type, bytes.size());
    if (data == nullptr) throw std::bad_alloc();
    std::ranges::copy(bytes, data);
}

// Writes or reads the parts of a packet that an encoder sets, in decoding order.
void archive_packet(Archive& archive, AVPacket& packet) {
    std::vector<std::uint8_t> bytes(packet.data, packet.data + packet.size);
    std::int64_t time = packet.pts;
    int flags = packet.flags;
    archive(bytes, time, flags);
    if (archive.is_reading()) {
        if (api().av_new_packet(&packet, static_cast<int>(bytes.size())) < 0)
            throw std::bad_alloc();
        std::ranges::copy(bytes, packet.data);
        packet.pts = time;
        packet.flags = flags;
    }
    auto count = static_cast<std::int32_t>(packet.side_data_elems);
    archive(count);
    for (int k = 0; k < count; ++k) archive_side_data(archive, packet, k);
}

std::string bytes_of(AVPacket& packet) {
    Archive archive;
    archive_packet(archive, packet);
    return archive.finished();
}

Owned<AVPacket> packet_of(std::string bytes) {
    Owned<AVPacket> packet = owned(api().av_packet_alloc());
    Archive archive(std::move(bytes), "an encoded frame");
    archive_packet(archive, *packet);
    archive.expect_end();
    return packet;
}

class VideoFilm : public FilmInFile {
  public:
    VideoFilm(const std::filesystem::path& path, VideoSettings settings, const Codec& codec)
        : FilmInFile(path, std::move(settings)), codec_(codec) {
        libav::listen();
        if (settings_.has_sound) sound_.emplace(codec_.sound);
    }

    void add_sound(std::int64_t first, std::span<const std::int16_t> samples) override;
    std::unique_ptr<FilmSegment> segment(int) override { return std::make_unique<Segment>(*this); }

  private:
    class Segment : public FilmSegment {
      public:
        explicit Segment(VideoFilm& film);
        void add(const Canvas& frame) override;
        void finish() override;
        void archive(Archive& archive) override;
        void join() override { film_.append(*this); }

      private:
        friend class VideoFilm;
        void check(int result) const { libav::check_encoder(film_.codec_.encoder, result); }
        void open();
        void keep_parameters();
        void encode(const AVFrame* frame);

        VideoFilm& film_;
        Owned<AVCodecContext> context_;
        Owned<AVFrame> frame_;
        std::uint64_t converted_ = 0;        ///< Canvas::picture() that `frame_` holds
        Spool packets_{most_encoded_bytes};  ///< as bytes_of(), in decoding order
        Owned<AVCodecParameters> parameters_;
        AVRational time_base_ = {1, 1};
        int reordering_ = 0;  ///< number of frames by which decoding runs ahead of showing
    };

    void write_end() override;
    void start(const Segment& segment);
    void append(Segment& segment);
    void start_sound();
    void write_sound_until(std::int64_t frame);
    void write(AVPacket& packet, int stream, AVRational time_base);
    void check(int result) const;

    /// The parameters of an encoder of this film, for segments that were encoded elsewhere.
    struct Template {
        Owned<AVCodecParameters> parameters;
        AVRational time_base;
        int reordering;
    };
    std::optional<Template> template_;

    const Codec& codec_;
    std::optional<SoundEncoder> sound_;
    std::optional<FilmIo> io_;
    Owned<AVFormatContext> format_;
    Owned<AVCodecParameters> parameters_;  ///< of the first segment
    std::int64_t frames_ = 0;
};

VideoFilm::Segment::Segment(VideoFilm& film) : film_(film) { libav::listen(); }

void VideoFilm::Segment::open() {
    context_ = open_encoder(film_.settings_, film_.codec_);
    frame_ = frame_for(*context_);
    frame_->pts = 0;
}

void VideoFilm::Segment::add(const Canvas& canvas) {
    if (!context_) open();
    const PixelView frame = canvas.pixels();
    const VideoSettings& settings = film_.settings_;
    assert(frame.width == settings.width && frame.height == settings.height);
    AVFrame& planes = *frame_;
    check(api().av_frame_make_writable(&planes));
    const YuvPlanes to{planes.data[0],     planes.data[1], planes.data[2],    planes.linesize[0],
                       planes.linesize[1], planes.data[3], planes.linesize[3]};
    if (settings.transparent)
        to_yuva420(frame, settings.behind, to);
    else if (const auto changed = canvas.changes_since(converted_))
        to_yuv420(frame, *changed, to);
    else
        to_yuv420(frame, to);
    converted_ = canvas.picture();
    encode(&planes);
    ++planes.pts;
}

// Null flushes the frames that the encoder still holds.
void VideoFilm::Segment::encode(const AVFrame* frame) {
    check(api().avcodec_send_frame(context_.get(), frame));
    while (true) {
        Owned<AVPacket> packet = owned(api().av_packet_alloc());
        const int result = api().avcodec_receive_packet(context_.get(), packet.get());
        if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
        check(result);
        packets_.add(bytes_of(*packet));
    }
}

void VideoFilm::Segment::finish() {
    encode(nullptr);
    assert(static_cast<std::int64_t>(packets_.size()) == frame_->pts);
    keep_parameters();
}

void VideoFilm::Segment::keep_parameters() {
    parameters_ = owned(api().avcodec_parameters_alloc());
    check(api().avcodec_parameters_from_context(parameters_.get(), context_.get()));
    time_base_ = context_->time_base;
    reordering_ = context_->has_b_frames;
    context_.reset();
    frame_.reset();
}

// The parameters must equal those of an encoder with the same settings; they are compared, as the
// libraries of two machines may differ.
void VideoFilm::Segment::archive(Archive& archive) {
    if (archive.is_reading()) {
        if (!film_.template_) {
            open();
            keep_parameters();
            film_.template_ = {std::move(parameters_), time_base_, reordering_};
        }
        parameters_ = owned(api().avcodec_parameters_alloc());
        check(api().avcodec_parameters_copy(parameters_.get(), film_.template_->parameters.get()));
        time_base_ = film_.template_->time_base;
        reordering_ = film_.template_->reordering;
    }
    std::vector<std::uint8_t> header(parameters_->extradata,
                                     parameters_->extradata + parameters_->extradata_size);
    const std::vector<std::uint8_t> own = header;
    archive(header);
    if (header != own) archive.refuse("it was encoded with other parameters");
    archive(packets_);
}

// libav reports a failed write late, with another error, or not at all.
void VideoFilm::check(int result) const {
    if (io_) io_->check();
    if (result >= 0) return;
    throw_system_error(
        fmt::format("cannot write {}: {}", file_.path().string(), libav::cause_of(result)),
        AVUNERROR(result));
}

void VideoFilm::start(const Segment& segment) {
    AVFormatContext* allocated = nullptr;
    check(api().avformat_alloc_output_context2(&allocated, nullptr, codec_.container, nullptr));
    format_ = owned(allocated);
    io_.emplace(file_).connect(*format_);
    // Each packet is written at once, so that a full disk stops the work early.
    format_->flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_FLUSH_PACKETS;
    set_metadata(*format_, settings_, codec_);
    set_chapters(*format_, settings_);

    AVStream* const stream = api().avformat_new_stream(format_.get(), nullptr);
    if (stream == nullptr) throw std::bad_alloc();
    parameters_ = owned(api().avcodec_parameters_alloc());
    check(api().avcodec_parameters_copy(parameters_.get(), segment.parameters_.get()));
    check(api().avcodec_parameters_copy(stream->codecpar, segment.parameters_.get()));
    stream->time_base = segment.time_base_;
    if (settings_.transparent) api().av_dict_set(&stream->metadata, "alpha_mode", "1", 0);
    stream->avg_frame_rate = {settings_.fps, 1};
    if (sound_) start_sound();
    AVDictionary* options = nullptr;
    api().av_dict_set(&options, codec_.index_first.first, codec_.index_first.second, 0);
    const int result = api().avformat_write_header(format_.get(), &options);
    api().av_dict_free(&options);
    check(result);
}

void VideoFilm::append(Segment& segment) {
    if (!format_) start(segment);
    if (!same_stream(*parameters_, *segment.parameters_))
        throw SystemError(
            fmt::format("cannot write {}: its segments were encoded with different parameters",
                        file_.path().string()));

    std::int64_t index = frames_;
    for (std::size_t k = 0; k < segment.packets_.size(); ++k) {
        const Owned<AVPacket> packet = packet_of(segment.packets_.piece(k));
        write_sound_until(index);
        packet->pts += frames_;
        // At a constant rate the decoding time is the number in the file, whatever its segment.
        packet->dts = index++ - segment.reordering_;
        packet->duration = 1;
        write(*packet, 0, segment.time_base_);
    }
    frames_ = index;
}

void VideoFilm::write(AVPacket& packet, int stream, AVRational time_base) {
    packet.stream_index = stream;
    api().av_packet_rescale_ts(&packet, time_base, format_->streams[stream]->time_base);
    check(api().av_write_frame(format_.get(), &packet));
}

void VideoFilm::add_sound(std::int64_t first, std::span<const std::int16_t> samples) {
    if (!sound_) throw std::logic_error("a film without sound");
    sound_->fill(first);
    sound_->add(samples);
}

void VideoFilm::start_sound() {
    AVStream* const stream = api().avformat_new_stream(format_.get(), nullptr);
    if (stream == nullptr) throw std::bad_alloc();
    check(api().avcodec_parameters_copy(stream->codecpar, &sound_->parameters()));
    stream->time_base = {1, sound_rate};
}

// Packets are stored in the file in the order in which they are played. In WebM the time stamps of
// Opus include the samples that a decoder drops at the start; libavformat before FFmpeg 6 does not
// add them, and shifts the pictures instead.
void VideoFilm::write_sound_until(std::int64_t frame) {
    if (!sound_) return;
    constexpr bool is_added = LIBAVFORMAT_VERSION_MAJOR >= 60;
    const AVCodecParameters& its = sound_->parameters();
    const bool is_missing = !is_added && its.codec_id == AV_CODEC_ID_OPUS;
    const std::int64_t dropped = is_missing ? its.initial_padding : 0;
    while (const Owned<AVPacket> packet = sound_->next(samples_before(frame, settings_.fps))) {
        packet->pts += dropped;
        packet->dts += dropped;
        write(*packet, 1, {1, sound_rate});
    }
}

void VideoFilm::write_end() {
    assert(frames_ > 0);
    if (sound_) {
        sound_->fill(samples_before(frames_, settings_.fps));
        sound_->finish();
        write_sound_until(std::numeric_limits<std::int32_t>::max());
    }
    check(api().av_write_trailer(format_.get()));
    io_->flush();
    check(0);
}

}  // namespace

std::string encoding_library() {
    const unsigned version = api().avcodec_version();
    return fmt::format("libavcodec {}.{}.{}", AV_VERSION_MAJOR(version), AV_VERSION_MINOR(version),
                       AV_VERSION_MICRO(version));
}

std::unique_ptr<FilmWriter> mp4_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int) {
    return std::make_unique<VideoFilm>(path, settings, h264);
}

std::unique_ptr<FilmWriter> webm_film(const std::filesystem::path& path,
                                      const VideoSettings& settings, int) {
    return std::make_unique<VideoFilm>(path, settings, vp9);
}

}  // namespace carom
