#include "scene/keys/fields.h"

#include <fmt/format.h>

#include "scene/yaml/scalar.h"

namespace carom {
namespace {

std::optional<Quantity> uniform_law(const Node& list, Errors& errors) {
    const Eigen::Array2d ends = pair(list);
    if (ends[0] <= ends[1]) return UniformLaw{ends[0], ends[1]};
    errors.add(list, fmt::format("expected [low, high] for `uniform`, found {} above {}", ends[0],
                                 ends[1]));
    return std::nullopt;
}

std::optional<Quantity> normal_law(const Node& list, Range range, Errors& errors) {
    const Eigen::Array2d law = pair(list);
    if (law[0] >= range.low) return NormalLaw{law[0], law[1]};
    errors.add(list.items[0], fmt::format("expected a positive mean for `normal`, found {}",
                                          in_quotes(list.items[0].text)));
    return std::nullopt;
}

}  // namespace

const Node* Fields::given(std::string_view key) const {
    const Node* node = find(node_, key);
    return node != nullptr && node->valid && node->kind != Node::Kind::null ? node : nullptr;
}

bool Fields::mentions(std::string_view key) const { return find(node_, key) != nullptr; }

const Node* Fields::value(std::string_view key) const {
    if (const Node* node = given(key)) return node;
    const Node& preset = section_.presets.at(section_.index(key));
    return preset.kind == Node::Kind::null ? nullptr : &preset;
}

std::optional<double> Fields::number(std::string_view key) const {
    const Node* node = value(key);
    return node == nullptr ? std::nullopt : number_in(*node);
}

std::optional<std::int64_t> Fields::integer(std::string_view key) const {
    const auto number = this->number(key);
    if (!number) return std::nullopt;
    return static_cast<std::int64_t>(*number);
}

std::optional<bool> Fields::flag(std::string_view key) const {
    const Node* node = value(key);
    return node == nullptr ? std::nullopt : flag_in(*node);
}

std::optional<std::string> Fields::text(std::string_view key) const {
    const Node* node = value(key);
    if (node == nullptr || !node->is_scalar()) return std::nullopt;
    return node->text.substr(0, node->text.find_last_not_of(" \t\n") + 1);
}

std::optional<Fields> Fields::inner(std::string_view key) const {
    const Node* node = given(key);
    if (node == nullptr || !node->is_mapping()) return std::nullopt;
    return Fields{*node, section_of(section_, key)};
}

std::vector<double> numbers(const Node& list) {
    std::vector<double> values;
    values.reserve(list.items.size());
    for (const Node& item : list.items) values.push_back(number_in(item).value_or(0.0));
    return values;
}

Eigen::Array2d pair(const Node& list) {
    const std::vector<double> values = numbers(list);
    return {values.at(0), values.at(1)};
}

std::vector<Eigen::Array2d> points(const Node& node, int dimension) {
    const auto point = [&](const Node& one) -> Eigen::Array2d {
        if (dimension == 2) return pair(one);
        return {number_in(one).value_or(0.0), 0.0};
    };
    if (!lists_points(node, dimension)) return {point(node)};
    std::vector<Eigen::Array2d> values;
    values.reserve(node.items.size());
    for (const Node& item : node.items) values.push_back(point(item));
    return values;
}

bool lists_points(const Node& node, int dimension) {
    return node.is_list() && (dimension == 1 || node.items.front().is_list());
}

std::optional<Quantity> quantity_in(const Node& node, Range range, Errors& errors) {
    if (const auto value = number_in(node)) return *value;
    if (node.is_list()) return numbers(node);
    if (const Node* law = find(node, "uniform"); law != nullptr && law->valid)
        return uniform_law(*law, errors);
    if (const Node* law = find(node, "normal"); law != nullptr && law->valid)
        return normal_law(*law, range, errors);
    return std::nullopt;
}

}  // namespace carom
