// What carom render says of a film that it has made.
#pragma once

#include <string>
#include <vector>

#include "app/film/render.h"
#include "media/formats.h"

namespace carom {

/// The seconds of each stage, and what they were spent on.
std::string timings_of(const RenderReport& report);

/// Of a scene with sound whose film is in a format without.
std::string warning_of_silence(const OutputFormat& format);

/// That there is no room for these (FramePainter::cut_words()). Empty: nothing is cut.
std::string warning_of_cut(const std::vector<std::string>& cut);

/// What may disappoint: no sound, its size for its format or `in_page`, words that are cut,
/// callouts that are not there. Empty: nothing.
std::string warnings_of(const RenderReport& report, const OutputFormat& format, bool in_page);

}  // namespace carom
