// Words on LaTeX pages, set by pdfLaTeX itself. Skipped where it is not installed.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "figures/escaping.h"
#include "support/files.h"
#include "support/pdflatex_boxes.h"
#include "support/process.h"

using namespace carom;
using test::run;

namespace {

std::string utf8(char32_t letter) {
    if (letter < 0x80) return {static_cast<char>(letter)};
    const auto rest = [&](int shift) { return static_cast<char>(0x80 | (letter >> shift & 0x3F)); };
    if (letter < 0x800) return {static_cast<char>(0xC0 | letter >> 6), rest(0)};
    return {static_cast<char>(0xE0 | letter >> 12), rest(6), rest(0)};
}

std::string document(const std::string& words) {
    return "\\documentclass{article}\n\\usepackage{graphicx}\n\\begin{document}\n" + words +
           "\n\\end{document}\n";
}

test::Outcome typeset(const test::TemporaryFolder& folder) {
    return run({"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "text.tex"},
               folder.path());
}

bool has_latex() {
    if (test::is_installed("pdflatex")) return true;
    MESSAGE("pdflatex is not installed: no page is set");
    return false;
}

}  // namespace

TEST_CASE("pdfLaTeX sets every letter that is not told as beyond it, in captions too") {
    if (!has_latex()) return;
    std::string words;
    int letters = 0;
    for (char32_t letter = 0x21; letter < 0xFFFE; ++letter) {
        if ((letter >= 0x7F && letter < 0xA0) || (letter >= 0xD800 && letter < 0xE000)) continue;
        const std::string one = utf8(letter), set = escaped(one, PageKind::latex);
        if (!beyond_pdflatex(set).empty() || set.empty()) continue;
        words += "\\begin{figure}\\caption{x" + set + set + "x}\\end{figure}\\clearpage\n";
        ++letters;
    }
    CHECK(letters > 550);
    const test::TemporaryFolder folder;
    folder.write("text.tex", document("\\listoffigures\n" + words));
    for (int pass = 0; pass < 2; ++pass) {
        const test::Outcome outcome = typeset(folder);
        CAPTURE(outcome.out.substr(outcome.out.size() > 600 ? outcome.out.size() - 600 : 0));
        REQUIRE(outcome.exit_code == 0);
        CHECK(outcome.out.find("Missing character") == std::string::npos);
    }
}

TEST_CASE("words come out of a LaTeX page as they went in") {
    if (!has_latex() || !test::is_installed("pdftotext")) return;
    const std::string plain = "50 % of {ab} & $2 #1 \\z [i] a -- b --- c, d.. 1/2 e@f = g + h";
    const test::TemporaryFolder folder;
    folder.write("text.tex",
                 document("\\footnotesize\n" + escaped(plain, PageKind::latex) + "\n\n" +
                          escaped("λ₁² − ⟨v⟩ ≤ 2 × 10⁻³ π µ", PageKind::latex)));
    REQUIRE(typeset(folder).exit_code == 0);
    const std::string text = run({"pdftotext", "-layout", "text.pdf", "-"}, folder.path()).out;
    CAPTURE(text);
    CHECK(text.find(plain) != std::string::npos);
    for (const std::string letter : {"λ", "−", "≤", "×", "π"})
        CHECK(text.find(letter) != std::string::npos);
}

TEST_CASE("pdfLaTeX does not set a letter that is told as beyond it") {
    if (!has_latex()) return;
    REQUIRE_FALSE(beyond_pdflatex("二").empty());
    const test::TemporaryFolder folder;
    folder.write("text.tex", document("二"));
    CHECK(typeset(folder).exit_code != 0);
}

TEST_CASE("formulae have the sizes that are recorded") {
    if (!has_latex()) return;
    std::string words;
    for (const test::MeasuredFormula& one : test::pdflatex_boxes)
        words += fmt::format(
            "\\setbox0\\hbox{{${}{}$}}\\typeout{{BOX \\the\\wd0 \\space\\the\\ht0 "
            "\\space\\the\\dp0}}\n",
            one.stands_alone ? "\\displaystyle " : "", one.tex);
    const test::TemporaryFolder folder;
    folder.write("text.tex", document(words));
    std::istringstream lines(typeset(folder).out);
    std::size_t next = 0;
    const auto is_near = [](double points, double recorded) {
        return std::abs(0.1 * points - recorded) < 6e-5;  // recorded to six figures
    };
    for (std::string line; std::getline(lines, line);) {
        double width = 0.0, height = 0.0, depth = 0.0;
        if (std::sscanf(line.c_str(), "BOX %lfpt %lfpt %lfpt", &width, &height, &depth) != 3)
            continue;
        REQUIRE(next < test::pdflatex_boxes.size());
        const test::MeasuredFormula& recorded = test::pdflatex_boxes[next++];
        CAPTURE(std::string(recorded.tex));
        CHECK(is_near(width, recorded.width));
        CHECK(is_near(height, recorded.height));
        CHECK(is_near(depth, recorded.depth));
    }
    CHECK(next == test::pdflatex_boxes.size());
}
