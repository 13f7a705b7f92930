// The paths of films, as determined by -o and --format together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom {

/// -o, --format, --page and --slides as given; each may be empty.
struct FilmDestination {
    std::string output;
    std::string format;
    std::string page = {};    ///< kind of the page that contains the film
    std::string slides = {};  ///< folder of slides that contains the films
    bool several = false;     ///< the command renders several scenes
};

/// Whether a path has the ending of a film format that is a single file.
bool is_video(const std::filesystem::path& path);

/// The path of the film of `scene`, from which format_of_film() takes the format. For standard
/// output, a device or a pipe, the path that the film would have as a file. Throws UsageError if -o
/// and --format contradict each other or what already exists at the path.
std::filesystem::path film_path(const FilmDestination& destination, const std::string& scene);

/// The paths of the films of scenes, or of the pages that contain them; with `is_joined` that of
/// the one film of all. Throws UsageError as film_path(), and if two would be the same.
std::vector<std::filesystem::path> outputs_of(const FilmDestination& destination,
                                              const std::vector<std::string>& scenes,
                                              bool is_joined);

/// The path from which the format of such a film is determined.
std::filesystem::path film_at(const FilmDestination& destination,
                              const std::filesystem::path& output);

}  // namespace carom
