#include "figures/escaping.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <sstream>
#include <utility>

#include "util/formula/formula.h"
#include "util/text.h"

namespace carom {
namespace {

using std::string;
using std::string_view;

// Jekyll reads Markdown, and HTML that begins with front matter, with Liquid first. Liquid looks
// for two braces, or a brace and a percent sign, and a backslash does not stop it.
constexpr string_view hidden_brace = "&#123;";

string html(string_view letter) {
    if (letter == "{") return string(hidden_brace);
    if (letter == "&") return "&amp;";
    if (letter == "<") return "&lt;";
    if (letter == ">") return "&gt;";
    if (letter == "\"") return "&quot;";
    return letter == "'" ? "&#39;" : string(letter);
}

bool is_of_scheme(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           string_view("+-.").find(c) != string_view::npos;
}

bool is_blank(char c) { return string_view(" \n\t\r").find(c) != string_view::npos; }

// Whether a colon after `before` may end the scheme of an address, as in http://a.b or doi:10.1.
bool ends_scheme(string_view before) {
    const auto word = std::ranges::find_if_not(before.rbegin(), before.rend(), is_of_scheme);
    return std::any_of(before.rbegin(), word, [](char c) { return c > '9'; });
}

bool ends_with_www(string_view text) {
    constexpr std::size_t letters = 3;
    return text.size() >= letters &&
           std::ranges::all_of(text.substr(text.size() - letters),
                               [](char c) { return c == 'w' || c == 'W'; });
}

// A letter without which bare addresses, http://a.b, www.a.b and a@b.c, are not found: many readers
// of Markdown make links of them.
bool makes_address(string_view letter, string_view before, string_view after) {
    if (letter == ":") return !after.empty() && !is_blank(after.front()) && ends_scheme(before);
    return letter == "@" || (letter == "." && ends_with_www(before));
}

// Characters that begin a heading, a list or a quotation are escaped only at the start of a line.
string markdown(string_view letter, string_view before, string_view after) {
    if (letter == "{") return string(hidden_brace);
    if (makes_address(letter, before, after))
        return fmt::format("&#{};", static_cast<int>(letter.front()));
    const bool number = before.find_first_not_of("0123456789") == string_view::npos;
    if (string_view("\\`*_[]<>&|$~").find(letter) != string_view::npos ||
        (before.empty() && string_view("#+-=!:").find(letter) != string_view::npos) ||
        (!before.empty() && number && (letter == "." || letter == ")")))
        return "\\" + string(letter);
    return string(letter);
}

using Letters = std::map<string, string, std::less<>>;

// Parses a table of letters and their replacements, all separated by blanks.
Letters in_pairs(const char* words) {
    Letters letters;
    std::istringstream rest(words);
    for (string letter, meaning; rest >> letter >> meaning;) letters[letter] = meaning;
    return letters;
}

// Replacements for letters that have a meaning in LaTeX, or that pdfLaTeX does not know by itself.
// They need no packages and work in its oldest font encoding (OT1).
const Letters& latex_letters() {
    static const Letters letters{
        {"\\", "\\textbackslash{}"},
        {"{", "\\{"},
        {"}", "\\}"},
        {"$", "\\$"},
        {"&", "\\&"},
        {"#", "\\#"},
        {"_", "\\_"},
        {"%", "\\%"},
        {"~", "\\textasciitilde{}"},
        {"^", "\\textasciicircum{}"},
        {"\"", "\\char34{}"},
        {"`", "\\textasciigrave{}"},
        {"<", "\\(<\\)"},
        {">", "\\(>\\)"},
        {"|", "\\textbar{}"},
        {"„", ",,"},
        {"‚", ","},
        {"‑", "-"},
        {"\u00A0", "~"},
        {"\u2002", "\\enspace{}"},
        {"\u2003", "\\quad{}"},
        {"\u2004", "\\ "},
        {"\u2005", "\\ "},
        {"\u2007", "~"},
        {"\u2009", "\\,"},
        {"\u200A", "\\,"},
        {"\u202F", "\\,"},
        {"\u200B", ""},
        {"\u2060", ""},
        {"\uFEFF", ""},
        {"−", "\\(-\\)"},
        {"°", "\\(^\\circ\\)"},
        {"′", "\\(^{\\prime}\\)"},
        {"″", "\\(^{\\prime\\prime}\\)"},
        {"‹", "\\(<\\)"},
        {"›", "\\(>\\)"},
        {"⅓", "\\(\\frac13\\)"},
        {"⅔", "\\(\\frac23\\)"},
        {"⅕", "\\(\\frac15\\)"},
        {"⅙", "\\(\\frac16\\)"},
        {"⅛", "\\(\\frac18\\)"},
        {"ο", "\\(o\\)"},
    };
    return letters;
}

// Letters that are a command in LaTeX's math mode; the commands are given without the backslash.
const Letters& latex_commands() {
    static const Letters letters = in_pairs(
        "× times ÷ div · cdot ⋅ cdot ∙ cdot ∗ ast ± pm ∓ mp ∘ circ ≈ approx ≃ simeq ≅ cong ∼ sim "
        "∝ propto ≠ neq ≡ equiv ≤ leq ≥ geq ≪ ll ≫ gg « ll » gg √ surd ∞ infty ∑ sum ∏ prod ∫ int "
        "∂ partial ∇ nabla ∈ in ∉ notin ∩ cap ∪ cup ⊂ subset ∅ emptyset ∀ forall ∃ exists ∧ wedge "
        "∨ vee ⊥ perp ∥ parallel ∠ angle ℓ ell ℏ hbar → to ← leftarrow ↔ leftrightarrow ↑ uparrow "
        "↓ downarrow ⇒ Rightarrow ⇐ Leftarrow ⇔ Leftrightarrow ↦ mapsto ⋯ cdots ○ bigcirc "
        "● bullet △ triangle ⟨ langle ⟩ rangle α alpha β beta γ gamma δ delta ε varepsilon "
        "ϵ epsilon ζ zeta η eta θ theta ϑ vartheta ι iota κ kappa λ lambda μ mu ν nu ξ xi π pi "
        "ρ rho ς varsigma σ sigma τ tau υ upsilon φ varphi ϕ phi χ chi ψ psi ω omega Γ Gamma "
        "Δ Delta Θ Theta Λ Lambda Ξ Xi Π Pi Σ Sigma Υ Upsilon Φ Phi Ψ Psi Ω Omega µ mu");
    return letters;
}

// Greek capitals that look like Latin ones.
const Letters& latin_capitals() {
    static const Letters letters = in_pairs("Α A Β B Ε E Ζ Z Η H Ι I Κ K Μ M Ν N Ο O Ρ P Τ T Χ X");
    return letters;
}

// Superscript and subscript letters.
const Letters& raised_letters() {
    static const Letters letters =
        in_pairs("⁰ 0 ¹ 1 ² 2 ³ 3 ⁴ 4 ⁵ 5 ⁶ 6 ⁷ 7 ⁸ 8 ⁹ 9 ⁺ + ⁻ - ⁼ = ⁽ ( ⁾ ) ⁿ n ⁱ i");
    return letters;
}

const Letters& lowered_letters() {
    static const Letters letters = in_pairs(
        "₀ 0 ₁ 1 ₂ 2 ₃ 3 ₄ 4 ₅ 5 ₆ 6 ₇ 7 ₈ 8 ₉ 9 ₊ + ₋ - ₌ = ₍ ( ₎ ) ₐ a ₑ e ₒ o ₓ x ₕ h ₖ k ₗ l "
        "ₘ m ₙ n ₚ p ₛ s ₜ t ᵢ i ⱼ j");
    return letters;
}

// The letter in LaTeX's math mode; empty if it needs no replacement.
string latex_formula(string_view letter) {
    const auto found_in = [&](const Letters& letters) {
        const auto found = letters.find(letter);
        return found == letters.end() ? string() : found->second;
    };
    if (const string name = found_in(latex_commands()); !name.empty())
        return "\\(\\" + name + "\\)";
    if (const string capital = found_in(latin_capitals()); !capital.empty())
        return "\\(\\mathrm{" + capital + "}\\)";
    if (const string plain = found_in(raised_letters()); !plain.empty())
        return "\\(^{" + plain + "}\\)";
    if (const string plain = found_in(lowered_letters()); !plain.empty())
        return "\\(_{" + plain + "}\\)";
    return {};
}

// Separates pairs such as -- that TeX would join into another character (a ligature).
string latex(string_view letter, string_view before) {
    if (string_view("-',").find(letter) != string_view::npos && before.ends_with(letter))
        return "{}" + string(letter);
    if (const auto found = latex_letters().find(letter); found != latex_letters().end())
        return found->second;
    const string formula = latex_formula(letter);
    return formula.empty() ? string(letter) : formula;
}

// The code point of one UTF-8 letter; for an invalid byte, a number that no letter has.
char32_t code_point(string_view letter) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
    if (letter.size() == 1) return byte(0) < 0x80 ? byte(0) : 0xFFFFFFFF;
    char32_t number = byte(0) & (0xFFU >> (letter.size() + 1));
    for (std::size_t i = 1; i < letter.size(); ++i) number = number << 6 | (byte(i) & 0x3FU);
    return number;
}

// Whether pdfLaTeX can set a letter beyond ASCII without packages: in LaTeX of 2022 with Computer
// Modern.
bool is_latex_letter(char32_t letter) {
    constexpr std::array<std::pair<char32_t, char32_t>, 59> ranges{
        {{0x00A1, 0x00AA}, {0x00AC, 0x00BA}, {0x00BC, 0x00CF}, {0x00D1, 0x00DD}, {0x00DF, 0x00EF},
         {0x00F1, 0x00FD}, {0x00FF, 0x0103}, {0x0106, 0x010F}, {0x0112, 0x0117}, {0x011A, 0x0125},
         {0x0128, 0x012D}, {0x0130, 0x0137}, {0x0139, 0x013E}, {0x0141, 0x0148}, {0x014C, 0x0165},
         {0x0168, 0x0171}, {0x0174, 0x017E}, {0x0192, 0x0192}, {0x01C4, 0x01D4}, {0x01E2, 0x01E3},
         {0x01E6, 0x01E9}, {0x01F0, 0x01F0}, {0x01F4, 0x01F5}, {0x0218, 0x021B}, {0x0232, 0x0233},
         {0x0237, 0x0237}, {0x2010, 0x2016}, {0x2018, 0x2019}, {0x201C, 0x201D}, {0x2020, 0x2022},
         {0x2026, 0x2026}, {0x2030, 0x2031}, {0x203B, 0x203B}, {0x203D, 0x203D}, {0x2044, 0x2044},
         {0x204E, 0x204E}, {0x2052, 0x2052}, {0x20A1, 0x20A1}, {0x20A4, 0x20A4}, {0x20A6, 0x20A6},
         {0x20A9, 0x20A9}, {0x20AB, 0x20AC}, {0x20B1, 0x20B1}, {0x2103, 0x2103}, {0x2116, 0x2117},
         {0x211E, 0x211E}, {0x2120, 0x2120}, {0x2122, 0x2122}, {0x2126, 0x2127}, {0x212E, 0x212E},
         {0x2190, 0x2193}, {0x2329, 0x232A}, {0x25E6, 0x25E6}, {0x25EF, 0x25EF}, {0x27E8, 0x27E9},
         {0xFB00, 0xFB06}, {0x1E8E, 0x1E91}, {0x1E9E, 0x1E9E}, {0x1EF2, 0x1EF3}}};
    return letter < 0x80 || std::ranges::any_of(ranges, [&](const auto& range) {
               return letter >= range.first && letter <= range.second;
           });
}

// Puts the blanks at the ends of the original text, at most one at each end, around the converted
// line.
string with_blanks(const string& text, const string& line) {
    if (line.empty()) return text.empty() ? "" : " ";
    return (is_blank(text.front()) ? " " : "") + line + (is_blank(text.back()) ? " " : "");
}

// TeX on one line, with the characters escaped that begin a comment, a macro argument or a table
// column.
string escaped_tex(string_view tex) {
    string escaped;
    for (const char c : tex) {
        const bool is_sign = c == '%' || c == '#' || c == '&';
        if (is_sign && !escaped.ends_with('\\')) escaped += '\\';
        escaped += c == '\n' ? ' ' : c;
    }
    return escaped;
}

// TeX with commands instead of Unicode letters, needing no packages.
string plain_tex(string_view tex) {
    string plain;
    for (std::size_t i = 0, next = 0; i < tex.size(); i = next) {
        next = next_code_point(tex, i);
        const string_view letter = tex.substr(i, next - i), rest = tex.substr(i);
        constexpr string_view text_command = "\\text{";
        if (rest.starts_with(text_command)) {
            plain += "\\mbox{";
            next = i + text_command.size();
        } else if (const formula::Symbol* symbol = formula::symbol_of_letter(letter);
                   letter.size() > 1 && symbol != nullptr) {
            plain += symbol->tex.size() == 1 ? symbol->tex : "\\" + symbol->tex + " ";
        } else {
            plain += letter;
        }
    }
    return plain;
}

// Puts a blank between adjacent braces: it changes nothing in TeX, and avoids {{, which has a
// meaning in Jekyll.
string with_braces_apart(string_view tex) {
    string apart;
    for (const char c : tex) {
        if (c == '{' && apart.ends_with('{')) apart += ' ';
        apart += c;
    }
    return apart;
}

}  // namespace

string escaped(string_view text, PageKind kind) {
    string line, plain;
    bool blank = false;
    for (std::size_t i = 0, next = 0; i < text.size(); i = next) {
        next = next_code_point(text, i);
        const string_view letter = text.substr(i, next - i);
        if (is_blank(letter.front())) {
            blank = !line.empty();
            continue;
        }
        if (std::exchange(blank, false)) {
            line += ' ';
            plain += ' ';
        }
        if (kind == PageKind::html) line += html(letter);
        if (kind == PageKind::markdown) line += markdown(letter, plain, text.substr(next));
        if (kind == PageKind::latex) line += latex(letter, plain);
        plain += letter;
    }
    return line;
}

string escaped_with_formulas(string_view text, PageKind kind) {
    string line;
    for (const formula::Span& span : formula::spans_of(text)) {
        if (span.is_formula && kind == PageKind::html)
            line += formula::mathml(formula::parsed(span.text));
        else if (span.is_formula)
            line += kind == PageKind::latex ? "\\(" + plain_tex(escaped_tex(span.text)) + "\\)"
                                            : "$" + with_braces_apart(escaped_tex(span.text)) + "$";
        else
            line += with_blanks(span.text, escaped(span.text, kind));
    }
    return string(line.substr(std::min(line.find_first_not_of(' '), line.size())));
}

std::vector<string> beyond_pdflatex(string_view page) {
    std::vector<string> letters;
    for (std::size_t i = 0, next = 0; i < page.size(); i = next) {
        next = next_code_point(page, i);
        const string letter(page.substr(i, next - i));
        if (!is_latex_letter(code_point(letter)) &&
            std::ranges::find(letters, letter) == letters.end())
            letters.push_back(letter);
    }
    return letters;
}

}  // namespace carom
