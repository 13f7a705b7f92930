#include "media/film_io.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <span>

namespace carom {

using libav::Owned, libav::owned, libav::api;

FilmIo::FilmIo(AtomicFile& file) : file_(file) { output_.context = context_of(output_, true); }

Owned<AVIOContext> FilmIo::context_of(Stream& stream, bool is_written) {
    constexpr int block = 1 << 15;
    void* buffer = api().av_malloc(block);
    if (buffer == nullptr) throw std::bad_alloc();
    AVIOContext* const context = api().avio_alloc_context(
        static_cast<unsigned char*>(buffer), block, is_written ? 1 : 0, &stream, read, write, seek);
    if (context == nullptr) api().av_freep(&buffer);
    return owned(context);
}

void FilmIo::connect(AVFormatContext& muxer) {
    muxer.pb = output_.context.get();
    muxer.opaque = this;
    muxer.io_open = open;
    muxer.io_close2 = close;
}

// No exception may pass through libav.
template <class Work>
std::int64_t FilmIo::kept(const Work& work) {
    try {
        return work();
    } catch (...) {
        if (!failure_) failure_ = std::current_exception();
        return AVERROR(EIO);
    }
}

int FilmIo::write(void* opaque, Bytes* bytes, int count) {
    auto& stream = *static_cast<Stream*>(opaque);
    return static_cast<int>(stream.io.kept([&] {
        stream.io.file_.write_at(stream.place, {bytes, static_cast<std::size_t>(count)});
        stream.place += count;
        return count;
    }));
}

int FilmIo::read(void* opaque, std::uint8_t* to, int count) {
    auto& stream = *static_cast<Stream*>(opaque);
    return static_cast<int>(stream.io.kept([&]() -> std::int64_t {
        const auto done = static_cast<std::int64_t>(
            stream.io.file_.read_at(stream.place, {to, static_cast<std::size_t>(count)}));
        stream.place += done;
        return done > 0 ? done : AVERROR_EOF;
    }));
}

std::int64_t FilmIo::seek(void* opaque, std::int64_t offset, int from) {
    auto& stream = *static_cast<Stream*>(opaque);
    return stream.io.kept([&]() -> std::int64_t {
        if (from == AVSEEK_SIZE) return stream.io.file_.size();
        const int whence = from & ~AVSEEK_FORCE;
        const std::int64_t start = whence == SEEK_SET   ? 0
                                   : whence == SEEK_CUR ? stream.place
                                                        : stream.io.file_.size();
        if (start + offset < 0) return AVERROR(EINVAL);
        return stream.place = start + offset;
    });
}

// To put the index first, a muxer opens its own file a second time, for reading.
int FilmIo::open(AVFormatContext* muxer, AVIOContext** opened, const char*, int flags,
                 AVDictionary**) {
    auto& io = *static_cast<FilmIo*>(muxer->opaque);
    if ((flags & AVIO_FLAG_WRITE) != 0 || io.input_.context) return AVERROR(EINVAL);
    return static_cast<int>(io.kept([&] {
        io.input_.place = 0;
        io.input_.context = io.context_of(io.input_, false);
        *opened = io.input_.context.get();
        return 0;
    }));
}

int FilmIo::close(AVFormatContext* muxer, AVIOContext*) {
    static_cast<FilmIo*>(muxer->opaque)->input_.context.reset();
    return 0;
}

}  // namespace carom
