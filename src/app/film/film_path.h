// Where films go: what -o and --format say, together.
#pragma once

#include <filesystem>
#include <string>

namespace carom {

/// -o and --format as given; either may be empty.
struct FilmDestination {
    std::string output;
    std::string format;
    bool several = false;  ///< scenes
};

/// Whether a path has the ending of a film that is one file.
bool is_video(const std::filesystem::path& path);

/// The path of the film of `scene`, as format_of_film() reads it; of one for standard output the
/// name that it would have. Throws UsageError when -o and --format contradict one another, or what
/// is there already.
std::filesystem::path film_path(const FilmDestination& destination, const std::string& scene);

}  // namespace carom
