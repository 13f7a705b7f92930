#include "media/libav.h"

#include <fmt/format.h>

#include <array>
#include <cstdarg>
#include <cstdio>

#include "util/diagnostics.h"

namespace carom::libav {
namespace {

// libav returns "generic error in an external library" and logs what was wrong: that is kept, and
// everything else that it would print is not.
thread_local std::string last_complaint;

void keep_complaint(void*, int level, const char* format, va_list arguments) {
    if (level > AV_LOG_ERROR) return;
    std::array<char, 256> text = {};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    last_complaint = text.data();
    while (!last_complaint.empty() && last_complaint.back() == '\n') last_complaint.pop_back();
}

}  // namespace

void listen() {
    [[maybe_unused]] static const bool once = (av_log_set_callback(keep_complaint), true);
    last_complaint.clear();
}

std::string words_of(int error) {
    std::array<char, AV_ERROR_MAX_STRING_SIZE> text = {};
    av_strerror(error, text.data(), text.size());
    return text.data();
}

std::string cause_of(int error) {
    return last_complaint.empty() ? words_of(error)
                                  : fmt::format("{} ({})", words_of(error), last_complaint);
}

void check_encoder(const char* name, int result) {
    if (result < 0)
        throw SystemError(fmt::format("cannot encode with {}: {}", name, cause_of(result)));
}

Owned<AVFrame> frame(AVPixelFormat format, int width, int height) {
    Owned<AVFrame> made = owned(av_frame_alloc());
    made->format = format;
    made->width = width;
    made->height = height;
    if (av_frame_get_buffer(made.get(), 0) < 0) throw std::bad_alloc();
    return made;
}

Owned<AVCodecContext> encoder(const char* name) {
    const AVCodec* const codec = avcodec_find_encoder_by_name(name);
    if (codec == nullptr)
        throw SystemError(fmt::format("cannot encode: this libavcodec has no {}", name));
    return owned(avcodec_alloc_context3(codec));
}

}  // namespace carom::libav
