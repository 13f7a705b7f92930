// A static website for a folder of scenes: an index with a card for each scene, and a page for each
// film. It needs no server. Only pages of scenes that have changed are made again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "films/film_plan.h"
#include "scene/load.h"

namespace carom {

struct GalleryOptions {
    std::filesystem::path folder;  ///< folder with scenes, also in subfolders
    std::filesystem::path site;
    std::string title = {};  ///< of the site; empty: the name of the folder
    std::string format = "mp4";
    FilmOptions film = {};  ///< the quality and the threads
    Overrides overrides = {};
    bool is_classroom = false;  ///< hold each scene to the limits of a classroom
    bool is_strict = false;     ///< refuse scenes with notes
    bool force = false;  ///< make everything again, and replace files that carom has not written
    bool quiet = false;  ///< no progress
    std::string depfile = {};  ///< path of a depfile with a rule for index.html; empty: none
};

/// What was done.
struct GalleryReport {
    int made = 0, up_to_date = 0;       ///< films
    std::vector<std::string> replaced;  ///< files that carom had not written, or changed since
    std::vector<std::string> removed;   ///< removed files of scenes that no longer exist
    std::vector<std::string> left;  ///< files of such scenes that others have changed: not removed
};

/// The name of a folder, also for paths such as ".".
std::string name_of_folder(const std::filesystem::path& folder);

/// Makes the site: index.html and, for each scene, its page, film, pictures and text files under
/// films/, in the same subfolders as the scenes. Figure sets are left out. Throws, before anything
/// is written, UsageError (no scenes, two scenes of one name, a link that leads out of the folder,
/// files in the site that carom has not written) and SceneError with the mistakes of all scenes;
/// later SystemError or Interrupted, after which the films that are finished stay.
GalleryReport make_gallery(const GalleryOptions& options);

}  // namespace carom
