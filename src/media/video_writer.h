// H.264 in MP4 or VP9 in WebM: segments encoded each by its own single-threaded encoder, joined by
// stream copy. The one door to libav. Owns settings, colour tags, metadata and the file; knows
// nothing of scenes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "draw/canvas.h"

namespace carom {

enum class Quality { draft, standard, final_ };

enum class VideoFormat { mp4, webm };  ///< H.264 in MP4, VP9 in WebM

struct VideoSettings {
    int width = 1920, height = 1080;  ///< of the drawn frames; odd sizes are padded to even ones by
                                      ///< repeating the last row and column
    int fps = 30;
    Quality quality = Quality::standard;
    VideoFormat format = VideoFormat::mp4;
    bool transparent = false;  ///< frames have alpha, and so has the film: VP9 only
    std::uint32_t behind = 0;  ///< 0xffRRGGBB shown by players that know no transparency
    std::vector<std::pair<std::string, std::string>>
        metadata;  ///< title, description, comment, ... as libav names them
};

/// The finished packets of one segment: a closed group of pictures that decodes on its own. A
/// movable value.
class EncodedSegment {
  public:
    EncodedSegment();
    ~EncodedSegment();
    EncodedSegment(EncodedSegment&&) noexcept;
    EncodedSegment& operator=(EncodedSegment&&) noexcept;
    int frames() const;
    std::int64_t bytes() const;

  private:
    friend class SegmentEncoder;
    friend class VideoWriter;
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Encodes the frames of one segment, in order, on the calling thread alone: the same bytes on any
/// number of cores.
class SegmentEncoder {
  public:
    explicit SegmentEncoder(
        const VideoSettings& settings);  ///< throws SystemError naming codec and cause
    ~SegmentEncoder();
    SegmentEncoder(SegmentEncoder&&) noexcept;

    void add(const PixelView&
                 frame);      ///< converted to 4:2:0 BT.709 limited range; size as in the settings
    EncodedSegment finish();  ///< flushes; the encoder is spent afterwards

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Joins segments into one file (index first, constant rate), whole or not at all.
class VideoWriter {
  public:
    VideoWriter(const std::filesystem::path& path,
                const VideoSettings& settings);  ///< throws SystemError
    ~VideoWriter();                              ///< uncommitted: leaves nothing

    void append(EncodedSegment segment);  ///< the next one in order
    void commit();  ///< trailer, sync, rename; any write error, late ones too, is a SystemError and
                    ///< leaves an earlier file as it was
    std::int64_t bytes() const;  ///< of the file, after commit

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
