#include "scene/manual/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/keys/key_text.h"
#include "scene/reading/scene_reading.h"
#include "util/text.h"

namespace carom {
namespace {

// The sections of the mappings in a key of another box; those of the plane if it has no such key.
std::vector<const Section*> sections_in_key(const Section& other, const Key& in_plane) {
    const std::size_t index = other.index(in_plane.name);
    return sections_in(index < other.keys.size() ? other.keys[index].forms : in_plane.forms);
}

void add_sections(const SectionsOfBoxes& all, std::set<std::string>& names,
                  std::vector<SectionsOfBoxes>& found) {
    if (!names.insert(all.plane->name).second) return;
    found.push_back(all);
    for (const Key& key : all.plane->keys) {
        const std::vector<const Section*> inner = sections_in(key.forms);
        const auto on_wire = sections_in_key(*all.wire, key);
        const auto in_space = sections_in_key(*all.space, key);
        for (std::size_t k = 0; k < inner.size(); ++k)
            add_sections({inner[k], k < on_wire.size() ? on_wire[k] : inner[k],
                          k < in_space.size() ? in_space[k] : inner[k]},
                         names, found);
    }
}

bool is_one_of_needed(const Section& section, const std::string& name) {
    return std::ranges::any_of(section.choices, [&](const Choice& choice) {
        return choice.required && std::ranges::find(choice.names, name) != choice.names.end();
    });
}

// Whether a page says the same of both keys, the one of the plane and the other.
bool is_said_alike(const Section& plane, const Key& in_plane, const Section& other,
                   const Key& elsewhere) {
    return in_plane.meaning == elsewhere.meaning && forms_text(in_plane) == forms_text(elsewhere) &&
           default_of(plane, in_plane) == default_of(other, elsewhere);
}

}  // namespace

SectionsOfBoxes sections_of_scenes(PanelKinds kinds) {
    return {&scene_table(kinds, 2).section(), &scene_table(kinds, 1).section(),
            &scene_table(kinds, 3).section()};
}

std::vector<SectionsOfBoxes> sections_within(const SectionsOfBoxes& all) {
    std::vector<SectionsOfBoxes> found;
    std::set<std::string> names;
    add_sections(all, names, found);
    return found;
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

Otherwise otherwise(const Section& plane, const Section& other) {
    Otherwise found;
    for (const Key& key : other.keys) {
        const std::size_t index = plane.index(key.name);
        if (index == plane.keys.size() || !is_said_alike(plane, plane.keys[index], other, key))
            found.keys.push_back(&key);
    }
    for (const Key& key : plane.keys)
        if (other.index(key.name) == other.keys.size()) found.missing.push_back(key.name);
    return found;
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
