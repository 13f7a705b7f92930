// Where films go: what -o and --format say, together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom {

/// What a film can be, as --format names it: png is a folder of frames.
inline const std::vector<std::string> film_formats = {"mp4", "webm", "gif", "png"};

/// -o and --format as given; either may be empty.
struct FilmDestination {
    std::string output;
    std::string format;
    bool several = false;  ///< scenes
};

/// The path of the film of `scene`, as film_writer() reads it, or `-` for standard output. Throws
/// UsageError when -o and --format contradict one another, or what is there already.
std::filesystem::path film_path(const FilmDestination& destination, const std::string& scene);

/// The kind of the film at such a path.
std::string film_format(const FilmDestination& destination, const std::filesystem::path& path);

}  // namespace carom
