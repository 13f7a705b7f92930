// libav's reading and writing of a film's file: by place, so that nothing is sought, and with every
// failure kept.
#pragma once

#include <cstdint>
#include <exception>
#include <type_traits>

#include "media/libav.h"
#include "util/files/atomic_file.h"

namespace carom {

/// The file of a film as libav's muxers write it, and as they read back what they have written. The
/// muxer must be freed first.
class FilmIo {
  public:
    explicit FilmIo(AtomicFile& file);
    FilmIo(const FilmIo&) = delete;
    FilmIo& operator=(const FilmIo&) = delete;

    /// Makes a muxer write here, and open nothing by name.
    void connect(AVFormatContext& muxer);

    /// Writes what libav still holds.
    void flush() { libav::api().avio_flush(output_.context.get()); }

    /// Throws the first failure of any call so far.
    void check() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    // One use of the file, with its own place in it.
    struct Stream {
        FilmIo& io;
        std::int64_t place = 0;
        libav::Owned<AVIOContext> context;
    };
    using Bytes =
        std::conditional_t<(LIBAVFORMAT_VERSION_MAJOR >= 61), const std::uint8_t, std::uint8_t>;

    static int write(void* opaque, Bytes* bytes, int count);
    static int read(void* opaque, std::uint8_t* to, int count);
    static std::int64_t seek(void* opaque, std::int64_t offset, int from);
    static int open(AVFormatContext* muxer, AVIOContext** opened, const char* url, int flags,
                    AVDictionary** options);
    static int close(AVFormatContext* muxer, AVIOContext* opened);

    libav::Owned<AVIOContext> context_of(Stream& stream, bool is_written);
    template <class Work>
    std::int64_t kept(const Work& work);

    AtomicFile& file_;
    std::exception_ptr failure_;
    Stream output_{*this, 0, nullptr}, input_{*this, 0, nullptr};
};

}  // namespace carom
