// A film in words, for those who cannot see it and for players that show words of their own:
// captions, chapters and descriptions as WebVTT, and a transcript. A silent film needs a text
// alternative (WCAG 2.2, success criterion 1.2.1).
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "app/film/frame_span.h"
#include "app/progress.h"
#include "scene/scene.h"

namespace carom {

/// Whole files. Times count from the first frame of the span.
struct FilmWords {
    std::string captions;      ///< what stands under the gas
    std::string chapters;      ///< from event to event, or quarters of a film that has none
    std::string descriptions;  ///< what is seen, and how the numbers stand when a chapter begins
    std::string transcript;    ///< all of these as plain text
};

/// Runs the physics once more, for the numbers. `span` is of the scene's timeline. Throws as
/// render() does.
FilmWords words_of_film(const Scene& scene, const FrameSpan& span, Progress& progress);

/// What their files are called, by what they hold: the film's name without its extension, and this.
inline const std::map<std::string, std::string> words_endings = {
    {"captions", ".captions.vtt"},
    {"chapters", ".chapters.vtt"},
    {"descriptions", ".descriptions.vtt"},
    {"transcript", ".transcript.txt"}};

/// Writes them beside the film at `path`, as film.captions.vtt, film.chapters.vtt,
/// film.descriptions.vtt and film.transcript.txt (beside a folder of frames, with its name), each
/// whole or not at all. Throws SystemError.
void write_words(const FilmWords& words, const std::filesystem::path& path);

}  // namespace carom
