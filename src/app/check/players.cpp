#include "app/check/players.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "media/codecs.h"
#include "scene/film.h"

namespace carom {
namespace {

bool has_mp4(const std::vector<const OutputFormat*>& formats) {
    return std::ranges::find(formats, "mp4", &OutputFormat::name) != formats.end();
}

std::optional<H264Level> level_of(const Film& film) {
    return h264_level(film.size.width, film.size.height, film.fps);
}

}  // namespace

Json h264_level_of(const Film& film, const std::vector<const OutputFormat*>& formats) {
    const std::optional<H264Level> level = level_of(film);
    return level && has_mp4(formats) ? Json(level->name) : Json();
}

Facts player_rows(const Film& film, const std::vector<const OutputFormat*>& formats) {
    const std::optional<H264Level> level = level_of(film);
    if (!has_mp4(formats) || (level && level->is_common)) return {};
    const std::string its =
        level ? fmt::format("needs H.264 level {}", level->name) : "is beyond all levels of H.264";
    return {
        {"", nullptr, "players",
         fmt::format("many refuse the mp4: it {}, and most decoders end at level 5.2 (3840 by 2160 "
                     "at 60 frames a second, 4096 by 2304 at 56); give a smaller --size or a "
                     "lower --fps, or make webm",
                     its)}};
}

}  // namespace carom
