// The file that a film is written to, for the writers of the formats.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "media/film_writer.h"
#include "util/files/atomic_file.h"

namespace carom {

/// A new file at the path or, if the settings say so, a temporary one. Throws as AtomicFile does.
inline AtomicFile file_of_film(const std::filesystem::path& path, const VideoSettings& settings) {
    return settings.is_scratch ? AtomicFile(Scratch{}) : AtomicFile(path);
}

/// As FilmWriter::copy().
void copy_file(const AtomicFile& file, const std::function<void(std::string_view)>& take);

}  // namespace carom
