// What carom render says of a film that it has made.
#pragma once

#include <string>

#include "app/film/render.h"
#include "media/formats.h"

namespace carom {

/// The seconds of each stage, and what they were spent on.
std::string timings_of(const RenderReport& report);

/// What may disappoint: its size for its format or `in_page`, words that are cut. Empty: nothing.
std::string warnings_of(const RenderReport& report, const OutputFormat& format, bool in_page);

}  // namespace carom
