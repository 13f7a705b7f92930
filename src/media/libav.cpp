#include "media/libav.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <system_error>

#include "util/diagnostics.h"

namespace carom::libav {
namespace {

// libav returns "generic error in an external library" and logs what was wrong: the last logged
// error is kept, and nothing is printed.
thread_local std::string last_complaint;

void keep_complaint(void*, int level, const char* format, va_list arguments) {
    if (level > AV_LOG_ERROR) return;
    std::array<char, 256> text = {};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    last_complaint = text.data();
    while (!last_complaint.empty() && last_complaint.back() == '\n') last_complaint.pop_back();
}

std::string words_of_loader() {
    const char* const words = dlerror();
    return words != nullptr ? words : "there is no memory for its words";
}

// The libraries that the program was built with may lie in a folder that the system does not
// search.
void* load(const char* name, int version) {
#ifdef __APPLE__
    const std::string file = fmt::format("lib{}.{}.dylib", name, version);
#else
    const std::string file = fmt::format("lib{}.so.{}", name, version);
#endif
    constexpr int flags = RTLD_LAZY | RTLD_LOCAL;
    if (void* const found = dlopen(file.c_str(), flags)) return found;
    const std::string reason = words_of_loader();
    const std::string path = std::string(CAROM_LIBAV_FOLDER) + "/" + file;
    if (void* const found = dlopen(path.c_str(), flags)) return found;
    const bool is_there = access(path.c_str(), F_OK) == 0;
    throw SystemError(fmt::format(
        "cannot encode films: {}{}", reason,
        is_there ? "" : "; install FFmpeg's libraries of the version that carom was built with"));
}

void* find(void* library, const char* name) {
    if (void* const found = dlsym(library, name)) return found;
    throw SystemError(fmt::format("cannot encode films: {}", words_of_loader()));
}

// libgcrypt, which libavformat depends on, terminates the program if it cannot open a file.
void require_descriptor() {
    const int descriptor = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        const int error = errno;
        throw_system_error(fmt::format("cannot encode films: /dev/null cannot be opened: {}",
                                       std::generic_category().message(error)),
                           error);
    }
    close(descriptor);
}

Functions loaded() {
    require_descriptor();
    Functions all;
    void* library = nullptr;
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage)
#define CAROM_FIND(name) all.name = reinterpret_cast<decltype(all.name)>(find(library, #name));
    library = load("avutil", LIBAVUTIL_VERSION_MAJOR);
    CAROM_OF_AVUTIL(CAROM_FIND)
    library = load("avcodec", LIBAVCODEC_VERSION_MAJOR);
    CAROM_OF_AVCODEC(CAROM_FIND)
    library = load("avformat", LIBAVFORMAT_VERSION_MAJOR);
    CAROM_OF_AVFORMAT(CAROM_FIND)
    library = load("avfilter", LIBAVFILTER_VERSION_MAJOR);
    CAROM_OF_AVFILTER(CAROM_FIND)
#undef CAROM_FIND
    return all;
}

}  // namespace

const Functions& api() {
    static const Functions functions = loaded();
    return functions;
}

void listen() {
    [[maybe_unused]] static const bool once = (api().av_log_set_callback(keep_complaint), true);
    last_complaint.clear();
}

std::string words_of(int error) {
    std::array<char, AV_ERROR_MAX_STRING_SIZE> text = {};
    api().av_strerror(error, text.data(), text.size());
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
    Owned<AVFrame> made = owned(api().av_frame_alloc());
    made->format = format;
    made->width = width;
    made->height = height;
    if (api().av_frame_get_buffer(made.get(), 0) < 0) throw std::bad_alloc();
    return made;
}

Owned<AVCodecContext> encoder(const char* name) {
    const AVCodec* const codec = api().avcodec_find_encoder_by_name(name);
    if (codec == nullptr)
        throw SystemError(fmt::format("cannot encode: this libavcodec has no {}", name));
    return owned(api().avcodec_alloc_context3(codec));
}

}  // namespace carom::libav
