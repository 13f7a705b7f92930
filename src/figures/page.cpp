#include "figures/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "scene/limits.h"
#include "util/text.h"

namespace carom {
namespace {

using std::string;
using std::string_view;

struct Tag {
    char sign = ' ';  ///< # ^ / ! or a blank
    string name;
    std::size_t begin = 0, end = 0;  ///< range of the text that the tag replaces
    std::size_t place = 0;           ///< position where its braces begin
};

string_view trimmed(string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\n");
    if (first == string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

// If a tag is alone on its line, apart from blanks, extends it to the whole line.
void take_line(Tag& tag, const string& text) {
    std::size_t begin = tag.begin, end = tag.end;
    while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
    while (end < text.size() && (text[end] == ' ' || text[end] == '\t' || text[end] == '\r')) ++end;
    if ((begin > 0 && text[begin - 1] != '\n') || (end < text.size() && text[end] != '\n')) return;
    tag.begin = begin;
    tag.end = std::min(text.size(), end + 1);
}

// The next tag. Of three braces the first belongs to the text: \caption{{{caption}}}.
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

// The word of the program for a name that begins with an underscore.
std::optional<Phrase> phrase_of(const string& name) {
    if (!name.starts_with('_')) return std::nullopt;
    return Phrase{string_view(name).substr(1)};
}

bool is_known(Phrase phrase) {
    return std::ranges::any_of(phrases::all(),
                               [&](const phrases::Row& row) { return row[0] == phrase.english; });
}

/// A part of a template: text, a placeholder, or a section between two tags.
struct Part {
    char sign = 't';  ///< t: text
    string text;      ///< or name
    std::vector<Part> inner = {};
};

class Parser {
  public:
    Parser(const Source& page, const Placeholders& names, Errors& errors)
        : page_(page), names_(names), errors_(errors) {}

    std::vector<Part> parse() { return until(nullptr, {""}); }

  private:
    // Names of the enclosing lists, from the innermost to the page.
    using Scopes = std::vector<string>;

    std::vector<string> names_in(const Scopes& scopes) const {
        std::vector<string> names;
        for (const string& scope : scopes) {
            const auto& more = names_.at(scope);
            names.insert(names.end(), more.begin(), more.end());
        }
        return names;
    }

    void check(const Tag& tag, const Scopes& scopes) {
        if (errors_.is_full()) return errors_.add(page_, tag.place, "", "");
        if (const auto phrase = phrase_of(tag.name); phrase && is_known(*phrase)) return;
        const std::vector<string> names = names_in(scopes);
        const bool lists = tag.sign == ' ' && !tag.name.empty() && names_.contains(tag.name);
        if (!lists && std::ranges::find(names, tag.name) != names.end()) return;
        if (lists)
            return errors_.add(page_, tag.place, fmt::format("`{}` is a list", tag.name),
                               fmt::format("write {{{{#{0}}}}} … {{{{/{0}}}}}", tag.name));
        errors_.add(page_, tag.place,
                    fmt::format("{} is no placeholder {}", in_quotes(tag.name),
                                scopes.front().empty() ? string("of a page")
                                                       : fmt::format("in `{}`", scopes.front())),
                    spelling_hint(tag.name, names, "there are " + listed(names, "and", "`")));
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
                errors_.add(
                    page_, tag->place,
                    fmt::format("{} is closed, and is not open here", in_quotes(tag->name)),
                    opened != nullptr ? fmt::format("`{}` is open", opened->name) : "leave it out");
                continue;
            }
            check(*tag, scopes);
            Part part{tag->sign, tag->name};
            if (tag->sign != ' ') part.inner = stretch(*tag, scopes);
            parts.push_back(std::move(part));
        }
        if (opened != nullptr && !broken_)
            errors_.add(page_, opened->place, fmt::format("`{}` is not closed", opened->name),
                        fmt::format("it ends with {{{{/{}}}}}", opened->name));
        parts.push_back({'t', page_.text.substr(at_)});
        at_ = page_.text.size();
        return parts;
    }

    // Parses the section between a tag and its closing tag. A list inside itself is refused: it
    // would repeat without end.
    std::vector<Part> stretch(const Tag& tag, const Scopes& scopes) {
        Scopes inside = scopes;
        const bool is_list = tag.sign == '#' && names_.contains(tag.name);
        if (is_list && std::ranges::find(scopes, tag.name) != scopes.end())
            errors_.add(page_, tag.place, fmt::format("`{}` is inside itself", tag.name),
                        fmt::format("close it before with {{{{/{}}}}}", tag.name));
        else if (is_list)
            inside.insert(inside.begin(), tag.name);
        if (depth_ == most_page_nesting.count()) {
            errors_.add(
                page_, tag.place,
                fmt::format("more than {} levels, one in another", most_page_nesting.count()),
                to_text(most_page_nesting));
            broken_ = true;
            at_ = page_.text.size();
            return {};
        }
        ++depth_;
        std::vector<Part> parts = until(&tag, inside);
        --depth_;
        return parts;
    }

    const Source& page_;
    const Placeholders& names_;
    Errors& errors_;
    std::size_t at_ = 0, depth_ = 0;
    bool broken_ = false;  ///< an error was reported, and parsing stops
};

// The URL of a file. A name with a colon gets ./ in front: text before a colon would be read as the
// scheme.
string address(const string& file) {
    const string encoded = percent_encoded(file, "-._~/+=:;,");
    return file.find(':') != string::npos ? "./" + encoded : encoded;
}

string latex_name(const string& file) {
    if (file.find_first_of("\\{}%#^~$&\n") == string::npos) return file;
    throw UsageError(fmt::format(
        "{}: a LaTeX page cannot name this file, as letters of its name are commands there; rename "
        "the scene",
        file));
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
    static Language language_in(const std::vector<const PageFields*>& scopes) {
        for (const PageFields* scope : scopes)
            if (scope->language) return *scope->language;
        return Language::english;
    }

    std::optional<string> value(const string& name,
                                const std::vector<const PageFields*>& scopes) const {
        if (const auto phrase = phrase_of(name))
            return escaped(say(language_in(scopes), *phrase), kind_);
        for (const PageFields* scope : scopes) {
            if (const auto words = scope->words.find(name); words != scope->words.end())
                return escaped(words->second, kind_);
            if (const auto words = scope->formulated.find(name); words != scope->formulated.end())
                return escaped_with_formulas(words->second, kind_);
            if (const auto file = scope->inlined.find(name); file != scope->inlined.end())
                return file->second;
            if (const auto file = scope->files.find(name); file != scope->files.end())
                return kind_ == PageKind::latex ? latex_name(file->second) : address(file->second);
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

// The template must be UTF-8, like the words that are filled in.
void require_utf8(const Source& page, Errors& errors) {
    for (std::size_t i = 0, next = 0; i < page.text.size(); i = next) {
        next = next_code_point(page.text, i);
        if (is_utf8(string_view(page.text).substr(i, next - i))) continue;
        return errors.add(
            page, i,
            fmt::format("byte 0x{:02X} is not UTF-8", static_cast<unsigned char>(page.text[i])),
            "save the file as UTF-8");
    }
}

}  // namespace

const Placeholders& placeholders() {
    static const Placeholders names{
        {"",
         {"title", "description", "language", "carom", "style", "sections", "figures", "films"}},
        {"sections", {"title", "subtitle", "description", "scene", "seed", "figures", "films"}},
        {"figures",
         {"name", "number", "caption", "alt", "kind", "time", "title", "scene", "seed", "width",
          "height", "wide", "picture", "inline", "svg", "pdf", "png", "csv"}},
        {"films",
         {"title", "description", "scene", "film", "poster", "captions", "chapters", "descriptions",
          "transcript"}}};
    return names;
}

string filled_page(const Source& page, PageKind kind, const PageFields& fields,
                   const Placeholders& names) {
    Errors errors;
    require_utf8(page, errors);
    const std::vector<Part> parts = Parser(page, names, errors).parse();
    errors.throw_if_any();
    return Filler(kind).fill(parts, {&fields});
}

}  // namespace carom
