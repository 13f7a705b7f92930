// A static site of a folder of scenes: a page with a card for each, and a page for each film. It
// needs no server, and is made again only where scenes have changed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/film/film_plan.h"
#include "scene/load.h"

namespace carom {

struct GalleryOptions {
    std::filesystem::path folder;  ///< of the scenes, and of folders of them
    std::filesystem::path site;
    std::string title = {};  ///< of the site; empty: the name of the folder
    std::string format = "mp4";
    FilmOptions film = {};  ///< the quality and the threads
    Overrides overrides = {};
    bool force = false;        ///< make all again, and replace what others have written
    bool quiet = false;        ///< no progress
    std::string depfile = {};  ///< path of a rule about index.html; empty: none
};

/// What was done.
struct GalleryReport {
    int made = 0, up_to_date = 0;       ///< films
    std::vector<std::string> replaced;  ///< files that carom had not written, or not so
    std::vector<std::string> removed;   ///< files of scenes that are no more
    std::vector<std::string> left;      ///< of these those that others have changed
};

/// The name of a folder, however its path is written: "." has one too.
std::string name_of_folder(const std::filesystem::path& folder);

/// Makes the site: index.html, and for each scene its page, film, pictures and text under films/,
/// in folders as the scenes are. Figure sets are left out. Throws before anything is written
/// UsageError (no scenes, two of one name, a link that leads out of the folder, files of others in
/// the site) and SceneError with the mistakes of all scenes; then SystemError, Interrupted, which
/// leave the films that are finished.
GalleryReport make_gallery(const GalleryOptions& options);

}  // namespace carom
