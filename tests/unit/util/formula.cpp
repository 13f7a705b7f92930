// Formulae are read from TeX, said in words and written as MathML; what is outside of the subset is
// an error at its place.
#include "util/formula/formula.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace carom;
using formula::Part;

namespace {

std::string spoken(const std::string& tex) {
    return formula::spoken(Language::english, formula::parsed(tex));
}

struct Refused {
    std::size_t at;
    std::string message, hint;
};

Refused refused(const std::string& text) {
    try {
        formula::check(text);
    } catch (const formula::Error& error) {
        return {error.at, error.what(), error.hint};
    }
    FAIL("nothing is refused in " << text);
    return {};
}

}  // namespace

TEST_CASE("a formula is a tree of parts with their indices") {
    const formula::Parts parts = formula::parsed("\\frac{kT}{m}v_1'^2");
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].of == Part::Of::fraction);
    CHECK(parts[0].body.size() == 2);
    CHECK(parts[0].below.size() == 1);
    CHECK(parts[1].symbol->tex == "v");
    CHECK(parts[1].symbol->is_slanted);
    REQUIRE(parts[1].above_index.size() == 2);
    CHECK(parts[1].above_index[0].symbol->tex == "prime");
    CHECK(parts[1].above_index[1].symbol->tex == "2");
    CHECK(parts[1].below_index.front().symbol->tex == "1");

    // Letters of Unicode are the commands that name them.
    for (const auto& [letter, command] : std::vector<std::pair<std::string, std::string>>{
             {"π", "\\pi"}, {"≤", "\\leq"}, {"\\le", "\\leq"}, {"·", "\\cdot"}, {"−", "-"}})
        CHECK(formula::parsed(letter).front().symbol->letter ==
              formula::parsed(command).front().symbol->letter);
}

TEST_CASE("a formula is said in the language of the picture") {
    const formula::Parts parts = formula::parsed("\\sqrt{\\frac{kT}{m}} \\leq \\bar v^2");
    CHECK(formula::spoken(Language::german, parts) ==
          "Wurzel aus k mal T durch m, Ende der Wurzel höchstens v quer hoch zwei");
    CHECK(formula::spoken(Language::french, parts) ==
          "la racine carrée de k fois T sur m, fin de la racine est au plus v barre au carré");
    CHECK(formula::spoken(Language::spanish, parts) ==
          "la raíz cuadrada de k por T entre m, fin de la raíz es como máximo v barra al "
          "cuadrado");
}

TEST_CASE("a formula is said in words") {
    const std::vector<std::pair<std::string, std::string>> all{
        {"\\frac{kT}{m}", "k times T over m"},
        {"E = \\frac12 m v^2", "E equals 1 over 2, times m times v squared"},
        {"\\sqrt{\\frac{2kT}{m}}", "the square root of 2 times k times T over m, end of root"},
        {"\\sqrt\\pi", "the square root of pi"},
        {"\\langle v^2 \\rangle", "the mean of v squared"},
        {"\\langle a + b \\rangle = 0", "the mean of a plus b, end of mean equals 0"},
        {"f(v) \\propto v e^{-mv^2/2kT}",
         "f of v is proportional to v times e to the power minus m times v squared over 2 times k "
         "times T"},
        {"\\frac{a+b}{c}", "the fraction a plus b, over c, end of fraction"},
        {"\\sum_i m_i v_i", "the sum over i of m sub i times v sub i"},
        {"\\int_0^\\infty f(v)\\,\\mathrm{d}v = 1",
         "the integral from 0 to infinity of f of v d v equals 1"},
        {"\\vec v_1' = \\hat n", "vector v sub 1 prime equals n hat"},
        {"S = -k\\ln w", "S equals minus k the natural logarithm of w"},
        {"\\left| x \\right| \\leq 12.5", "the absolute value of x is at most 12.5"},
        {"2(n+1)!", "2 times open bracket n plus 1 close bracket factorial"},
        {"v'^2", "v prime squared"},
        {"x^{n+1} y", "x to the power n plus 1, end of power times y"},
    };
    for (const auto& [tex, words] : all) CHECK(spoken(tex) == words);
    CHECK(formula::spoken_text(Language::english, "it is $kT$, for \\$5") ==
          "it is k times T, for $5");
}

TEST_CASE("formulae stand between dollar signs") {
    const auto spans = formula::spans_of("a \\$b $c_1$ d");
    REQUIRE(spans.size() == 3);
    CHECK(spans[0].text == "a $b ");
    CHECK(spans[1].is_formula);
    CHECK(spans[1].text == "c_1");
    CHECK(spans[1].at == 7);
    CHECK(spans[2].text == " d");
    CHECK_FALSE(formula::has_formula("no \\$ here"));
    CHECK(formula::has_formula("$x$"));
}

TEST_CASE("what is outside of the subset is refused at its place") {
    const auto check = [](const std::string& text, std::size_t at, const std::string& message,
                          const std::string& hint = "") {
        CAPTURE(text);
        const Refused found = refused(text);
        CHECK(found.at == at);
        CHECK(found.message == message);
        if (!hint.empty()) CHECK(found.hint == hint);
    };
    check("a $5", 2, "a `$` that begins a formula, and no `$` that ends it",
          "write \\$ for a dollar sign");
    check("$$", 0, "an empty formula");
    check("is $\\frca{1}{2}$", 4, "`\\frca` has no meaning in a formula", "did you mean `\\frac`?");
    check("$a \\begin{x}$", 3, "`\\begin` has no meaning in a formula");
    check("$a & b$", 3, "`&` has no meaning in a formula");
    check("$\\frac{a}$", 1, "`\\frac` with nothing after it");
    check("$x^2^3$", 4, "`^` twice on one part", "use braces: `{x^a}^b`");
    check("$x^2'$", 4, "a `'` after a `^`");
    check("$^2$", 1, "`^` with nothing before it");
    check("$x^$", 2, "`^` with nothing after it");
    check("$\\sqrt[3]{x}$", 6, "`\\sqrt` takes no degree");
    check("${a$", 1, "a `{` that is not closed");
    check("$a}$", 2, "a `}` that closes nothing");
    check("$\\left( a$", 1, "`\\left` without a `\\right` after it");
    check("$a \\right)$", 3, "`\\right` without a `\\left` before it");
    check("$\\left< a \\right>$", 6, "`<` is no bracket that grows");
    check("$\\mathrm x$", 1, "`\\mathrm` without braces after it");
    check("$\\text{a^b}$", 8, "`^` among upright words");
    std::string deep = "$";
    for (int i = 0; i < 2000; ++i) deep += "\\sqrt";
    check(deep + "x$", 1 + 12 * 5, "parts within parts, more than 12 deep");
}

TEST_CASE("a formula is MathML in pages") {
    CHECK(formula::mathml(formula::parsed("\\frac{kT}{2}<12")) ==
          "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><mfrac><mrow><mi>k</mi><mi>T"
          "</mi></mrow><mn>2</mn></mfrac><mo>&lt;</mo><mn>12</mn></mrow></math>");
    CHECK(formula::mathml(formula::parsed("\\sum_{i}^N v_1^2"))
              .find("<munderover><mo>∑</mo><mi>i</mi><mi>N</mi></munderover><msubsup><mi>v</"
                    "mi><mn>1</mn>"
                    "<mn>2</mn></msubsup>") != std::string::npos);
}
