// Where the frames of a film go: a video, or a folder of pictures. Segments are worked on side by
// side, each on one thread, and joined in order; the result depends on the frames alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "draw/canvas.h"
#include "util/pending/pending_output.h"

namespace carom {

class Archive;

enum class Quality { draft, standard, final_ };

/// How a film moves, for its encoder.
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
    int width = 1920, height = 1080;  ///< of the drawn frames; odd sizes are padded to even ones by
                                      ///< repeating the last row and column
    int fps = 30;
    Quality quality = Quality::standard;
    Motion motion = Motion::usual;
    bool transparent = false;  ///< frames have alpha, and so has the film: VP9 only
    std::uint32_t behind = 0;  ///< 0xffRRGGBB shown by players that know no transparency
    std::vector<std::pair<std::string, std::string>>
        metadata;  ///< title, description, comment, ... as libav names them
    std::vector<FilmChapter> chapters = {};  ///< in order; none: the film has no chapters
    bool has_sound = false;                  ///< and add_sound() is called; not in every format
};

/// Bytes of encoded frames that a segment keeps in memory, at most: more wait in a temporary file
/// where there is room for one.
inline constexpr std::size_t most_encoded_bytes = 2 << 20;

/// What becomes of one run of frames. It may refer to its FilmWriter.
class FilmSegment {
  public:
    FilmSegment() = default;
    virtual ~FilmSegment() = default;
    FilmSegment(const FilmSegment&) = delete;
    FilmSegment& operator=(const FilmSegment&) = delete;

    virtual void add(const Canvas& frame) = 0;  ///< the next one in order
    virtual void finish() {}                    ///< after its last frame, on the same thread

    /// Writes what has become of its frames, after finish(); or reads it into a new segment of the
    /// same number in another writer with the same settings, in place of frames. Throws
    /// SystemError.
    virtual void archive(Archive& archive) = 0;
    virtual void join() = 0;  ///< to the film: all segments in order, one at a time
};

/// The library that encodes, with its version.
std::string encoding_library();

/// A film that is being written; it appears whole or not at all. All throw SystemError.
class FilmWriter : public PendingOutput {
  public:
    /// The document of which each frame is a page, to be drawn one after the other, each ended by
    /// end_page() (draw/pages/pages.h). Null where frames are pixels, which segments take.
    virtual Canvas* document() { return nullptr; }

    /// Colours for the whole film, 0xffRRGGBB, before the first segment: for a format that has few
    /// of them (OutputFormat::previews).
    virtual void use_colors(const std::vector<std::uint32_t>&) {}

    /// Adds sound from sample number `first` of the film on (sound/rate.h), behind all that was
    /// added before: in order, and before the segments are joined that it belongs to. It is silent
    /// in between, and from there to the end. Throws std::logic_error where the film has no sound.
    virtual void add_sound(std::int64_t /*first*/, std::span<const std::int16_t> /*samples*/) {
        throw std::logic_error("a film without sound");
    }

    /// The segment that begins with frame number `first`, from 0. From any thread.
    virtual std::unique_ptr<FilmSegment> segment(int first) = 0;
    virtual std::int64_t bytes() const = 0;  ///< of all that was written, after settle
};

/// H.264 and AAC in MP4, and VP9 and Opus in WebM: the index first, at a constant rate. Each
/// segment is encoded by a single-threaded encoder to a group of pictures that decodes on its own;
/// they are joined by stream copy.
std::unique_ptr<FilmWriter> mp4_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int frames);
std::unique_ptr<FilmWriter> webm_film(const std::filesystem::path& path,
                                      const VideoSettings& settings, int frames);

/// A PDF with a page of lines, curves and text for each frame. It has no segments: to ask for one
/// throws std::logic_error.
std::unique_ptr<FilmWriter> pdf_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int frames);

/// A folder of frame-00001.png and so on, which must be empty if it is there already. `frames` are
/// those of the whole film: so many digits.
std::unique_ptr<FilmWriter> folder_of_frames(const std::filesystem::path& path,
                                             const VideoSettings& settings, int frames);

}  // namespace carom
