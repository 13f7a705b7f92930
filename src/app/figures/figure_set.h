// The figures that share a folder: those of one scene, or of several.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/figures/figure_folder.h"
#include "figures/page.h"
#include "scene/scene.h"

namespace carom {

/// The file in a folder of figures that is always there: what is said of each.
inline const std::string captions_name = "captions.json";

/// A scene with those of its figures that are shown, in this order.
struct SetPart {
    Scene scene;
    std::string stem;         ///< of the files of its film
    std::string title;        ///< the scene's, if it has no other here
    std::string description;  ///< under the title; may be empty
    std::vector<std::string> figures;
    bool compares = false;  ///< it has one figure, of several scenes, and no film
};

/// A page to be made, of the name of its set with this ending.
struct PageTemplate {
    Source source;
    PageKind kind = PageKind::html;
    std::string ending;  ///< with its dot
};

struct FigureSet {
    std::string of;    ///< how the folder calls it: the name of its file
    std::string stem;  ///< of the files of its pages
    std::filesystem::path folder = {};
    std::string title = {};
    std::string description = {};  ///< may be empty
    std::vector<SetPart> parts = {};
    std::vector<std::string> formats = {};  ///< endings of files, as in figure_formats
    std::vector<PageTemplate> pages = {};
};

struct SetOptions {
    std::vector<std::string> only;  ///< names of figures; none: all
    bool force = false;             ///< make all again, and replace what others have written
    bool films = false;             ///< render the films that pages show, too
    int threads = 1;                ///< for films, and for runs of several seeds
    bool quiet = false;             ///< no progress
};

/// A figure that is in the folder, with what is said of it.
struct SetFigure {
    const SetPart* part;
    const FigureSpec* spec;
    std::string caption, alt;
    std::vector<std::string> files;  ///< that show it, in the order of figure_formats
};

/// A film that is in the folder, as its scene has it now.
struct SetFilm {
    const SetPart* part;
    std::map<std::string, std::string> files;  ///< by what they are: film, poster, captions, …
};

/// What was done.
struct SetReport {
    int made = 0, up_to_date = 0;       ///< figures
    int films = 0;                      ///< rendered
    std::vector<std::string> replaced;  ///< files that carom had not written, or not so
    std::vector<std::string> gone;      ///< files of figures that are no more
    std::map<std::string, std::vector<std::string>>
        unset;  ///< by LaTeX page: letters that pdfLaTeX cannot set
};

/// The figure of this name; null if the scene has none.
const FigureSpec* figure_spec(const Scene& scene, const std::string& name);

/// Throws UsageError where two figures, films or pages of a set would have one name.
void refuse_same_names(const FigureSet& set);

/// All files that make_figures() may write.
std::vector<std::filesystem::path> outputs_of(const FigureSet& set, const SetOptions& options);

/// Makes what is not there yet or not from the present scenes. Throws UsageError before anything
/// is written when a file of others would be replaced, or figures share a name; SceneError,
/// SystemError, Interrupted.
SetReport make_figures(const FigureSet& set, const SetOptions& options);

}  // namespace carom
