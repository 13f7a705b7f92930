#include "util/diagnostics.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "util/text.h"

namespace carom {
namespace {

std::string all_texts(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
        if (!text.empty()) text += "\n\n";
        text += to_text(diagnostic);
    }
    return text;
}

// Tabs are kept, so that the caret is below its character at any tab width.
std::string padding_up_to(const std::string& line, int column) {
    std::string padding;
    int position = 1;
    for (std::size_t i = 0; i < line.size() && position < column; i = next_code_point(line, i)) {
        padding += line[i] == '\t' ? '\t' : ' ';
        ++position;
    }
    padding.append(static_cast<std::size_t>(std::max(0, column - position)), ' ');
    return padding;
}

// Cuts a line that is wider than a screen to a piece around the place.
Diagnostic cut_to_screen(Diagnostic diagnostic) {
    constexpr int longest = 160;
    constexpr int kept_before = 60;
    std::string& line = diagnostic.source_line;
    SourceSpan& span = diagnostic.span;
    if (code_points(line) <= longest) return diagnostic;
    const int first = std::max(0, span.column - 1 - kept_before);
    std::string piece = first > 0 ? "…" : "";
    int position = 0;
    for (std::size_t i = 0; i < line.size() && position < first + longest; ++position) {
        const std::size_t next = next_code_point(line, i);
        if (position >= first) piece += line.substr(i, next - i);
        i = next;
    }
    line = piece + (first + longest < code_points(line) ? "…" : "");
    span.column -= first > 0 ? first - 1 : 0;
    span.length = std::min(span.length, longest - kept_before);
    return diagnostic;
}

// Returns the line, with its number if it is from a file, and the caret below it.
std::string marked_line(const Diagnostic& whole) {
    const Diagnostic shown = cut_to_screen(whole);
    const SourceSpan& span = shown.span;
    const std::string number = span.line > 0 ? fmt::format("{}", span.line) : "";
    const auto carets = static_cast<std::size_t>(std::max(1, span.length));
    return fmt::format("\n{:>5} | {}\n{:>8}{}{}", number, printable(shown.source_line), "| ",
                       padding_up_to(shown.source_line, span.column), std::string(carets, '^'));
}

}  // namespace

std::string to_text(const Diagnostic& diagnostic) {
    const SourceSpan& span = diagnostic.span;
    std::string text = printable(span.file);
    if (span.line > 0) text += fmt::format(":{}:{}", span.line, span.column);
    if (!text.empty()) text += ": ";
    text += "error: " + printable(diagnostic.message);
    if (!diagnostic.source_line.empty()) text += marked_line(diagnostic);
    if (!diagnostic.hint.empty()) text += "\n  hint: " + printable(diagnostic.hint);
    return text;
}

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(all_texts(diagnostics)), diagnostics_(std::move(diagnostics)) {}

bool is_transient(int error) {
    constexpr std::array passing{ENOSPC, EDQUOT, EIO,    EAGAIN, EMFILE,
                                 ENFILE, ENOMEM, ESTALE, EBUSY,  ETIMEDOUT};
    return std::ranges::find(passing, error) != passing.end();
}

void throw_system_error(const std::string& message, int error) {
    if (is_transient(error)) throw TemporaryError(message);
    throw SystemError(message);
}

void write_to_standard_error(std::initializer_list<std::string_view> parts) noexcept {
    for (const std::string_view part : parts)
        if (write(STDERR_FILENO, part.data(), part.size()) < 0) return;
}

}  // namespace carom
