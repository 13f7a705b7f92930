#include "scene/manual/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/keys/key_text.h"
#include "scene/reading/scene_reading.h"
#include "util/text.h"

namespace carom {
namespace {

void add_sections(const SectionPair& both, std::set<std::string>& names,
                  std::vector<SectionPair>& all) {
    const auto& [plane, wire] = both;
    if (!names.insert(plane->name).second) return;
    all.push_back(both);
    for (const Key& key : plane->keys) {
        const std::size_t index = wire->index(key.name);
        const std::vector<const Section*> inner = sections_in(key.forms);
        const std::vector<const Section*> others =
            index < wire->keys.size() ? sections_in(wire->keys[index].forms) : inner;
        for (std::size_t k = 0; k < inner.size(); ++k)
            add_sections({inner[k], k < others.size() ? others[k] : inner[k]}, names, all);
    }
}

bool is_one_of_needed(const Section& section, const std::string& name) {
    return std::ranges::any_of(section.choices, [&](const Choice& choice) {
        return choice.required && std::ranges::find(choice.names, name) != choice.names.end();
    });
}

// Whether a page says the same of both keys, the one of the plane and the one of the wire.
bool is_said_alike(const SectionPair& section, const Key& in_plane, const Key& on_wire) {
    return in_plane.meaning == on_wire.meaning && forms_text(in_plane) == forms_text(on_wire) &&
           default_of(*section.plane, in_plane) == default_of(*section.wire, on_wire);
}

}  // namespace

std::vector<SectionPair> sections_within(const Section& plane, const Section& wire) {
    std::vector<SectionPair> all;
    std::set<std::string> names;
    add_sections({&plane, &wire}, names, all);
    return all;
}

std::string default_of(const Section& section, const Key& key) {
    if (key.required) return "required";
    if (!key.default_value.empty()) return "`" + key.default_value + "`";
    if (!key.default_text.empty()) return key.default_text;
    return is_one_of_needed(section, key.name) ? "see below" : "none";
}

std::vector<std::string> choices_in_words(const Section& section) {
    std::vector<std::string> words;
    for (const Choice& choice : section.choices)
        words.push_back(fmt::format("{} of {}.", choice.required ? "Exactly one" : "At most one",
                                    listed(choice.names, "and", "`")));
    return words;
}

OnWire on_wire(const SectionPair& section) {
    const auto& [plane, wire] = section;
    OnWire others;
    for (const Key& key : wire->keys) {
        const std::size_t index = plane->index(key.name);
        if (index == plane->keys.size() || !is_said_alike(section, plane->keys[index], key))
            others.keys.push_back(&key);
    }
    for (const Key& key : plane->keys)
        if (wire->index(key.name) == wire->keys.size()) others.missing.push_back(key.name);
    return others;
}

KeysOfKind keys_of_kind(const Section& section, const std::string& kind) {
    KeysOfKind keys;
    for (const Key& key : section.keys)
        if (std::ranges::find(key.kinds, kind) != key.kinds.end())
            (key.kinds.size() == 1 ? keys.own : keys.shared).push_back(&key);
    return keys;
}

const Section& panel_section(PanelKinds kinds) {
    return section_of(section_of(scene_table(kinds, 2).section(), "film"), "panels");
}

const Section& figure_section(PanelKinds kinds) {
    return section_of(scene_table(kinds, 2).section(), "figures");
}

}  // namespace carom
