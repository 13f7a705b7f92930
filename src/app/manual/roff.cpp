#include "app/manual/roff.h"

#include <fmt/format.h>

#include "util/text.h"

namespace carom {
namespace {

// Characters that roff would take for something else, or set as a typographic one.
std::string escaped(const std::string& text) {
    std::string roff;
    for (const char letter : text) {
        switch (letter) {
            case '\\':
                roff += "\\e";
                break;
            case '-':
                roff += "\\-";
                break;
            case '\'':
                roff += "\\(aq";
                break;
            case '`':
                roff += "\\(ga";
                break;
            case '^':
                roff += "\\(ha";
                break;
            case '~':
                roff += "\\(ti";
                break;
            default:
                roff += letter;
        }
    }
    return roff.starts_with('.') ? "\\&" + roff : roff;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }

// The words of a call that are typed as they stand, before those that stand for others.
std::string call_line(const std::string& call) {
    std::size_t end = call.find(' ');
    const bool named = end != std::string::npos && call.size() > end + 1 && call[end + 1] >= 'a' &&
                       call[end + 1] <= 'z';
    if (named) end = call.find(' ', end + 1);
    if (end == std::string::npos) return bold(call);
    return bold(call.substr(0, end)) + escaped(call.substr(end));
}

std::string section_roff(const ManualSection& section) {
    std::string roff = ".SH " + upper_case(section.title) + "\n";
    for (const std::string& call : section.calls)
        roff += (&call == section.calls.data() ? "" : ".br\n") + call_line(call) + "\n";
    for (const std::string& paragraph : section.paragraphs)
        roff +=
            (&paragraph == section.paragraphs.data() ? "" : ".PP\n") + escaped(paragraph) + "\n";
    for (const auto& [term, meaning] : section.definitions)
        roff += ".TP\n" + bold(term) + "\n" + escaped(meaning) + "\n";
    return roff;
}

}  // namespace

std::string roff_of(const ManualPage& page) {
    std::string roff = fmt::format(
        ".\\\" Made from the table of commands by `carom help --files`.\n"
        ".TH {} 1 \"\" \"carom {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n",
        escaped(upper_case(page.name)), CAROM_VERSION, escaped(page.name), escaped(page.summary));
    for (const ManualSection& section : page.sections) roff += section_roff(section);
    return roff;
}

}  // namespace carom
