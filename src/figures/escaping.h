// Words on pages of figures, so that HTML, Markdown or LaTeX shows them as they are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom {

enum class PageKind { markdown, html, latex };

/// `text` as a page of this kind shows it, on one line.
std::string escaped(std::string_view text, PageKind kind);

/// The same of a text with formulae between `$` signs, as formula::check() takes it: in HTML as
/// MathML, in LaTeX and Markdown as TeX.
std::string escaped_with_formulas(std::string_view text, PageKind kind);

/// The letters of a LaTeX page, each once, that pdfLaTeX cannot set without packages; LuaLaTeX and
/// XeLaTeX may.
std::vector<std::string> beyond_pdflatex(std::string_view page);

}  // namespace carom
