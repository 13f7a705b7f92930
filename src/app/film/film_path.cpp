#include "app/film/film_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "app/command.h"
#include "app/output.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// Endings of films that are one file.
std::vector<std::string> video_extensions() {
    std::vector<std::string> endings;
    for (const std::string& name : film_formats())
        if (name != "png") endings.push_back("." + name);
    return endings;
}

bool is_video(const fs::path& path) {
    return std::ranges::count(video_extensions(), path.extension().string()) > 0;
}

bool is_folder(const std::string& output) {
    std::error_code error;  // a name that cannot be looked at will be told when it is written
    return output.ends_with('/') || fs::is_directory(output, error);
}

// Frames never go among other files: whose they are could not be told afterwards.
void refuse_used_folder(const std::string& output, const std::string& scene) {
    std::error_code error;
    if (!fs::is_directory(output, error)) return;
    if (!fs::is_empty(output, error) && !error)
        throw UsageError(
            fmt::format("-o {}: numbered frames go into a new or empty folder, and this one holds "
                        "files; for a film in it write -o {}{}.mp4",
                        output, output, scene_stem(scene)));
    if (is_same_file(output, "."))
        throw UsageError(fmt::format(
            "-o {}: this is the working folder; name a new one for the frames", output));
}

fs::path frames_folder(std::string output, const std::string& scene) {
    if (!output.ends_with('/')) output += '/';
    refuse_used_folder(output, scene);
    return output;
}

fs::path standard_output(const FilmDestination& destination) {
    if (destination.several)
        throw UsageError("-o -: several scenes are written into a folder; name one");
    if (destination.format == "png")
        throw UsageError(
            "-o -: numbered frames are many files, standard output is one; name a folder");
    return destination.output;
}

void refuse_other_ending(const FilmDestination& destination) {
    const auto& [output, format, several] = destination;
    const std::string extension = fs::path(output).extension().string();
    if (is_video(output) && !format.empty() && "." + format != extension)
        throw UsageError(fmt::format("-o {}: the name ends in {}, and --format asks for {}", output,
                                     extension, format));
    if (several && is_video(output))
        throw UsageError(
            fmt::format("-o {}: several scenes are written into a folder; name one", output));
}

// One film, named by -o as a file or as its folder of frames.
fs::path named_path(const FilmDestination& destination, const std::string& scene) {
    const auto& [output, format, several] = destination;
    if (output.ends_with('/') || (format == "png" && !is_video(output)))
        return frames_folder(output, scene);
    if (!is_video(output) && !is_same_file(output, scene))
        throw UsageError(
            fmt::format("-o {}: a film ends in {}; a folder of PNG frames ends in a slash", output,
                        listed(video_extensions(), "or")));
    return output_path(output, false, scene, {fs::path(output).extension().string()});
}

}  // namespace

fs::path film_path(const FilmDestination& destination, const std::string& scene) {
    const auto& [output, format, several] = destination;
    if (Output::is_standard_output(output)) return standard_output(destination);
    refuse_other_ending(destination);
    const bool frames = format == "png";
    const bool in_folder =
        several || output.empty() ||
        (is_folder(output) && !(output.ends_with('/') && (frames || format.empty())));
    if (!in_folder) return named_path(destination, scene);
    const fs::path film =
        output_path(output, several, scene, {"." + (format.empty() ? "mp4" : format)});
    return frames ? frames_folder((film.parent_path() / film.stem()).string(), scene) : film;
}

const OutputFormat& film_format(const FilmDestination& destination, const fs::path& path) {
    if (!Output::is_standard_output(path.string())) return format_of_film(path);
    return output_format(destination.format.empty() ? "mp4" : destination.format);
}

}  // namespace carom
