// Words as the kinds of pages want them; whether pages show them so, pdfLaTeX says itself
// (app_latex.cpp).
#include "figures/escaping.h"

#include <doctest/doctest.h>

#include <string>

using namespace carom;

TEST_CASE("words are escaped as the kind of page asks") {
    CHECK(escaped("<b> & \"c\"", PageKind::html) == "&lt;b&gt; &amp; &quot;c&quot;");
    CHECK(escaped("50 % of {a_b} & $2 #1 ~ ^ \\", PageKind::latex) ==
          "50 \\% of \\{a\\_b\\} \\& \\$2 \\#1 \\textasciitilde{} \\textasciicircum{} "
          "\\textbackslash{}");
    CHECK(escaped("a -- b ''", PageKind::latex) == "a -{}- b '{}'");
    CHECK(escaped("r² − π", PageKind::latex) == "r\\(^{2}\\) \\(-\\) \\(\\pi\\)");
    CHECK(escaped("a *b* [c](d) <e> `f` a_b", PageKind::markdown) ==
          "a \\*b\\* \\[c\\](d) \\<e\\> \\`f\\` a\\_b");
    CHECK(escaped("# no heading - 1. x", PageKind::markdown) == "\\# no heading - 1. x");
    CHECK(escaped("12. May", PageKind::markdown) == "12\\. May");
    // Jekyll's tags are read before Markdown and HTML are, and a backslash does not hide them.
    for (const PageKind kind : {PageKind::markdown, PageKind::html})
        CHECK(escaped("{{ x }} {% raw %}", kind) == "&#123;&#123; x }} &#123;% raw %}");
    // Readers of Markdown make links of bare addresses.
    CHECK(escaped("http://a.b www.a.b a@b.c doi:1 x-y1:z", PageKind::markdown) ==
          "http&#58;//a.b www&#46;a.b a&#64;b.c doi&#58;1 x-y1&#58;z");
    CHECK(escaped("mass 2: 12:30, www wWw.x, at: b", PageKind::markdown) ==
          "mass 2: 12:30, www wWw&#46;x, at: b");
    for (const PageKind kind : {PageKind::html, PageKind::latex, PageKind::markdown})
        CHECK(escaped(" two\n\nparagraphs ", kind) == "two paragraphs");
}

TEST_CASE("letters that pdfLaTeX cannot set are named, each once") {
    CHECK(beyond_pdflatex("all of ASCII, äöüß, Łódź, “quotes” and 5 € – 6 ‰").empty());
    CHECK(beyond_pdflatex("二 disks and 二 beads, ☺ \xF0\x9D\x94\xB8") ==
          std::vector<std::string>{"二", "☺", "\xF0\x9D\x94\xB8"});
    CHECK(beyond_pdflatex("λ") == std::vector<std::string>{"λ"});
    CHECK(beyond_pdflatex(escaped("λ", PageKind::latex)).empty());
}

TEST_CASE("captions have formulae in the way of each page") {
    CHECK(escaped_with_formulas("a_b $x_1$ c", PageKind::markdown) == "a\\_b $x_1$ c");
    CHECK(escaped_with_formulas("$x^{{{2}}}$", PageKind::markdown) == "$x^{ { {2}}}$");
    // What begins a comment, an argument or a column in TeX, and an empty line, which ends a
    // formula.
    for (const PageKind kind : {PageKind::latex, PageKind::markdown})
        CHECK(escaped_with_formulas("$1\\,\\mathrm{%&#}\n\n+ x$", kind)
                  .find("\\mathrm{\\%\\&\\#}  + x") != std::string::npos);
    CHECK(escaped_with_formulas("$\\frac{a}{b}\\text{ of }π$, & 5", PageKind::latex) ==
          "\\(\\frac{a}{b}\\mbox{ of }\\pi \\), \\& 5");
    CHECK(escaped_with_formulas("$x$ < \\$2", PageKind::html) ==
          "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mi>x</mi></math> &lt; $2");
    CHECK(beyond_pdflatex(escaped_with_formulas("$λ ≤ ∞$", PageKind::latex)).empty());
}
