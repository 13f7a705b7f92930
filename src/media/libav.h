// What the files that use libav share: owning types for its handles, and the words of its errors.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavformat/avformat.h>
}

#include <memory>
#include <new>
#include <string>

namespace carom::libav {

struct Free {
    void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
    void operator()(AVCodecParameters* parameters) const { avcodec_parameters_free(&parameters); }
    void operator()(AVFilterGraph* graph) const { avfilter_graph_free(&graph); }
    void operator()(AVFormatContext* context) const { avformat_free_context(context); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVIOContext* context) const { avio_close(context); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

/// Throws std::bad_alloc when there is nothing to own.
template <class T>
Owned<T> owned(T* pointer) {
    if (pointer == nullptr) throw std::bad_alloc();
    return Owned<T>(pointer);
}

/// Keeps what libav complains of from here on, on this thread, and lets it print nothing.
void listen();

/// The words of an error code.
std::string words_of(int error);

/// The same with the last complaint.
std::string cause_of(int error);

/// Throws SystemError, `cannot encode with NAME: CAUSE`, when `result` is an error.
void check_encoder(const char* name, int result);

/// An empty picture with room for its pixels.
Owned<AVFrame> frame(AVPixelFormat format, int width, int height);

/// An encoder by libav's name of it, not yet opened. Throws SystemError when there is none.
Owned<AVCodecContext> encoder(const char* name);

}  // namespace carom::libav
