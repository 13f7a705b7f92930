#include "scene/overrides.h"

#include <fmt/format.h>

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

std::optional<std::size_t> list_index(const std::string& word) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return index;
}

Node key_node(const Source& source, const Step& step) {
    Node key;
    key.kind = Node::Kind::scalar;
    key.source = &source;
    key.offset = step.offset;
    key.text = step.word;
    return key;
}

Node* enter_list(Node& list, const Source& source, const Step& step, Errors& errors) {
    const auto index = list_index(step.word);
    if (index && *index < list.items.size()) return &list.items[*index];
    errors.add(key_node(source, step),
               fmt::format("expected an item of a list of {}, found {}", list.items.size(),
                           in_quotes(step.word)),
               "items are counted from 0");
    return nullptr;
}

Node* enter_mapping(Node& mapping, const Source& source, const Step& step) {
    for (std::size_t i = 0; i < mapping.keys.size(); ++i) {
        if (mapping.keys[i].text != step.word) continue;
        mapping.keys[i] = key_node(source, step);
        return &mapping.items[i];
    }
    mapping.keys.push_back(key_node(source, step));
    Node& value = mapping.items.emplace_back();
    value.source = &source;
    value.offset = step.offset;
    return &value;
}

Node* enter(Node& node, const Source& source, const Step& step, Errors& errors) {
    if (node.is_list()) return enter_list(node, source, step, errors);
    if (node.kind == Node::Kind::null) node.kind = Node::Kind::mapping;
    if (node.is_mapping()) return enter_mapping(node, source, step);
    errors.add(key_node(source, step), fmt::format("{} is set inside {}, which is no mapping",
                                                   in_quotes(step.word), described(node)));
    return nullptr;
}

// A colour may be given as it is: on the command line `#` begins no comment.
std::optional<Node> read_value(const Source& source, std::size_t begin, Errors& errors) {
    if (begin >= source.text.size() || source.text[begin] != '#')
        return read_yaml(source, errors, begin);
    return key_node(source, {source.text.substr(begin), begin});
}

void apply(const Source& source, const std::string& path, std::size_t path_at, Node& scene,
           Errors& errors) {
    std::optional<Node> value = read_value(source, path_at + path.size() + 1, errors);
    if (!value) return;
    if (value->kind == Node::Kind::null) value->offset = path_at;
    Node* place = &scene;
    for (const Step& step : steps_of(path, path_at)) {
        place = enter(*place, source, step, errors);
        if (place == nullptr) return;
    }
    *place = std::move(*value);
}

}  // namespace

void apply_overrides(const Overrides& overrides, Node& scene, Sources& sources, Errors& errors) {
    constexpr std::string_view option = "--set ";
    if (overrides.values.size() > most_overrides.count()) {
        sources.push_back({"--set", "", Origin::command_line});
        errors.add(sources.back(), fmt::format("{} values are set", overrides.values.size()),
                   fmt::format("the limit is {} {}", most_overrides.value, most_overrides.meaning));
        return;
    }
    for (const auto& [path, value] : overrides.values) {
        const std::string text = fmt::format("{}{}={}", option, path, value);
        sources.push_back({text, text, Origin::command_line});
        apply(sources.back(), path, option.size(), scene, errors);
    }
}

}  // namespace carom
