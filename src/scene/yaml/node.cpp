#include "scene/yaml/node.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "scene/limits.h"
#include "scene/yaml/yaml_text.h"
#include "util/text.h"

namespace carom {
namespace {

// Further errors are counted but not kept: a list of a hundred thousand wrong numbers is one
// mistake.
constexpr std::size_t most_listed = 1000;

std::size_t end_of_line(std::string_view text, std::size_t offset) {
    const std::size_t end = std::min(text.find('\n', offset), text.size());
    return end > offset && text[end - 1] == '\r' ? end - 1 : end;
}

std::size_t start_of_line(std::string_view text, std::size_t offset) {
    return offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;  // npos + 1 is 0
}

// Returns the length of the bracketed or quoted text at the beginning of a line, including brackets
// and quotes.
std::size_t enclosed_bytes(std::string_view line) {
    int depth = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' || line[i] == '\'')
            i = std::min(end_of_quotation(line, i), line.size());
        else if (line[i] == '[' || line[i] == '{')
            ++depth;
        else if (line[i] == ']' || line[i] == '}')
            --depth;
        if (depth == 0 && i < line.size()) return i + 1;
    }
    return 1;
}

std::size_t marked_bytes(const Node& node) {
    const std::string_view text = node.source->text;
    if (node.offset >= text.size()) return 1;
    const std::string_view line =
        text.substr(node.offset, end_of_line(text, node.offset) - node.offset);
    if (line.empty()) return 1;
    if (std::string_view{"[{\"'"}.find(line[0]) != std::string_view::npos)
        return enclosed_bytes(line);
    if (line[0] == '|' || line[0] == '>') return 1;
    if (node.is_scalar() && line.starts_with(node.text)) return node.text.size();
    return std::max<std::size_t>(1, std::min(line.find_first_of(":,]}# \t"), line.size()));
}

// Returns a place in a source. An `offset` of npos stands for the whole source. A text from the
// command line has no lines.
Diagnostic place_in(const Source& source, std::size_t offset, std::size_t bytes) {
    Diagnostic place;
    place.span.file = source.name;
    if (offset == std::string::npos) return place;
    const std::string_view text = source.text;
    offset = std::min(offset, text.size());
    const std::size_t start = start_of_line(text, offset);
    if (source.origin != Origin::command_line) {
        const std::string_view before = text.substr(0, start);
        place.span.line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
    }
    place.span.column = 1 + code_points(text.substr(start, offset - start));
    place.span.length = std::max(1, code_points(text.substr(offset, bytes)));
    place.source_line = printable(text.substr(start, end_of_line(text, start) - start));
    return place;
}

// Order of errors by origin: first the scene's own, then the template's, then those of the command
// line.
int rank(Origin origin) {
    return origin == Origin::scene ? 0 : origin == Origin::template_file ? 1 : 2;
}

}  // namespace

const Node* find(const Node& mapping, std::string_view key) {
    for (std::size_t i = 0; i < mapping.keys.size(); ++i)
        if (mapping.keys[i].text == key) return &mapping.items[i];
    return nullptr;
}

Node* find(Node& mapping, std::string_view key) {
    return const_cast<Node*>(find(std::as_const(mapping), key));
}

void point_to(Node& node, const Source& source) {
    node.source = &source;
    for (Node& key : node.keys) point_to(key, source);
    for (Node& item : node.items) point_to(item, source);
}

void erase_key(Node& mapping, std::size_t index) {
    mapping.keys.erase(mapping.keys.begin() + static_cast<std::ptrdiff_t>(index));
    mapping.items.erase(mapping.items.begin() + static_cast<std::ptrdiff_t>(index));
}

void erase_key(Node& mapping, std::string_view key) {
    for (std::size_t i = mapping.keys.size(); i-- > 0;)
        if (mapping.keys[i].text == key) erase_key(mapping, i);
}

std::string in_quotes(std::string_view text) {
    constexpr int most_shown = 40;
    std::size_t end = 0;
    for (int length = 0; end < text.size() && length < most_shown; ++length)
        end = next_code_point(text, end);
    return "`" + printable(text.substr(0, end)) + (end < text.size() ? "…`" : "`");
}

std::string described(const Node& node) {
    switch (node.kind) {
        case Node::Kind::null:
            return "nothing";
        case Node::Kind::scalar:
            return node.quoted ? "the text " + in_quotes(node.text)
                               : in_quotes(node.written.empty() ? node.text : node.written);
        case Node::Kind::list:
            return node.items.empty() ? "an empty list"
                                      : fmt::format("a list of {}", node.items.size());
        case Node::Kind::mapping:
            return "a mapping";
    }
    return "nothing";
}

void Errors::add(const Node& node, std::string message, std::string hint) {
    const std::size_t bytes = is_full() ? 1 : marked_bytes(node);
    add({node.source, node.offset, bytes, std::move(message), std::move(hint)});
}

void Errors::add(const Source& source, std::size_t offset, std::string message, std::string hint) {
    add({&source, offset, 1, std::move(message), std::move(hint)});
}

void Errors::add(Found found) {
    if (!is_full())
        found_.push_back(std::move(found));
    else
        ++unlisted_;
}

void Errors::add(const Source& source, std::string message, std::string hint) {
    add(source, std::string::npos, std::move(message), std::move(hint));
}

bool Errors::is_full() const { return found_.size() >= most_listed; }

void Errors::throw_if_any() const {
    if (found_.empty()) return;
    std::vector<Diagnostic> diagnostics = in_order(found_, most_errors_shown.count());
    const std::size_t left_out = found_.size() + unlisted_ - diagnostics.size();
    if (left_out > 0) {
        const std::string file = diagnostics.front().span.file;
        Diagnostic& rest = diagnostics.emplace_back();
        rest.span.file = file;
        rest.message = fmt::format("and {} more errors", left_out);
    }
    throw SceneError(std::move(diagnostics));
}

void Errors::add_note(const Node& node, std::string message, std::string hint) {
    notes_.push_back(
        {node.source, node.offset, marked_bytes(node), std::move(message), std::move(hint)});
}

std::vector<Diagnostic> Errors::notes() const { return in_order(notes_, notes_.size()); }

std::vector<Diagnostic> Errors::in_order(std::vector<Found> found, std::size_t most) {
    std::ranges::stable_sort(found, {}, [](const Found& one) {
        return std::tuple{rank(one.source->origin), one.source->name, one.offset};
    });
    std::vector<Diagnostic> diagnostics;
    for (std::size_t i = 0; i < std::min(found.size(), most); ++i) {
        Diagnostic diagnostic = place_in(*found[i].source, found[i].offset, found[i].bytes);
        diagnostic.message = std::move(found[i].message);
        diagnostic.hint = std::move(found[i].hint);
        diagnostics.push_back(std::move(diagnostic));
    }
    return diagnostics;
}

Diagnostic place_of(const Node& node) {
    return place_in(*node.source, node.offset, marked_bytes(node));
}

}  // namespace carom
