// The destination of the frames of a film: a video or a folder of pictures. Segments of a film can
// be processed in parallel, each on one thread, and are joined in order; the result depends on the
// frames alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draw/canvas.h"
#include "util/pending/pending_output.h"

namespace carom {

class Archive;

enum class Quality { draft, standard, final_ };

/// The kind of motion in a film, for its encoder.
enum class Motion {
    sparse,  ///< few edges, slowly
    usual,   ///< many edges; or beads or a field, slowly
    fast     ///< few edges, by several pixels from frame to frame
};

/// A part of a film that players can jump to.
struct FilmChapter {
    int first = 0, end = 0;  ///< frames
    std::string title;
};

struct VideoSettings {
    /// Of the drawn frames; odd sizes are padded to even ones by repeating the last row and column.
    int width = 1920, height = 1080;
    int fps = 30;
    Quality quality = Quality::standard;
    Motion motion = Motion::usual;
    bool transparent = false;  ///< frames have alpha, and so has the film: VP9 only
    std::uint32_t behind = 0;  ///< background 0xffRRGGBB for players without transparency
    /// Title, description, comment, ... as libav names them.
    std::vector<std::pair<std::string, std::string>> metadata;
    std::vector<FilmChapter> chapters = {};  ///< in order; none: the film has no chapters
    bool has_sound = false;  ///< the film has sound, given by add_sound(); not in every format
    /// Its file is temporary, to be read by FilmWriter::copy(): it is not committed, and its path
    /// is not used.
    bool is_scratch = false;
};

/// The largest number of bytes of encoded frames that a segment keeps in memory; any more go to a
/// temporary file if there is room for one.
inline constexpr std::size_t most_encoded_bytes = 2 << 20;

/// Processes consecutive frames of a film. It may refer to its FilmWriter.
class FilmSegment {
  public:
    FilmSegment() = default;
    virtual ~FilmSegment() = default;
    FilmSegment(const FilmSegment&) = delete;
    FilmSegment& operator=(const FilmSegment&) = delete;

    virtual void add(const Canvas& frame) = 0;  ///< the next one in order
    virtual void finish() {}                    ///< after its last frame, on the same thread

    /// After finish(), writes the encoded frames; or reads them into a new segment of the same
    /// number, of another writer with the same settings, instead of adding frames. Throws
    /// SystemError.
    virtual void archive(Archive& archive) = 0;
    virtual void join() = 0;  ///< appends it to the film: all segments in order, one at a time
};

/// The name and version of the encoding library.
std::string encoding_library();

/// A film that is being written; its file appears complete or not at all. All functions throw
/// SystemError.
class FilmWriter : public PendingOutput {
  public:
    /// The document in which each frame is a page. Pages are drawn one after the other, each ended
    /// by end_page() (draw/pages/pages.h). Null if frames are pixels, which are given to segments.
    virtual Canvas* document() { return nullptr; }

    /// Chooses the colours 0xffRRGGBB of the whole film, before the first segment: for formats that
    /// have few colours (OutputFormat::previews).
    virtual void use_colors(const std::vector<std::uint32_t>&) {}

    /// Adds sound that begins at sample number `first` of the film (sound/rate.h), after all sound
    /// added before: in order, and before the segments that it belongs to are joined. Gaps, and the
    /// rest of the film, are silent. Throws std::logic_error if the film has no sound.
    virtual void add_sound(std::int64_t /*first*/, std::span<const std::int16_t> /*samples*/) {
        throw std::logic_error("a film without sound");
    }

    /// A new segment that begins with frame number `first`, counted from 0. May be called from any
    /// thread.
    virtual std::unique_ptr<FilmSegment> segment(int first) = 0;
    virtual std::int64_t bytes() const = 0;  ///< size of the finished film, after settle()

    /// Passes the bytes of the finished film on, in order and in pieces, after settle(). Throws
    /// std::logic_error if the film is a folder.
    virtual void copy(const std::function<void(std::string_view)>& /*take*/) const {
        throw std::logic_error("a film of several files");
    }
};

/// H.264 and AAC in MP4, or VP9 and Opus in WebM: with the index first, at a constant frame rate.
/// Each segment is encoded by a single-threaded encoder to a group of pictures that can be decoded
/// independently; segments are joined by stream copy.
std::unique_ptr<FilmWriter> mp4_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int frames);
std::unique_ptr<FilmWriter> webm_film(const std::filesystem::path& path,
                                      const VideoSettings& settings, int frames);

/// A PDF with a page of lines, curves and text for each frame. It has no segments: segment() throws
/// std::logic_error.
std::unique_ptr<FilmWriter> pdf_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int frames);

/// A folder of pictures frame-00001.png and so on; an existing folder must be empty. `frames`, the
/// number of frames of the whole film, determines the number of digits.
std::unique_ptr<FilmWriter> folder_of_frames(const std::filesystem::path& path,
                                             const VideoSettings& settings, int frames);

}  // namespace carom
