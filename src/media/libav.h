// Shared by the files that use libav: its functions, owning types for its handles, and the texts of
// its errors.
//
// libav's libraries are loaded when a film is first encoded. Together with their dependencies they
// are 120 further libraries, and take much longer to load than the rest of the program.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
#include <libavformat/avformat.h>
#include <libavutil/cpu.h>
#include <libavutil/opt.h>
}

#include <memory>
#include <new>
#include <string>

// The functions that are used, of each library: EACH(name).
// NOLINTBEGIN(cppcoreguidelines-macro-usage): a name becomes a member and a text
#define CAROM_OF_AVUTIL(EACH)    \
    EACH(av_calloc)              \
    EACH(av_dict_free)           \
    EACH(av_dict_get)            \
    EACH(av_dict_set)            \
    EACH(av_force_cpu_flags)     \
    EACH(av_frame_alloc)         \
    EACH(av_frame_free)          \
    EACH(av_frame_get_buffer)    \
    EACH(av_frame_make_writable) \
    EACH(av_freep)               \
    EACH(av_log_set_callback)    \
    EACH(av_malloc)              \
    EACH(av_mallocz)             \
    EACH(av_opt_set)             \
    EACH(av_strerror)
#define CAROM_OF_AVCODEC(EACH)            \
    EACH(av_new_packet)                   \
    EACH(av_packet_alloc)                 \
    EACH(av_packet_free)                  \
    EACH(av_packet_new_side_data)         \
    EACH(av_packet_rescale_ts)            \
    EACH(avcodec_alloc_context3)          \
    EACH(avcodec_find_encoder_by_name)    \
    EACH(avcodec_free_context)            \
    EACH(avcodec_open2)                   \
    EACH(avcodec_parameters_alloc)        \
    EACH(avcodec_parameters_copy)         \
    EACH(avcodec_parameters_free)         \
    EACH(avcodec_parameters_from_context) \
    EACH(avcodec_receive_packet)          \
    EACH(avcodec_send_frame)              \
    EACH(avcodec_version)
#define CAROM_OF_AVFORMAT(EACH)          \
    EACH(av_write_frame)                 \
    EACH(av_write_trailer)               \
    EACH(avformat_alloc_output_context2) \
    EACH(avformat_free_context)          \
    EACH(avformat_new_stream)            \
    EACH(avformat_write_header)          \
    EACH(avio_alloc_context)             \
    EACH(avio_context_free)              \
    EACH(avio_flush)
#define CAROM_OF_AVFILTER(EACH)        \
    EACH(av_buffersink_get_frame)      \
    EACH(av_buffersrc_add_frame)       \
    EACH(avfilter_get_by_name)         \
    EACH(avfilter_graph_alloc)         \
    EACH(avfilter_graph_config)        \
    EACH(avfilter_graph_create_filter) \
    EACH(avfilter_graph_free)          \
    EACH(avfilter_link)
#define CAROM_MEMBER(name) decltype(&::name) name = nullptr;

namespace carom::libav {

/// libav's functions by their own names.
struct Functions {
    CAROM_OF_AVUTIL(CAROM_MEMBER)
    CAROM_OF_AVCODEC(CAROM_MEMBER)
    CAROM_OF_AVFORMAT(CAROM_MEMBER)
    CAROM_OF_AVFILTER(CAROM_MEMBER)
};
#undef CAROM_MEMBER
// NOLINTEND(cppcoreguidelines-macro-usage)

/// The functions of libav, loaded at the first call. Throws SystemError if they cannot be loaded,
/// e.g. because a library of the version that the program was built with is missing.
const Functions& api();

struct Free {
    void operator()(AVCodecContext* context) const { api().avcodec_free_context(&context); }
    void operator()(AVCodecParameters* parameters) const {
        api().avcodec_parameters_free(&parameters);
    }
    void operator()(AVFilterGraph* graph) const { api().avfilter_graph_free(&graph); }
    void operator()(AVFormatContext* context) const { api().avformat_free_context(context); }
    void operator()(AVFrame* frame) const { api().av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { api().av_packet_free(&packet); }
    void operator()(AVIOContext* context) const {
        api().av_freep(&context->buffer);
        api().avio_context_free(&context);
    }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

/// Throws std::bad_alloc when there is nothing to own.
template <class T>
Owned<T> owned(T* pointer) {
    if (pointer == nullptr) throw std::bad_alloc();
    return Owned<T>(pointer);
}

/// From here on, on this thread, keeps libav's last error message (see cause_of()) and suppresses
/// its output.
void listen();

/// The text of an error code.
std::string words_of(int error);

/// The text of an error code, with libav's last error message.
std::string cause_of(int error);

/// If `result` is an error, throws SystemError with the text `cannot encode with NAME: CAUSE`.
void check_encoder(const char* name, int result);

/// A new picture with allocated but unset pixels.
Owned<AVFrame> frame(AVPixelFormat format, int width, int height);

/// The encoder with this libav name, not yet opened. Throws SystemError if there is none.
Owned<AVCodecContext> encoder(const char* name);

}  // namespace carom::libav
