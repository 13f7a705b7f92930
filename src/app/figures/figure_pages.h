// The pages of a folder of figures: finds their templates and fills them; also writes
// captions.json, the same information for programs.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/figures/figure_set.h"
#include "figures/page.h"

namespace carom {

/// The names of carom's own templates of pages.
inline const std::vector<std::string> page_templates = {"markdown", "html", "latex"};

/// The template for `asked`: one of page_templates, or the path of a file that ends in .md, .html
/// or .tex. Throws UsageError, SystemError.
PageTemplate page_template(const std::string& asked);

/// Throws UsageError if none of a figure's files is a picture that a page of this kind can show.
void require_picture(const FigureSet& set, const FigureSpec& figure,
                     std::span<const std::string> files, PageKind kind);

/// The page of a folder that holds `figures` and films.
std::string page_text(const FigureSet& set, const PageTemplate& page,
                      std::span<const SetFigure> figures, std::span<const SetFilm> films);

/// The contents of captions.json: UTF-8, ending in a newline.
std::string captions_json(const std::string& title, std::span<const SetFigure> figures);

}  // namespace carom
