// The paths of films, as determined by -o and --format together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom {

/// -o and --format as given; either may be empty.
struct FilmDestination {
    std::string output;
    std::string format;
    bool several = false;  ///< the command renders several scenes
};

/// Whether a path has the ending of a film format that is a single file.
bool is_video(const std::filesystem::path& path);

/// The path of the film of `scene`, from which format_of_film() takes the format. For standard
/// output, a device or a pipe, the path that the film would have as a file. Throws UsageError if -o
/// and --format contradict each other or what already exists at the path.
std::filesystem::path film_path(const FilmDestination& destination, const std::string& scene);

}  // namespace carom
