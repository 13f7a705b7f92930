#include "util/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>

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

// Tabs stay tabs, so that the caret stands under its character at any tab width.
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

}  // namespace

std::string to_text(const Diagnostic& diagnostic) {
    const SourceSpan& span = diagnostic.span;
    std::string text = span.file;
    if (span.line > 0) text += fmt::format(":{}:{}", span.line, span.column);
    if (!text.empty()) text += ": ";
    text += "error: " + diagnostic.message;
    if (span.line > 0 && !diagnostic.source_line.empty()) {
        const std::string gutter = fmt::format("{:>5} | ", span.line);
        const auto carets = static_cast<std::size_t>(std::max(1, span.length));
        text += fmt::format("\n{}{}", gutter, diagnostic.source_line);
        text += fmt::format("\n{:>8}{}{}", "| ", padding_up_to(diagnostic.source_line, span.column),
                            std::string(carets, '^'));
    }
    if (!diagnostic.hint.empty()) text += "\n  hint: " + diagnostic.hint;
    return text;
}

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(all_texts(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace carom
