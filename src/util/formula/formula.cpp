#include "util/formula/formula.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <utility>

#include "util/text.h"

namespace carom::formula {
namespace {

constexpr int deepest = 12;  // parts within parts

const std::array<std::pair<std::string_view, double>, 4> spaces{
    {{",", 3.0}, {";", 5.0}, {" ", 6.0}, {"quad", 18.0}}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

class Parser {
  public:
    explicit Parser(std::string_view tex) : tex_(tex) {}

    Parts all() {
        Parts parts = list();
        if (at_ == tex_.size()) return parts;
        if (tex_[at_] == '}')
            fail(at_, "a `}` that closes nothing", "leave it out, or write `{` before it");
        fail(at_, "`\\right` without a `\\left` before it", "write the bracket alone");
    }

  private:
    [[noreturn]] static void fail(std::size_t at, const std::string& message,
                                  const std::string& hint) {
        throw Error(at, message, hint);
    }

    void skip_blanks() {
        while (at_ < tex_.size() && (tex_[at_] == ' ' || tex_[at_] == '\n')) ++at_;
    }

    // Returns whether the list that is being parsed ends here.
    bool is_at_end() {
        skip_blanks();
        if (at_ == tex_.size() || tex_[at_] == '}') return true;
        constexpr std::string_view right = "\\right";
        return tex_.substr(at_).starts_with(right) &&
               (at_ + right.size() == tex_.size() || !is_letter(tex_[at_ + right.size()]));
    }

    Parts list() {
        Parts parts;
        while (!is_at_end()) {
            const char next = tex_[at_];
            if (next == '^' || next == '_' || next == '\'')
                index(parts);
            else
                parts.push_back(part());
        }
        return parts;
    }

    // Parses a superscript or subscript of the preceding part.
    void index(Parts& parts) {
        const std::size_t at = at_;
        const char sign = tex_[at_++];
        if (parts.empty() || parts.back().of == Part::Of::space)
            fail(at, fmt::format("`{}` with nothing before it", sign),
                 "write what it belongs to, or `{}` for nothing");
        Part& of = parts.back();
        Parts& its = sign == '_' ? of.below_index : of.above_index;
        if (sign == '\'') {
            if (!its.empty() && its.back().symbol != symbol_of_command("prime"))
                fail(at, "a `'` after a `^`", "write it before: `v'^2`");
            its.push_back(of_symbol(*symbol_of_command("prime")));
            return;
        }
        const bool is_primed = !its.empty() && its.back().symbol == symbol_of_command("prime");
        if (!its.empty() && !is_primed)
            fail(at, fmt::format("`{}` twice on one part", sign),
                 fmt::format("use braces: `{{x{0}a}}{0}b`", sign));
        Parts more = argument(at, std::string(1, sign));
        if (more.empty()) more.push_back({.of = Part::Of::space});
        its.insert(its.end(), more.begin(), more.end());
    }

    static Part of_symbol(const Symbol& symbol) { return {.kind = symbol.kind, .symbol = &symbol}; }

    // Parses the parts in braces, or otherwise the next part alone.
    Parts argument(std::size_t at, const std::string& of) {
        skip_blanks();
        if (at_ == tex_.size() || tex_[at_] == '}')
            fail(at, fmt::format("`{}` with nothing after it", of),
                 "write what belongs to it in braces");
        if (tex_[at_] == '{') return braces();
        if (tex_[at_] == '^' || tex_[at_] == '_' || tex_[at_] == '\'')
            fail(at_, fmt::format("`{}` after `{}`", tex_[at_], of), "put it into braces");
        return {part()};
    }

    Parts braces() {
        const std::size_t at = at_++;
        Parts parts = list();
        if (at_ == tex_.size()) fail(at, "a `{` that is not closed", "write `}` where it ends");
        if (tex_[at_] != '}')
            fail(at_, "`\\right` without a `\\left` in the same braces",
                 "put both brackets into the same braces");
        ++at_;
        return parts;
    }

    Part part() {
        if (++depth_ > deepest)
            fail(at_, fmt::format("parts within parts, more than {} deep", deepest),
                 "write it in several formulae");
        Part one = undivided();
        --depth_;
        return one;
    }

    Part undivided() {
        const std::size_t at = at_;
        if (tex_[at_] == '{') return group(braces());
        if (tex_[at_] == '\\') return command();
        at_ = next_code_point(tex_, at_);
        const std::string_view letter = tex_.substr(at, at_ - at);
        if (const Symbol* symbol = symbol_of_letter(letter)) return of_symbol(*symbol);
        fail(at, fmt::format("`{}` has no meaning in a formula", letter),
             "formulae have Latin and Greek letters, digits, and the signs that docs/films.md "
             "lists");
    }

    // A single symbol in braces is just that symbol, without the space around it.
    static Part group(Parts parts) {
        if (parts.size() == 1 && parts[0].of == Part::Of::symbol && !parts[0].has_indices() &&
            parts[0].kind == Class::ordinary)
            return std::move(parts[0]);
        return {.of = Part::Of::group, .body = std::move(parts)};
    }

    std::string command_name() {
        const std::size_t begin = ++at_;
        while (at_ < tex_.size() && is_letter(tex_[at_])) ++at_;
        if (at_ == begin && at_ < tex_.size()) at_ = next_code_point(tex_, at_);
        return std::string(tex_.substr(begin, at_ - begin));
    }

    Part command() {
        const std::size_t at = at_;
        const std::string name = command_name();
        if (const Symbol* symbol = symbol_of_command(name)) return of_symbol(*symbol);
        if (const Symbol* accent = accent_of_command(name)) {
            Parts over = argument(at, "\\" + name);
            return {.of = Part::Of::accent, .symbol = accent, .body = std::move(over)};
        }
        if (name == "frac") {
            Parts above = argument(at, "\\frac"), below = argument(at, "\\frac");
            return {.of = Part::Of::fraction, .body = std::move(above), .below = std::move(below)};
        }
        if (name == "sqrt") {
            skip_blanks();
            if (at_ < tex_.size() && tex_[at_] == '[')
                fail(at_, "`\\sqrt` takes no degree", "write `x^{1/3}`");
            return {.of = Part::Of::root, .body = argument(at, "\\sqrt")};
        }
        if (name == "left") return fenced(at);
        if (name == "mathrm" || name == "text") return upright(at, name);
        if (!spoken_function(name).english.empty())
            return {.of = Part::Of::upright, .kind = Class::operation, .words = name};
        for (const auto& [space, width] : spaces)
            if (name == space) return {.of = Part::Of::space, .width = width};
        std::vector<std::string> written;
        for (const std::string& command : commands()) written.push_back("\\" + command);
        fail(at, fmt::format("`\\{}` has no meaning in a formula", name),
             spelling_hint("\\" + name, written, "docs/films.md lists the commands of formulae"));
    }

    // Parses upright letters, as in the surrounding text.
    Part upright(std::size_t at, const std::string& name) {
        skip_blanks();
        if (at_ == tex_.size() || tex_[at_] != '{')
            fail(at, fmt::format("`\\{}` without braces after it", name),
                 fmt::format("write `\\{}{{words}}`", name));
        const std::size_t begin = at_ + 1, end = tex_.find('}', begin);
        if (end == std::string_view::npos)
            fail(at_, "a `{` that is not closed", "write `}` where it ends");
        std::string words(tex_.substr(begin, end - begin));
        if (const std::size_t bad = words.find_first_of("\\{$^_"); bad != std::string::npos)
            fail(begin + bad, fmt::format("`{}` among upright words", words[bad]),
                 "`\\mathrm` and `\\text` have plain words only");
        if (name == "mathrm") std::erase(words, ' ');
        at_ = end + 1;
        return {.of = Part::Of::upright, .words = std::move(words)};
    }

    Part fenced(std::size_t at) {
        Part whole{.of = Part::Of::fenced, .kind = Class::inner};
        whole.left = bracket(at, "\\left");
        whole.body = list();
        if (at_ == tex_.size() || tex_[at_] == '}')
            fail(at, "`\\left` without a `\\right` after it",
                 "`\\right.` closes without a bracket");
        const std::size_t end = at_;
        at_ += std::string_view("\\right").size();
        whole.right = bracket(end, "\\right");
        return whole;
    }

    // Parses a delimiter; returns null for `.`.
    const Symbol* bracket(std::size_t at, const std::string& after) {
        skip_blanks();
        if (at_ == tex_.size())
            fail(at, fmt::format("`{}` without a bracket", after),
                 fmt::format("write `{}(`", after));
        const std::size_t begin = at_;
        std::string name;
        if (tex_[at_] == '\\') {
            name = command_name();
        } else {
            at_ = next_code_point(tex_, at_);
            name = std::string(tex_.substr(begin, at_ - begin));
            if (name == "⟨") name = "langle";
            if (name == "⟩") name = "rangle";
        }
        if (name == ".") return nullptr;
        if (const Symbol* symbol = bracket_of(name)) return symbol;
        fail(begin, fmt::format("`{}` is no bracket that grows", tex_.substr(begin, at_ - begin)),
             "those are ( ) [ ] | \\langle \\rangle, and . for none");
    }

    std::string_view tex_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

Parts parsed(std::string_view tex) { return Parser(tex).all(); }

std::vector<Span> spans_of(std::string_view text) {
    std::vector<Span> spans;
    Span words;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_escaped = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '$';
        if (is_escaped) ++i;
        if (text[i] != '$' || is_escaped) {
            words.text += text[i];
            continue;
        }
        const std::size_t end = text.find('$', i + 1);
        if (end == std::string_view::npos)
            throw Error(i, "a `$` that begins a formula, and no `$` that ends it",
                        "write \\$ for a dollar sign");
        if (text.substr(i + 1, end - i - 1).find_first_not_of(" \n") == std::string_view::npos)
            throw Error(i, "an empty formula", "write \\$ for a dollar sign");
        if (!words.text.empty()) spans.push_back(std::move(words));
        spans.push_back({true, std::string(text.substr(i + 1, end - i - 1)), i + 1});
        words = {.at = end + 1};
        i = end;
    }
    if (!words.text.empty()) spans.push_back(std::move(words));
    return spans;
}

std::string without_formulas(std::string_view words) {
    std::string text;
    for (const char c : words) text += c == '$' ? std::string("\\$") : std::string(1, c);
    return text;
}

bool has_formula(std::string_view text) {
    for (const Span& span : spans_of(text))
        if (span.is_formula) return true;
    return false;
}

void check(std::string_view text) {
    for (const Span& span : spans_of(text)) try {
            if (span.is_formula) parsed(span.text);
        } catch (const Error& error) {
            throw Error(span.at + error.at, error.what(), error.hint);
        }
}

}  // namespace carom::formula
