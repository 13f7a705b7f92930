// Messages of `carom render` about a finished film.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/pages/slides.h"
#include "films/render.h"
#include "media/formats.h"

namespace carom {

struct Film;

/// What was made, in a line; with --max-size (empty: not given) also in which shape. `name`: of the
/// output.
std::string words_of(const RenderReport& report, const Film& film, const std::string& name,
                     const std::string& max_size);

/// A table of the seconds of each stage, and what they were spent on.
std::string timings_of(const RenderReport& report);

/// Warns that the format of the film has no sound although the scene has.
std::string warning_of_silence(const OutputFormat& format);

/// Warns that there was no room for these words (words_without_room()). Empty if nothing is
/// cut.
std::string warning_of_cut(const std::vector<std::string>& cut);

/// All warnings about a film: missing sound, a large size for its format or for a page (`in_page`),
/// words that are cut, callouts that no frame shows. Empty if there are none.
std::string warnings_of(const RenderReport& report, const OutputFormat& format, bool in_page);

/// What was made of a folder of slides, in a line; `page` is the name of its page.
std::string words_of(const SlidesReport& report, const std::string& page, std::size_t slides);

/// Warns of files that were replaced, or left, because others have changed them. Empty if there are
/// none.
std::string warnings_of(const SlidesReport& report, const std::string& folder);

}  // namespace carom
