// What hints suggest is followed, and must be accepted: in each bad scene of tests/scenes_bad, the
// text that a hint gives in backquotes replaces the mistake, and the message must be gone.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "panels/registry.h"
#include "scene/load.h"
#include "scene/scene.h"
#include "support/bad_scenes.h"
#include "support/files.h"
#include "support/test_root.h"
#include "util/text.h"

using carom::Diagnostic;
using carom::test::contents;
namespace fs = std::filesystem;

namespace {

std::vector<Diagnostic> mistakes_in(const std::string& text, const fs::path& path) {
    try {
        carom::load_scene_text(text, path.string(), {"templates", carom::panel_kinds()});
    } catch (const carom::SceneError& error) {
        return error.diagnostics();
    }
    return {};
}

// Returns what stands between the first backquotes after one of these beginnings of a hint.
std::optional<std::string> suggested(const std::string& hint) {
    for (const std::string begin : {"did you mean `", "write `", "for instance `"}) {
        if (!hint.starts_with(begin)) continue;
        const std::size_t end = hint.find('`', begin.size());
        return hint.substr(begin.size(), end - begin.size());
    }
    return std::nullopt;
}

// Returns the byte at which a place begins, and that after its end.
std::pair<std::size_t, std::size_t> bytes_of(const carom::SourceSpan& span,
                                             const std::string& text) {
    std::size_t at = 0;
    for (int line = 1; line < span.line; ++line) at = text.find('\n', at) + 1;
    for (int column = 1; column < span.column; ++column) at = carom::next_code_point(text, at);
    std::size_t end = at;
    for (int k = 0; k < span.length; ++k) end = carom::next_code_point(text, end);
    return {at, end};
}

// Follows a suggestion: a key that a mapping needs is added to it, anything else replaces the
// mistake. An empty value is written behind its key, or behind its dash.
std::string followed(const Diagnostic& mistake, const std::string& written,
                     const std::string& text) {
    const auto [begin, end] = bytes_of(mistake.span, text);
    const std::string before = text.substr(0, begin);
    if (mistake.message.find(" needs ") != std::string::npos) {
        if (text[begin] == '{') {
            const bool is_empty = text[begin + 1] == '}';
            return before + "{" + written + (is_empty ? "" : ", ") + text.substr(begin + 1);
        }
        const std::size_t column = begin - (before.rfind('\n') + 1);
        return before + written + "\n" + std::string(column, ' ') + text.substr(begin);
    }
    if (mistake.message.ends_with("found nothing")) {
        const std::size_t value =
            text[begin] == '-' || text[begin] == '[' ? begin + 1 : text.find(':', begin) + 1;
        return text.substr(0, value) + " " + written + text.substr(value);
    }
    return before + written + text.substr(end);
}

// Returns how many mistakes of this kind there are in this line.
auto count_of(const Diagnostic& one, const std::vector<Diagnostic>& all) {
    return std::ranges::count_if(all, [&](const Diagnostic& other) {
        return other.span.line == one.span.line && other.message == one.message;
    });
}

}  // namespace

TEST_CASE("each suggestion is accepted when it is followed") {
    fs::current_path(carom::test::checkout());
    std::size_t tried = 0;
    for (const fs::path& path : carom::test::bad_scenes()) {
        const std::string text = contents(path);
        const std::vector<Diagnostic> mistakes = mistakes_in(text, path);
        for (const Diagnostic& mistake : mistakes) {
            const auto written = suggested(mistake.hint);
            if (!written || mistake.span.file != path.string()) continue;
            CAPTURE(path.string());
            CAPTURE(mistake.message);
            CAPTURE(*written);
            CHECK(count_of(mistake, mistakes_in(followed(mistake, *written, text), path)) <
                  count_of(mistake, mistakes));
            ++tried;
        }
    }
    CHECK(tried > 120);
}

TEST_CASE("every mistake in a bad scene has a place and a suggestion") {
    fs::current_path(carom::test::checkout());
    for (const fs::path& path : carom::test::bad_scenes()) {
        for (const Diagnostic& mistake : mistakes_in(contents(path), path)) {
            CAPTURE(path.string());
            CAPTURE(mistake.message);
            const bool is_rest = mistake.message.starts_with("and ");
            CHECK((is_rest || (mistake.span.line > 0 && !mistake.hint.empty())));
        }
    }
}
