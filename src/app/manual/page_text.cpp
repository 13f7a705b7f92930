#include "app/manual/page_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "util/text.h"

namespace carom {
namespace {

constexpr std::size_t line_width = 80;
constexpr std::size_t widest_term = 26;

// Words filled into lines that begin at a column; the first line goes on from `column`.
std::string filled(const std::string& text, std::size_t indent, std::size_t column) {
    std::string lines;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::size_t length = static_cast<std::size_t>(code_points(word));
        if (column > indent && column + 1 + length > line_width) {
            lines += "\n" + std::string(indent, ' ');
            column = indent;
        }
        if (column > indent) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += length;
    }
    return lines + "\n";
}

std::string definitions_text(const ManualSection& section) {
    std::size_t widest = 0;
    for (const Definition& definition : section.definitions)
        if (definition.term.size() <= widest_term)
            widest = std::max(widest, definition.term.size());
    const std::size_t indent = section.long_terms ? 6 : widest + 4;
    std::string text;
    for (const auto& [term, meaning] : section.definitions) {
        text += "  " + term;
        const bool fits = term.size() <= widest && !section.long_terms;
        text += fits ? std::string(indent - 2 - term.size(), ' ') : "\n" + std::string(indent, ' ');
        text += filled(meaning, indent, indent);
    }
    return text;
}

std::string section_text(const ManualSection& section) {
    std::string text = "\n" + section.title + ":\n";
    for (const std::string& call : section.calls) text += "  " + call + "\n";
    for (const std::string& paragraph : section.paragraphs)
        text += (&paragraph == section.paragraphs.data() ? "  " : "\n  ") + filled(paragraph, 2, 2);
    return text + definitions_text(section);
}

}  // namespace

std::string text_of(const ManualPage& page) {
    std::string text = filled(page.name + ": " + page.summary, 0, 0);
    for (const ManualSection& section : page.sections) text += section_text(section);
    return text;
}

}  // namespace carom
