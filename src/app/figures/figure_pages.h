// The pages of a folder of figures: where their templates are, and what stands in them.
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

/// The template that is asked for: one of page_templates, or the path of a file that ends in .md,
/// .html or .tex. Throws UsageError, SystemError.
PageTemplate page_template(const std::string& asked);

/// Throws UsageError if there is no picture of `figure` that a page of this kind can show.
void require_picture(const FigureSet& set, const SetFigure& figure, PageKind kind);

/// The page of a folder that holds `figures` and films.
std::string page_text(const FigureSet& set, const PageTemplate& page,
                      std::span<const SetFigure> figures, std::span<const SetFilm> films);

}  // namespace carom
