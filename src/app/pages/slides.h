// A folder of slides: a page of Reveal.js with a slide for each scene, and beside it the films and
// their posters, for this page and for other programs that show slides.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/figures/figure_folder.h"
#include "app/pages/film_page.h"
#include "figures/page.h"
#include "util/files/atomic_file.h"

namespace carom {

struct SlidesOptions {
    std::filesystem::path folder;
    std::vector<std::string> names;  ///< of the slides in order, without endings
    std::string format = "mp4";      ///< of the films
    bool words = false;              ///< also write the text files of the films (text_endings)
    bool force = false;              ///< replace files that carom has not written, or changed since
};

/// What became of earlier files.
struct SlidesReport {
    std::vector<std::string> replaced;  ///< files that carom had not written, or changed since
    std::vector<std::string> removed;   ///< files of slides that are no longer asked for
    std::vector<std::string> left;      ///< such files that others have changed
};

class Slides {
  public:
    /// Throws UsageError if the folder holds files and is not one of slides, or if files would be
    /// replaced that carom has not written, and `force` is not asked for.
    explicit Slides(SlidesOptions options);

    /// The path of the page.
    std::filesystem::path page() const { return options_.folder / "index.html"; }

    /// Renders the film of the next slide. If it exceeds `options.most_bytes`, there is no slide,
    /// and the function may be called again. Throws what render() throws.
    RenderReport add(const Scene& scene, FilmOptions options, Progress& progress);

    /// Writes the page; all files appear together. Throws SystemError.
    SlidesReport finish();

  private:
    void write(const std::string& file, std::string_view bytes);
    std::vector<std::string> files_of_slides() const;

    SlidesOptions options_;
    FigureFolder folder_;
    std::vector<std::string> replaced_;
    Source page_;
    std::map<std::string, std::string> reveal_;    ///< contents by name
    std::optional<AtomicFolder> files_;            ///< from the first slide on
    std::map<std::string, std::string> contents_;  ///< fingerprints of what is written there
    std::vector<PageFields> slides_;
};

}  // namespace carom
