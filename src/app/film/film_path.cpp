#include "app/film/film_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "app/command.h"
#include "app/output.h"
#include "media/formats.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// The file endings of film formats that are single files.
std::vector<std::string> video_extensions() {
    std::vector<std::string> endings;
    for (const std::string& name : film_formats())
        if (name != "png") endings.push_back("." + name);
    return endings;
}

// Frames are never written into a folder with other files, from which they could not be told apart
// later.
void refuse_used_folder(const std::string& output, const std::string& scene) {
    std::error_code error;
    if (!fs::is_directory(output, error)) return;
    if (!fs::is_empty(output, error) && !error)
        throw UsageError(
            fmt::format("-o {}: frames need a new or empty folder, and this one holds files; for a "
                        "film in it write -o {}{}.mp4",
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

[[noreturn]] void refuse_several(const std::string& output) {
    throw UsageError(fmt::format("-o {}: several scenes need a folder; name one", output));
}

// For standard output, a device or a pipe: the path that the film would have as a file.
fs::path streamed_path(const FilmDestination& destination) {
    const auto& [output, format, page, slides, several] = destination;
    if (several) refuse_several(output);
    if (format == "png")
        throw UsageError(fmt::format(
            "-o {}: frames are several files and cannot go to {}; name a "
            "folder",
            output, Output::is_standard_output(output) ? "standard output" : "a device or a pipe"));
    if (is_video(output)) {
        refuse_other_format(output, format);
        return "film" + ending_of(output);
    }
    return "film." + (format.empty() ? "mp4" : format);
}

// The path of a single film whose file or folder of frames is given by -o.
fs::path named_path(const FilmDestination& destination, const std::string& scene) {
    const auto& [output, format, page, slides, several] = destination;
    if (output.ends_with('/') || (format == "png" && !is_video(output)))
        return frames_folder(output, scene);
    if (!is_video(output) && !is_same_file(output, scene))
        throw UsageError(
            fmt::format("-o {}: a film ends in {}; a folder of PNG frames ends in a slash", output,
                        listed(video_extensions(), "or")));
    return output_path(output, false, scene, {ending_of(output)});
}

// Of a film that a page shows.
std::string format_of_page(const FilmDestination& its) {
    return its.format.empty() ? "mp4" : its.format;
}

// The path of the film of a scene, or of the page that contains it.
fs::path output_of(const FilmDestination& its, const std::string& scene) {
    if (!its.slides.empty())
        return fs::path(its.slides) / (scene_stem(scene) + "." + format_of_page(its));
    if (its.page.empty()) return film_path(its, scene);
    if (Output::is_standard_output(its.output)) return its.output;
    return output_path(its.output, its.several, scene, {"." + its.page});
}

}  // namespace

bool is_video(const fs::path& path) {
    return std::ranges::count(video_extensions(), ending_of(path)) > 0;
}

fs::path film_path(const FilmDestination& destination, const std::string& scene) {
    const auto& [output, format, page, slides, several] = destination;
    if (Output::is_stream(output)) return streamed_path(destination);
    if (is_video(output)) refuse_other_format(output, format);
    if (several && is_video(output)) refuse_several(output);
    const bool frames = format == "png";
    const bool in_folder =
        several || output.empty() ||
        (names_folder(output) && !(output.ends_with('/') && (frames || format.empty())));
    if (!in_folder) return named_path(destination, scene);
    const fs::path film =
        output_path(output, several, scene, {"." + (format.empty() ? "mp4" : format)});
    return frames ? frames_folder((film.parent_path() / film.stem()).string(), scene) : film;
}

std::vector<fs::path> outputs_of(const FilmDestination& destination,
                                 const std::vector<std::string>& scenes, bool is_joined) {
    if (is_joined) return {film_path(destination, scenes.front())};
    std::vector<fs::path> outputs;
    for (const std::string& scene : scenes) {
        const fs::path path = output_of(destination, scene);
        if (std::ranges::find(outputs, path) != outputs.end())
            throw UsageError(fmt::format("two scenes would be written to {}; {}", path.string(),
                                         destination.slides.empty()
                                             ? "render them one by one with -o"
                                             : "rename one of them"));
        outputs.push_back(path);
    }
    return outputs;
}

fs::path film_at(const FilmDestination& destination, const fs::path& output) {
    if (destination.page.empty()) return output;
    return "film." + format_of_page(destination);
}

}  // namespace carom
