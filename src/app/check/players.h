// Whether players commonly play the MP4 of a scene's film.
#pragma once

#include <vector>

#include "app/report/facts.h"
#include "media/formats.h"

namespace carom {

struct Film;

/// The lowest H.264 level that allows the film; null if no level does, or if MP4 is not one of the
/// formats.
Json h264_level_of(const Film& film, const std::vector<const OutputFormat*>& formats);

/// A row that says so if few players have this level.
Facts player_rows(const Film& film, const std::vector<const OutputFormat*>& formats);

}  // namespace carom
