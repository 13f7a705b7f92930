// Escapes words on pages of figures, so that HTML, Markdown or LaTeX shows them literally.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom {

enum class PageKind { markdown, html, latex };

/// `text` escaped for a page of this kind, on one line.
std::string escaped(std::string_view text, PageKind kind);

/// The same for a text with formulae between `$` signs, in the syntax of formula::check(). Formulae
/// become MathML in HTML, TeX in LaTeX and Markdown.
std::string escaped_with_formulas(std::string_view text, PageKind kind);

/// The distinct characters of a LaTeX page that pdfLaTeX cannot set without packages. LuaLaTeX and
/// XeLaTeX may be able to.
std::vector<std::string> beyond_pdflatex(std::string_view page);

}  // namespace carom
