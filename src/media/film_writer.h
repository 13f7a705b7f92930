// Where the frames of a film go: a video, or a folder of pictures. Segments are worked on side by
// side, each on one thread, and joined in order; the result depends on the frames alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "draw/canvas.h"
#include "media/video_writer.h"

namespace carom {

/// What becomes of one run of frames. It may refer to its FilmWriter.
class FilmSegment {
  public:
    FilmSegment() = default;
    virtual ~FilmSegment() = default;
    FilmSegment(const FilmSegment&) = delete;
    FilmSegment& operator=(const FilmSegment&) = delete;

    virtual void add(const Canvas& frame) = 0;  ///< the next one in order
    virtual void finish() = 0;                  ///< after its last frame, on the same thread
    virtual void join() = 0;  ///< to the film: all segments in order, one at a time
};

/// A film that is being written; it appears whole or not at all. All throw SystemError.
class FilmWriter {
  public:
    FilmWriter() = default;
    virtual ~FilmWriter() = default;  ///< uncommitted: leaves nothing
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    /// How many frames, spread over the whole film, it must see before the first segment: to choose
    /// its colours. None: preview() and previews_done() are not called.
    virtual int wanted_previews() const { return 0; }
    virtual void preview(const Canvas&) {}  ///< one of them, in order
    virtual void previews_done() {}

    /// The segment that begins with frame number `first`, from 0. From any thread.
    virtual std::unique_ptr<FilmSegment> segment(int first) = 0;
    virtual void commit() = 0;
    virtual std::int64_t bytes() const = 0;  ///< of all that was written, after commit
};

/// A folder of frame-00001.png and so on when `path` ends in a slash (it must be empty if it is
/// there already), otherwise by its extension: .webm, .gif, MP4 under any other name.
/// `frames` are those of the whole film: so many digits.
std::unique_ptr<FilmWriter> film_writer(const std::filesystem::path& path,
                                        const VideoSettings& settings, int frames);

}  // namespace carom
