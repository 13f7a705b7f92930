#include "figures/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "util/text.h"

namespace carom {
namespace {

using std::string;
using std::string_view;

struct Tag {
    char sign = ' ';  ///< # ^ / ! or a blank
    string name;
    std::size_t begin = 0, end = 0;  ///< of the text that it replaces
    std::size_t place = 0;           ///< where its braces begin
};

string_view trimmed(string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\n");
    if (first == string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

// Where nothing but blanks stands beside a tag on its line, the whole line goes.
void take_line(Tag& tag, const string& text) {
    std::size_t begin = tag.begin, end = tag.end;
    while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
    while (end < text.size() && (text[end] == ' ' || text[end] == '\t' || text[end] == '\r')) ++end;
    if ((begin > 0 && text[begin - 1] != '\n') || (end < text.size() && text[end] != '\n')) return;
    tag.begin = begin;
    tag.end = std::min(text.size(), end + 1);
}

// The next tag; of three braces the first is a text's own: \caption{{{caption}}}.
std::optional<Tag> next_tag(const string& text, std::size_t from) {
    std::size_t open = text.find("{{", from);
    if (open == string::npos) return std::nullopt;
    while (open + 2 < text.size() && text[open + 2] == '{') ++open;
    Tag tag;
    tag.begin = tag.place = open;
    const std::size_t close = text.find("}}", open + 2);
    if (close == string::npos) {
        tag.end = string::npos;
        return tag;
    }
    tag.end = close + 2;
    string_view inside = string_view(text).substr(open + 2, close - open - 2);
    if (!inside.empty() && string_view("#^/!").find(inside.front()) != string_view::npos) {
        tag.sign = inside.front();
        inside.remove_prefix(1);
        take_line(tag, text);
    }
    tag.name = trimmed(inside);
    return tag;
}

/// A template in parts: text, a placeholder, or a stretch between two tags.
struct Part {
    char sign = 't';  ///< t: text
    string text;      ///< or name
    std::vector<Part> inner = {};
};

class Parser {
  public:
    Parser(const Source& page, Errors& errors) : page_(page), errors_(errors) {}

    std::vector<Part> parse() { return until(nullptr, {""}); }

  private:
    // Scopes from the innermost to the page.
    using Scopes = std::vector<string>;

    std::vector<string> names_in(const Scopes& scopes) const {
        std::vector<string> names;
        for (const string& scope : scopes) {
            const auto& more = placeholders().at(scope);
            names.insert(names.end(), more.begin(), more.end());
        }
        return names;
    }

    void check(const Tag& tag, const Scopes& scopes) {
        const std::vector<string> names = names_in(scopes);
        const bool lists =
            tag.sign == ' ' && !tag.name.empty() && placeholders().contains(tag.name);
        if (!lists && std::ranges::find(names, tag.name) != names.end()) return;
        if (lists)
            return errors_.add(page_, tag.place, fmt::format("`{}` is a list", tag.name),
                               fmt::format("write {{{{#{0}}}}} … {{{{/{0}}}}}", tag.name));
        const auto near = nearest_spelling(tag.name, names);
        errors_.add(page_, tag.place,
                    fmt::format("{} is no placeholder {}", in_quotes(tag.name),
                                scopes.front().empty() ? string("of a page")
                                                       : fmt::format("in `{}`", scopes.front())),
                    near ? fmt::format("did you mean `{}`?", *near)
                         : "there are " + listed(names, "and", "`"));
    }

    std::vector<Part> until(const Tag* opened, const Scopes& scopes) {
        std::vector<Part> parts;
        while (const auto tag = next_tag(page_.text, at_)) {
            if (tag->end == string::npos) {
                errors_.add(page_, tag->place, "a placeholder that is not closed",
                            "it ends with `}}`; two braces of your own need a blank between them");
                at_ = page_.text.size();
                broken_ = true;
                break;
            }
            parts.push_back({'t', page_.text.substr(at_, tag->begin - at_)});
            at_ = tag->end;
            if (tag->sign == '!') continue;
            if (tag->sign == '/') {
                if (opened != nullptr && tag->name == opened->name) return parts;
                errors_.add(page_, tag->place,
                            fmt::format("{} is closed, and is not open here", in_quotes(tag->name)),
                            opened != nullptr ? fmt::format("`{}` is open", opened->name) : "");
                continue;
            }
            check(*tag, scopes);
            Part part{tag->sign, tag->name};
            if (tag->sign != ' ') {
                Scopes inside = scopes;
                if (tag->sign == '#' && placeholders().contains(tag->name))
                    inside.insert(inside.begin(), tag->name);
                part.inner = until(&*tag, inside);
            }
            parts.push_back(std::move(part));
        }
        if (opened != nullptr && !broken_)
            errors_.add(page_, opened->place, fmt::format("`{}` is not closed", opened->name),
                        fmt::format("it ends with {{{{/{}}}}}", opened->name));
        parts.push_back({'t', page_.text.substr(at_)});
        at_ = page_.text.size();
        return parts;
    }

    const Source& page_;
    Errors& errors_;
    std::size_t at_ = 0;
    bool broken_ = false;  ///< reported, and nothing after it is read
};

bool is_plain_address(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           string_view("-._~/+=:;,").find(c) != string_view::npos;
}

string address(string_view file) {
    string text;
    for (const char c : file)
        text += is_plain_address(c) ? string(1, c)
                                    : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return text;
}

class Filler {
  public:
    explicit Filler(PageKind kind) : kind_(kind) {}

    string fill(const std::vector<Part>& parts, const std::vector<const PageFields*>& scopes) {
        string text;
        for (const Part& part : parts) {
            if (part.sign == 't')
                text += part.text;
            else if (part.sign == ' ')
                text += value(part.text, scopes).value_or("");
            else
                text += stretch(part, scopes);
        }
        return text;
    }

  private:
    std::optional<string> value(const string& name,
                                const std::vector<const PageFields*>& scopes) const {
        for (const PageFields* scope : scopes) {
            if (const auto words = scope->words.find(name); words != scope->words.end())
                return escaped(words->second, kind_);
            if (const auto file = scope->files.find(name); file != scope->files.end())
                return kind_ == PageKind::latex ? file->second : address(file->second);
        }
        return std::nullopt;
    }

    string stretch(const Part& part, const std::vector<const PageFields*>& scopes) {
        for (const PageFields* scope : scopes) {
            const auto list = scope->lists.find(part.text);
            if (list == scope->lists.end()) continue;
            if (part.sign == '^') return list->second.empty() ? fill(part.inner, scopes) : "";
            string text;
            for (const PageFields& item : list->second) {
                std::vector<const PageFields*> inside = scopes;
                inside.insert(inside.begin(), &item);
                text += fill(part.inner, inside);
            }
            return text;
        }
        const bool there = !value(part.text, scopes).value_or("").empty();
        return there == (part.sign == '#') ? fill(part.inner, scopes) : "";
    }

    PageKind kind_;
};

string html(string_view letter) {
    if (letter == "&") return "&amp;";
    if (letter == "<") return "&lt;";
    if (letter == ">") return "&gt;";
    if (letter == "\"") return "&quot;";
    return letter == "'" ? "&#39;" : string(letter);
}

// What begins a heading, a list or a quotation does so at the start of a line only.
string markdown(string_view letter, string_view before) {
    const bool number = before.find_first_not_of("0123456789") == string_view::npos;
    if (string_view("\\`*_[]<>&|$~").find(letter) != string_view::npos ||
        (before.empty() && string_view("#+-=!:").find(letter) != string_view::npos) ||
        (!before.empty() && number && (letter == "." || letter == ")")))
        return "\\" + string(letter);
    return string(letter);
}

// The letters that mean something in LaTeX, or that pdfLaTeX does not know by itself, as it knows
// them without packages, in its oldest encoding of fonts (OT1).
const std::map<string_view, string_view>& latex_letters() {
    static const std::map<string_view, string_view> letters{
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
        {"×", "\\(\\times\\)"},
        {"÷", "\\(\\div\\)"},
        {"·", "\\(\\cdot\\)"},
        {"⋅", "\\(\\cdot\\)"},
        {"∙", "\\(\\cdot\\)"},
        {"∗", "\\(\\ast\\)"},
        {"±", "\\(\\pm\\)"},
        {"∓", "\\(\\mp\\)"},
        {"∘", "\\(\\circ\\)"},
        {"°", "\\(^\\circ\\)"},
        {"′", "\\(^{\\prime}\\)"},
        {"″", "\\(^{\\prime\\prime}\\)"},
        {"≈", "\\(\\approx\\)"},
        {"≃", "\\(\\simeq\\)"},
        {"≅", "\\(\\cong\\)"},
        {"∼", "\\(\\sim\\)"},
        {"∝", "\\(\\propto\\)"},
        {"≠", "\\(\\neq\\)"},
        {"≡", "\\(\\equiv\\)"},
        {"≤", "\\(\\leq\\)"},
        {"≥", "\\(\\geq\\)"},
        {"≪", "\\(\\ll\\)"},
        {"≫", "\\(\\gg\\)"},
        {"«", "\\(\\ll\\)"},
        {"»", "\\(\\gg\\)"},
        {"‹", "\\(<\\)"},
        {"›", "\\(>\\)"},
        {"√", "\\(\\surd\\)"},
        {"∞", "\\(\\infty\\)"},
        {"∑", "\\(\\sum\\)"},
        {"∏", "\\(\\prod\\)"},
        {"∫", "\\(\\int\\)"},
        {"∂", "\\(\\partial\\)"},
        {"∇", "\\(\\nabla\\)"},
        {"∈", "\\(\\in\\)"},
        {"∉", "\\(\\notin\\)"},
        {"∩", "\\(\\cap\\)"},
        {"∪", "\\(\\cup\\)"},
        {"⊂", "\\(\\subset\\)"},
        {"∅", "\\(\\emptyset\\)"},
        {"∀", "\\(\\forall\\)"},
        {"∃", "\\(\\exists\\)"},
        {"∧", "\\(\\wedge\\)"},
        {"∨", "\\(\\vee\\)"},
        {"⊥", "\\(\\perp\\)"},
        {"∥", "\\(\\parallel\\)"},
        {"∠", "\\(\\angle\\)"},
        {"ℓ", "\\(\\ell\\)"},
        {"ℏ", "\\(\\hbar\\)"},
        {"→", "\\(\\to\\)"},
        {"←", "\\(\\leftarrow\\)"},
        {"↔", "\\(\\leftrightarrow\\)"},
        {"↑", "\\(\\uparrow\\)"},
        {"↓", "\\(\\downarrow\\)"},
        {"⇒", "\\(\\Rightarrow\\)"},
        {"⇐", "\\(\\Leftarrow\\)"},
        {"⇔", "\\(\\Leftrightarrow\\)"},
        {"↦", "\\(\\mapsto\\)"},
        {"⋯", "\\(\\cdots\\)"},
        {"○", "\\(\\bigcirc\\)"},
        {"●", "\\(\\bullet\\)"},
        {"△", "\\(\\triangle\\)"},
        {"⟨", "\\(\\langle\\)"},
        {"⟩", "\\(\\rangle\\)"},
        {"⅓", "\\(\\frac13\\)"},
        {"⅔", "\\(\\frac23\\)"},
        {"⅕", "\\(\\frac15\\)"},
        {"⅙", "\\(\\frac16\\)"},
        {"⅛", "\\(\\frac18\\)"},
        {"α", "\\(\\alpha\\)"},
        {"β", "\\(\\beta\\)"},
        {"γ", "\\(\\gamma\\)"},
        {"δ", "\\(\\delta\\)"},
        {"ε", "\\(\\varepsilon\\)"},
        {"ϵ", "\\(\\epsilon\\)"},
        {"ζ", "\\(\\zeta\\)"},
        {"η", "\\(\\eta\\)"},
        {"θ", "\\(\\theta\\)"},
        {"ϑ", "\\(\\vartheta\\)"},
        {"ι", "\\(\\iota\\)"},
        {"κ", "\\(\\kappa\\)"},
        {"λ", "\\(\\lambda\\)"},
        {"μ", "\\(\\mu\\)"},
        {"ν", "\\(\\nu\\)"},
        {"ξ", "\\(\\xi\\)"},
        {"π", "\\(\\pi\\)"},
        {"ρ", "\\(\\rho\\)"},
        {"ς", "\\(\\varsigma\\)"},
        {"σ", "\\(\\sigma\\)"},
        {"τ", "\\(\\tau\\)"},
        {"υ", "\\(\\upsilon\\)"},
        {"φ", "\\(\\varphi\\)"},
        {"ϕ", "\\(\\phi\\)"},
        {"χ", "\\(\\chi\\)"},
        {"ψ", "\\(\\psi\\)"},
        {"ω", "\\(\\omega\\)"},
        {"Γ", "\\(\\Gamma\\)"},
        {"Δ", "\\(\\Delta\\)"},
        {"Θ", "\\(\\Theta\\)"},
        {"Λ", "\\(\\Lambda\\)"},
        {"Ξ", "\\(\\Xi\\)"},
        {"Π", "\\(\\Pi\\)"},
        {"Σ", "\\(\\Sigma\\)"},
        {"Υ", "\\(\\Upsilon\\)"},
        {"Φ", "\\(\\Phi\\)"},
        {"Ψ", "\\(\\Psi\\)"},
        {"Ω", "\\(\\Omega\\)"},
        {"ο", "\\(o\\)"},
        {"Α", "\\(\\mathrm{A}\\)"},
        {"Β", "\\(\\mathrm{B}\\)"},
        {"Ε", "\\(\\mathrm{E}\\)"},
        {"Ζ", "\\(\\mathrm{Z}\\)"},
        {"Η", "\\(\\mathrm{H}\\)"},
        {"Ι", "\\(\\mathrm{I}\\)"},
        {"Κ", "\\(\\mathrm{K}\\)"},
        {"Μ", "\\(\\mathrm{M}\\)"},
        {"Ν", "\\(\\mathrm{N}\\)"},
        {"Ο", "\\(\\mathrm{O}\\)"},
        {"Ρ", "\\(\\mathrm{P}\\)"},
        {"Τ", "\\(\\mathrm{T}\\)"},
        {"Χ", "\\(\\mathrm{X}\\)"},
        {"µ", "\\(\\mu\\)"},
    };
    return letters;
}

// Those above and below the line.
string latex_index(string_view letter) {
    constexpr std::array<std::pair<string_view, string_view>, 17> raised{{{"⁰", "0"},
                                                                          {"¹", "1"},
                                                                          {"²", "2"},
                                                                          {"³", "3"},
                                                                          {"⁴", "4"},
                                                                          {"⁵", "5"},
                                                                          {"⁶", "6"},
                                                                          {"⁷", "7"},
                                                                          {"⁸", "8"},
                                                                          {"⁹", "9"},
                                                                          {"⁺", "+"},
                                                                          {"⁻", "-"},
                                                                          {"⁼", "="},
                                                                          {"⁽", "("},
                                                                          {"⁾", ")"},
                                                                          {"ⁿ", "n"},
                                                                          {"ⁱ", "i"}}};
    constexpr std::array<std::pair<string_view, string_view>, 29> lowered{
        {{"₀", "0"}, {"₁", "1"}, {"₂", "2"}, {"₃", "3"}, {"₄", "4"}, {"₅", "5"},
         {"₆", "6"}, {"₇", "7"}, {"₈", "8"}, {"₉", "9"}, {"₊", "+"}, {"₋", "-"},
         {"₌", "="}, {"₍", "("}, {"₎", ")"}, {"ₐ", "a"}, {"ₑ", "e"}, {"ₒ", "o"},
         {"ₓ", "x"}, {"ₕ", "h"}, {"ₖ", "k"}, {"ₗ", "l"}, {"ₘ", "m"}, {"ₙ", "n"},
         {"ₚ", "p"}, {"ₛ", "s"}, {"ₜ", "t"}, {"ᵢ", "i"}, {"ⱼ", "j"}}};
    for (const auto& [sign, plain] : raised)
        if (letter == sign) return fmt::format("\\(^{{{}}}\\)", plain);
    for (const auto& [sign, plain] : lowered)
        if (letter == sign) return fmt::format("\\(_{{{}}}\\)", plain);
    return {};
}

// Two of some letters would become one other.
string latex(string_view letter, string_view before) {
    if (string_view("-',").find(letter) != string_view::npos && before.ends_with(letter))
        return "{}" + string(letter);
    if (const auto found = latex_letters().find(letter); found != latex_letters().end())
        return string(found->second);
    const string index = latex_index(letter);
    return index.empty() ? string(letter) : index;
}

// The number of one code point of UTF-8; of a byte that is none, one that no letter has.
char32_t code_point(string_view letter) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
    if (letter.size() == 1) return byte(0) < 0x80 ? byte(0) : 0xFFFFFFFF;
    char32_t number = byte(0) & (0xFFU >> (letter.size() + 1));
    for (std::size_t i = 1; i < letter.size(); ++i) number = number << 6 | (byte(i) & 0x3FU);
    return number;
}

// What pdfLaTeX sets by itself beyond ASCII, as the LaTeX of 2022 does with Computer Modern.
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

}  // namespace

const std::map<string, std::vector<string>>& placeholders() {
    static const std::map<string, std::vector<string>> names{
        {"", {"title", "description", "carom", "sections", "figures", "films"}},
        {"sections", {"title", "subtitle", "description", "scene", "seed", "figures", "films"}},
        {"figures",
         {"name", "number", "caption", "alt", "kind", "time", "title", "scene", "seed", "width",
          "height", "picture", "inline", "svg", "pdf", "png", "csv"}},
        {"films",
         {"title", "description", "scene", "film", "poster", "captions", "chapters", "descriptions",
          "transcript"}}};
    return names;
}

string escaped(string_view text, PageKind kind) {
    string line, plain;
    bool blank = false;
    for (std::size_t i = 0, next = 0; i < text.size(); i = next) {
        next = next_code_point(text, i);
        const string_view letter = text.substr(i, next - i);
        if (letter == " " || letter == "\n" || letter == "\t" || letter == "\r") {
            blank = !line.empty();
            continue;
        }
        if (std::exchange(blank, false)) {
            line += ' ';
            plain += ' ';
        }
        if (kind == PageKind::html) line += html(letter);
        if (kind == PageKind::markdown) line += markdown(letter, plain);
        if (kind == PageKind::latex) line += latex(letter, plain);
        plain += letter;
    }
    return line;
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

string filled_page(const Source& page, PageKind kind, const PageFields& fields) {
    Errors errors;
    const std::vector<Part> parts = Parser(page, errors).parse();
    errors.throw_if_any();
    return Filler(kind).fill(parts, {&fields});
}

}  // namespace carom
