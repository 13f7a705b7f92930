// The figures that share a folder, of one scene or of several.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/figures/figure_folder.h"
#include "figures/page.h"
#include "scene/scene.h"

namespace carom {

/// The file that every folder of figures has: the captions of all figures.
inline const std::string captions_name = "captions.json";

/// A scene and those of its figures that are shown, in this order.
struct SetPart {
    Scene scene;
    std::string stem;         ///< file name of its film, without ending
    std::string title;        ///< the scene's title, unless the set gives it another
    std::string description;  ///< under the title; may be empty
    std::vector<std::string> figures;
    bool compares = false;  ///< the part is a comparison: one figure of several scenes, and no film
};

/// A page to be made. Its file has the name of the set with this ending.
struct PageTemplate {
    Source source;
    PageKind kind = PageKind::html;
    std::string ending;  ///< with its dot
};

struct FigureSet {
    std::string of;    ///< the name by which the folder knows the set: that of its file
    std::string stem;  ///< file name of its pages, without ending
    std::filesystem::path folder = {};
    std::string title = {};
    std::string description = {};  ///< may be empty
    std::vector<SetPart> parts = {};
    std::vector<std::string> formats = {};  ///< endings of files, as in figure_formats
    std::vector<PageTemplate> pages = {};
};

struct SetOptions {
    std::vector<std::string> only;  ///< names of figures; none: all
    bool force = false;  ///< make everything again, and replace files that carom has not written
    bool films = false;  ///< also render the films that pages show
    int threads = 1;     ///< for films, and for runs of several seeds
    bool quiet = false;  ///< no progress
};

/// A figure that exists in the folder, with its texts.
struct SetFigure {
    const SetPart* part;
    const FigureSpec* spec;
    FigureWords words;
    std::vector<std::string> files;  ///< files that show it, in the order of figure_formats
};

/// A film that exists in the folder and is up to date with its scene.
struct SetFilm {
    const SetPart* part;
    std::map<std::string, std::string> files;  ///< file names by role: film, poster, captions, …
};

/// What was done.
struct SetReport {
    int made = 0, up_to_date = 0;       ///< figures
    int films = 0;                      ///< rendered
    std::vector<std::string> replaced;  ///< files that carom had not written, or changed since
    std::vector<std::string> gone;      ///< removed files of figures that no longer exist
    std::map<std::string, std::vector<std::string>>
        unset;  ///< for each LaTeX page, the letters that pdfLaTeX cannot set
};

/// The figure of this name; null if the scene has none.
const FigureSpec* figure_spec(const Scene& scene, const std::string& name);

/// Throws UsageError if two figures, films or pages of a set would have the same name.
void refuse_same_names(const FigureSet& set);

/// All files that make_figures() may write.
std::vector<std::filesystem::path> outputs_of(const FigureSet& set, const SetOptions& options);

/// Makes all figures and pages that are missing or not up to date with the scenes. Throws
/// UsageError, before anything is written, if a file that carom has not written would be replaced,
/// or if figures share a name; SceneError, SystemError, Interrupted.
SetReport make_figures(const FigureSet& set, const SetOptions& options);

}  // namespace carom
