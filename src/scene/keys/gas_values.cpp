#include "scene/keys/gas_values.h"

#include <fmt/format.h>

#include <utility>

#include "physics/units/gas_table.h"

namespace carom {
namespace {

void add_key(Node& item, const Node& place, const char* key, std::string text, const char* unit) {
    if (find(item, key) != nullptr) return;
    Node name = place, value = place;
    name.text = key;
    value.quoted = unit == nullptr;
    if (unit != nullptr) value.written = fmt::format("{} {}", text, unit);
    value.text = std::move(text);
    item.keys.push_back(std::move(name));
    item.items.push_back(std::move(value));
}

}  // namespace

std::vector<std::string> names_of_gases() {
    std::vector<std::string> names;
    for (const NamedGas& gas : named_gases()) names.emplace_back(gas.name.english);
    return names;
}

void fill_in_gases(Node& root) {
    Node* species = find(root, "gas");
    if (species == nullptr || !species->is_list()) return;
    for (Node& item : species->items) {
        const Node* named = item.is_mapping() ? find(item, "gas") : nullptr;
        const NamedGas* gas =
            named != nullptr && named->is_scalar() ? gas_named(named->text) : nullptr;
        if (gas == nullptr) continue;
        const Node place = *named;
        // Sums of atomic weights and halves of diameters, without their rounding errors.
        const auto number = [](double value) { return fmt::format("{:.7g}", value); };
        add_key(item, place, "name", std::string(gas->name.english), nullptr);
        add_key(item, place, "radius", number(0.5 * gas->diameter), "nm");
        if (find(item, "density") == nullptr) add_key(item, place, "mass", number(gas->mass), "u");
        add_key(item, place, "color", std::string(gas->color), nullptr);
    }
}

bool is_filled_in(const Node& item, std::string_view key) {
    const Node *value = find(item, key), *named = find(item, "gas");
    return value != nullptr && named != nullptr && value->source == named->source &&
           value->offset == named->offset;
}

}  // namespace carom
