#include "scene/overrides.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "scene/limits.h"
#include "scene/yaml/yaml.h"

namespace carom {
namespace {

struct Step {
    std::string word;
    std::size_t offset;  ///< in the source's text
};

std::vector<Step> steps_of(const std::string& path, std::size_t offset) {
    std::vector<Step> steps;
    std::size_t start = 0;
    while (true) {
        const std::size_t dot = path.find('.', start);
        steps.push_back({path.substr(start, dot - start), offset + start});
        if (dot == std::string::npos) return steps;
        start = dot + 1;
    }
}

// Returns "gas.0.count" for "gas[0].count" and "gas/0/count", and nothing for paths with points.
std::string with_points(std::string path) {
    const bool has_slashes = path.find('.') == path.npos && path.find('/') != path.npos;
    if (!has_slashes && path.find('[') == path.npos) return "";
    std::erase(path, ']');
    std::ranges::replace_if(
        path, [&](char c) { return c == '[' || (has_slashes && c == '/'); }, '.');
    return path;
}

std::optional<std::size_t> list_index(const std::string& word) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return index;
}

Node key_node(const Source& source, const Step& step) {
    return {
        .kind = Node::Kind::scalar, .source = &source, .offset = step.offset, .text = step.word};
}

Node* enter_list(Node& list, const Source& source, const Step& step, Errors& errors) {
    const auto index = list_index(step.word);
    if (index && *index < list.items.size()) return &list.items[*index];
    std::vector<std::string> names;
    for (Node& item : list.items) {
        const Node* name = find(item, "name");
        if (name == nullptr) continue;
        if (name->text == step.word) return &item;
        names.push_back(name->text);
    }
    const std::string by_name =
        names.empty() ? "" : ", or named: " + fmt::format("`{}`", fmt::join(names, "`, `"));
    errors.add(key_node(source, step),
               fmt::format("expected an item of a list of {}, found {}", list.items.size(),
                           in_quotes(step.word)),
               "items are counted from 0" + by_name);
    return nullptr;
}

Node* enter_mapping(Node& mapping, const Source& source, const Step& step) {
    for (std::size_t i = 0; i < mapping.keys.size(); ++i) {
        if (mapping.keys[i].text != step.word) continue;
        mapping.keys[i] = key_node(source, step);
        return &mapping.items[i];
    }
    mapping.keys.push_back(key_node(source, step));
    return &mapping.items.emplace_back(Node{.source = &source, .offset = step.offset});
}

Node* enter(Node& node, const Source& source, const Step& step, Errors& errors) {
    if (node.is_list()) return enter_list(node, source, step, errors);
    if (node.kind == Node::Kind::null) node.kind = Node::Kind::mapping;
    if (node.is_mapping()) return enter_mapping(node, source, step);
    errors.add(key_node(source, step),
               fmt::format("{} is set inside {}, which is no mapping", in_quotes(step.word),
                           described(node)),
               "the keys before it lead to a single value: leave out what follows that");
    return nullptr;
}

// A colour may be given without quotes: on the command line `#` does not begin a comment.
std::optional<Node> read_value(const Source& source, std::size_t begin, Errors& errors) {
    if (begin >= source.text.size() || source.text[begin] != '#')
        return read_yaml(source, errors, begin);
    return key_node(source, {source.text.substr(begin), begin});
}

// Applies the change that begins at byte `begin` of the source's text.
void apply(const Source& source, std::size_t begin, Node& scene, Errors& errors) {
    const std::size_t sign = source.text.find('=', begin);
    std::optional<Node> value = read_value(source, sign + 1, errors);
    if (!value) return;
    if (value->kind == Node::Kind::null) value->offset = begin;
    if (const std::string path = with_points(source.text.substr(begin, sign - begin));
        !path.empty())
        return errors.add(source, begin, "the keys of a path are separated by points",
                          fmt::format("write `{}`", path));
    Node* place = &scene;
    for (const Step& step : steps_of(source.text.substr(begin, sign - begin), begin)) {
        place = enter(*place, source, step, errors);
        if (place == nullptr) return;
    }
    *place = std::move(*value);
}

}  // namespace

std::string text_of_change(const std::string& change) { return "--set " + change; }

void apply_overrides(const Overrides& overrides, Node& scene, Sources& sources, Errors& errors) {
    if (overrides.size() > most_overrides.count()) {
        sources.push_back({"--set", "", Origin::command_line});
        errors.add(sources.back(), fmt::format("{} values are set", overrides.size()),
                   to_text(most_overrides));
        return;
    }
    for (const std::string& change : overrides) {
        const std::string text = text_of_change(change);
        sources.push_back({text, text, Origin::command_line});
        apply(sources.back(), text.size() - change.size(), scene, errors);
    }
}

}  // namespace carom
